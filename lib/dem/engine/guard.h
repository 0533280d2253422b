// Notices when physics breaks, and says where and why.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/archive.h"
#include "dem/contact/model.h"
#include "dem/engine/simulation.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"
#include "dem/state/plane.h"

namespace soilweave::dem {

/// Guards of one simulation. They throw PhysicsError with step, body or axis, numbers, and likely cause.
class Guard {
 public:
  /// Takes the limits, and the extent of grains and planes at the start.
  /// `range`: largest gap across which contacts act, m.
  /// Throws DataError if a grain could act across this gap on two images of one grain.
  Guard(const Numerics& numerics, const Bodies& bodies, const Cell& cell, const Planes& planes, double range);

  /// Checks that every number of the state is finite.
  /// `force`: a sum over all contact forces. `spent`: energy taken by damping, J; it is NaN if any velocity is NaN.
  void finite(std::int64_t step, const Bodies& bodies, double force, double spent) const;
  /// Throws for a contact that is too deep. `deepest`: the contact in words (overlap.h).
  [[noreturn]] void too_deep(std::int64_t step, const std::string& deepest, double unbalanced_force,
                             const Measures& measures) const;
  /// Checks that no grain, its range included, spans half the cell along a periodic axis.
  void room(std::int64_t step, const Cell& cell) const;
  /// Checks the energy balance. The energies must be those of this moment (Energies::at).
  void balance(std::int64_t step, const Energies& energies) const;
  /// Checks that no grain left through an open side.
  void escape(std::int64_t step, const Bodies& bodies) const;

  /// Keeps or restores the positions that grains may reach.
  void archive(Archive& archive) { archive.item("guard_low", low_), archive.item("guard_high", high_); }

 private:
  /// Returns the advice to lower the time step.
  std::string lower_step() const;

  /// Limits beyond which physics counts as broken.
  Limits limits_;
  /// Whether the time step is fixed.
  bool fixed_step_;
  /// Largest diameter, m.
  double largest_;
  /// Largest gap across which contacts act, m.
  double range_;
  /// Whether there are planes.
  bool planes_ = false;
  /// Axes along which a grain may leave.
  std::array<bool, 3> open_{};
  /// Farthest allowed positions, m.
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
  /// Dimension of the space, 2 or 3.
  int dimension_;
};

}  // namespace soilweave::dem
