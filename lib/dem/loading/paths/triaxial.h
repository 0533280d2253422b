// Drained triaxial loading (biaxial in 2D): axial strain in stations, lateral stress held.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/loading/path.h"

namespace soilweave::dem {

/// Drained compression or extension at constant lateral stress.
class Triaxial final : public Path {
 public:
  /// Name in scenarios.
  static constexpr std::string_view name = "triaxial";
  /// Reads the lateral stress, the greatest rate, and the stations.
  static Triaxial read(Settings& table) {
    const double confining = read_stress(table, "confining_pressure", "lateral stress");
    return {confining, read_max_rate(table), read_strain_stations(table)};
  }

  /// Takes the lateral stress, Pa, the greatest lateral rate, 1/s, and the stations.
  Triaxial(double confining_pressure, double max_rate, StrainStations axial)
      : confining_pressure_(confining_pressure), max_rate_(max_rate), axial_(std::move(axial)) {}
  std::size_t stations() const override { return axial_.strain.size(); }
  AxisGoals goals(std::size_t station, const PathState& state) const override {
    const AxisGoal lateral{AxisGoal::Kind::stress, confining_pressure_, max_rate_};
    AxisGoals goals = {lateral, lateral, lateral};
    goals[static_cast<std::size_t>(loading_axis(state.dimension))] = {AxisGoal::Kind::strain, axial_.strain[station],
                                                                      axial_.rate};
    return goals;
  }

 private:
  /// Lateral stress, Pa, and greatest rate, 1/s.
  double confining_pressure_, max_rate_;
  StrainStations axial_;
};

}  // namespace soilweave::dem
