// Doubts about an analytical answer: a soil that nobody chose, states beyond the data behind its constants.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Returns the doubts about an answer. "default-soil": the soil was not `chosen`. "estimated-soil": no bags of it were
/// computed. "extrapolation": a stiffness (N/m), or the mean stress or axial strain of a state, leaves the range on
/// which the soil's constants were identified. States that do not exist are skipped.
std::vector<Doubt> doubts(const SoilFile& soil, bool chosen, const std::vector<double>& stiffnesses,
                          const std::vector<Point>& states);

}  // namespace soilweave::gws
