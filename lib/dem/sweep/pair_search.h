// Searches pairs of near grains by a grid over the (possibly sheared) cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"

namespace soilweave::dem {

/// Replaces `found` by all pairs with a gap below the skin (m), in the order of lists. Nodes of one fabric form no
/// pairs. longest: upper bound on the branch of such a pair, m.
void find_pairs(const Bodies& bodies, const Cell& cell, double skin, double longest, int threads,
                std::vector<Pair>& found);

}  // namespace soilweave::dem
