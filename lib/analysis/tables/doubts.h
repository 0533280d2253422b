// Doubts about a packing, a bag or a run that was made as told: numbers with their thresholds and remedies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/run/scenario.h"
#include "files/files.h"

namespace soilweave::analysis {

/// Returns doubts about any packing at rest: "cell-over-grain" if the cell is narrower than 4 diameters of the largest
/// grain along a periodic axis.
std::vector<Doubt> cell_doubts(const io::Snapshot& state);

/// Returns doubts about an isotropically compressed packing at rest: "rattlers" (share of grains outside the backbone
/// of Coordination), "coordination" (2 Nc/N) and "isotropy" (q/p). Empty for grains without contacts.
std::vector<Doubt> compaction_doubts(const io::Snapshot& state);

/// Returns doubts about a bag: "outside" if grains have left it, "preload" if hardly any yarn is taut. Empty for a
/// state without yarns or soil.
std::vector<Doubt> bag_doubts(const io::Snapshot& state);

/// Returns the inertial number of a strain rate, rate * d * sqrt(rho / p), with the mean diameter d (m), the density
/// rho in the equations of motion (kg/m3, scaling included) and the mean stress p (Pa). da Cruz et al. (2005).
double inertial_number(double rate, double diameter, double density, double pressure);

/// Returns the doubts that the input of a run raises, for --check: about the packing's cell and its bag, and "inertia",
/// the largest inertial number of a stage with a prescribed axial rate.
std::vector<Doubt> doubts_before(const io::Snapshot& start, const dem::Scenario& scenario);

/// Returns the doubts about an ended run: about the cell and the bag at its end, about the end of its last isotropic
/// stage, and "inertia" at the stresses of the run.
std::vector<Doubt> doubts_after(const io::Snapshot& start, const dem::Scenario& scenario, const io::RunFile& run);

}  // namespace soilweave::analysis
