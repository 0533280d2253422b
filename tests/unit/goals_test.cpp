// Goals of cells, plates and paths, when they are reached, and the forecasts based on them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

#include "core/error.h"
#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/run/forecast.h"
#include "dem/run/run.h"
#include "support/assemblies.h"
#include "support/impact.h"
#include "support/scenario.h"

namespace soilweave::dem {
namespace {

using support::scenario;

std::unique_ptr<Path> path(const std::string& name, const std::string& keys) {
  Settings table = Settings::parse(keys, "test.toml");
  std::unique_ptr<Path> p = read_path(name, table);
  table.finish();
  return p;
}

PathState under(int dimension, const Vec3& stress) { return {dimension, stress.asDiagonal(), Vec3::Zero()}; }

TEST(Servo, HasNotSettledAboveItsStressNorBelowIt) {
  const Simulation s(support::packed(support::sand(), 1e5), support::sand(), {});
  Tolerances tolerances;
  tolerances.unbalanced_force = 1;
  const auto settled = [&](double share, int axis) {
    AxisGoals goals;
    for (int a = 0; a < 3; ++a)
      goals[static_cast<std::size_t>(a)] = {AxisGoal::Kind::stress, (a == axis ? share : 1) * s.measures().stress(a, a),
                                            1};
    return Servo::settled(goals, 3, tolerances, s);
  };
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_TRUE(settled(1, axis));
    // The tolerance is a thousandth of the goal.
    EXPECT_FALSE(settled(1 / 1.0011, axis)) << "stress above its goal";
    EXPECT_FALSE(settled(1 / 0.9989, axis)) << "stress below its goal";
    EXPECT_TRUE(settled(1 / 1.0009, axis));
  }
}

TEST(Run, LowersAStressToItsGoal) {
  const Scenario plan = scenario("[[stage]]\npath = \"isotropic\"\npressure = 5e4\n");
  const io::RunFile file = run(prepare(support::packed(plan.model, 1e5), plan), plan, {}).file;
  for (const char* stress : {"stress_xx", "stress_yy", "stress_zz"})
    EXPECT_NEAR(file.series.at(stress).values.back(), 5e4, 1e-3 * 5e4);
}

// A sphere presses its plate with its weight. That load has arrived, and neither a smaller nor a larger one.
TEST(Rig, ALoadHasArrivedWhereTheGrainsBearIt) {
  constexpr double radius = 0.01, g = 9.81;
  const HertzMindlin::Material m{1e9, 0.2, 0, {}, {}, {}};
  test::Sphere s{radius, 2650, Vec3(0.1, 0.1, radius), Vec3::Zero()};
  // Fn = 4/3 E* sqrt(R) d^1.5, with E* of two equal solids.
  s.position.z() -= std::pow(s.mass() * g / (4.0 / 3.0 * 1e9 / (2 * 0.96) * std::sqrt(radius)), 2.0 / 3.0);
  Simulation simulation(test::scene({s}, true), {std::vector<HertzMindlin::Material>{m, m, m}},
                        test::undamped(1e-6, g));
  const auto arrived = [&](double share) {
    Rig rig({RigPart{"plate", false, 0, 0}});
    rig.begin_stage();
    const std::vector<DriveGoal> goals = {{"plate", DriveGoal::Kind::load, Vec3::UnitZ(), share * s.mass() * g, 1e-6}};
    rig.drive(goals, 0, simulation);
    return rig.arrived(goals, 1e-3, simulation);
  };
  const double overlap = radius - s.position.z();  // a plate's control uses Hertz's tangent, 2 E* sqrt(R d)
  const double tangent = 2 * 1e9 / (2 * 0.96) * std::sqrt(radius * overlap);
  EXPECT_NEAR(simulation.plate_loads()[0].stiffness, tangent, 1e-9 * tangent);
  EXPECT_TRUE(arrived(1));
  EXPECT_FALSE(arrived(0.99)) << "pressed by more than the load";
  EXPECT_FALSE(arrived(1.01)) << "pressed by less than the load";
}

// A plate with a mass that meets no grain falls freely under its load, less the damping from its second step on.
TEST(Rig, APlateOfAMassIsAcceleratedByWhatTheGrainsDoNotBear) {
  const HertzMindlin::Material m{1e9, 0.2, 0, {}, {}, {}};
  const test::Sphere far{0.01, 2650, Vec3(0.1, 0.1, 0.15), Vec3::Zero()};
  constexpr double dt = 1e-5, load = 3, weight = 0.5, damping = 0.25;
  Simulation simulation(test::scene({far}, true), {std::vector<HertzMindlin::Material>{m, m, m}}, test::undamped(dt));
  Rig rig({RigPart{"plate", false, 0, weight}});
  rig.begin_stage();
  const auto velocity = [&](const DriveGoal& goal) {
    rig.drive({goal}, damping, simulation);
    const Vec3 v = simulation.planes().all[0].velocity;
    simulation.step();
    return v;
  };
  const DriveGoal pressed{"plate", DriveGoal::Kind::load, Vec3::UnitZ(), load, 1};
  const double gain = dt * load / weight;
  EXPECT_NEAR(velocity(pressed).z(), gain, 1e-12 * gain);
  EXPECT_NEAR(velocity(pressed).z(), gain * (1 + (1 - damping)), 1e-12 * gain);
  // A part that moves along its load, to either side, no longer carries it.
  const DriveGoal moved{"plate", DriveGoal::Kind::displacement, -Vec3::UnitZ(), 1, 0.3};
  EXPECT_EQ(velocity(moved), Vec3(0, 0, -0.3));
}

// Displacements count from the start of each stage, and the last step covers exactly the remaining distance.
TEST(Rig, DisplacementsCountFromTheStartOfTheStage) {
  const HertzMindlin::Material m{1e9, 0.2, 0, {}, {}, {}};
  const test::Sphere far{0.01, 2650, Vec3(0.1, 0.1, 0.15), Vec3::Zero()};
  Simulation simulation(test::scene({far}, true), {std::vector<HertzMindlin::Material>{m, m, m}}, test::undamped(1e-3));
  Rig rig({RigPart{"plate", false, 0, 0}});
  const std::vector<DriveGoal> goals = {{"plate", DriveGoal::Kind::displacement, Vec3::UnitY(), 2.5e-3, 1}};
  for (const double reached : {2.5e-3, 5e-3}) {
    rig.begin_stage();
    int steps = 0;
    for (; !rig.moved(goals) && steps < 10; ++steps) rig.drive(goals, 0, simulation), simulation.step();
    EXPECT_EQ(steps, 3) << "two whole ones and a half";
    EXPECT_NEAR(simulation.planes().all[0].point.y(), reached, 1e-15);
  }
}

// A plane may press on a grain at the start by a fiftieth of its radius and no more.
TEST(Prepare, RefusesPlanesThatStandInTheGrains) {
  const io::Snapshot grain = test::scene({{0.01, 2650, Vec3(0.1, 0.1, 0.1), Vec3::Zero()}}, false);
  const auto prepared = [&](double depth) {
    const Scenario plan = scenario(
        fmt::format("[[plane]]\nname = \"top\"\npoint = [0, 0, {}]\nnormal = [0, 0, -1]\n[[stage]]\npath = \"drive\"\n"
                    "[[stage.move]]\npart = \"top\"\nalong = [0, 0, 1]\ndistance = 1e-3\nspeed = 1\n",
                    0.11 - depth));
    return prepare(grain, plan);
  };
  EXPECT_NO_THROW(prepared(0.019 * 0.01));
  EXPECT_THROW(prepared(0.021 * 0.01), DataError);
}

TEST(Path, PlatesThatBothMoveTakeHalfTheWayAtHalfTheSpeedEach) {
  const std::string keys = "height = 0.2\nstations = [0.1, -0.05]\nrate = 0.3\n";
  for (const std::size_t station : {0U, 1U}) {
    const double strain = station ? -0.05 : 0.1;
    const auto both = path("uniaxial", keys)->drives(station);
    const auto upper = path("uniaxial", keys + "moving = \"upper\"\n")->drives(station);
    ASSERT_EQ(both.size(), 2U);
    ASSERT_EQ(upper.size(), 1U);
    Vec3 closed = Vec3::Zero();
    for (const DriveGoal& goal : both) {
      EXPECT_DOUBLE_EQ(goal.value, 0.5 * 0.2 * strain);
      EXPECT_DOUBLE_EQ(goal.speed, 0.5 * 0.2 * 0.3);
      closed += (goal.part == "bottom" ? 1 : -1) * goal.value * goal.direction;
    }
    EXPECT_DOUBLE_EQ(closed.z(), 0.2 * strain);
    EXPECT_DOUBLE_EQ(upper[0].value, 0.2 * strain);
    EXPECT_DOUBLE_EQ(upper[0].speed, 0.2 * 0.3);
    EXPECT_EQ(upper[0].part, "top");
    EXPECT_EQ(upper[0].direction, Vec3(-Vec3::UnitZ()));
  }
}

TEST(Path, MovesAndLoadsAreApproachedInEqualParts) {
  const auto drive = path("drive",
                          "parts = 4\n[[move]]\npart = \"a\"\nalong = [0, 0.3, 0.4]\ndistance = 0.02\nspeed = 1\n"
                          "[[load]]\npart = \"b\"\nalong = [0, 0, 1]\nforce = 50\nforce_from = 10\nspeed = 1\n");
  for (std::size_t station = 0; station < 4; ++station) {
    const double share = 0.25 * static_cast<double>(station + 1);
    for (const DriveGoal& goal : drive->drives(station)) {
      const bool load = goal.kind == DriveGoal::Kind::load;
      EXPECT_NEAR(goal.value, load ? 10 + 40 * share : 0.02 * share, 1e-12);
      EXPECT_LT((goal.direction - (load ? Vec3(0, 0, 1) : Vec3(0, 0.6, 0.8))).norm(), 1e-15);
    }
  }
}

// Natural strains of all axes sum to zero, in space and in the plane.
TEST(Path, ConstantVolumeHasNoVolumetricStrainInEitherDimension) {
  for (const int dimension : {2, 3}) {
    const AxisGoals goals = path("constant-volume", "axial_strain = 0.02\nincrement = 0.02\nrate = 0.3\n")
                                ->goals(0, under(dimension, Vec3(1e5, 1e5, 1e5)));
    double strain = 0, rate = 0;
    for (int a = 0; a < dimension; ++a) {
      const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      strain += goal.value;
      rate += (a == dimension - 1 ? 1 : -1) * goal.max_rate;
    }
    EXPECT_NEAR(strain, 0, 1e-17) << dimension;
    EXPECT_NEAR(rate, 0, 1e-15) << "and they get there together, " << dimension;
    EXPECT_EQ(goals[static_cast<std::size_t>(dimension - 1)].value, 0.02);
  }
}

TEST(Path, ConstantVolumeKeepsTheVoidRatioOfDisks) {
  const Model model = support::linear_sand();
  Simulation s(support::packed(model, 1e3, 60, 2), model, {});
  s.set_reference();
  const double before = s.void_ratio();
  const auto undrained = path("constant-volume", "axial_strain = 0.01\nincrement = 0.01\nrate = 5\n");
  Servo servo;
  const AxisGoals goals = undrained->goals(0, under(2, Vec3::Zero()));
  while (!Servo::strained(goals, 2, s)) servo.drive(goals, 2, s), s.step();
  EXPECT_NEAR(s.strain().y(), 0.01, 1e-9);
  // The product of the stretches of a step differs from one by the squared strain of the step.
  EXPECT_NEAR(s.void_ratio(), before, 1e-6);
}

// p = (sum of the stresses)/dimension, and the axial stress is given.
TEST(Path, ConstantPLeavesTheLateralAxesWhatTheAxialOneDoesNotTake) {
  const auto p = path("constant-p", "mean_stress = 1e5\naxial_strain = 0.1\n");
  EXPECT_DOUBLE_EQ(p->goals(0, under(3, Vec3(9e4, 9e4, 1.6e5)))[0].value, (3e5 - 1.6e5) / 2);
  EXPECT_DOUBLE_EQ(p->goals(0, under(2, Vec3(9e4, 1.6e5, 0)))[0].value, 2e5 - 1.6e5);
  EXPECT_DOUBLE_EQ(p->goals(0, under(3, Vec3(1, 1, 5e5)))[0].value, 1e2) << "never a tension";
}

// ---- The forecast. Steps of a stage: for each station its strain over rate and time step, and a rest.

Forecast::OfStage stage_of(const io::Snapshot& start, const std::string& stage, const std::string& before = "") {
  const Scenario plan = scenario("[[stage]]\n" + stage, before);
  return forecast(prepare(start, plan), plan).stages.at(0);
}
double steps_of(const io::Snapshot& start, const std::string& stage, const std::string& before = "") {
  return stage_of(start, stage, before).steps;
}

TEST(Forecast, CountsTheStepsOfStrainsAtTheirRates) {
  const io::Snapshot start = support::packed(support::sand(), 1e5, 60);
  const auto shear = [](double strain, double increment, double rate) {
    return fmt::format(
        "path = \"free\"\nparts = {}\n[stage.x]\nstrain = 0\n[stage.y]\nstrain = {}\nmax_rate = {}\n"
        "[stage.z]\nstrain = {}\nmax_rate = {}\n",
        std::lround(strain / increment), -0.1 * strain, rate, strain, rate);
  };
  const double dt = Simulation(start, support::sand(), {}).time_step();
  const Forecast::OfStage slow = stage_of(start, shear(0.02, 0.02, 0.05));
  EXPECT_NEAR(slow.steps - slow.waiting, 0.02 / (0.05 * dt), 1e-9 * slow.steps) << "the slowest axis rules";
  const double one = steps_of(start, shear(0.02, 0.02, 0.1)), rest = one - 0.02 / (0.1 * dt);
  EXPECT_GT(rest, 0);
  EXPECT_NEAR(steps_of(start, shear(0.02, 0.005, 0.1)) - one, 3 * rest, 1e-9 * one) << "a rest at every station";
  // Every e-fold of the unbalanced force takes equally long.
  const auto until = [&](const char* force) {
    return steps_of(start, shear(0.02, 0.02, 0.1), fmt::format("[equilibrium]\nunbalanced_force = {}\n", force));
  };
  EXPECT_GT(until("1e-4") - one, 100);
  EXPECT_NEAR(until("1e-5") - until("1e-4"), until("1e-4") - one, 1e-9 * one);
  const double undamped = steps_of(start, shear(0.02, 0.02, 0.1), "[numerics]\ndamping = 0.05\n");
  EXPECT_NEAR(undamped - one, 3 * rest, 1e-9 * one) << "a quarter of the damping of 0.2, four times the rest";
  EXPECT_EQ(steps_of(start, shear(0.02, 0.02, 0.1), "[equilibrium]\nsteps = 100\n"), 100) << "no station takes more";
}

TEST(Forecast, CountsTheStepsOfAStressByTheStiffness) {
  const io::Snapshot start = support::packed(support::sand(), 1e5, 60);
  const Simulation s(start, support::sand(), {});
  const double dt = s.time_step(), k = s.measures().axial_stiffness.minCoeff();
  ASSERT_GT(k, 1.1e6);
  const auto loaded = [&](double rate) {
    return steps_of(start, fmt::format("path = \"k0\"\naxial_stress = [2e5, 1e6]\nmax_rate = {}\n", rate));
  };
  const double strain = (1e6 - s.measures().stress(2, 2)) / s.measures().axial_stiffness.z();
  EXPECT_NEAR(loaded(1e-3) - loaded(2e-3), strain / dt * (1e3 - 5e2), 1e-9 * loaded(1e-3));
}

// Two hundred timed steps represent all steps.
TEST(Forecast, ItsTimeIsThatOfTheStepsTriedForAllOfThem) {
  const io::Snapshot start = support::packed(support::sand(), 1e5, 60);
  const Scenario plan = scenario(
      "[[stage]]\npath = \"triaxial\"\nconfining_pressure = 1e5\naxial_strain = 0.1\nincrement = 0.01\nrate = 0.01\n"
      "[[stage]]\npath = \"isotropic\"\npressure = 1e5\n[record]\nsnapshots = \"stations\"\n");
  const auto clock = std::chrono::steady_clock::now();
  const Forecast f = forecast(prepare(start, plan), plan);
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - clock).count();
  const double steps = f.stages.at(0).steps + f.stages.at(1).steps;
  EXPECT_NEAR(static_cast<double>(f.cost.steps), steps, 0.5);
  EXPECT_EQ(f.states, 12U) << "the start, ten stations and one";
  const double tried = f.cost.stepping / steps * 200;
  EXPECT_GT(tried, 0);
  EXPECT_LE(tried, took);
  EXPECT_NEAR(f.cost.contacts(), static_cast<double>(start.contacts.size()),
              0.1 * static_cast<double>(start.contacts.size()));
}

}  // namespace
}  // namespace soilweave::dem
