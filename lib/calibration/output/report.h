// Report of an assimilation for a reader, and doubts about it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/assimilation.h"
#include "core/doubts.h"

namespace soilweave::calibration {

/// Returns doubts: unused runs, rows of unknown ids, runs that are all far from the observations (25 variances each, or
/// half of an observable's root mean square), and Simulated::doubts. If weights are told also degeneracy, observations
/// that tell nothing, and columns of sets that are no parameters.
std::vector<Doubt> doubts(const Assimilation& a, bool weights_told = true);
/// Returns a message if all likelihoods of a step are zero in double precision.
std::optional<std::string> all_zero(const Assimilation& a);
/// Describes unused runs, error model, some steps, and final parameters.
std::string describe(const Assimilation& a);

}  // namespace soilweave::calibration
