// Frequency of the swing of an assembly that waits for rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/swing.h"

#include <algorithm>
#include <cmath>

#include "dem/engine/homogeneous.h"

namespace soilweave::dem {
namespace {

// Steps between samples. Single grains rattle faster than this, so that their motion averages out.
constexpr std::int64_t steps_between_looks = 80;
// Samples before the first estimate.
constexpr std::int64_t first_looks = 6;
// Lower bound of the frequency, as a share of the affine one.
constexpr double slowest_share = 0.1;

}  // namespace

void Swing::begin(const Simulation& simulation) {
  bound_ = slowest_swing(simulation);
  frequency_ = frequency_ > 0 ? std::min(frequency_, bound_) : bound_;
  looks_ = 0;
  products_ = squares_ = 0;
}

void Swing::look(const Simulation& simulation) {
  if (bound_ == 0 || simulation.steps() % steps_between_looks != 0) return;
  const HomogeneousField field(simulation);
  std::rotate(gradient_.begin(), gradient_.begin() + 1, gradient_.end());
  gradient_.back() = field.gradient(simulation.bodies()).diagonal();
  ++looks_;
  if (looks_ >= 3) estimate(field.second_moments(), steps_between_looks * simulation.time_step());
}

void Swing::estimate(const Vec3& moments, double interval) {
  const auto& [before, now, after] = gradient_;
  const Vec3 second = (after - 2 * now + before) / (interval * interval), first = (after - before) / (2 * interval);
  // The weight of a sample falls to 1/e after the time 1/w, because the swing lasts no longer.
  const double kept = std::exp(-interval * frequency_);
  products_ = kept * products_ - moments.dot(now.cwiseProduct(second + critical_drag() * first));
  squares_ = kept * squares_ + moments.dot(now.cwiseProduct(now));
  // A negative sum means that no force drives the motion back: the grains rearrange instead of swinging.
  if (looks_ < first_looks || !(products_ > 0)) return;
  frequency_ = std::clamp(std::sqrt(products_ / squares_), slowest_share * bound_, bound_);
}

void Swing::archive(Archive& a) {
  a.item("affine_frequency", bound_), a.item("swing_frequency", frequency_);
  for (std::size_t k = 0; k < gradient_.size(); ++k) a.item("swing_gradient_" + std::to_string(k), gradient_[k]);
  a.whole("swing_looks", looks_);
  a.item("swing_products", products_), a.item("swing_squares", squares_);
}

}  // namespace soilweave::dem
