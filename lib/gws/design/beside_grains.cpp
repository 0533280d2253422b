// The ultimate load of the solution beside full-size bags and cells of discrete elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/design/beside_grains.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

namespace soilweave::gws {
namespace {

constexpr std::array<BesideGrains, 7> bags{{{53e3, 1.15, 0.898, -0.327},
                                            {116e3, 1.07, 0.917, -0.129},
                                            {232e3, 1.07, 0.887, 0.495},
                                            {464e3, 1.04, 0.896, 0.39},
                                            {696e3, 1.01, 0.916, -0.353},
                                            {928e3, 1.06, 0.943, 0.615},
                                            {1160e3, 1, 0.968, -0.586}}};
constexpr std::array<BesideGrains, 9> cells{{{53e3, 1.17, 0.695, 1.32, 10e3},
                                             {232e3, 1.2, 0.742, 0.691, 10e3},
                                             {1160e3, 1.28, 0.836, 1.47, 10e3},
                                             {53e3, 1.11, 0.454, 3.82, 50e3},
                                             {232e3, 1.14, 0.581, 2.46, 50e3},
                                             {1160e3, 1.3, 0.709, 2.67, 50e3},
                                             {53e3, 1.09, 0.343, 7.82, 100e3},
                                             {232e3, 1.1, 0.486, 3.42, 100e3},
                                             {1160e3, 1.25, 0.629, 1.93, 100e3}}};

bool comparable(const Case& bag) {
  const Bag thesis;
  return bag.soil == Soil{} && bag.bag.width == thesis.width && bag.bag.height == thesis.height &&
         bag.usable_share() == 0.5 && !bag.initial_settlement && !bag.initial_surcharge;
}

// Returns lines about the two runs that enclose `stiffness`. They name only one run if it has this stiffness, or if
// `stiffness` lies outside the runs.
std::string lines(std::span<const BesideGrains> runs, double stiffness, std::string_view what) {
  const auto above = std::lower_bound(runs.begin(), runs.end(), stiffness * (1 - 1e-3),
                                      [](const BesideGrains& run, double J) { return run.stiffness < J; });
  const bool alone = above == runs.begin() || above == runs.end() || above->stiffness <= stiffness * (1 + 1e-3);
  const auto first = alone ? std::min(above, runs.end() - 1) : above - 1;
  std::string text = fmt::format("Beside full-size {} in the same geotextile, the solution bears at failure\n", what);
  for (const BesideGrains& run : std::span(first, alone ? 1 : 2))
    text += fmt::format(
        "  {:.2f} times their load with {:.4g} kN/m, at a settlement that differs by {:+.1f} % of the "
        "height; at 5 % of settlement {:.2f} times\n",
        run.ratio, run.stiffness / 1e3, run.settlement, run.early);
  return text;
}

// Returns the cells whose lateral stress is nearest, as a ratio.
std::span<const BesideGrains> cells_under(double lateral) {
  const auto off = [lateral](const BesideGrains& run) { return std::abs(std::log(run.lateral / lateral)); };
  const double nearest = std::ranges::min_element(cells, {}, off)->lateral;
  const auto begin = std::ranges::lower_bound(cells, nearest, {}, &BesideGrains::lateral);
  return {begin, std::ranges::upper_bound(begin, cells.end(), nearest, {}, &BesideGrains::lateral)};
}

}  // namespace

std::span<const BesideGrains> bags_of_grains() { return bags; }

std::span<const BesideGrains> cells_of_grains() { return cells; }

std::string beside_grains(const Case& bag) {
  if (!comparable(bag)) return "";
  const double J = bag.geotextile.stiffness;
  const auto most = std::ranges::max_element(bag.lateral.lateral);
  if (most == bag.lateral.lateral.end() || !(*most > 0)) return lines(bags, J, "bags of discrete elements");
  const auto runs = cells_under(*most);
  return lines(
      runs, J,
      fmt::format("cells of discrete elements under {:.4g} kPa of lateral stress", runs.front().lateral / 1e3));
}

}  // namespace soilweave::gws
