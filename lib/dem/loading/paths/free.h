// Any combination of stress and strain goals, axis by axis, approached in equal steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include "core/text/beside.h"
#include "dem/loading/path.h"

namespace soilweave::dem {

/// Goals given for each axis.
class Free final : public Path {
 public:
  /// Name in scenarios.
  static constexpr std::string_view name = "free";
  /// Reads [stage.x], [stage.y], [stage.z]: `stress` (held, or ramped from `stress_from`) or `strain`, and `max_rate`.
  /// `parts`: number of equal parts of strains and ramps.
  static Free read(Settings& table) {
    static constexpr Parameter count{"parts", "1", 1, 1e6, false, "number of equal increments towards the goals"};
    static constexpr Parameter strain{"strain", "1", -2, 2, false, "natural strain of the stage, compression positive"};
    static constexpr Parameter from{"stress_from", "Pa", 0, 1e12, false, "stress at the start of the stage"};
    Free path;
    path.parts_ = static_cast<std::size_t>(table.integer(count, 1));
    for (std::size_t a = 0; a < 3; ++a) {
      static constexpr std::array<std::string_view, 3> names = {"x", "y", "z"};
      if (a == 2 && !table.has("z")) continue;
      Settings axis = table.table(names[a]);
      Axis& goal = path.axes_[a];
      goal.end.max_rate = read_max_rate(axis);
      if (axis.has("stress")) {
        refuse_beside(axis, "stress", {strain.name});
        goal.end.kind = AxisGoal::Kind::stress;
        goal.end.value = read_stress(axis, "stress", "stress at the end");
        goal.start = axis.number(from, goal.end.value);
        if (axis.has(from.name) && path.parts_ == 1) axis.mistake(from.name, begins_in_parts);
      } else {
        goal.end.value = axis.number(strain, 0.0);
        goal.start = 0.0;
      }
    }
    return path;
  }

  std::size_t stations() const override { return parts_; }
  int least_dimension() const override {
    const AxisGoal& z = axes_[2].end;
    return z.kind == AxisGoal::Kind::stress || z.value != 0 ? 3 : 2;
  }
  AxisGoals goals(std::size_t station, const PathState&) const override {
    const double share = static_cast<double>(station + 1) / static_cast<double>(parts_);
    AxisGoals goals;
    for (std::size_t a = 0; a < 3; ++a) {
      goals[a] = axes_[a].end;
      goals[a].value =
          station + 1 == parts_ ? axes_[a].end.value : axes_[a].start + share * (axes_[a].end.value - axes_[a].start);
    }
    return goals;
  }

 private:
  /// Goal at the end, and the stress at the start, Pa.
  struct Axis {
    AxisGoal end;
    double start = 0;
  };
  std::array<Axis, 3> axes_;
  std::size_t parts_ = 1;
};

}  // namespace soilweave::dem
