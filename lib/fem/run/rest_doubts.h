// Doubts about the rest of the soil at the end of a two-scale run.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "fem/run/scenario.h"

namespace soilweave::fem {

/// Forces on the soil's nodes that do not balance.
struct OutOfBalance {
  /// Tractions and interface forces less internal forces, N/m per node; 0 along held axes.
  std::vector<Vec2> forces;
  /// Sum of the magnitudes of the internal forces, N/m.
  double internal = 0;
};
/// Returns the present forces that do not balance. Throws PhysicsError naming a degenerate element.
OutOfBalance out_of_balance(const ModelSetup& setup, const Model& model);

/// Returns "unrest" if supports and chain ends stand still and the soil moves about its rest by more than a twentieth
/// of the change that its loads cause. An undamped oscillator of stiffness k under a sudden force F has the amplitude A
/// F/k in every phase, with A^2 = (r/F)^2 + 2 K/W: r is the force out of balance, K the kinetic energy, W the work of
/// F. start: the forces before the first step. said: doubts so far, some of which explain the motion. Returns "inertia"
/// if supports or chain ends drive the soil without [quasi_static], and a fifth of its internal forces is out of
/// balance: forces of inertia and damping, which a slower drive does not have.
std::vector<Doubt> rest_doubts(const Scenario& scenario, const Model& model, const OutOfBalance& start,
                               const std::vector<Doubt>& said);

}  // namespace soilweave::fem
