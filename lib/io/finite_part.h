// What is left of a state that went wrong.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "io/records.h"

namespace soilweave::io {

/// The grains and contacts whose numbers are finite; contacts of a grain that is left out go with it.
Snapshot finite_part(const Snapshot& state);

}  // namespace soilweave::io
