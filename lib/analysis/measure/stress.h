// Love-Weber stress of the cell and of each grain, compression positive.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stress is the virial of the contact forces (Love 1927, Weber 1966): the mean over a volume V of force f times branch
// l, from centre to centre,
//
//   sigma = (1/V) sum over contacts of f (x) l                                                      thesis Eq. 3.4
//
// The forces across a plane, over its area, are the traction sigma n. Inertia is neglected, since loading is
// quasi-static. A grain's stress is its share of the sum, over the volume of its power cell.
#pragma once

#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// Returns the stress of all contacts, Pa (2D: N/m), thesis Eq. 3.4. f acts on the second grain; l runs from the first
/// to the second. The skew part is the moment that contacts carry.
Mat3 contact_stress(const io::Snapshot& state);
/// Returns -sum T l n (x) n / V over all yarns (tension, length, direction), Pa. Zero in a cell without periodic axes.
Mat3 yarn_stress(const io::Snapshot& state);
/// Returns contact_stress() + yarn_stress(), Pa: the stress that a run's servo controls.
Mat3 cell_stress(const io::Snapshot& state);

/// Returns sum f (x) l of each grain, N m. Dyads are split at contact points, so grains add up to the cell.
std::vector<Mat3> grain_dyads(const io::Snapshot& state);

/// Principal values and directions of the symmetric part.
struct Principal {
  /// Largest first.
  Vec3 values;
  /// Unit vectors, as columns.
  Mat3 directions;
};
/// Computes principal values and directions. The largest component of each direction is positive.
Principal principal(const Mat3& stress, int dimension);

}  // namespace soilweave::analysis
