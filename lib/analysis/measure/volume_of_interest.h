// Volumes to average over: boxes, and copies of a tiled representative volume.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// A part of the assembly.
struct Volume {
  /// Name in tables.
  std::string name;
  /// Indices of its grains.
  std::vector<std::size_t> grains;
  /// Image of each grain that lies in the volume, counted from its unwrapped position. Empty if unwrapped positions
  /// count.
  std::vector<Vec3i> images;
};

/// Returns the grains with centres in a box (m), without nodes of a geotextile. The box excludes its upper faces. It
/// may reach beyond a periodic face by at most one cell. It holds each grain once; an image in the cell comes first.
Volume box(const io::Snapshot& state, const Vec3& low, const Vec3& high);
/// Returns the reinforced soil (parts.h) of each copy, in the order of copy_id.
std::vector<Volume> copies(const io::Snapshot& state);
/// Returns the groups #1 to #5 of thesis Fig. 3.9. A group is a pair of copies along x in both middle rows along y,
/// four in all. With an odd number of copies along x, each copy of the middle row is a group. Groups without reinforced
/// soil are left out; the others keep their names. Empty unless the copies form one square layer, whose outer rows may
/// be missing, equally many on all four sides.
std::vector<Volume> groups(const io::Snapshot& state);
/// Returns the volume of all grains.
Volume whole(const io::Snapshot& state);

/// Returns the mean of the grain centres, m, each at its image.
Vec3 centre(const io::Snapshot& state, const Volume& volume);

/// Averages over a volume.
struct VolumeState {
  /// Number of grains averaged over.
  double grains = 0;
  /// Volume, m3 (2D: m2).
  double volume = 0;
  double void_ratio = 0;
  /// Pa (2D: N/m).
  Mat3 stress = Mat3::Zero();
};
/// Averages dyads (N m) and power-cell volumes. Grains whose cell reaches outside (volume 0) are left out. If no grain
/// remains, stress and void ratio are NaN.
VolumeState volume_state(const io::Snapshot& state, const Volume& volume, const std::vector<Mat3>& dyads,
                         const std::vector<double>& cell_volumes);

/// Returns the cell's volume, m3 (2D: m2).
double cell_volume(const io::Snapshot& state);
/// Returns the cell's void ratio; overlaps count twice.
double void_ratio(const io::Snapshot& state);

}  // namespace soilweave::analysis
