// Friction between soil and a flat geotextile in a shear box.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/interface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/tables/tables.h"
#include "core/error.h"
#include "core/text/settings.h"

namespace soilweave::analysis {
namespace {

/// Returns the displacements (m) or forces (N) of planes in a row, summed over the planes.
Vec3 sum(const io::Series& run, const char* what, const std::vector<std::string>& planes, std::size_t row) {
  Vec3 total = Vec3::Zero();
  for (const std::string& name : planes)
    for (int a = 0; a < 3; ++a) total[a] += run.at(std::string(what) + "_" + name + "_" + "xyz"[a]).values[row];
  return total;
}

}  // namespace

ShearBox shear_box(const io::RunFile& run, const std::string& where) {
  if (run.series.rows() == 0)
    throw DataError(where + ": has no series: it is a packing, not a run; load it by run-dem");
  const io::Snapshot& start = run.snapshots.front();
  if (start.yarns.size() == 0) throw DataError(where + ": has no geotextile for soil to slide on");
  Settings scenario = Settings::parse(run.scenario, where + ": scenario");
  std::vector<Settings> planes = scenario.tables("plane");
  ShearBox box;
  for (std::size_t k = 0; k < planes.size() && k < start.planes.partners.size(); ++k) {
    if (!planes[k].has("name") || start.planes.partners[k] != 1) continue;
    box.planes.push_back(planes[k].text("name"));
    if (start.planes.normal[k].normalized().z() < -0.5) box.lids.push_back(box.planes.back());
  }
  if (box.lids.empty() || box.planes.size() == box.lids.size())
    throw DataError(where +
                    ": has no shear box: give the walls and the lid around the soil names and partners = \"soil\"");
  return box;
}

io::Series interface(const io::Series& run, const ShearBox& box) {
  const auto way = [&](const std::string& plane, std::size_t i) -> Vec2 {
    return sum(run, "displacement", {plane}, i).head<2>();
  };
  // Plane with the greatest displacement.
  std::string foremost = box.planes.front();
  Vec2 farthest(0, 0);
  for (const std::string& plane : box.planes)
    for (std::size_t i = 0; i < run.rows(); ++i)
      if (way(plane, i).norm() > farthest.norm()) farthest = way(plane, i), foremost = plane;
  const Vec2 along = farthest.norm() > 0 ? Vec2(farthest.normalized()) : Vec2(1, 0);
  io::Series table;
  for (std::size_t i = 0; i < run.rows(); ++i) {
    for (const char* name : {"step", "time", "stage"})
      put(table, name, run.at(name).unit, run.at(name).long_name, run.at(name).values[i]);
    const double shear = 0.0 - sum(run, "force", box.planes, i).head<2>().dot(along);
    const double normal = sum(run, "force", box.lids, i).z();
    put(table, "travel", "m", "displacement of the plane with the largest horizontal travel",
        way(foremost, i).dot(along));
    put(table, "shear_force", "N", "force of the planes on the soil along that travel, which the geotextile resists",
        shear);
    put(table, "normal_force", "N", "force of the soil on the lid", normal);
    put(table, "friction_angle", "deg", "angle whose tangent is the shear force over the normal force",
        normal > 0 ? std::atan2(shear, normal) * 180 / std::numbers::pi : std::nan(""));
  }
  return table;
}

}  // namespace soilweave::analysis
