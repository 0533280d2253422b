// Frequency of the swing of an assembly that waits for rest, and the drag that stops it soonest.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mode of frequency w under a drag c (over the mass) decays soonest for c = 2 w. With less it swings on, with more it
// creeps. The whole assembly swings slowest. Its frequency follows from samples of the velocity gradient L that fits
// the grains best: L'' + c L' + w^2 L = 0 gives by least squares
//   w^2 = -sum M L (L'' + c L') / sum M L^2,
// with the second moments of mass M as weights, as in dynamic relaxation (Underwood, 1983). The frequency of contacts
// that strain affinely bounds the estimate from above, and serves before the first one.
#pragma once

#include <array>

#include "core/archive.h"
#include "dem/engine/simulation.h"

namespace soilweave::dem {

/// Estimator of the swing of one run.
class Swing {
 public:
  /// Starts anew. Call it when the loading stops.
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

  /// Frequency if contacts strain affinely (0: no contacts), and the estimate, 1/s.
  double bound_ = 0, frequency_ = 0;
  /// Diagonal of L at the last three samples, latest last, 1/s.
  std::array<Vec3, 3> gradient_ = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  /// Number of samples since the wait began.
  std::int64_t looks_ = 0;
  /// Sums in which older samples count less.
  double products_ = 0, squares_ = 0;
};

}  // namespace soilweave::dem
