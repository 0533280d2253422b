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

/// Returns the inertial number rate * d * sqrt(rho / p), with the mean diameter d (m), the scaled density rho (kg/m3)
/// and the mean stress p (Pa). da Cruz et al. (2005).
double inertial_number(double rate, double diameter, double density, double pressure);

/// Returns doubts about the input of a run, for --check: its cell, its bag, and "inertia", the largest inertial number
/// of a stage with a prescribed axial rate.
std::vector<Doubt> doubts_before(const io::Snapshot& start, const dem::Scenario& scenario);

/// Returns doubts about an ended run: cell and bag at its end, the end of its last isotropic stage, and "inertia".
std::vector<Doubt> doubts_after(const io::Snapshot& start, const dem::Scenario& scenario, const io::RunFile& run);

}  // namespace soilweave::analysis
