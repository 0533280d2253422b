// Doubts about the fabric of a state.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/fabric_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

#include "analysis/measure/fabric.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"
#include "dem/sweep/pair_search.h"

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

// Returns the number of pairs that overlap by more than rounding, nodes of one fabric left out.
std::size_t overlapping_pairs(const io::Snapshot& state) {
  constexpr double touching = 1 - 1e-9;
  if (state.grains.size() == 0) return 0;
  dem::Bodies bodies(state.grains);
  std::vector<std::int32_t> fabric(state.grains.size(), -1);
  for (std::size_t y = 0; y < state.yarns.size(); ++y)
    for (const std::int32_t node : state.yarns.nodes[y]) fabric[static_cast<std::size_t>(node)] = state.yarns.fabric[y];
  if (state.yarns.size() > 0) bodies.set_fabric(std::move(fabric));
  std::vector<double> reach = state.grains.radius;
  for (double& r : reach) r *= touching;
  std::vector<dem::Pair> pairs;
  dem::find_pairs(bodies, dem::Cell(state.cell, state.grains.dimension), reach, 2 * std::ranges::max(reach), 1, pairs);
  return pairs.size();
}

constexpr const char* unstored =
    "the file keeps no contacts of grains that overlap, as of an import; give a state of run-dem, which finds them";

}  // namespace

std::vector<Doubt> contact_doubts(const io::Snapshot& state) {
  if (state.contacts.size() > 0) return {};
  const std::size_t pairs = overlapping_pairs(state);
  if (pairs == 0) return {};
  return {
      {"no_contacts", fmt::format("step {}: {} pairs of grains overlap, and the stress and coordination number count "
                                  "none of them (0): {}",
                                  state.step, pairs, unstored)}};
}

std::vector<Doubt> fabric_doubts(const io::Snapshot& state) {
  if (state.contacts.size() > 0) return {};
  return {{"no_contacts", fmt::format("step {}: no contacts, and so no fabric and no anisotropy (nan); {}", state.step,
                                      overlapping_pairs(state) > 0 ? unstored : "give a state under load")}};
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
