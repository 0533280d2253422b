// A strip of yarns between clamps carries the curve of its yarns, unloads at the slope and breaks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/strip.h"

#include <gtest/gtest.h>

#include <cmath>

#include "dem/run/geotextile.h"
#include "dem/run/run.h"

namespace soilweave::dem {
namespace {

using support::move;
using support::pe_points;
using support::pulled;
using support::slow;
using support::strip;

const WireCurve pe{"PE", {0.02, 0.06, 0.17035}, {8.4, 20.6, 47.5}, 420};

// Expects the curve of a strip of n yarns in a row, in two rows, that is pulled, eased and pulled until it breaks.
void expect_curve(int n, double tolerance, double speed = slow) {
  const double length = 0.005 * n;
  const io::Snapshot start = strip(n);
  const Scenario plan =
      pulled(pe_points, move(0.09 * length, 9, speed) + move(-0.02 * length, 2, speed) + move(0.12 * length, 12, speed),
             0.5 * length);
  const io::RunFile run = dem::run(prepare(start, plan), plan, {}).file;
  const auto& way = run.series.at("displacement_right_y").values;
  const auto& force = run.series.at("force_right_y").values;
  WireHistory history;
  for (std::size_t k = 0; k < way.size(); ++k)
    EXPECT_NEAR(-force[k], 2 * pull(pe, way[k] / length, history), tolerance * 2 * 47.5) << "station " << k;
  EXPECT_TRUE(history.broken) << "the last stations lie beyond the last point of the curve";
  const io::YarnsRecord& yarns = run.snapshots.back().yarns;
  for (std::size_t k = 0; k < yarns.size(); ++k)
    if (yarns.broken[k]) {
      EXPECT_GT(yarns.break_time[k], 0);
      EXPECT_LT(std::abs(yarns.break_position[k].x()), 3e-3);
      // The node is half way between a fixed clamp and one that has moved by the breaking strain.
      if (n == 1) {
        EXPECT_NEAR(yarns.break_position[k].y(), 0.5 * 0.17035 * length, 1e-3 * length);
      }
    }
}

TEST(Strip, OfOneYarnCarriesItsCurveUnloadsAtTheSlopeAndBreaks) { expect_curve(1, 1e-6); }

// Yarns in a row yield one after the other, because the pull sends a wave along the strip. Their strains differ by the
// speed of the pull over the speed of the wave, 1e-3 over 8.8 m/s. A pull five times slower is five times nearer.
TEST(Strip, OfSeveralYarnsDoesSoInTheLimitOfASlowPull) {
  for (const double speed : {slow, slow / 5}) expect_curve(4, 0.5 * speed, speed);
}

}  // namespace
}  // namespace soilweave::dem
