// Input of a simulation: materials, and the numerical settings of the steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/tensor.h"
#include "dem/contact/materials.h"
#include "dem/contact/wire.h"

namespace soilweave::dem {

/// Contact law with its materials, indexed by material_id, planes included.
struct Model {
  /// Materials of one law.
  Materials materials;
  /// Curves by geotextile_id.
  std::vector<WireCurve> geotextiles = {};
};

/// Limits beyond which a simulation counts as broken.
struct Limits {
  /// Overlap of two grains over the smaller radius.
  double overlap = 0.5;
  /// Error of the energy balance over the energy turned over.
  double energy_error = 0.1;
  /// Distance of a grain beyond the initial box of grains and planes along an open axis, over the diagonal of that box
  /// plus the largest diameter.
  double escape = 2;
};

/// Numerical settings of the steps.
struct Numerics {
  /// Cundall's local non-viscous damping, 0 to 1.
  double damping = 0.2;
  /// Fraction of the stability limit from the present stiffness.
  double time_step_safety = 0.8;
  /// Fixed time step, s; replaces the estimate.
  std::optional<double> time_step;
  /// Whether steps evaluate the stiffness. May be false if the time step is fixed and no servo drives the cell.
  bool watch_stiffness = true;
  /// Acceleration of gravity, m/s2.
  Vec3 gravity = Vec3::Zero();
  /// Limits of the guards.
  Limits limits;
  /// Grains of each clamp.
  std::vector<std::vector<std::int32_t>> clamps = {};
  /// Number of threads.
  int threads = 1;
};

}  // namespace soilweave::dem
