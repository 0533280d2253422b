// Elastic and Mohr-Coulomb points in plane strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/material/continuum_laws.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>

#include "core/linear_algebra.h"

namespace soilweave::fem {
namespace {

bool descending(const Vec3& s, double tolerance) { return s[0] >= s[1] - tolerance && s[1] >= s[2] - tolerance; }

}  // namespace

Vec3 mohr_coulomb_return(const Vec3& trial, double bulk, double shear, double sin_friction, double sin_dilation,
                         double cohesion) {
  const double f = sin_friction, d = sin_dilation, strength = 2 * cohesion * std::sqrt(1 - f * f);
  const auto yield = [&](double major, double minor) { return major - minor + (major + minor) * f - strength; };
  const double main = yield(trial[0], trial[2]);
  if (main <= 0) return trial;
  // Change of the three principal stresses by a unit of plastic flow.
  const double first = 2 * shear * (1 + d / 3) + 2 * bulk * d, between = (4 * shear / 3 - 2 * bulk) * d,
               last = 2 * shear * (1 - d / 3) - 2 * bulk * d;
  const double a = 4 * shear * (1 + f * d / 3) + 4 * bulk * f * d;
  const double tolerance = 1e-12 * trial.cwiseAbs().maxCoeff();
  const double one = main / a;
  Vec3 s = trial + one * Vec3(-first, between, last);
  if (descending(s, tolerance)) return s;

  // Maps to the edge where the intermediate stress equals the minor one (triaxial extension), or the major one.
  const bool right = (1 - d) * trial[0] - 2 * trial[1] + (1 + d) * trial[2] > 0;
  const double b = 2 * shear * (right ? 1 + f + d - f * d / 3 : 1 - f - d - f * d / 3) + 4 * bulk * f * d;
  const double other = right ? yield(trial[0], trial[1]) : yield(trial[1], trial[2]);
  const double determinant = a * a - b * b;
  const double along = (a * main - b * other) / determinant, across = (a * other - b * main) / determinant;
  s = trial + along * Vec3(-first, between, last) +
      across * (right ? Vec3(-first, last, between) : Vec3(between, -first, last));
  if (descending(s, tolerance)) return s;
  return Vec3::Constant(cohesion * std::sqrt(1 - f * f) / f);
}

ContinuumPoint::ContinuumPoint(const ContinuumLaw& law)
    : law_(law),
      lame_(law.young_modulus * law.poisson_ratio / ((1 + law.poisson_ratio) * (1 - 2 * law.poisson_ratio))),
      shear_(law.young_modulus / (2 * (1 + law.poisson_ratio))),
      stress_(Vec2(law.initial_stress[0], law.initial_stress[1]).asDiagonal()),
      out_of_plane_(law.initial_stress[2]) {
  initial_energy_ = elastic_energy();
}

void ContinuumPoint::advance(const Mat2& gradient) {
  const Mat2 midway = gradient * (Mat2::Identity() + 0.5 * gradient).inverse();
  const Mat2 strain = 0.5 * (midway + midway.transpose()), spin = 0.5 * (midway - midway.transpose());
  const Mat2 turn = (Mat2::Identity() - 0.5 * spin).inverse() * (Mat2::Identity() + 0.5 * spin);
  const Mat2 before = stress_;
  stress_ = (turn * stress_ * turn.transpose()).eval();
  stress_ += lame_ * strain.trace() * Mat2::Identity() + 2 * shear_ * strain;
  out_of_plane_ += lame_ * strain.trace();
  limit();
  work_ += 0.5 * (before + stress_).cwiseProduct(strain).sum();
}

void ContinuumPoint::limit() {
  if (!law_.friction_angle) return;
  const Eigensystem<Mat2> plane = eigensystem_in_closed_form(stress_);
  const Vec3 unsorted(plane.values[0], plane.values[1], out_of_plane_);
  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return unsorted[a] > unsorted[b]; });
  const Vec3 trial(unsorted[order[0]], unsorted[order[1]], unsorted[order[2]]);
  const Vec3 s = mohr_coulomb_return(trial, lame_ + 2 * shear_ / 3, shear_, std::sin(*law_.friction_angle),
                                     std::sin(law_.dilation_angle), law_.cohesion);
  if (s == trial) return;
  Vec3 limited;
  for (int k = 0; k < 3; ++k) limited[order[static_cast<std::size_t>(k)]] = s[k];
  const Mat2& axes = plane.vectors;
  stress_ = axes * limited.head<2>().asDiagonal() * axes.transpose();
  stress_ = (0.5 * (stress_ + stress_.transpose())).eval();
  out_of_plane_ = limited[2];
}

double ContinuumPoint::elastic_energy() const {
  const double trace = stress_.trace() + out_of_plane_;
  const double square = stress_.squaredNorm() + out_of_plane_ * out_of_plane_;
  return 0.5 / law_.young_modulus * ((1 + law_.poisson_ratio) * square - law_.poisson_ratio * trace * trace);
}

Mat3 ContinuumPoint::tangent() const {
  Mat3 t = Mat3::Zero();
  t.topLeftCorner<2, 2>().setConstant(lame_);
  t(0, 0) = t(1, 1) = lame_ + 2 * shear_;
  t(2, 2) = shear_;
  return t;
}

PointEnergy ContinuumPoint::energy() const {
  const double stored = elastic_energy() - initial_energy_;
  return {stored, 0, law_.friction_angle ? work_ - stored : 0};
}

void ContinuumPoint::archive(Archive& a, const std::string& prefix) {
  std::vector<double> kept(stress_.data(), stress_.data() + 4);
  kept.insert(kept.end(), {out_of_plane_, work_});
  a.sized(prefix + "stress", kept);
  std::copy(kept.begin(), kept.begin() + 4, stress_.data());
  out_of_plane_ = kept.at(4), work_ = kept.at(5);
}

}  // namespace soilweave::fem
