// Drives the named plates and clamps of a run by displacements and loads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/archive.h"
#include "dem/engine/simulation.h"

namespace soilweave::dem {

/// Goal of one part along one direction. Velocities of several goals add up.
struct DriveGoal {
  /// Quantity that the part is driven to.
  enum class Kind { displacement, load };
  /// Name of the plate or clamp.
  std::string part;
  Kind kind = Kind::displacement;
  /// Unit vector along which the part moves, or a load pushes the grains.
  Vec3 direction = Vec3::UnitZ();
  /// Displacement since the start of the stage, m, or load, N.
  double value = 0;
  /// Greatest speed, m/s.
  double speed = 0;
};

/// A plate or clamp that can be driven.
struct RigPart {
  /// Name in the scenario.
  std::string name;
  /// Whether the part is a clamp; otherwise it is a plate.
  bool is_clamp = false;
  /// Index of the plane or clamp.
  std::size_t number = 0;
  /// Mass, kg; 0: massless, carried by its contacts.
  double mass = 0;
};

/// Cosine between a move and a load above which the move replaces the load.
inline constexpr double along_load = 0.5;

/// All named plates and clamps of a run.
class Rig {
 public:
  Rig() = default;
  /// Takes the parts of a scenario, all at rest.
  explicit Rig(std::vector<RigPart> parts) : parts_(std::move(parts)), states_(parts_.size()) {}

  /// Returns whether there are any parts.
  bool any() const { return !parts_.empty(); }
  /// Makes displacements count from here.
  void begin_stage();
  /// Sets the velocities of all parts for the next step. Loads of earlier stages are held. Other parts rest.
  /// pace: share of the greatest speed at which displacements are approached.
  void drive(const std::vector<DriveGoal>& goals, double damping, Simulation& simulation, double pace = 1);
  /// Returns the velocity gradient (1/s) that the prescribed displacements impose between facing planes or clamps.
  /// The relative velocity of a facing pair is spread evenly. Other elements stay as in `before`.
  Mat3 gradient_of_way(const std::vector<DriveGoal>& goals, double pace, const Mat3& before,
                       const Simulation& simulation) const;
  /// Returns whether all displacements are reached.
  bool moved(const std::vector<DriveGoal>& goals) const;
  /// Returns whether all displacements are reached and all loads, also earlier ones, are within the tolerance.
  bool arrived(const std::vector<DriveGoal>& goals, double tolerance, const Simulation& simulation) const;
  /// Names one part that has not arrived, with a remedy; empty if all have arrived.
  std::string late_part(const std::vector<DriveGoal>& goals, double tolerance, const Simulation& simulation) const;
  /// Appends displacement and force of every part to the series.
  void record(const Simulation& simulation, io::Series& series) const;
  /// Returns displacement and force of every part in brief, for progress.
  std::string text(const Simulation& simulation) const;
  /// Keeps or restores displacements, loads and velocities.
  void archive(Archive& archive);

 private:
  /// Present state of one part.
  struct State {
    /// Displacement now and at the start of the stage, m.
    Vec3 displacement = Vec3::Zero(), at_start = Vec3::Zero();
    /// Whether the part carries a load.
    bool loaded = false;
    /// Unit vector of the load.
    Vec3 direction = Vec3::Zero();
    /// Load, N; greatest speed and velocity along the load, m/s.
    double load = 0, speed = 0, velocity = 0;
  };
  /// Two facing parts.
  struct Facing {
    std::size_t first, second;
    /// Unit vector from the first towards the second.
    Vec3 across;
    /// Distance along `across`, m.
    double distance;
  };
  /// Returns all pairs of facing parts.
  std::vector<Facing> facing(const Simulation& simulation) const;
  /// Returns the index of a part by its name. Throws DataError if there is none.
  std::size_t index(const std::string& name) const;
  /// Whether a part carries a load.
  bool loaded() const;
  /// Returns the force of the grains on a part, N.
  Vec3 force(std::size_t part, const std::vector<PlateLoad>& plates, const Simulation& simulation) const;
  /// Returns the velocity, m/s, with which a part follows its load.
  double load_velocity(std::size_t part, const std::vector<PlateLoad>& plates, double damping,
                       const Simulation& simulation);

  std::vector<RigPart> parts_;
  std::vector<State> states_;
};

/// Returns whether planes with these normals face each other.
bool face_each_other(const Vec3& one, const Vec3& other);

/// Appends a value to the named column, and makes a missing column.
void append(io::Series& series, const std::string& name, const std::string& unit, const std::string& long_name,
            double value);

}  // namespace soilweave::dem
