// The stability limit of the time step: below it a packing keeps its energy, well above it a guard stops the run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"
#include "dem/engine/simulation.h"
#include "dem/loading/control.h"
#include "support/assemblies.h"

namespace soilweave::dem {
namespace {

Model smooth_linear() {
  Model model = support::linear_sand();
  for (auto& m : model.materials.of<Linear::Material>()) m.rolling = m.twisting = {};
  return model;
}

Model bouncing_sand() {
  Model model = support::sand();
  for (auto& m : model.materials.of<HertzMindlin::Material>()) {
    m.rolling = m.twisting = {};
    m.restitution = 0.7;
  }
  return model;
}

// Runs a triaxial test under the servo until the steps end, or a guard ends them.
void compress(Simulation& simulation, int dimension, double pressure, int steps) {
  Servo servo;
  AxisGoals goals;
  goals.fill({AxisGoal::Kind::stress, pressure, 1});
  goals[static_cast<std::size_t>(dimension) - 1] = {AxisGoal::Kind::strain, 1, dimension == 3 ? 0.1 : 0.01};
  for (int k = 0; k < steps; ++k) {
    servo.drive(goals, dimension, simulation);
    simulation.step();
  }
}

// At 0.9 of the limit a test keeps its energy: to 5e-4 of the turned-over energy with damping, to 3e-3 without. An
// undamped grain that rattles between its neighbours has impacts of two or three steps and may gain a little at each.
// At three times the limit a guard stops the run within a few dozen steps.
TEST(StabilityLimit, KeepsAMargin) {
  for (const Model& model : {support::sand(), bouncing_sand(), support::linear_sand(), smooth_linear()})
    for (const int dimension : {3, 2}) {
      // Disks have N/m, and overlaps as small as those of the spheres.
      const double pressure = dimension == 3 ? 1e5 : 5e3;
      const io::Snapshot start = support::packed(model, pressure, 100, dimension);
      const double limit = Simulation(start, model, {}).stability_limit();
      for (const double damping : {0.0, 0.2}) {
        Numerics stable, unstable;
        unstable.time_step = 3 * limit;
        stable.time_step_safety = 0.9;
        stable.damping = unstable.damping = damping;
        Simulation good(start, model, stable), bad(start, model, unstable);
        EXPECT_NO_THROW(compress(good, dimension, pressure, 3000));
        const Energies e = good.energies();
        const double turned_over = e.initial() + std::abs(e["boundary_work"]) + e["frictional"];
        EXPECT_LT(std::abs(e.error()), (damping > 0 ? 1e-3 : 1e-2) * turned_over);
        // The servo meets its goal to 1 % if moments help to hold a hundred rearranging grains, to 2.5 % without
        // moments.
        EXPECT_NEAR(good.measures().stress(0, 0), pressure, 0.03 * pressure);
        EXPECT_THROW(compress(bad, dimension, pressure, 600), PhysicsError);
        EXPECT_LT(bad.steps(), 50);
      }
    }
}

// Dashpots that leave hardly any rebound: at 0.9 of the limit the servo brings a packing to rest under a greater
// stress. At the limit of the same contacts without dashpots, a guard stops the run.
TEST(StabilityLimit, CountsDashpots) {
  for (const double restitution : {0.1, 0.02}) {
    Model model = support::sand();
    const io::Snapshot start = support::packed(model, 1e5, 100);
    const double undamped = Simulation(start, model, {}).stability_limit();
    for (auto& m : model.materials.of<HertzMindlin::Material>()) m.restitution = restitution;
    Numerics stable, unstable;
    stable.time_step_safety = 0.9;
    unstable.time_step = undamped;
    Simulation good(start, model, stable), bad(start, model, unstable);
    const AxisGoal goal{AxisGoal::Kind::stress, 1.2e5, 1};
    Servo servo;
    int steps = 0;
    for (; steps < 50000 && !Servo::settled({goal, goal, goal}, 3, Tolerances(), good); ++steps) {
      servo.drive({goal, goal, goal}, 3, good);
      good.step();
    }
    EXPECT_LT(steps, 50000) << restitution << ": " << good.measures().stress(0, 0) << " Pa";
    EXPECT_THROW(compress(bad, 3, 1e5, 600), PhysicsError);
  }
}

}  // namespace
}  // namespace soilweave::dem
