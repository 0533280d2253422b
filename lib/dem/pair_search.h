// Pairs of grains near one another, by a grid over the (possibly sheared) cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/bodies.h"
#include "dem/cell.h"
#include "dem/contacts.h"

namespace soilweave::dem {

/// Replaces `found` by all pairs whose gap is below the skin (m), in the order of lists; nodes of one fabric are no
/// pairs. longest: no such pair's branch is longer, m.
void find_pairs(const Bodies& bodies, const Cell& cell, double skin, double longest, int threads,
                std::vector<Pair>& found);

}  // namespace soilweave::dem
