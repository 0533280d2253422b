// Parts of an assembly to average over: boxes, and the copies of a tiled representative volume.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// A part of the assembly: its grains, each with the volume of its power cell.
struct Volume {
  std::string name;
  std::vector<std::size_t> grains;
  bool wrapped =
      false;  // whether its grains were told by their places in the cell, not by where they have travelled to
};

/// Returns the grains whose wrapped centre lies in an axis-parallel box (m); the upper faces are excluded.
Volume box(const io::Snapshot& state, const Vec3& low, const Vec3& high);
/// Returns one volume per copy of a tiled representative volume, in the order of copy_id, of its reinforced soil
/// (parts.h).
std::vector<Volume> copies(const io::Snapshot& state);
/// Returns the groups #1 to #5 of thesis Fig. 3.9: four neighbouring copies each of ten by ten, along x in the middle
/// of y, one per pair along x. An odd number of copies along x gives one group per copy, with the same positions for
/// five by five copies of twice the size. Groups without reinforced soil are left out; the others keep their names.
std::vector<Volume> groups(const io::Snapshot& state);
/// Returns the volume of all grains.
Volume whole(const io::Snapshot& state);

/// Returns the mean of the centres of a volume's grains, m. Grains of a wrapped volume count by their places in the
/// cell.
Vec3 centre(const io::Snapshot& state, const Volume& volume);

/// Stress (Pa; 2D: N/m) and void ratio of a volume, from dyads (N m) and power-cell volumes of its grains.
struct VolumeState {
  double volume = 0;  // m3 (2D: m2)
  double void_ratio = 0;
  Mat3 stress = Mat3::Zero();
};
/// Averages over a volume. Grains whose cell reaches outside (volume 0) are left out.
VolumeState volume_state(const io::Snapshot& state, const Volume& volume, const std::vector<Mat3>& dyads,
                         const std::vector<double>& cell_volumes);

/// Return the cell volume, m3 (2D: m2), and the void ratio; overlaps count twice.
double cell_volume(const io::Snapshot& state);
double void_ratio(const io::Snapshot& state);

}  // namespace soilweave::analysis
