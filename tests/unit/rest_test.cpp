// Forecast of the waits for rest: their terms by hand, and runs whose steps lie in the range that it gives.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/rest.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "dem/engine/homogeneous.h"
#include "dem/run/forecast.h"
#include "dem/run/run.h"
#include "support/assemblies.h"
#include "support/scenario.h"

namespace soilweave::dem {
namespace {

using support::scenario;

const std::string triaxial =
    "[[stage]]\npath = \"triaxial\"\nconfining_pressure = 1e5\naxial_strain = 0.04\nincrement = 0.01\nrate = 0.1\n";

Arrival sheared(double rate, double pressure) {
  Arrival arrival;
  arrival.gradient(2, 2) = rate, arrival.sheared = true, arrival.pressure = pressure;
  return arrival;
}

// At a damping of 0.5 a wait takes 1.7 * 0.45 ln(U/limit) inertial times d sqrt(rho/p), with U = 0.43 I^0.6.
TEST(RestEstimate, CountsInertialTimesInACell) {
  const io::Snapshot start = support::packed(support::sand(), 1e5, 60);
  const Scenario plan = scenario(triaxial, "[numerics]\ndamping = 0.5\n[equilibrium]\nunbalanced_force = 1e-4\n");
  const Simulation s(start, plan.model, plan.numerics);
  const RestEstimate rest(s, plan);
  double diameter = 0, mass = 0, solid = 0;
  for (std::size_t i = 0; i < start.grains.size(); ++i) {
    const double r = start.grains.radius[i];
    diameter += 2 * r / static_cast<double>(start.grains.size());
    mass += start.grains.mass[i], solid += 4 * M_PI / 3 * r * r * r;
  }
  const double time = diameter * std::sqrt(mass / solid / 4e5);
  const double folds = std::log(0.43 * std::pow(0.1 * time, 0.6) / 1e-4);
  EXPECT_NEAR(rest.steps(plan.stages[0], sheared(0.1, 4e5)), 1.7 * 0.45 * folds * time / s.time_step(),
              1e-6 * folds * time / s.time_step());
  EXPECT_EQ(rest.steps(plan.stages[0], sheared(1e-12, 4e5)), 20)
      << "grains that hardly move have come to rest on the way";
}

// The tried steps show that the time step falls with the pressure to the power 1/6, as for Hertz's contacts.
TEST(RestEstimate, LearnsHowTheTimeStepFallsWithThePressure) {
  const Scenario plan = scenario(triaxial);
  const Simulation soft(support::packed(support::sand(), 1e5, 60), plan.model, plan.numerics);
  const Simulation stiff(support::packed(support::sand(), 1e6, 60), plan.model, plan.numerics);
  RestEstimate rest(soft, plan);
  EXPECT_EQ(rest.step_share(sheared(0.1, 1e6)), 1) << "nothing learnt";
  rest.learn(soft);
  EXPECT_EQ(rest.step_share(sheared(0.1, 1e6)), 1) << "the same pressure tells nothing";
  rest.learn(stiff);
  EXPECT_NEAR(rest.step_share(sheared(0.1, 1e6)), stiff.time_step() / soft.time_step(), 0.01);
  EXPECT_LT(rest.step_share(sheared(0.1, 1e6)), 0.8);
}

// Between plates under a drag of 2 half, the remaining energy of the velocity field falls at the rate
// 2 (half - sqrt(half^2 - w^2)), where w is half the frequency of the slowest affine swing.
TEST(RestEstimate, TakesTheSlowestSwingUnderADrag) {
  io::Snapshot start = support::packed(support::sand(), 1e5, 60);
  start.cell.periodic = {false, false, false};
  const Simulation s(start, support::sand(), {});
  const double w = 0.5 * slowest_swing(s), half = 2 * w, slow = half - std::sqrt(half * half - w * w);
  ASSERT_GT(w, 0);
  const auto waits = [&](const char* energy, const char* keys) {
    const Scenario plan = scenario(triaxial + fmt::format("rest_drag = {}\n{}", 2 * half, keys),
                                   fmt::format("[equilibrium]\nkinetic_energy = {}\n", energy));
    return RestEstimate(s, plan).steps(plan.stages[0], sheared(0.1, 1e5)) * s.time_step();
  };
  EXPECT_NEAR(waits("1e-14", "") - waits("1e-12", ""), 0.5 * std::log(100) / slow, 1e-9 / slow);
  EXPECT_NEAR(waits("1e-14", "") - waits("1e-14", "homogeneous_start = true\n"), -0.5 * std::log(0.012) / slow,
              1e-9 / slow);
}

double steps_taken(const io::Snapshot& start, const Scenario& plan) {
  return run(prepare(start, plan), plan, {}).file.series.at("step").values.back();
}

TEST(Forecast, TellsARangeThatHoldsTheStepsOfTheRun) {
  const io::Snapshot start = support::packed(support::sand(), 1e5, 100);
  for (const char* rate : {"0.1", "1"})
    for (const char* damping : {"0.2", "0.7"}) {
      const Scenario plan =
          scenario(triaxial + fmt::format("max_rate = 1\ndamping = {}\n", damping) +
                   fmt::format("[[stage]]\npath = \"isotropic\"\npressure = 4e5\nmax_rate = {}\n", rate));
      const Forecast f = forecast(prepare(start, plan), plan);
      const double fewest = f.stages[0].fewest + f.stages[1].fewest, most = f.stages[0].most + f.stages[1].most;
      const double taken = steps_taken(start, plan);
      EXPECT_LT(fewest, taken) << damping;
      EXPECT_GT(most, taken) << damping;
      EXPECT_LT(fewest, static_cast<double>(f.cost.steps));
      EXPECT_GT(most, static_cast<double>(f.cost.steps));
      EXPECT_LT(most, 5 * fewest) << "a range that tells something";
      EXPECT_LT(f.least_time, f.cost.stepping + f.cost.output);
      EXPECT_GT(f.greatest_time, f.cost.stepping + f.cost.output);
    }
}

// Strains at constant volume come after a stress of a hundred times the present one.
TEST(Forecast, TakesThePressureOfTheStageBeforeForStrainsAlone) {
  const io::Snapshot start = support::packed(support::sand(), 1e3, 100);
  const Scenario plan = scenario(
      "[[stage]]\npath = \"isotropic\"\npressure = 1e5\n[[stage]]\npath = \"constant-volume\"\naxial_strain = 0.01\n"
      "increment = 0.005\nrate = 0.1\n");
  const Forecast f = forecast(prepare(start, plan), plan);
  const double fewest = f.stages[0].fewest + f.stages[1].fewest, most = f.stages[0].most + f.stages[1].most;
  const double taken = steps_taken(start, plan);
  EXPECT_LT(fewest, taken);
  EXPECT_GT(most, taken);
}

}  // namespace
}  // namespace soilweave::dem
