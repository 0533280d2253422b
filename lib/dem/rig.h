// What moves the named plates and clamps of a run: displacements at a speed, and loads, which stay until changed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/archive.h"
#include "dem/simulation.h"

namespace soilweave::dem {

/// What one part is asked for along a direction. Where several goals are of one part, its velocities add up.
struct DriveGoal {
  enum class Kind { displacement, load };
  std::string part;
  Kind kind = Kind::displacement;
  Vec3 direction = Vec3::UnitZ();  // unit; a load pushes the grains along it
  double value = 0;                // m since the start of the stage, or N
  double speed = 0;                // m/s, largest
};

/// A plate or clamp that can be driven.
struct RigPart {
  std::string name;
  bool is_clamp = false;
  std::size_t number = 0;  // of the plane or clamp
  double mass = 0;         // kg; 0: massless, carried by its contacts
};

class Rig {
 public:
  Rig() = default;
  explicit Rig(std::vector<RigPart> parts) : parts_(std::move(parts)), states_(parts_.size()) {}

  bool any() const { return !parts_.empty(); }
  /// Displacements count from here.
  void begin_stage();
  /// Sets the velocities of all parts for the next step: goals as given, displacements at this share of their speed,
  /// loads of earlier stages held, the rest at rest.
  void drive(const std::vector<DriveGoal>& goals, double damping, Simulation& simulation, double pace = 1);
  /// Velocity gradient, 1/s, that the displacements on their way ask of the grains between parts that face each other:
  /// two planes, or two clamps. Across a pair the relative velocity is spread evenly. Velocities that no part is told,
  /// along loads and across no pair, are as in `before`.
  Mat3 gradient_of_way(const std::vector<DriveGoal>& goals, double pace, const Mat3& before,
                       const Simulation& simulation) const;
  /// Displacements reached.
  bool moved(const std::vector<DriveGoal>& goals) const;
  /// Displacements reached, and loads, old ones too, met to the tolerance.
  bool arrived(const std::vector<DriveGoal>& goals, double tolerance, const Simulation& simulation) const;
  /// Displacement and force of every part, appended to the series.
  void record(const Simulation& simulation, io::Series& series) const;
  /// The same in brief, as progress shows it: how far each part is, and what the grains press it by.
  std::string text(const Simulation& simulation) const;
  void archive(Archive& archive);

 private:
  struct State {
    Vec3 displacement = Vec3::Zero(), at_start = Vec3::Zero();  // m
    bool loaded = false;
    Vec3 direction = Vec3::Zero();
    double load = 0, speed = 0, velocity = 0;  // N, m/s; velocity: along the direction of the load
  };
  /// Two parts, and how far the second is from the first along the unit vector from one to the other, m.
  struct Facing {
    std::size_t first, second;
    Vec3 across;
    double distance;
  };
  std::vector<Facing> facing(const Simulation& simulation) const;
  std::size_t index(const std::string& name) const;
  bool loaded() const;  // whether some part carries a load
  Vec3 force(std::size_t part, const std::vector<PlateLoad>& plates, const Simulation& simulation) const;
  double load_velocity(std::size_t part, const std::vector<PlateLoad>& plates, double damping,
                       const Simulation& simulation);

  std::vector<RigPart> parts_;
  std::vector<State> states_;
};

/// Whether planes with these normals face each other.
bool face_each_other(const Vec3& one, const Vec3& other);

/// Appends a value to the named column, which is made where it is missing.
void append(io::Series& series, const std::string& name, const std::string& unit, const std::string& long_name,
            double value);

}  // namespace soilweave::dem
