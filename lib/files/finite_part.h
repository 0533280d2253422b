// The valid part of a state that went wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/records.h"

namespace soilweave::io {

/// Returns grains with finite numbers, and their contacts. Normalises quaternions. Axes of a collapsed cell become
/// aperiodic.
Snapshot finite_part(const Snapshot& state);

}  // namespace soilweave::io
