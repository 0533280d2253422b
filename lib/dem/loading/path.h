// A loading path: a sequence of stations with goals. A new path is one file in paths/.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/settings.h"
#include "dem/loading/control.h"
#include "dem/loading/rig.h"

namespace soilweave::dem {

/// Present state, from which a path may compute its goals.
struct PathState {
  /// Dimension of the space, 2 or 3.
  int dimension;
  /// Stress, Pa, compression positive.
  Mat3 stress;
  /// Natural strain since the start of the stage.
  Vec3 strain;
};

/// Plates that a path moves towards each other along z.
struct Between {
  /// Names of the plates.
  std::string lower, upper;
  /// Height that strains refer to, m.
  double height;
};

/// A loading path. Goals depend only on the station and the state.
class Path {
 public:
  virtual ~Path() = default;
  /// Returns the number of stations.
  virtual std::size_t stations() const = 0;
  /// Returns the goals of the cell's axes for `station`, counted from 0. Strains count from the start of the stage.
  virtual AxisGoals goals(std::size_t station, const PathState& state) const = 0;
  /// Returns the goals of plates and clamps for a station.
  virtual std::vector<DriveGoal> drives(std::size_t) const { return {}; }
  /// Returns the two plates between which the path compresses the grains, if any.
  virtual std::optional<Between> between() const { return std::nullopt; }
  /// Returns the smallest dimension of the space, 2 or 3, that the path can load.
  virtual int least_dimension() const { return 2; }
  /// Returns the strain by which snapshots select a station; NaN: the strain of the cell.
  virtual double nominal_strain(std::size_t) const { return std::numeric_limits<double>::quiet_NaN(); }
};

/// Returns the loading axis: the last axis of the space.
inline int loading_axis(int dimension) { return dimension - 1; }

/// Keys that most paths share.
struct StrainStations {
  /// Natural strains, compression positive, monotonic in the loading direction.
  std::vector<double> strain;
  /// Greatest rate, 1/s.
  double rate;
};

/// Reads axial_strain and increment, or an explicit list `stations`, and rate.
StrainStations read_strain_stations(Settings& table);
/// Returns strains at multiples of `step`, the last one `end`. Reports a mistake if they are more than a million, or if
/// a step of 5 % or more is beyond `end`, since it is likelier meant in per cent.
std::vector<double> stations_every(double step, double end, Settings& table);
/// Reads max_rate of the stress-controlled axes, 1/s.
double read_max_rate(Settings& table);
/// Reads a stress, Pa.
double read_stress(Settings& table, std::string_view key, std::string_view sentence);

/// Mistake of a key that gives the value at the start of a stage that goes to its end in one part.
inline constexpr std::string_view begins_in_parts =
    "has no effect with parts = 1, which goes to the end at once: give parts of 2 or more, or leave it out";

/// Returns the names of all paths, for scenarios.
std::vector<std::string> path_names();
/// Reads the path `name`. Mistakes are collected in the table's document.
std::unique_ptr<Path> read_path(const std::string& name, Settings& table);

}  // namespace soilweave::dem
