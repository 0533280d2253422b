// Whole compactions: the void ratio asked for is held at rest, or the message names one that is in reach.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "packing/generate/generate.h"
#include "support/assemblies.h"
#include "support/clouds.h"
#include "support/messages.h"

namespace soilweave::packing {
namespace {

using support::sparse;
using test::message_of;
using test::number_after;

io::Snapshot loose(int dimension) {
  std::vector<double> radii = Grading::toyoura().radii(200, dimension);
  for (double& r : radii) r *= 0.58;
  return cloud(radii, 2.0, {1, 1, 1}, dimension, 2650e3, 3);
}

TEST(Compact, HoldsVoidRatioAndPressureAtFullFriction) {
  Recipe recipe;
  recipe.pressure = 1e5;
  recipe.void_ratio = 0.70;
  const Result result = compact(loose(3), support::sand(), {}, recipe);
  const dem::Simulation s(result.state, support::sand(), {});
  EXPECT_NEAR(s.void_ratio(), 0.70, 0.002);
  EXPECT_NEAR(s.measures().stress(0, 0), 1e5, 1e2);
  EXPECT_LE(s.unbalanced_force(), 1e-3);
  EXPECT_LT(result.friction_angle, 29 * support::degree);
  EXPECT_EQ(s.strain(), Vec3(Vec3::Zero()));
}

TEST(Compact, MakesDisksByTheSamePath) {
  Recipe recipe;
  recipe.pressure = 1e3;
  const dem::Model model = support::linear_sand();
  const double loosest = compact(loose(2), model, {}, recipe).void_ratio;
  recipe.void_ratio = loosest - 0.01;
  EXPECT_NEAR(compact(loose(2), model, {}, recipe).void_ratio, loosest - 0.01, 0.002);
}

TEST(Compact, SaysWhyAVoidRatioCannotBeReached) {
  Recipe recipe;
  recipe.pressure = 1e5;
  for (const auto& [target, reason] :
       {std::pair(1.2, "at the full friction angle"), std::pair(0.3, "without friction")}) {
    recipe.void_ratio = target;
    try {
      compact(loose(3), support::sand(), {}, recipe);
      FAIL() << target << " was reached";
    } catch (const TargetNotReached& e) {
      EXPECT_NE(std::string(e.what()).find(reason), std::string::npos) << e.what();
    }
  }
}

TEST(Compact, NamesTheVoidRatiosInReachAndTheyAre) {
  Recipe recipe;
  recipe.pressure = 1e5;
  recipe.void_ratio = 1.5;
  const auto work = [&] { return compact(sparse(80), support::sand(), {}, recipe); };
  const double loosest = number_after("ask for at most ", message_of<TargetNotReached>(work));
  recipe.void_ratio = 0.2;
  const double densest = number_after("ask for one from ", message_of<TargetNotReached>(work));
  EXPECT_LT(densest, loosest - 0.05);
  for (const double e : {densest, loosest}) {
    recipe.void_ratio = e;
    const Result result = work();
    EXPECT_NEAR(result.void_ratio, e, 0.002);
    EXPECT_FALSE(result.unheld);
  }
}

// The first attempt misses so narrow a tolerance; further ones start from the same cloud.
TEST(Compact, BeginsAgainWhereAVoidRatioIsNotHeld) {
  Recipe recipe;
  recipe.pressure = 1e5;
  recipe.void_ratio = 0.72, recipe.void_ratio_tolerance = 2e-5;
  recipe.most_attempts = 1;
  const Result once = compact(sparse(80), support::sand(), {}, recipe);
  ASSERT_TRUE(once.unheld);
  EXPECT_NEAR(number_after("at last to ", *once.unheld), once.void_ratio, 1e-4);
  recipe.most_attempts = 12;
  const Result often = compact(sparse(80), support::sand(), {}, recipe);
  EXPECT_GT(often.cost.steps, once.cost.steps);
  EXPECT_LT(std::abs(often.void_ratio - 0.72), std::abs(once.void_ratio - 0.72));
  const dem::Simulation s(often.state, support::sand(), {});
  EXPECT_LE(s.unbalanced_force(), 1e-3);
  EXPECT_NEAR(s.measures().stress(0, 0), 1e5, 2e2);
}

TEST(Ahead, RefusesACloudThatDoesNotCloseAndNamesRateAndDensityThatCloseIt) {
  io::Snapshot light = sparse(60);
  for (double& m : light.grains.mass) m *= 1e-9;
  Recipe recipe;
  recipe.pressure = 1e5, recipe.tolerances.unbalanced_force = 1e-2, recipe.max_rate = 0.1;
  const auto work = [&] { compact(light, support::sand(), {}, recipe); };
  const std::string said = message_of<DataError>(work);
  const double rate = number_after("raise the rate to ", said), density = number_after("scale the density by ", said);
  for (double& m : light.grains.mass) m *= density;
  EXPECT_NO_THROW(work());
  for (double& m : light.grains.mass) m /= density;
  recipe.max_rate = rate;
  EXPECT_NO_THROW(work());
}

}  // namespace
}  // namespace soilweave::packing
