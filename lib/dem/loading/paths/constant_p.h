// Axial strain in stations at constant mean stress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/loading/path.h"

namespace soilweave::dem {

/// Shear at constant p: the lateral stress falls as the axial stress rises.
class ConstantP final : public Path {
 public:
  /// Name in scenarios.
  static constexpr std::string_view name = "constant-p";
  /// Reads the mean stress, the greatest rate, and the stations.
  static ConstantP read(Settings& table) {
    const double p = read_stress(table, "mean_stress", "mean stress held during loading");
    return {p, read_max_rate(table), read_strain_stations(table)};
  }

  /// Takes the mean stress, Pa, the greatest lateral rate, 1/s, and the stations.
  ConstantP(double mean_stress, double max_rate, StrainStations axial)
      : mean_stress_(mean_stress), max_rate_(max_rate), axial_(std::move(axial)) {}
  std::size_t stations() const override { return axial_.strain.size(); }
  AxisGoals goals(std::size_t station, const PathState& state) const override {
    const int axis = loading_axis(state.dimension);
    const double lateral_stress = (state.dimension * mean_stress_ - state.stress(axis, axis)) / (state.dimension - 1);
    // A tensile goal would open the cell. A lateral stress at this bound no longer holds p.
    const AxisGoal lateral{AxisGoal::Kind::stress, std::max(lateral_stress, 1e-3 * mean_stress_), max_rate_};
    AxisGoals goals = {lateral, lateral, lateral};
    goals[static_cast<std::size_t>(axis)] = {AxisGoal::Kind::strain, axial_.strain[station], axial_.rate};
    return goals;
  }

 private:
  /// Mean stress, Pa, and greatest lateral rate, 1/s.
  double mean_stress_, max_rate_;
  StrainStations axial_;
};

}  // namespace soilweave::dem
