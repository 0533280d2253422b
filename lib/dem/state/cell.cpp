// The periodic cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/state/cell.h"

#include <Eigen/LU>
#include <algorithm>

namespace soilweave::dem {

Cell::Cell(const io::CellRecord& record, int dimension)
    : dimension_(dimension),
      matrix_(record.matrix),
      velocity_gradient_(record.velocity_gradient),
      deformation_gradient_(record.deformation_gradient),
      periodic_(record.periodic) {
  if (dimension_ == 2) periodic_[2] = false;
}

void Cell::advance(double dt) {
  deforming_ = !velocity_gradient_.isZero(0.0);
  if (!deforming_) return;
  const Mat3 step = Mat3::Identity() + dt * velocity_gradient_;
  matrix_ = (step * matrix_).eval();
  deformation_gradient_ = (step * deformation_gradient_).eval();
}

bool Cell::all_periodic() const {
  return std::all_of(periodic_.begin(), periodic_.begin() + dimension_, [](bool periodic) { return periodic; });
}

double Cell::volume() const {
  if (dimension_ == 2) return matrix_.topLeftCorner<2, 2>().determinant();
  return matrix_.topLeftCorner(dimension_, dimension_).determinant();
}

Vec3 Cell::widths() const {
  const Mat3 inverse = matrix_.inverse();
  return inverse.rowwise().norm().cwiseInverse();
}

Vec3i Cell::nearest_image(const Vec3& from, const Vec3& to) const {
  const Vec3 offset = matrix_.inverse() * (from - to);
  Vec3i image = Vec3i::Zero();
  for (int a = 0; a < dimension_; ++a)
    if (periodic(a)) image[a] = static_cast<int>(std::lround(offset[a]));
  return image;
}

io::CellRecord Cell::record() const { return {matrix_, periodic_, velocity_gradient_, deformation_gradient_}; }

}  // namespace soilweave::dem
