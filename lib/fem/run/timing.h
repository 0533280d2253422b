// Doubts about the duration of a two-scale run, and the extent of its mesh.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/doubts.h"
#include "fem/run/scenario.h"

namespace soilweave::fem {

/// Returns "1.2 m by 0.6 m", the extent of the mesh along x and y.
std::string extent_text(const Mesh& mesh);

/// Returns "wave" if the run ends before an elastic wave has crossed the mesh's shorter side, and "few_steps" if it has
/// too few steps for any response. Runs that come to rest at their outputs have neither.
std::vector<Doubt> timing_doubts(const Scenario& scenario, const Model& model, std::int64_t steps);

}  // namespace soilweave::fem
