// Doubts about analytical answers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace soilweave::gws {
namespace {

// Relative tolerance at the ends of a range, because numbers of data are rounded.
constexpr double slack = 0.01;

// Returns the values that leave a range as one phrase; empty if none does, or if the range is not known.
std::string beyond(const Span& range, const std::vector<double>& values, const char* name, double unit,
                   const char* unit_name) {
  if (!range.known()) return "";
  double worst = 0, farthest = 0;
  for (const double v : values) {
    const double over = std::max(v - range.high * (1 + slack), range.low * (1 - slack) - v);
    if (std::isfinite(v) && over > farthest) farthest = over, worst = v;
  }
  if (farthest == 0) return "";
  return fmt::format("{} {:.4g} {} (identified on {:.4g} to {:.4g} {})", name, worst / unit, unit_name,
                     range.low / unit, range.high / unit, unit_name);
}

}  // namespace

std::vector<Doubt> doubts(const SoilFile& soil, bool chosen, const std::vector<double>& stiffnesses,
                          const std::vector<Point>& states) {
  std::vector<Doubt> found;
  if (!chosen)
    found.push_back(
        {"default-soil", fmt::format("the soil is {}, since none was chosen: give --soil, of data/soils or identified "
                                     "from bags of your own (gws-solve identify --toml)",
                                     soil.name)});
  if (!soil.estimated.empty())
    found.push_back(
        {"estimated-soil", fmt::format("soil {}: {}; alpha, beta and the dilatancy line are Toyoura sand's; "
                                       "identify them on bags of its own (gws-solve identify)",
                                       soil.name, soil.estimated)});
  std::vector<double> pressures, strains;
  for (const Point& point : states) {
    if (point.soil.end != End::none) continue;
    pressures.push_back(point.soil.p), strains.push_back(point.soil.strain_axial / 100);
  }
  std::string all;
  for (const std::string& part :
       {beyond(soil.identified.stiffness, stiffnesses, "stiffness of the geotextile", 1e3, "kN/m"),
        beyond(soil.identified.mean_stress, pressures, "mean stress", 1e3, "kPa"),
        beyond(soil.identified.axial_strain, strains, "axial strain", 0.01, "%")})
    if (!part.empty()) all += (all.empty() ? "" : ", ") + part;
  if (!all.empty())
    found.push_back(
        {"extrapolation", fmt::format("the constants of {} are extrapolated: {}; identify them on such bags "
                                      "(gws-solve identify)",
                                      soil.name, all)});
  return found;
}

}  // namespace soilweave::gws
