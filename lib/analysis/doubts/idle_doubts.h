// Doubts about loading that the grains did not follow.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/run/scenario.h"
#include "files/files.h"

namespace soilweave::analysis {

/// Returns "idle-plate" if a stage moves a plane towards the grains, and nothing presses against it at a recorded
/// station that is below one with a force, or at the last station. A state without any force is at rest, so a run does
/// not stop there. series: rows of the run.
std::vector<Doubt> idle_plate_doubts(const dem::Scenario& scenario, const io::Series& series);

/// Returns "no-contact" if a stage strains the cell or moves parts, and at a station no bodies touch that touched
/// before. series: rows of the run.
std::vector<Doubt> no_contact_doubts(const dem::Scenario& scenario, const io::Series& series);

}  // namespace soilweave::analysis
