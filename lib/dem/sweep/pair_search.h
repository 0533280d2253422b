// Searches pairs of near grains by a grid over the cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"

namespace soilweave::dem {

/// Replaces `found` by all pairs with a gap below `skin`, m, sorted by PairOrder.
/// Nodes of one fabric form no pairs. `longest`: upper bound on the branch of a pair, m.
void find_pairs(const Bodies& bodies, const Cell& cell, double skin, double longest, int threads,
                std::vector<Pair>& found);

}  // namespace soilweave::dem
