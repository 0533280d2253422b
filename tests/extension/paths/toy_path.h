// A loading path from outside the library: an isotropic pressure under a key of its own.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/loading/path.h"

namespace soilweave::dem {

/// One station at which every axis has the pressure.
class ToyPath final : public Path {
 public:
  static constexpr std::string_view name = "toy-path";
  static ToyPath read(Settings& table) { return ToyPath(read_stress(table, "toy_pressure", "pressure of the toy")); }

  explicit ToyPath(double pressure) : pressure_(pressure) {}
  std::size_t stations() const override { return 1; }
  AxisGoals goals(std::size_t, const PathState&) const override {
    const AxisGoal all{AxisGoal::Kind::stress, pressure_, 1.0};
    return {all, all, all};
  }

 private:
  double pressure_;
};

}  // namespace soilweave::dem
