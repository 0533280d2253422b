// Copies, groups and boxes by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/volume_choice.h"

#include <fmt/format.h>

#include <string_view>
#include <utility>

#include "core/error.h"
#include "core/text/number_word.h"

namespace soilweave::analysis {

void VolumeChoice::check(std::vector<std::string>& wrong) const {
  for (const std::string& text : boxes) {
    const std::vector<double> b = numbers_of_list(text);
    if (b.size() != 6 || b[0] >= b[1] || b[2] >= b[3] || b[4] >= b[5])
      wrong.push_back(fmt::format("--box {}: give x, y and z from low to high, as in 0,0.1,0,0.1,0,0.2", text));
  }
}

std::vector<Volume> VolumeChoice::volumes(const io::Snapshot& state, const std::string& where) const {
  std::vector<Volume> all;
  const auto take = [&](std::vector<Volume> some, std::string_view absent) {
    if (some.empty()) throw DataError(fmt::format("{}: {}; take --box", where, absent));
    for (Volume& one : some) all.push_back(std::move(one));
  };
  if (copies) take(analysis::copies(state), "holds no copies of a representative volume");
  if (groups)
    take(analysis::groups(state), "has no groups along x, which need copies in one layer, as many along x as along y");
  for (const std::string& text : boxes) {
    const std::vector<double> b = numbers_of_list(text);
    all.push_back(box(state, {b[0], b[2], b[4]}, {b[1], b[3], b[5]}));
  }
  return all;
}

}  // namespace soilweave::analysis
