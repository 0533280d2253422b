// The periodic cell: shape, velocity gradient, volume, nearest images. An aperiodic axis only carries a length.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tensor.h"
#include "files/records.h"

namespace soilweave::dem {

/// Shape H and motion L of the cell. Columns of H are the cell vectors.
class Cell {
 public:
  Cell() = default;
  /// Takes a cell from a file. In 2D the third axis is aperiodic.
  Cell(const io::CellRecord& record, int dimension);

  /// Advances shape and deformation gradient over a step, first order: H <- (1 + L dt) H (LAWS.md §5).
  void advance(double dt);
  /// Sets L for the next steps, 1/s, extension positive.
  void set_velocity_gradient(const Mat3& gradient) { velocity_gradient_ = gradient; }
  /// Makes the present shape the reference of the deformation gradient.
  void set_reference() { deformation_gradient_ = Mat3::Identity(); }

  /// Returns H, m.
  const Mat3& matrix() const { return matrix_; }
  /// Returns L, 1/s, extension positive.
  const Mat3& velocity_gradient() const { return velocity_gradient_; }
  /// Returns the deformation gradient since the reference.
  const Mat3& deformation_gradient() const { return deformation_gradient_; }
  /// Returns whether an axis is periodic.
  bool periodic(int axis) const { return periodic_[static_cast<std::size_t>(axis)]; }
  /// Returns whether any axis is periodic.
  bool any_periodic() const { return periodic_[0] || periodic_[1] || periodic_[2]; }
  /// Returns whether all axes of the space are periodic.
  bool all_periodic() const;
  /// Returns whether the last step changed the cell.
  bool deforming() const { return deforming_; }

  /// Returns the volume, m3 (2D: m2).
  double volume() const;
  /// Returns the distances between opposite faces, m.
  Vec3 widths() const;
  /// Returns the offset, in cells, of the image of `to` nearest to `from`.
  /// Exact for grains smaller than half the cell.
  Vec3i nearest_image(const Vec3& from, const Vec3& to) const;
  /// Returns the cell as files hold it.
  io::CellRecord record() const;

 private:
  /// Dimension of the space, 2 or 3.
  int dimension_ = 3;
  /// H, m.
  Mat3 matrix_ = Mat3::Identity();
  /// L, 1/s.
  Mat3 velocity_gradient_ = Mat3::Zero();
  /// Deformation since the reference.
  Mat3 deformation_gradient_ = Mat3::Identity();
  /// Whether each axis is periodic.
  std::array<bool, 3> periodic_ = {false, false, false};
  /// Whether the last step changed the cell.
  bool deforming_ = false;
};

}  // namespace soilweave::dem
