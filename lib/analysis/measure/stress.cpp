// Sums of force (x) branch.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/stress.h"

#include <cmath>
#include <limits>

#include "analysis/measure/volume_of_interest.h"
#include "core/linear_algebra.h"

namespace soilweave::analysis {

Mat3 contact_stress(const io::Snapshot& state) {
  Mat3 sum = Mat3::Zero();
  for (std::size_t c = 0; c < state.contacts.size(); ++c)
    sum += state.contacts.force(c) * state.contacts.branch_vector[c].transpose();
  return sum / cell_volume(state);
}

Mat3 yarn_stress(const io::Snapshot& state) {
  Mat3 sum = Mat3::Zero();
  const auto& periodic = state.cell.periodic;
  if (!periodic[0] && !periodic[1] && !periodic[2]) return sum;
  const io::YarnsRecord& y = state.yarns;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (!(y.tension[k] > 0)) continue;
    const Vec3 reach = state.grains.position[static_cast<std::size_t>(y.nodes[k][1])] -
                       state.grains.position[static_cast<std::size_t>(y.nodes[k][0])];
    sum -= y.tension[k] / reach.norm() * reach * reach.transpose();
  }
  return sum / cell_volume(state);
}

Mat3 cell_stress(const io::Snapshot& state) { return contact_stress(state) + yarn_stress(state); }

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
  if (!s.allFinite()) {
    p.values.setConstant(std::numeric_limits<double>::quiet_NaN());
    p.directions.setConstant(p.values[0]);
    return p;
  }
  if (dimension == 3) {
    const Eigensystem<Mat3> system = eigensystem(s);
    p.values = system.values.reverse();
    p.directions = system.vectors.rowwise().reverse();
  } else {
    const Eigensystem<Mat2> system = eigensystem(Mat2(s.topLeftCorner<2, 2>()));
    p.values.head<2>() = system.values.reverse();
    p.directions.topLeftCorner<2, 2>() = system.vectors.rowwise().reverse();
  }
  // An eigenvector has no sign, so the largest component is made positive: equal states give equal numbers.
  for (int k = 0; k < dimension; ++k) {
    int largest = 0;
    p.directions.col(k).cwiseAbs().maxCoeff(&largest);
    if (p.directions(largest, k) < 0) p.directions.col(k) *= -1;
  }
  return p;
}

}  // namespace soilweave::analysis
