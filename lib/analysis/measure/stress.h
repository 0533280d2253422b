// Love-Weber stress of the cell and of each grain, compression positive.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stress of a granular assembly is the virial of its contact forces (Love 1927, Weber 1966): the mean over a volume
// V of force f times branch l, from centre to centre,
//
//   sigma = (1/V) sum over contacts of f (x) l                                                      thesis Eq. 3.4
//
// Cut the assembly by a plane: the forces of the contacts that cross it, over its area, are the traction sigma n. The
// sum counts each contact as often as planes meet its branch. Inertia is neglected, since loading is quasi-static. The
// share of a grain in this sum, over the volume of its power cell, is the stress of a grain.
#pragma once

#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// Returns sum f (x) l over all contacts, over the cell's volume, Pa (2D: N/m), thesis Eq. 3.4. f acts on the second
/// grain, l runs from the first to the second. The skew part is the moment that contacts carry.
Mat3 contact_stress(const io::Snapshot& state);
/// Returns -sum T l n (x) n over all yarns (tension, length, direction), over the cell's volume, Pa. Zero in a cell
/// without periodic axes.
Mat3 yarn_stress(const io::Snapshot& state);
/// Returns the sum of both: the stress at the faces of the cell, which the servo of a run holds.
Mat3 cell_stress(const io::Snapshot& state);

/// Returns sum f (x) l of each grain, N m. A contact's dyad is split at the contact point, so that the grains' sum
/// equals the cell's.
std::vector<Mat3> grain_dyads(const io::Snapshot& state);

/// Principal values of the symmetric part, largest first, with unit directions as columns.
struct Principal {
  Vec3 values;
  Mat3 directions;
};
/// Computes principal values and directions. The largest component of a direction is positive.
Principal principal(const Mat3& stress, int dimension);

}  // namespace soilweave::analysis
