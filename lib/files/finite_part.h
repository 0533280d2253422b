// The valid part of a state that went wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/records.h"

namespace soilweave::io {

/// Returns the grains with finite numbers, and their contacts. Quaternions are normalised. Axes along which the cell
/// collapsed become aperiodic.
Snapshot finite_part(const Snapshot& state);

}  // namespace soilweave::io
