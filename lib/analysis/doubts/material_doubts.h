// Doubts about materials that do not fit their grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "dem/contact/model.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns "stiffness" for each material whose absolute rolling or twisting stiffness is implausible: above ten times
/// or below a tenth of 1.26e-3 E R^3, the stiffness of the thesis's grains. R is the mean radius of the material's
/// grains. Nodes of geotextiles do not rotate and are left out.
std::vector<Doubt> stiffness_doubts(const io::Snapshot& state, const dem::Model& model);

/// Returns "range" if contacts act across gaps of more than a tenth of the grains' mean radius.
std::vector<Doubt> range_doubts(const io::Snapshot& state, const dem::Model& model);

/// Returns "weight" if gravity (m/s2) acts on grains or nodes of an implausible density: grains below 500 or above
/// 20,000 kg/m3, nodes above 20,000 kg/m3. Returns "weights" if grains of one material have different densities.
/// Without gravity, returns "density" if grains are below 500 kg/m3, since only scaling leaves true densities.
std::vector<Doubt> weight_doubts(const io::Snapshot& state, const Vec3& gravity);

/// Returns all doubts about materials of grains in this state.
std::vector<Doubt> material_doubts(const io::Snapshot& state, const dem::Model& model, const Vec3& gravity);

}  // namespace soilweave::analysis
