// The homogeneous field of velocity: recovered as added, without momentum, in the ledger, and in a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/homogeneous.h"

#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <random>

#include "dem/engine/mass_scaling.h"
#include "dem/loading/rig.h"
#include "dem/run/prepare.h"
#include "dem/run/run.h"
#include "dem/run/way.h"
#include "support/assemblies.h"
#include "support/assembly.h"
#include "support/same_state.h"

namespace soilweave::dem {
namespace {

using io::test::expect_error;

Vec3 momentum(const Bodies& bodies) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i < bodies.size(); ++i) sum += bodies.mass(i) * vector_of(bodies.velocity(i));
  return sum;
}

Bodies in_motion(const io::Snapshot& state) {
  Bodies bodies(state.grains);
  std::mt19937 engine(3);
  std::normal_distribution<double> part(0, 0.01);
  for (std::size_t i = 0; i < bodies.size(); ++i)
    bodies.set_velocity(i, Vec3(part(engine), part(engine), state.grains.dimension == 3 ? part(engine) : 0));
  return bodies;
}

TEST(Homogeneous, FieldIsFoundAgainAndTakesNoMomentum) {
  for (const int dimension : {3, 2}) {
    Bodies bodies = in_motion(support::packed(support::sand(), 1e5, 120, dimension));
    const HomogeneousField field(bodies, {true, true, true}, std::vector<bool>(bodies.size(), false));
    Mat3 laid;
    laid << 0.3, -0.2, 0.1, 0.5, 0.4, -0.6, 0.2, 0.7, -0.9;
    if (dimension == 2) laid.row(2).setZero(), laid.col(2).setZero();
    const Mat3 before = field.gradient(bodies);
    const Vec3 carried = momentum(bodies);
    field.add(laid, bodies);
    EXPECT_LT((field.gradient(bodies) - before - laid).norm(), 1e-12);
    field.add(-field.gradient(bodies), bodies);
    EXPECT_LT(field.gradient(bodies).norm(), 1e-12) << "nothing of it is left";
    EXPECT_LT((momentum(bodies) - carried).norm(), 1e-13 * bodies.total_mass());
  }
}

TEST(Homogeneous, FieldDoesNotVaryAlongPeriodicAxesNorMoveWhatIsHeld) {
  Bodies bodies = in_motion(support::packed(support::sand(), 1e5, 120));
  std::vector<bool> held(bodies.size(), false);
  held[5] = held[17] = true;
  const HomogeneousField field(bodies, {false, true, true}, held);
  EXPECT_EQ(field.gradient(bodies).col(0), Vec3::Zero());
  const Vec3 of_one = vector_of(bodies.velocity(5));
  Mat3 laid = Mat3::Zero();
  laid(2, 2) = -1;
  field.add(laid, bodies);
  EXPECT_EQ(vector_of(bodies.velocity(5)), of_one);
  EXPECT_NE(vector_of(bodies.velocity(6)).z(), 0);
}

// Three by three columns of eight equal spheres between plates form an even bar, along which waves run.
constexpr double radius = 0.01;
io::Snapshot columns() {
  io::Snapshot s;
  s.cell.matrix = Vec3(1, 1, 1).asDiagonal();
  s.cell.periodic = {false, false, false};
  for (int z = 0; z < 8; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x) analysis::test::add_grain(s, 2 * radius * Vec3(x, y, z), radius);
  for (double& m : s.grains.mass) m = 10;
  return s;
}

const std::string plates =
    "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = \"4 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 29\n"
    "[[plane]]\nname = \"top\"\npoint = \"touch\"\nnormal = [0, 0, -1]\n"
    "[[plane]]\nname = \"bottom\"\npoint = \"touch\"\nnormal = [0, 0, 1]\n"
    "[equilibrium]\nkinetic_energy = 1e-6\n";
const std::string pressed =
    "[[stage]]\npath = \"drive\"\ndamping = 0.5\n"
    "[[stage.load]]\npart = \"top\"\nalong = [0, 0, -1]\nforce = 9000\nspeed = 0.1\n"
    "[[stage.load]]\npart = \"bottom\"\nalong = [0, 0, 1]\nforce = 9000\nspeed = 0.1\n";
const std::string compression =
    "[[stage]]\npath = \"uniaxial\"\nheight = 0.16\nstrain = 0.008\nincrement = 0.002\nrate = 0.05\n";

Scenario pressing(const std::string& keys, const std::string& stages = pressed + compression) {
  return read_scenario(plates + stages + keys, "columns.toml", {});
}

io::RunFile compressed(const std::string& keys) {
  const Scenario scenario = pressing(keys);
  return run(prepare(columns(), scenario), scenario, {}).file;
}

double last(const io::RunFile& file, const char* name) { return file.series.at(name).values.back(); }

// Returns the change since the preload, which ends with a bump.
double since_preload(const io::RunFile& file, const char* name) {
  const std::vector<double>& values = file.series.at(name).values;
  return values.back() - values[1];
}

TEST(Homogeneous, StartsAndStopsAreInTheLedgerAndSpareSteps) {
  const std::string critical = "rest_drag = \"critical\"\n";
  const io::RunFile without = compressed(critical), with = compressed(critical + "homogeneous_start = true\n");
  EXPECT_LT(std::abs(since_preload(with, "energy_error")), 1e-3 * since_preload(with, "boundary_work"));
  EXPECT_LT(since_preload(with, "steps_waiting"), 0.6 * since_preload(without, "steps_waiting"));
  EXPECT_NEAR(last(with, "force_top_z") / last(without, "force_top_z"), 1, 0.002) << "the same rest";
}

