// Doubts about the materials and stages of a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/run/scenario.h"
#include "files/files.h"

namespace soilweave::analysis {

/// Returns "jump" if the stress among the grains of `begun`, the state before the first step with the forces of the
/// scenario's law, differs by more than a tenth from that which `start` keeps, and the first stage does not bring all
/// axes of a periodic cell to given stresses. A packing without contacts keeps no stress.
std::vector<Doubt> start_doubts(const io::Snapshot& start, const io::Snapshot& begun, const dem::Scenario& scenario);

/// Returns "jump" if a stage strains one axis of a cell while the stress that it holds on another differs by more than
/// a tenth from what acts there before. Not judged are ramps, and stresses that the stage before leaves open.
std::vector<Doubt> jump_doubts(const io::Snapshot& begun, const dem::Scenario& scenario);

/// Returns "strain" if a stage strains an axis by more than 0.5, as per cent without their sign would be, and
/// "stress-unit" if it lowers a stress of a cell to less than a fiftieth, as kPa without their unit would be. Not
/// judged are stages that lower all stresses which a stage before brought about.
std::vector<Doubt> unit_doubts(const io::Snapshot& begun, const dem::Scenario& scenario);

/// Returns "friction" if one of these friction angles, rad, is above 0 and below pi/2 degrees, as an angle given in
/// radians would be.
std::vector<Doubt> radian_doubts(const std::vector<double>& angles);

/// Returns radian_doubts() of all materials and stages.
std::vector<Doubt> friction_doubts(const dem::Scenario& scenario);

/// Returns "soft" if contacts overlap by more than a twentieth of the mean radius in the mean.
std::vector<Doubt> overlap_doubts(const io::Snapshot& state);

}  // namespace soilweave::analysis
