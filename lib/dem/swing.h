// How fast what waits for rest swings, and the drag that brings it to rest soonest.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A mode of frequency w under a drag c (over the mass) decays soonest where c = 2 w: with less it swings on, with more
// it creeps. An assembly of scaled density swings slowest as a whole. The velocity gradient L that fits its grains
// best, looked at every so many steps, tells how fast: from L'' + c L' + w^2 L = 0 by least squares,
//   w^2 = -sum M L (L'' + c L') / sum M L^2,
// with the second moments of mass M for weights, so that the swing that holds the energy counts. Dynamic relaxation
// estimates its damping likewise (Underwood, 1983). Contacts that strain affinely are stiffer than any that do not:
// their frequency bounds the estimate from above, and is what there is before the first.
#pragma once

#include <array>

#include "core/archive.h"
#include "dem/simulation.h"

namespace soilweave::dem {

class Swing {
 public:
  /// As what moved the grains stops: they swing about another state from here.
  void begin(const Simulation& simulation);
  /// Looks at the grains after a step, now and then.
  void look(const Simulation& simulation);
  /// 1/s, twice the frequency of the swing.
  double critical_drag() const { return 2 * frequency_; }
  void archive(Archive& archive);

 private:
  void estimate(const Vec3& moments, double interval);

  double bound_ = 0, frequency_ = 0;  // 1/s; bound_: of contacts that strain affinely; 0: nothing touches
  /// 1/s, diagonal of L at the last three looks, the latest last.
  std::array<Vec3, 3> gradient_ = {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
  std::int64_t looks_ = 0;             // since it began
  double products_ = 0, squares_ = 0;  // the sums, older looks counting less
};

}  // namespace soilweave::dem
