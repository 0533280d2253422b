// What is doubtful of an analytical answer: a soil that nobody chose, states beyond the data behind its constants.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "gws/respond.h"

namespace soilweave::gws {

/// Doubts about an answer: "default-soil" unless the soil was `chosen`; "extrapolation" where a stiffness, N/m, or the
/// mean stress or axial strain of a state leaves the ranges that the soil's constants were identified on. States that
/// do not exist are passed over.
std::vector<Doubt> doubts(const SoilFile& soil, bool chosen, const std::vector<double>& stiffnesses,
                          const std::vector<Point>& states);

}  // namespace soilweave::gws
