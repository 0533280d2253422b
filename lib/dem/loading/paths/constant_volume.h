// Undrained loading: axial strain in stations at constant volume.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/loading/path.h"

namespace soilweave::dem {

/// Undrained shear of a periodic cell.
class ConstantVolume final : public Path {
 public:
  /// Name in scenarios.
  static constexpr std::string_view name = "constant-volume";
  /// Reads the stations of axial strain.
  static ConstantVolume read(Settings& table) { return ConstantVolume(read_strain_stations(table)); }

  explicit ConstantVolume(StrainStations axial) : axial_(std::move(axial)) {}
  std::size_t stations() const override { return axial_.strain.size(); }
  /// Returns goals of all axes in proportion, so that every step keeps the volume.
  AxisGoals goals(std::size_t station, const PathState& state) const override {
    const double share = 1.0 / (state.dimension - 1);
    const double goal = axial_.strain[station];
    const AxisGoal lateral{AxisGoal::Kind::strain, -share * goal, share * axial_.rate};
    AxisGoals goals = {lateral, lateral, lateral};
    goals[static_cast<std::size_t>(loading_axis(state.dimension))] = {AxisGoal::Kind::strain, goal, axial_.rate};
    return goals;
  }

 private:
  StrainStations axial_;
};

}  // namespace soilweave::dem
