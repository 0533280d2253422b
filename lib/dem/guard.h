// Notices when physics breaks, and says where and why: cheap things at every step, what takes a pass over the grains
// now and then.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/archive.h"
#include "dem/bodies.h"
#include "dem/cell.h"
#include "dem/model.h"
#include "dem/plane.h"
#include "dem/simulation.h"

namespace soilweave::dem {

class Guard {
 public:
  Guard(const Numerics& numerics, const Bodies& bodies, const Cell& cell, const Planes& planes);

  // All throw PhysicsError: step, body or axis, numbers, likely cause.

  /// Every number of the state is finite. force: sum over the contacts; spent: what damping took, which no grain with a
  /// velocity that is none leaves finite.
  void finite(std::int64_t step, const Bodies& bodies, double force, double spent) const;
  /// A contact is deeper than it may be. deepest: names it, "grains 3 and 5 overlap by ..."
  [[noreturn]] void too_deep(std::int64_t step, const std::string& deepest, double unbalanced_force,
                             const Measures& measures) const;
  /// No grain spans half the cell along a periodic axis.
  void room(std::int64_t step, const Cell& cell) const;
  /// Energy is neither created nor lost, kinetic energy being that of the moment.
  void balance(std::int64_t step, const Energies& energies) const;
  /// No grain left through an open side: planes guard it only where they are.
  void escape(std::int64_t step, const Bodies& bodies) const;

  void archive(Archive& archive) { archive.item("guard_low", low_), archive.item("guard_high", high_); }

 private:
  std::string lower_step() const;

  Limits limits_;
  bool fixed_step_;
  double largest_;                                 // m, diameter
  std::array<bool, 3> open_{};                     // axes along which a grain may leave
  Vec3 low_ = Vec3::Zero(), high_ = Vec3::Zero();  // m, how far it may go
  int dimension_;
};

}  // namespace soilweave::dem
