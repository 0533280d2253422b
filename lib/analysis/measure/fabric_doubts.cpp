// Doubts about the fabric of a state.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/fabric_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "analysis/measure/fabric.h"

namespace soilweave::analysis {
namespace {

// Fewest classes of a rose; it has four quarters of two classes.
constexpr std::size_t fewest_classes = 8;

std::ptrdiff_t empty_classes(const io::Snapshot& state, std::size_t classes) {
  std::vector<Rose> roses = {plane_rose(state, 0, 1, classes)};
  if (state.grains.dimension == 3) {
    roses.push_back(plane_rose(state, 0, 2, classes));
    roses.push_back(polar_rose(state, classes / 4));
  }
  std::ptrdiff_t empty = 0;
  for (const Rose& rose : roses) empty += std::ranges::count(rose.contacts, 0.0);
  return empty;
}

}  // namespace

std::vector<Doubt> fabric_doubts(const io::Snapshot& state) {
  if (state.contacts.size() > 0) return {};
  return {{"no_contacts", fmt::format("step {}: no contacts, and so no fabric and no anisotropy (nan); give a state "
                                      "under load",
                                      state.step)}};
}

std::vector<Doubt> rose_doubts(const io::Snapshot& state, std::size_t classes) {
  if (state.contacts.size() == 0) return fabric_doubts(state);
  const std::ptrdiff_t empty = empty_classes(state, classes);
  if (empty == 0) return {};
  // Every fourth number is a class of a quarter more.
  std::size_t fewer = classes / 4 * 4;
  while (fewer >= fewest_classes && empty_classes(state, fewer) > 0) fewer -= 4;
  const std::string remedy =
      fewer >= fewest_classes ? fmt::format("give --classes {}, or more grains", fewer) : "give more grains";
  return {
      {"empty_classes", fmt::format("step {}: {} classes of the rose hold no contact, and have no mean force (nan); "
                                    "{}",
                                    state.step, empty, remedy)}};
}

}  // namespace soilweave::analysis
