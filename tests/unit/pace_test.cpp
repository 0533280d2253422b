// The loading speed: found from the response of the grains, and never above the prescribed speed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/pace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace soilweave::dem {
namespace {

constexpr double wanted = 0.02;
constexpr std::int64_t look = 16;
constexpr std::size_t grains = 8000;  // a wave crosses them in 200 steps

// Grains whose unbalanced force lags behind the speed by one crossing. In steady motion it is `per_speed` times the
// speed.
struct Delayed {
  double top_speed, per_speed, unbalanced = 1e-3, speed = 0, largest = 0;

  void go(Pace& pace, std::int64_t steps) {
    for (std::int64_t k = 0; k < steps; k += look) {
      pace.follow(unbalanced, wanted, look);
      speed = pace.share() * top_speed;
      unbalanced += (per_speed * speed - unbalanced) * static_cast<double>(look) / 200;
      largest = std::max(largest, unbalanced);
    }
  }
};

TEST(Pace, KeepsTheUnbalancedForceWhateverSpeedItIsGiven) {
  for (const double top_speed : {1.0, 3.0, 50.0}) {
    Pace pace(grains, 3);
    Delayed assembly{top_speed, 0.04};
    assembly.go(pace, 40000);
    EXPECT_NEAR(assembly.unbalanced, wanted, 0.02 * wanted) << top_speed;
    EXPECT_NEAR(assembly.speed, 0.5, 0.01) << top_speed;
    EXPECT_LT(assembly.largest, 1.6 * wanted) << top_speed << ": overshoots";
  }
}

TEST(Pace, GoesNoFasterThanGivenAndNeverStops) {
  Pace easy(grains, 3), stuck(grains, 3);
  for (int k = 0; k < 10000; ++k) easy.follow(0, wanted, look), stuck.follow(1, wanted, look);
  EXPECT_EQ(easy.share(), 1);
  EXPECT_EQ(stuck.share(), 0.01);
}

TEST(Pace, SlowsDownSoonerThanItSpeedsUp) {
  Pace pace(grains, 3);
  Delayed assembly{1, 0.04};
  assembly.go(pace, 40000);
  const double at_first = pace.share();
  pace.follow(10 * wanted, wanted, look);
  const double slower = at_first / pace.share();
  Pace other(grains, 3);
  Delayed{1, 0.04}.go(other, 40000);
  other.follow(wanted / 10, wanted, look);
  EXPECT_GT(std::log(slower), 5 * std::log(other.share() / at_first));
  EXPECT_GT(other.share(), at_first);
}

TEST(Pace, TakesLongerAcrossMoreGrainsAndBeginsEveryStageAnew) {
  Pace few(grains, 3), many(8 * grains, 3), disks(400, 2);
  few.follow(1e-4, wanted, look), disks.follow(1e-4, wanted, look);
  many.follow(1e-4, wanted, 2 * look);
  EXPECT_NEAR(many.share(), few.share(), 1e-12);
  EXPECT_NEAR(disks.share(), few.share(), 1e-12);
  const double begun = few.share();
  Delayed{1, 0.04}.go(few, 40000);
  EXPECT_GT(few.share(), 2 * begun);
  few.begin_stage();
  few.follow(1e-4, wanted, look);
  EXPECT_EQ(few.share(), begun);
}

TEST(Pace, GoesOnFromWhatIsKept) {
  Pace whole(grains, 3), resumed(grains, 3);
  Delayed assembly{3, 0.04};
  assembly.go(whole, 3000);
  Archive kept;
  whole.archive(kept);
  Archive given(kept.numbers(), "memory");
  resumed.archive(given);
  for (int k = 0; k < 50; ++k) {
    whole.follow(0.5 * wanted, wanted, look), resumed.follow(0.5 * wanted, wanted, look);
    EXPECT_EQ(whole.share(), resumed.share());
  }
}

}  // namespace
}  // namespace soilweave::dem
