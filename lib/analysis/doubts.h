// What is doubtful of a packing, a bag or a run, though it was made as told: numbers with their thresholds and
// remedies.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/scenario.h"
#include "io/files.h"

namespace soilweave::analysis {

/// Doubts about a packing at rest, whatever made it: "cell-over-grain" where the cell is narrower than
/// 4 diameters of the largest grain along a periodic axis.
std::vector<Doubt> cell_doubts(const io::Snapshot& state);

/// Doubts about a packing that was compressed isotropically and has come to rest: "rattlers" (share of grains outside
/// the backbone of Coordination), "coordination" (2 Nc/N) and "isotropy" (q/p). Empty for grains without contacts.
std::vector<Doubt> compaction_doubts(const io::Snapshot& state);

/// Doubts about a bag of geotextile: "outside" where grains have left it, "preload" where hardly any yarn is taut.
/// Empty for a state without yarns or without soil.
std::vector<Doubt> bag_doubts(const io::Snapshot& state);

/// Inertial number of a strain rate, strain rate * d * sqrt(rho / p): d is the mean diameter (m), rho the density in
/// the equations of motion (kg/m3, scaling included), p the mean stress (Pa). da Cruz et al. (2005).
double inertial_number(double rate, double diameter, double density, double pressure);

/// Doubts that the input of a run alone raises, for --check: the packing's cell, its bag, and "inertia": the largest
/// inertial number of a stage whose axial strain goes at a given rate.
std::vector<Doubt> doubts_before(const io::Snapshot& start, const dem::Scenario& scenario);

/// Doubts about a run that has ended: those of the cell and the bag at its end, of the state at the end of its last
/// isotropic stage, and "inertia" with the stresses that the run had.
std::vector<Doubt> doubts_after(const io::Snapshot& start, const dem::Scenario& scenario, const io::RunFile& run);

}  // namespace soilweave::analysis
