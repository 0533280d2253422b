// Assignment of bodies to the parts of an assembly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/parts.h"

#include <algorithm>
#include <utility>

namespace soilweave::analysis {

std::vector<Part> parts(const io::Snapshot& state) {
  const std::vector<bool> node = io::nodes(state);
  const auto of_copy = [&](std::size_t i) { return state.grains.copy_id[i] >= 0; };
  bool copies = false;
  for (std::size_t i = 0; i < node.size(); ++i) copies = copies || (!node[i] && of_copy(i));
  std::vector<Part> parts(node.size(), Part::soil);
  for (std::size_t i = 0; i < node.size(); ++i)
    if (node[i])
      parts[i] = Part::node;
    else if (copies && !of_copy(i))
      parts[i] = Part::fill;
  return parts;
}

std::vector<bool> those(const std::vector<Part>& parts, Part part) {
  std::vector<bool> mask(parts.size());
  std::transform(parts.begin(), parts.end(), mask.begin(), [part](Part p) { return p == part; });
  return mask;
}

bool has_fill(const io::Snapshot& state) {
  return std::ranges::any_of(parts(state), [](Part p) { return p == Part::fill; });
}

void mark_parts(const io::Snapshot& state, io::VtkPicture& grains) {
  if (!has_fill(state)) return;
  std::vector<std::uint8_t> numbers;
  for (const Part part : parts(state)) numbers.push_back(static_cast<std::uint8_t>(part));
  grains.point_data.push_back({"part", 1, std::move(numbers)});
}

}  // namespace soilweave::analysis
