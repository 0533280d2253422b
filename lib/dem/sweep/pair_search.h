// Searches pairs of near grains by a grid over the cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"

namespace soilweave::dem {

/// Replaces `found` by all pairs that are nearer than the sum of their reaches, sorted by PairOrder.
/// `reach`: radius and skin of each body, m. `longest`: upper bound on the sum of two reaches, m.
/// Nodes of one fabric form pairs only across a periodic face.
void find_pairs(const Bodies& bodies, const Cell& cell, const std::vector<double>& reach, double longest, int threads,
                std::vector<Pair>& found);

}  // namespace soilweave::dem