TEST(Homogeneous, StartNeedsPartsThatFaceEachOther) {
  Scenario scenario = pressing("homogeneous_start = true\n");
  scenario.planes.normal[1] = Vec3::UnitX();
  expect_error<DataError>([&] { prepare(columns(), scenario); }, "two named planes that face each other");
}

TEST(Homogeneous, GradientOfAWayIsThatOfThePlates) {
  const Scenario scenario = pressing("");
  std::vector<RigPart> parts;
  for (const PartSetting& p : scenario.parts) parts.push_back(p.part);
  const Rig rig(parts);
  const Simulation simulation(prepare(columns(), scenario), scenario.model, scenario.numerics);
  const auto& planes = simulation.planes().all;
  const double height = planes[0].point.z() - planes[1].point.z();
  using Kind = DriveGoal::Kind;
  Mat3 before = Mat3::Zero();
  before(0, 0) = 0.3, before(2, 2) = 0.7;
  const Mat3 pressed_and_sheared = rig.gradient_of_way({{"top", Kind::displacement, -Vec3::UnitZ(), 1e-3, 2e-3},
                                                        {"bottom", Kind::displacement, Vec3::UnitX(), 1e-3, 4e-3}},
                                                       0.5, before, simulation);
  Mat3 expected = Mat3::Zero();
  expected(0, 0) = 0.3, expected(2, 2) = -1e-3 / height, expected(0, 2) = -2e-3 / height;
  EXPECT_LT((pressed_and_sheared - expected).norm(), 1e-14);
}

// Plates, grains and their driver, which can go on from a checkpoint.
struct Rigged {
  Scenario scenario = pressing("rest_drag = \"critical\"\nhomogeneous_start = true\n");
  io::Snapshot start = prepare(columns(), scenario);
  Simulation simulation;
  Rig rig;
  Way way;

  explicit Rigged(int threads) : simulation(start, scenario.model, with(threads)), rig(parts()) {}
  Rigged(const Rigged& other, Archive given)
      : simulation(other.simulation.snapshot(), scenario.model, with(1), given), rig(parts()) {
    rig.archive(given), way.archive(given);
  }
  Numerics with(int threads) const {
    Numerics numerics = scenario.numerics;
    numerics.threads = threads;
    return numerics;
  }
  std::vector<RigPart> parts() const {
    std::vector<RigPart> all;
    for (const PartSetting& p : scenario.parts) all.push_back(p.part);
    return all;
  }
  Archive archive() {
    Archive kept;
    simulation.archive(kept), rig.archive(kept), way.archive(kept);
    return {kept.numbers(), "memory"};
  }
  void step(bool waiting) {
    const std::vector<DriveGoal> goals = {
        {"top", DriveGoal::Kind::displacement, -Vec3::UnitZ(), waiting ? 0 : 1e-2, 1e-2}};
    rig.begin_stage();
    rig.drive(goals, 0.2, simulation);
    way.before_step(scenario.stages[1], waiting, goals, 1, rig, simulation);
    simulation.step();
    way.after_step(simulation);
  }
};

TEST(Homogeneous, GoesOnInAWayAndInAWaitToTheSameBitsOnAnyThreads) {
  Rigged whole(1), threaded(3);
  auto resumed = std::make_unique<Rigged>(whole, whole.archive());
  for (int k = 0; k < 1300; ++k) {
    const bool waiting = k / 500 % 2 == 1;
    whole.step(waiting), threaded.step(waiting), resumed->step(waiting);
    if (k % 77 != 0) continue;
    io::test::expect_same(whole.simulation.snapshot(), threaded.simulation.snapshot());
    io::test::expect_same(whole.simulation.snapshot(), resumed->simulation.snapshot());
    EXPECT_EQ(whole.simulation.energies().error(), resumed->simulation.energies().error());
    resumed = std::make_unique<Rigged>(*resumed, resumed->archive());
  }
  EXPECT_GT(whole.way.waited(), 490);
  EXPECT_EQ(whole.way.waited(), resumed->way.waited());
}

TEST(MassScaling, GrainsOfAnySizeBearTheSameStepAndWeighWhatTheyDid) {
  io::GrainsRecord grains = support::packed(support::sand(), 1e5, 120).grains;
  const auto total = [&] { return std::accumulate(grains.mass.begin(), grains.mass.end(), 0.0); };
  const double before = total();
  equalise_steps(support::sand(), grains);
  EXPECT_NEAR(total(), before, 1e-12 * before);
  // Hertz: k = 2 E* sqrt(R* d) is proportional to the radius if the overlap is.
  for (std::size_t i = 0; i < grains.size(); ++i)
    EXPECT_NEAR(grains.mass[i] / grains.radius[i], grains.mass[0] / grains.radius[0], 1e-9 * before);
  const std::vector<double> once = grains.mass;
  equalise_steps(support::sand(), grains);
  for (std::size_t i = 0; i < grains.size(); ++i) EXPECT_NEAR(grains.mass[i], once[i], 1e-12 * once[i]);
}

TEST(MassScaling, IsRefusedWhereGrainsWeighSomething) {
  const std::string heavy = "[grains]\nmass_scaling = \"equal-step\"\n[numerics]\ngravity = [0, 0, -9.81]\n";
  const Scenario scenario = pressing("", heavy + pressed);
  io::test::expect_error<DataError>([&] { prepare(columns(), scenario); }, "numerics.gravity is not zero");
}

TEST(Homogeneous, CriticalDragNeedsRoomToSwing) {
  const Scenario scenario = pressing("rest_drag = \"critical\"\n");
  io::Snapshot soil = columns();
  soil.cell.periodic = {true, true, true};
  expect_error<DataError>([&] { prepare(soil, scenario); }, "periodic along all axes");
}

}  // namespace
}  // namespace soilweave::dem
