// Doubts about loading that the grains did not follow.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/run/scenario.h"
#include "files/files.h"

namespace soilweave::analysis {

/// Returns "idle-plate" if a stage displaces a plane towards the grains, farther than it was before, and nothing
/// presses against it at a station that is below one with a force, or at the last station. A state without any force is
/// at rest, so a run does not stop there. series: rows of the run.
std::vector<Doubt> idle_plate_doubts(const dem::Scenario& scenario, const io::Series& series);

/// Returns "no-contact" if a stage strains the cell or moves parts, and at a station no bodies touch that touched
/// before. series: rows of the run.
std::vector<Doubt> no_contact_doubts(const dem::Scenario& scenario, const io::Series& series);

/// Returns "clamp-speed" if a stage moves a clamp so fast that the wave which leaves it strains yarns by more than a
/// tenth of the strain at which their curve first bends. This strain is the speed over that of the wave, from the
/// first slope of the curve and the mass of the nodes along a yarn. start: the packing as the run begins.
std::vector<Doubt> clamp_doubts(const dem::Scenario& scenario, const io::Snapshot& start);

}  // namespace soilweave::analysis
