// Moves and loads of plates and clamps: [[stage.move]] and [[stage.load]].
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "dem/loading/path.h"

namespace soilweave::dem {

/// Moves and loads of named plates and clamps, approached in equal increments.
class Drive final : public Path {
 public:
  /// Name in scenarios.
  static constexpr std::string_view name = "drive";
  /// Reads the number of increments (`parts`), and the tables `load` and `move`.
  static Drive read(Settings& table) {
    static constexpr Parameter parts{"parts", "1", 1, 1e6, false, "number of equal increments of moves and loads"};
    static constexpr Parameter along{"along", "1", -1, 1, false, "direction"};
    static constexpr Parameter distance{"distance", "m", -1e3, 1e3, false, "displacement over the stage"};
    static constexpr Parameter force{"force", "N", 0, 1e15, false, "load on the grains along the direction"};
    static constexpr Parameter from{"force_from", "N", 0, 1e15, false, "load at the start, approached from there"};
    static constexpr Parameter speed{"speed", "m/s", 0, 1e3, true, "largest speed"};
    Drive path;
    path.parts_ = static_cast<std::size_t>(table.integer(parts, 1));
    const auto take = [&](Settings& entry, DriveGoal::Kind kind, const Parameter& value) {
      Goal goal;
      goal.end.part = entry.text({"part", "name of the plane or clamp"});
      goal.end.kind = kind;
      const Vec3 direction = entry.vector(along);
      if (direction.norm() == 0) entry.mistake("along", "is zero: give a direction");
      goal.end.direction = direction.normalized();
      goal.end.value = entry.number(value);
      goal.end.speed = entry.number(speed);
      goal.start = kind == DriveGoal::Kind::load ? entry.number(from, goal.end.value) : 0.0;
      if (kind == DriveGoal::Kind::load && entry.has(from.name) && path.parts_ == 1)
        entry.mistake(from.name, begins_in_parts);
      path.goals_.push_back(goal);
    };
    for (Settings entry : table.tables("load")) take(entry, DriveGoal::Kind::load, force);
    for (Settings entry : table.tables("move")) take(entry, DriveGoal::Kind::displacement, distance);
    return path;
  }

  std::size_t stations() const override { return parts_; }
  int least_dimension() const override {
    const auto leaves_plane = [](const Goal& goal) { return goal.end.direction.z() != 0; };
    return std::any_of(goals_.begin(), goals_.end(), leaves_plane) ? 3 : 2;
  }
  AxisGoals goals(std::size_t, const PathState&) const override { return {}; }
  std::vector<DriveGoal> drives(std::size_t station) const override {
    const double share = static_cast<double>(station + 1) / static_cast<double>(parts_);
    std::vector<DriveGoal> now;
    for (const Goal& goal : goals_) {
      now.push_back(goal.end);
      if (station + 1 < parts_) now.back().value = goal.start + share * (goal.end.value - goal.start);
    }
    return now;
  }

 private:
  /// Goal at the end, and the load at the start, N.
  struct Goal {
    DriveGoal end;
    double start = 0;
  };
  std::size_t parts_ = 1;
  std::vector<Goal> goals_;
};

}  // namespace soilweave::dem
