// What is left of a state that went wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/records.h"

namespace soilweave::io {

/// The grains and contacts whose numbers are finite, such that readers take them: contacts of a grain that is left out
/// go with it, quaternions are made rotations again, and axes along which the cell collapsed are open.
Snapshot finite_part(const Snapshot& state);

}  // namespace soilweave::io
