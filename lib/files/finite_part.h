// The valid part of a state that went wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/records.h"

namespace soilweave::io {

/// Returns the grains whose numbers are all finite, with their contacts and yarns. Normalises quaternions. Makes the
/// axes of a collapsed cell aperiodic.
Snapshot finite_part(const Snapshot& state);

}  // namespace soilweave::io
