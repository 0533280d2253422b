// The valid part of a state that went wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "files/records.h"

namespace soilweave::io {

/// Returns the grains and contacts with finite numbers, so that readers accept them. Contacts of removed grains are
/// removed. Quaternions are normalised. Axes along which the cell collapsed become aperiodic.
Snapshot finite_part(const Snapshot& state);

}  // namespace soilweave::io
