// Points of tests without a bag.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string>

#include "core/error.h"
#include "core/text/units.h"
#include "files/exchange/table.h"
#include "files/files.h"
#include "gws/solution/matsuoka_liu.h"

namespace soilweave::gws {
namespace {

// Pressures of tests, from the weight of some centimetres of soil to that under which grains are crushed to powder, Pa.
constexpr Span possible_pressure{500, 100e6};
// Confining pressures that triaxial tests have, Pa. A table with none of them is doubtful.
constexpr Span usual_pressure{10e3, 10e6};
// Range of the friction angle of granular soils (deg), as in calibration (pipelines/calibration/plausible.py).
constexpr Span friction{22, 55};
// Axial over radial stress of 15, a friction angle of 61 deg, is more than any soil bears.
constexpr double greatest_obliquity = 3 * (15.0 - 1) / (15.0 + 2);
constexpr double greatest_strain = 0.3;

// Reads a table, in which no further column could be meant for one of these.
io::Series read(const std::filesystem::path& path, std::initializer_list<const char*> names,
                std::vector<io::Source>& sources) {
  const io::TextFile text = io::read_text(path, "points");
  sources.push_back(text.source);
  io::Series table = io::from_tsv(text.text, path.string());
  for (const char* name : names)
    if (table.find(name)) io::demand_one(table, name, path.string());
  return table;
}

// Throws DataError for the first row with an impossible pressure.
void judge_pressures(const std::vector<double>& values, const char* name, const std::string& where) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!(values[i] >= possible_pressure.low && values[i] <= possible_pressure.high))
      throw DataError(
          fmt::format("{}: row {}: {} = {:.4g} kPa; must be from {:g} Pa to {:g} MPa: check the unit in the header",
                      where, i + 1, name, values[i] / 1e3, possible_pressure.low, possible_pressure.high / 1e6));
}

}  // namespace

Points compression_points(const std::filesystem::path& path, std::vector<io::Source>& sources) {
  if (path.empty()) return {};
  const io::Series table = read(path, {"mean_stress", "strain_volumetric"}, sources);
  const std::string where = path.string();
  Points points{io::in_unit(table, "mean_stress", "Pa", where), io::in_unit(table, "strain_volumetric", "1", where)};
  judge_pressures(points.x, "mean_stress", where);
  for (std::size_t i = 0; i < points.y.size(); ++i)
    if (!(std::abs(points.y[i]) < greatest_strain))
      throw DataError(
          fmt::format("{}: row {}: strain_volumetric = {:.4g}; must be between -{} and {}: per cent are written "
                      "strain_volumetric [%] in the header",
                      where, i + 1, points.y[i], greatest_strain, greatest_strain));
  if (table.at("strain_volumetric").unit.empty())
    points.doubts.push_back(
        {"compression-points",
         where + ": strain_volumetric has no unit and is taken for a fraction; write [%] or [1] in the header"});
  return points;
}

Points failure_points(const std::filesystem::path& path, bool confined, std::vector<io::Source>& sources) {
  if (path.empty()) return {};
  const io::Series table = read(path, {"confining_pressure", "obliquity_at_failure"}, sources);
  const std::string where = path.string();
  Points points{io::in_unit(table, "confining_pressure", "Pa", where),
                io::in_unit(table, "obliquity_at_failure", "1", where)};
  judge_pressures(points.x, "confining_pressure", where);
  std::string angles;
  for (std::size_t i = 0; i < points.y.size(); ++i) {
    if (!(points.y[i] > 0 && points.y[i] <= greatest_obliquity))
      throw DataError(
          fmt::format("{}: row {}: q/p = {:.4g} under {:.4g} kPa; in compression q/p lies between 0 and {:.2f}: check "
                      "that obliquity_at_failure is q/p, the axial less the radial stress over the mean stress",
                      where, i + 1, points.y[i], points.x[i] / 1e3, greatest_obliquity));
    const double angle = friction_angle(points.y[i]) / degree;
    if (angles.empty() && !(angle >= friction.low && angle <= friction.high))
      angles = fmt::format(
          "row {}: q/p = {:.4g} is a friction angle of {:.3g} deg, where granular soils have {:g} to {:g}: check that "
          "obliquity_at_failure is q/p, neither the sine nor the tangent of that angle",
          i + 1, points.y[i], angle, friction.low, friction.high);
  }
  if (!angles.empty()) points.doubts.push_back({"failure-points", fmt::format("{}: {}", where, angles)});
  if (!points.x.empty() && std::ranges::none_of(points.x, [](double sigma) {
        return sigma >= usual_pressure.low && sigma <= usual_pressure.high;
      }))
    points.doubts.push_back(
        {"failure-pressures",
         fmt::format("{}: all confining pressures lie beyond {:g} kPa to {:g} MPa, the first is {:.4g} kPa: check the "
                     "unit in the header",
                     where, usual_pressure.low / 1e3, usual_pressure.high / 1e6, points.x.front() / 1e3)});
  if (!confined)
    for (std::size_t i = 0; i < points.x.size(); ++i) points.x[i] *= 3 / (3 - points.y[i]);
  return points;
}

}  // namespace soilweave::gws
