// What the grains are made of and how the steps are taken: the inputs of a simulation.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/tensor.h"
#include "dem/laws.h"
#include "dem/wire.h"

namespace soilweave::dem {

/// The contact law and its material parameters; `materials` is indexed by material_id, planes included.
/// One alternative per registered law (laws.h).
struct Model {
  AnyMaterials materials;  // std::variant<std::vector<HertzMindlin::Material>, std::vector<Linear::Material>>
  std::vector<WireCurve> geotextiles = {};  // by geotextile_id
};

/// Beyond what a simulation counts as broken.
struct Limits {
  double overlap = 0.5;       // of two grains, over the smaller radius
  double energy_error = 0.1;  // of the energy turned over
  double escape = 2;          // of the extent of grains and planes at the start, out of it along an axis that is open
};

struct Numerics {
  double damping = 0.2;             // Cundall's local non-viscous damping, 0 to 1
  double time_step_safety = 0.8;    // fraction of the stability limit from the present stiffness
  std::optional<double> time_step;  // s, fixed; overrides the estimate
  bool watch_stiffness = true;      // to be left out where the time step is fixed and no servo drives the cell
  Vec3 gravity = Vec3::Zero();      // m/s2
  Limits limits;
  std::vector<std::vector<std::int32_t>> clamps = {};  // grains of each; a clamped grain moves as it is told
  int threads = 1;
};

}  // namespace soilweave::dem
