// Love-Weber stress, compression positive: of the cell and of each grain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/records.h"

namespace soilweave::analysis {

/// sum f (x) l over all contacts divided by the cell's volume, Pa (2D: N/m), thesis Eq. 3.4; f acts on the second
/// grain, l runs from the first to the second. Not symmetrised: the skew part is the moment contacts carry.
Mat3 contact_stress(const io::Snapshot& state);
/// -sum T l n (x) n over all yarns divided by the cell's volume, Pa: tension, length and direction of each. Zero in a
/// cell without periodic axes, whose faces are not there to feel it.
Mat3 yarn_stress(const io::Snapshot& state);
/// Both together: what the faces of the cell feel, and what the servo of a run holds.
Mat3 cell_stress(const io::Snapshot& state);

/// sum f (x) l of each grain, N m: a contact's dyad goes to its two grains in the ratio of their distances from the
/// contact point, so that the grains' sum is the cell's.
std::vector<Mat3> grain_dyads(const io::Snapshot& state);

/// Principal values, largest first, and unit directions as columns, of the symmetric part.
struct Principal {
  Vec3 values;
  Mat3 directions;
};
Principal principal(const Mat3& stress, int dimension);

}  // namespace soilweave::analysis
