// The ultimate load of the solution beside full-size bags and cells of discrete elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/design/beside_grains.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace soilweave::gws {
namespace {

constexpr std::array<BesideGrains, 7> bags{
    {{53e3, 1.15}, {116e3, 1.07}, {232e3, 1.07}, {464e3, 1.04}, {696e3, 1.01}, {928e3, 1.06}, {1160e3, 1.00}}};
constexpr std::array<BesideGrains, 3> cells{{{53e3, 1.17}, {232e3, 1.20}, {1160e3, 1.28}}};

bool comparable(const Case& bag) {
  const Bag thesis;
  return bag.soil == Soil{} && bag.bag.width == thesis.width && bag.bag.height == thesis.height &&
         bag.usable_share() == 0.5 && !bag.initial_settlement && !bag.initial_surcharge;
}

// Returns a sentence about the two runs that enclose `stiffness`. Names only one run if it has this stiffness, or if
// `stiffness` lies outside the runs.
std::string sentence(std::span<const BesideGrains> runs, double stiffness, std::string_view what) {
  const auto above = std::lower_bound(runs.begin(), runs.end(), stiffness * (1 - 1e-3),
                                      [](const BesideGrains& run, double J) { return run.stiffness < J; });
  const bool alone = above == runs.begin() || above == runs.end() || above->stiffness <= stiffness * (1 + 1e-3);
  const BesideGrains& nearest = above == runs.end() ? runs.back() : *above;
  const auto told = [](const BesideGrains& run) {
    return fmt::format("{:.2f} with {:.4g} kN/m", run.ratio, run.stiffness / 1e3);
  };
  return fmt::format("The solution's load at failure, over that of full-size {} in the same geotextile, is {}{}.\n",
                     what, alone ? "" : told(*(above - 1)) + " and ", told(nearest));
}

}  // namespace

std::span<const BesideGrains> bags_of_grains() { return bags; }

std::span<const BesideGrains> cells_of_grains() { return cells; }

std::string beside_grains(const Case& bag) {
  if (!comparable(bag)) return "";
  const double J = bag.geotextile.stiffness;
  const bool beside = std::ranges::any_of(bag.lateral.lateral, [](double stress) { return stress > 0; });
  return beside ? sentence(cells, J, "cells of discrete elements under 10 kPa of lateral stress")
                : sentence(bags, J, "bags of discrete elements");
}

}  // namespace soilweave::gws
