// A loading path: stations to be reached one after the other, and what each axis is asked for on the way.
// A new path is one file in paths/ and one line in the list of path.cpp.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/settings.h"
#include "dem/control.h"
#include "dem/rig.h"

namespace soilweave::dem {

/// What a path may look at when it sets goals.
struct PathState {
  int dimension;
  Mat3 stress;  // Pa, compression positive
  Vec3 strain;  // natural, since the start of the stage
};

class Path {
 public:
  virtual ~Path() = default;
  virtual std::size_t stations() const = 0;
  /// Goals on the way to a station (0 to stations() - 1); strains count from the start of the stage.
  virtual AxisGoals goals(std::size_t station, const PathState& state) const = 0;
  /// What plates and clamps are asked for on the way to a station.
  virtual std::vector<DriveGoal> drives(std::size_t) const { return {}; }
  /// The strain that names a station, where the cell's own does not.
  virtual double nominal_strain(std::size_t) const { return std::numeric_limits<double>::quiet_NaN(); }
};

/// Loading axis: the last one of the space.
inline int loading_axis(int dimension) { return dimension - 1; }

/// Keys most paths share.
struct StrainStations {
  std::vector<double> strain;  // natural, compression positive, ascending in the loading's direction
  double rate;                 // 1/s, largest
};

/// axial_strain, increment (or an explicit list `stations`), rate.
StrainStations read_strain_stations(Settings& table);
/// Strains from 0 to `end`, 0 left out and `end` taken in, `step` apart. More than a million are a mistake of the
/// table's key `increment`.
std::vector<double> stations_every(double step, double end, Settings& table);
/// max_rate of the stress-controlled axes, 1/s.
double read_max_rate(Settings& table);
/// A pressure-like key.
double read_stress(Settings& table, std::string_view key, std::string_view sentence);

std::vector<std::string> path_names();
/// Throws nothing itself: mistakes are collected in the table's document.
std::unique_ptr<Path> read_path(const std::string& name, Settings& table);

}  // namespace soilweave::dem
