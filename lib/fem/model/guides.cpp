// Guides that carry the geosynthetic under its seat pressure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/model/guides.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace soilweave::fem {
namespace {

// Distances between a bar and its guide, in radii. Their disks touch at two.
constexpr double nearest_guide = 1, farthest_guide = 3;

bool carries(const Guide& guide, const Vec2& at, double radius) {
  const Vec2 along = guide.to - guide.from;
  const double share = (at[0] - guide.from[0]) / along[0];
  if (!(share >= 0 && share <= 1)) return false;
  const double gap = (at[1] - guide.from[1] - share * along[1]) / radius;
  return gap >= nearest_guide && gap <= farthest_guide;
}

Vec2 middle(const BarsSetup& setup, std::size_t bar) { return 0.5 * (setup.chain[bar] + setup.chain[bar + 1]); }

// Returns the mean of y along a line of nodes.
double height(const std::vector<Vec2>& line) {
  double sum = 0, length = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const double edge = (line[k + 1] - line[k]).norm();
    sum += 0.5 * edge * (line[k][1] + line[k + 1][1]), length += edge;
  }
  return sum / length;
}

}  // namespace

std::vector<std::size_t> uncarried_bars(const BarsSetup& setup) {
  const auto [left, right] = std::minmax_element(setup.interface.begin(), setup.interface.end(),
                                                 [](const Vec2& a, const Vec2& b) { return a[0] < b[0]; });
  std::vector<std::size_t> bars;
  for (std::size_t bar = 0; bar + 1 < setup.chain.size(); ++bar) {
    const Vec2 at = middle(setup, bar);
    if (at[0] < (*left)[0] || at[0] > (*right)[0]) continue;
    if (std::none_of(setup.guides.begin(), setup.guides.end(),
                     [&](const Guide& guide) { return carries(guide, at, setup.radius); }))
      bars.push_back(bar);
  }
  return bars;
}

std::string uncarried_text(const BarsSetup& setup, const std::vector<std::size_t>& bars) {
  // Along a side or above the soil, guides have nothing to carry.
  if (!(height(setup.chain) < height(setup.interface) - setup.radius))
    return "the seat pressure acts against y, and its bars do not lie below the soil: leave geosynthetic.seat_pressure "
           "out";
  const Vec2 first = middle(setup, bars.front()), last = middle(setup, bars.back());
  const Vec2 down(0, -2 * setup.radius), from = setup.chain.front() + down, to = setup.chain.back() + down;
  const bool some = bars.size() < setup.chain.size() - 1 && !setup.guides.empty();
  return fmt::format(
      "no guide lies two radii below {} of its {} bars, between ({:.4g}, {:.4g}) and ({:.4g}, {:.4g}) m; to carry the "
      "whole chain, give a [[geosynthetic.guide]] from = [{:.4g}, {:.4g}], to = [{:.4g}, {:.4g}]{}",
      bars.size(), setup.chain.size() - 1, first[0], first[1], last[0], last[1], from[0], from[1], to[0], to[1],
      some ? ", or take a mesh no wider than the guides" : "");
}

}  // namespace soilweave::fem
