// Love-Weber stress, compression positive: of the cell, of a volume of interest, of each grain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/records.h"

namespace soilweave::analysis {

/// sum f (x) l over all contacts divided by the cell's volume, Pa (2D: N/m), thesis Eq. 3.4; f acts on the second grain, l
/// runs from the first to the second. Not symmetrised: the skew part is the moment contacts carry.
Mat3 cell_stress(const io::Snapshot& state);

/// sum f (x) l of each grain, N m: a contact's dyad goes to its two grains in the ratio of their distances from the contact
/// point, so that the grains' sum is the cell's.
std::vector<Mat3> grain_dyads(const io::Snapshot& state);

/// Principal values, largest first, and unit directions as columns, of the symmetric part.
struct Principal {
  Vec3 values;
  Mat3 directions;
};
Principal principal(const Mat3& stress, int dimension);

/// A part of the assembly: its grains, each counted with the volume of its power cell.
struct Volume {
  std::string name;
  std::vector<std::size_t> grains;
};

/// Grains whose wrapped centre lies in an axis-parallel box (m).
Volume box(const io::Snapshot& state, const Vec3& low, const Vec3& high);
/// One volume per copy of a tiled representative volume, in the order of copy_id.
std::vector<Volume> copies(const io::Snapshot& state);

/// Stress and void ratio of a volume from the dyads and power-cell volumes of its grains.
struct VolumeState {
  double volume = 0;  // m3
  double void_ratio = 0;
  Mat3 stress = Mat3::Zero();
};
VolumeState volume_state(const io::Snapshot& state, const Volume& volume, const std::vector<Mat3>& dyads,
                         const std::vector<double>& cell_volumes);

/// Natural strains of the cell since its reference, compression positive: minus the logarithm of the left stretch.
Mat3 cell_strain(const io::CellRecord& cell);
/// Cell volume, m3 (2D: m2), and void ratio with overlaps counted twice.
double cell_volume(const io::Snapshot& state);
double void_ratio(const io::Snapshot& state);

}  // namespace soilweave::analysis
