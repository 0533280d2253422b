// Love-Weber stress and what goes with it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/stress.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <cmath>
#include <map>

#include "dem/bodies.h"

namespace soilweave::analysis {

Mat3 cell_stress(const io::Snapshot& state) {
  Mat3 sum = Mat3::Zero();
  for (std::size_t c = 0; c < state.contacts.size(); ++c)
    sum += state.contacts.force(c) * state.contacts.branch_vector[c].transpose();
  return sum / cell_volume(state);
}

std::vector<Mat3> grain_dyads(const io::Snapshot& state) {
  std::vector<Mat3> dyads(state.grains.size(), Mat3::Zero());
  for (std::size_t c = 0; c < state.contacts.size(); ++c) {
    const auto [first, second] = state.contacts.bodies[c];
    const Vec3& branch = state.contacts.branch_vector[c];
    const Mat3 dyad = state.contacts.force(c) * branch.transpose();
    const double reach = state.grains.radius[static_cast<std::size_t>(first)] - 0.5 * state.contacts.overlap[c];
    const double share = second < 0 ? 1.0 : reach / branch.norm();
    dyads[static_cast<std::size_t>(first)] += share * dyad;
    if (second >= 0) dyads[static_cast<std::size_t>(second)] += (1 - share) * dyad;
  }
  return dyads;
}

Principal principal(const Mat3& stress, int dimension) {
  const Mat3 s = symmetric(stress);
  Principal p{Vec3::Zero(), Mat3::Identity()};
  if (dimension == 3) {
    const Eigen::SelfAdjointEigenSolver<Mat3> solver(s);
    p.values = solver.eigenvalues().reverse();
    p.directions = solver.eigenvectors().rowwise().reverse();
  } else {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(Eigen::Matrix2d(s.topLeftCorner<2, 2>()));
    p.values.head<2>() = solver.eigenvalues().reverse();
    p.directions.topLeftCorner<2, 2>() = solver.eigenvectors().rowwise().reverse();
  }
  // An eigenvector has no sign: the largest component points up, so that equal states give equal numbers.
  for (int k = 0; k < dimension; ++k) {
    int largest = 0;
    p.directions.col(k).cwiseAbs().maxCoeff(&largest);
    if (p.directions(largest, k) < 0) p.directions.col(k) *= -1;
  }
  return p;
}

Volume box(const io::Snapshot& state, const Vec3& low, const Vec3& high) {
  Volume volume{fmt::format("box {:g} {:g} {:g} {:g} {:g} {:g}", low.x(), high.x(), low.y(), high.y(), low.z(), high.z()), {}};
  const Mat3 inverse = state.cell.matrix.inverse();
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    Vec3 reduced = inverse * state.grains.position[i];
    for (int a = 0; a < state.grains.dimension; ++a)
      if (state.cell.periodic[static_cast<std::size_t>(a)]) reduced[a] -= std::floor(reduced[a]);
    const Vec3 at = state.cell.matrix * reduced;
    bool inside = true;
    for (int a = 0; a < state.grains.dimension; ++a) inside = inside && at[a] >= low[a] && at[a] < high[a];
    if (inside) volume.grains.push_back(i);
  }
  return volume;
}

std::vector<Volume> copies(const io::Snapshot& state) {
  std::map<std::int32_t, Volume> by_copy;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    Volume& v = by_copy[state.grains.copy_id[i]];
    v.name = fmt::format("copy {}", state.grains.copy_id[i]);
    v.grains.push_back(i);
  }
  std::vector<Volume> all;
  for (auto& [id, v] : by_copy) all.push_back(std::move(v));
  return all;
}

VolumeState volume_state(const io::Snapshot& state, const Volume& volume, const std::vector<Mat3>& dyads,
                         const std::vector<double>& cell_volumes) {
  VolumeState v;
  double solids = 0;
  for (const std::size_t i : volume.grains) {
    v.volume += cell_volumes[i];
    v.stress += dyads[i];
    solids += dem::grain_volume(state.grains.dimension, state.grains.radius[i]);
  }
  if (v.volume > 0) v.stress /= v.volume;
  v.void_ratio = solids > 0 ? v.volume / solids - 1 : 0;
  return v;
}

Mat3 cell_strain(const io::CellRecord& cell) {
  const Mat3& f = cell.deformation_gradient;
  const Eigen::SelfAdjointEigenSolver<Mat3> stretch(Mat3(f * f.transpose()));
  const Vec3 logs = -0.5 * stretch.eigenvalues().array().log();
  return stretch.eigenvectors() * logs.asDiagonal() * stretch.eigenvectors().transpose();
}

double cell_volume(const io::Snapshot& state) {
  const int d = state.grains.dimension;
  return d == 3 ? state.cell.matrix.determinant() : state.cell.matrix.topLeftCorner<2, 2>().determinant();
}

double void_ratio(const io::Snapshot& state) {
  double solids = 0;
  for (const double r : state.grains.radius) solids += dem::grain_volume(state.grains.dimension, r);
  return cell_volume(state) / solids - 1;
}

}  // namespace soilweave::analysis
