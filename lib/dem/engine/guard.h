// Notices when physics breaks, and says where and why: cheap things at every step, what takes a pass over the grains
// now and then.
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

/// Guards of one simulation, with the limits of its numerics.
class Guard {
 public:
  /// Takes the limits, and the extent of grains and planes at the start. range: the largest gap across which contacts
  /// act, m. Throws DataError for a range with which grains would feel two images of one partner.
  Guard(const Numerics& numerics, const Bodies& bodies, const Cell& cell, const Planes& planes, double range);

  // All functions throw PhysicsError with step, body or axis, numbers, and likely cause.

  /// Checks that every number of the state is finite. `force`: a sum over all contact forces. `spent`: the energy that
  /// damping took in this step. A NaN in any velocity makes it a NaN, so that two sums stand for all grains.
  void finite(std::int64_t step, const Bodies& bodies, double force, double spent) const;
  /// Throws for a contact that is too deep. deepest: its name, "grains 3 and 5 overlap by ..."
  [[noreturn]] void too_deep(std::int64_t step, const std::string& deepest, double unbalanced_force,
                             const Measures& measures) const;
  /// Checks that no grain spans half the cell along a periodic axis, the gaps across which it acts included.
  void room(std::int64_t step, const Cell& cell) const;
  /// Checks the energy balance. The energies must be those of this moment (Energies::at).
  void balance(std::int64_t step, const Energies& energies) const;
  /// Checks that no grain left through an open side. Planes hold grains back only where they are.
  void escape(std::int64_t step, const Bodies& bodies) const;

  /// Keeps or restores the positions that grains may reach.
  void archive(Archive& archive) { archive.item("guard_low", low_), archive.item("guard_high", high_); }

 private:
  std::string lower_step() const;

  /// Limits beyond which physics counts as broken.
  Limits limits_;
  /// Whether the time step is fixed.
  bool fixed_step_;
  /// Largest diameter, m.
  double largest_;
  /// Largest gap across which contacts act, m.
  double range_;
  /// Axes along which a grain may leave.
  std::array<bool, 3> open_{};
  /// Farthest allowed positions, m.
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();
  int dimension_;
};

}  // namespace soilweave::dem
