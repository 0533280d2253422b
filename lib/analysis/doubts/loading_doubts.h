// Doubts about the materials and stages of a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/doubts.h"
#include "core/text/settings.h"
#include "dem/run/scenario.h"
#include "files/files.h"

namespace soilweave::analysis {

/// Mean stresses among the grains before and after a contact law replaced the stored forces, Pa (2D: N/m).
struct StressChange {
  double before = 0, after = 0;
  /// Whether the grains moved, so that the law is not the cause.
  bool moved = false;
};
/// Returns the stress among the grains of two states if any axis differs by more than a tenth of the larger mean
/// stress. Empty for a packing without contacts. start: the packing as read. begun: with forces by a scenario's law.
std::optional<StressChange> stress_change(const io::Snapshot& start, const io::Snapshot& begun);

/// Returns "jump" if the stress among the grains differs by more than a tenth between `start` and `begun`. start: the
/// packing as read. begun: the state before the first step, with forces by the scenario's law. Empty for a packing
/// without contacts. Empty also if the first stage brings all axes of a periodic cell to given stresses.
std::vector<Doubt> start_doubts(const io::Snapshot& start, const io::Snapshot& begun, const dem::Scenario& scenario);

/// Returns "jump" if a stage strains one axis of a cell and holds another at a stress more than a tenth off the stress
/// before. Ramps are not judged, nor stresses that are unknown after the stage before.
std::vector<Doubt> jump_doubts(const io::Snapshot& begun, const dem::Scenario& scenario);

/// Returns "strain" if a stage strains an axis by more than 0.5: perhaps the % sign is missing. Returns "stress-unit"
/// if a stage lowers a stress of a cell to less than a fiftieth, or in 3D asks for a stress below 500 Pa without a
/// unit: perhaps the unit kPa is missing. A lowered stress that an earlier stage set is not judged in a stage that sets
/// all stresses, nor a small one beside another without a unit of 5 kPa or more.
std::vector<Doubt> unit_doubts(const io::Snapshot& begun, const dem::Scenario& scenario);

/// Returns "stress-unit" if one of these stresses, given without a unit, is below 500 Pa in magnitude and not zero, and
/// none is 5 kPa or more: perhaps the unit kPa is missing.
std::vector<Doubt> bare_stress_doubts(const std::vector<BareNumber>& stresses);

/// Returns "friction" if one of these friction angles (rad) is above 0 and below pi/2 degrees: perhaps it was given in
/// radians.
std::vector<Doubt> radian_doubts(const std::vector<double>& angles);

/// Returns radian_doubts() of the angles that stages set for grains and plates.
std::vector<Doubt> stage_friction_doubts(const dem::Scenario& scenario);

/// Returns "soft" if the mean overlap of contacts exceeds a twentieth of the mean radius.
std::vector<Doubt> overlap_doubts(const io::Snapshot& state);

}  // namespace soilweave::analysis
