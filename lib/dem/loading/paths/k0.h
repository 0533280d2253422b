// K0 (one-dimensional) compression: axial stress in stations, no lateral strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "dem/loading/path.h"

namespace soilweave::dem {

/// Axial stresses in stations; the lateral strain goal is zero.
class K0 final : public Path {
 public:
  /// Name in scenarios.
  static constexpr std::string_view name = "k0";
  /// Reads the axial stresses and the greatest rate.
  static K0 read(Settings& table) {
    static constexpr Parameter stresses{"axial_stress",
                                        "Pa",
                                        0,
                                        1e12,
                                        true,
                                        "axial stresses to reach, one after the other",
                                        "a packing of dry grains carries no tension"};
    return {table.numbers(stresses), read_max_rate(table)};
  }

  /// Takes the axial stresses, Pa, and the greatest rate, 1/s.
  K0(std::vector<double> axial_stress, double max_rate) : axial_stress_(std::move(axial_stress)), max_rate_(max_rate) {}
  std::size_t stations() const override { return axial_stress_.size(); }
  AxisGoals goals(std::size_t station, const PathState& state) const override {
    AxisGoals goals;
    for (std::size_t a = 0; a < 3; ++a) goals[a] = {AxisGoal::Kind::strain, 0.0, max_rate_};
    goals[static_cast<std::size_t>(loading_axis(state.dimension))] = {AxisGoal::Kind::stress, axial_stress_[station],
                                                                      max_rate_};
    return goals;
  }

 private:
  /// Axial stress at each station, Pa.
  std::vector<double> axial_stress_;
  /// Greatest strain rate, 1/s.
  double max_rate_;
};

}  // namespace soilweave::dem
