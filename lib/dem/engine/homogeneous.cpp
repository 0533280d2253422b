// A homogeneous field of velocity.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/homogeneous.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace soilweave::dem {
namespace {

std::vector<bool> held_by_clamps(const Simulation& simulation) {
  std::vector<bool> held(simulation.grains(), false);
  for (const Clamp& clamp : simulation.clamps())
    for (const std::int32_t i : clamp.grains) held[static_cast<std::size_t>(i)] = true;
  return held;
}

}  // namespace

HomogeneousField::HomogeneousField(const Bodies& bodies, OpenAxes open, std::vector<bool> held)
    : open_(open), held_(std::move(held)) {
  for (int a = bodies.dimension; a < 3; ++a) open_[static_cast<std::size_t>(a)] = false;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (held_[i]) continue;
    mass_ += bodies.mass(i);
    centre_ += bodies.mass(i) * vector_of(bodies.grains[i].position);
  }
  if (mass_ > 0) centre_ /= mass_;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (held_[i]) continue;
    const Vec3 x = vector_of(bodies.grains[i].position) - centre_;
    second_ += bodies.mass(i) * x * x.transpose();
  }
}

HomogeneousField::HomogeneousField(const Simulation& simulation)
    : HomogeneousField(simulation.bodies(),
                       {!simulation.cell().periodic(0), !simulation.cell().periodic(1), !simulation.cell().periodic(2)},
                       held_by_clamps(simulation)) {}

Mat3 HomogeneousField::gradient(const Bodies& bodies) const {
  Mat3 moments = second_;
  for (int a = 0; a < 3; ++a) {
    if (open_[static_cast<std::size_t>(a)]) continue;
    moments.row(a).setZero(), moments.col(a).setZero();
    moments(a, a) = 1;
  }
  Mat3 products = Mat3::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (!held_[i])
      products +=
          bodies.mass(i) * vector_of(bodies.velocity(i)) * (vector_of(bodies.grains[i].position) - centre_).transpose();
  for (int a = 0; a < 3; ++a)
    if (!open_[static_cast<std::size_t>(a)]) products.col(a).setZero();
  const Eigen::FullPivLU<Mat3> solver(moments);
  return solver.isInvertible() ? Mat3(products * solver.inverse()) : Mat3::Zero();
}

void HomogeneousField::add(const Mat3& gradient, Bodies& bodies) const {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (held_[i]) continue;
    const Vec3 x = vector_of(bodies.grains[i].position) - centre_;
    bodies.set_velocity(i, vector_of(bodies.velocity(i)) + gradient * x);
  }
}

Vec3 HomogeneousField::second_moments() const {
  Vec3 moments = second_.diagonal();
  for (int a = 0; a < 3; ++a)
    if (!open_[static_cast<std::size_t>(a)]) moments[a] = 0;
  return moments;
}

double slowest_swing(const Simulation& simulation) {
  const Vec3 stiffness = simulation.measures().axial_stiffness * simulation.volume();
  const Vec3 moments = HomogeneousField(simulation).second_moments();
  double slowest = std::numeric_limits<double>::infinity();
  for (int a = 0; a < 3; ++a)
    if (moments[a] > 0 && stiffness[a] > 0) slowest = std::min(slowest, std::sqrt(stiffness[a] / moments[a]));
  return std::isinf(slowest) ? 0 : slowest;
}

}  // namespace soilweave::dem
