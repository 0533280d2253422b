// The geotextiles of a plan, laid one after another.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "packing/expand/plan.h"

namespace soilweave::packing {

/// Adds the fabrics of a plan to the state. laid: as for assemble(). Throws DataError with the keys of two fabrics
/// whose nodes lie in one another by more than guards.overlap, since no run begins with them.
void lay_fabrics(const Plan& plan, const std::function<void(double)>& laid, io::Snapshot& state);

}  // namespace soilweave::packing
