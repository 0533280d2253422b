// Doubts about the fabric of a state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns "no_contacts" if a state has no contact although grains overlap, as one that was imported: means over its
/// contacts are 0 and not those of its grains.
std::vector<Doubt> contact_doubts(const io::Snapshot& state);
/// Returns "no_contacts" if a state has no contact, and with it no fabric.
std::vector<Doubt> fabric_doubts(const io::Snapshot& state);
/// Returns that doubt, or "empty_classes" if classes of the rose hold no contact, and with it no mean force. classes:
/// of the full circle.
std::vector<Doubt> rose_doubts(const io::Snapshot& state, std::size_t classes);

}  // namespace soilweave::analysis
