// Frequency of the swing of an assembly that waits for rest, and the drag that stops it soonest.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mode of frequency w under a drag c (over the mass) decays fastest for c = 2 w. It oscillates under a smaller drag,
// and creeps under a larger one. The slowest mode is the swing of the whole assembly. Its frequency is fitted to
// samples of the velocity gradient L of the grains: L'' + c L' + w^2 L = 0 gives by least squares
//   w^2 = -sum M L (L'' + c L') / sum M L^2,
// with the second moments of mass M as weights, as in dynamic relaxation (Underwood, 1983). The frequency under affine
// strain of the contacts is an upper bound, and the value before the first estimate.
#pragma once

#include <array>

#include "core/archive.h"
#include "dem/engine/simulation.h"

namespace soilweave::dem {

/// Estimator of the swing of one run.
class Swing {
 public:
  /// Discards all samples. Call it when the loading stops.
  void begin(const Simulation& simulation);
  /// Samples the grains after a step, at intervals.
  void look(const Simulation& simulation);
  /// Returns twice the frequency of the swing, 1/s.
  double critical_drag() const { return 2 * frequency_; }
  /// Keeps or restores samples and sums.
  void archive(Archive& archive);

 private:
  /// Fits the frequency to the samples so far.
  void estimate(const Vec3& moments, double interval);

  /// Frequency under affine strain (0: no contacts), and estimated frequency, 1/s.
  double bound_ = 0, frequency_ = 0;
  /// Diagonal of L at the last three samples, latest last, 1/s.
  std::array<Vec3, 3> gradient_ = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  /// Number of samples since the wait began.
  std::int64_t looks_ = 0;
  /// Sums of the least-squares fit, in which older samples count less.
  double products_ = 0, squares_ = 0;
};

}  // namespace soilweave::dem
