// Isotropic compression: the same stress on every axis.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/loading/path.h"

namespace soilweave::dem {

/// One station at which every axis has the pressure.
class Isotropic final : public Path {
 public:
  /// Name in scenarios.
  static constexpr std::string_view name = "isotropic";
  /// Reads the pressure and the greatest rate.
  static Isotropic read(Settings& table) {
    return {read_stress(table, "pressure", "mean stress"), read_max_rate(table)};
  }

  /// Takes the pressure, Pa, and the greatest rate, 1/s.
  Isotropic(double pressure, double max_rate) : pressure_(pressure), max_rate_(max_rate) {}
  std::size_t stations() const override { return 1; }
  AxisGoals goals(std::size_t, const PathState&) const override {
    const AxisGoal all{AxisGoal::Kind::stress, pressure_, max_rate_};
    return {all, all, all};
  }

 private:
  /// Pressure, Pa, and greatest rate, 1/s.
  double pressure_, max_rate_;
};

}  // namespace soilweave::dem
