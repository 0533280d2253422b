// Quantities that a run records and guards watch, for a few grains whose numbers can be counted by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "dem/contact/laws/linear.h"
#include "dem/engine/energy_term.h"
#include "dem/engine/guard.h"
#include "dem/run/cost.h"
#include "dem/run/record.h"
#include "support/assemblies.h"
#include "support/impact.h"
#include "support/page.h"

namespace soilweave::dem {
namespace {

using test::scene;
using test::Sphere;
using test::undamped;

constexpr double R = 0.01, density = 2650, E = 1e8;

Model linear() {
  const Linear::Material m{E, 0.5, 0.5, {}, {}, {}};
  return {std::vector<Linear::Material>{m, m, m}};
}
Sphere at(double x, double radius = R) { return {radius, density, Vec3(x, 0.1, 0.1), Vec3::Zero()}; }

double recorded(const Simulation& simulation, const char* name) {
  io::Series series = empty_series();
  record(simulation, simulation.snapshot(), simulation.energies(), 0, series);
  return series.at(name).values.at(0);
}

// Three grains in a row and one apart have 1, 2, 1 and 0 contacts.
TEST(Recorded, RattlersCountInTheCoordinationNumberAloneThatSaysSo) {
  io::Snapshot state = scene({at(0), at(1.99 * R), at(3.98 * R), at(9 * R)}, false);
  state.grains.material_id.assign(4, 0);
  const Simulation s(state, linear(), undamped(1e-6));
  EXPECT_DOUBLE_EQ(recorded(s, "coordination_number"), 2.0 * 2 / 4);
  EXPECT_DOUBLE_EQ(recorded(s, "mechanical_coordination_number"), (2.0 * 2 - 2) / (4 - 1 - 2));
  // The overlap is 0.01 R; the smaller of two radii counts.
  EXPECT_NEAR(s.largest_overlap(), 0.01, 1e-12);
  const Simulation unequal(scene({at(0), at(2.99 * R, 2 * R)}, false), linear(), undamped(1e-6));
  EXPECT_NEAR(unequal.largest_overlap(), 0.01, 1e-12);
}

// The deviatoric strain in the plane is the difference of the two principal strains; in a triaxial test in space it is
// 2/3 of the difference.
TEST(Recorded, DeviatoricStrainsAreThoseOfTheirSpace) {
  for (const int dimension : {2, 3}) {
    const Model model = support::linear_sand();
    Simulation s(support::packed(model, 1e3, 60, dimension), model, {});
    s.set_reference();
    Mat3 gradient = Mat3::Zero();
    gradient(dimension - 1, dimension - 1) = -1;
    s.set_velocity_gradient(gradient);
    for (int k = 0; k < 10; ++k) s.step();
    const double axial = s.strain()[dimension - 1];
    ASSERT_GT(axial, 1e-5);
    EXPECT_NEAR(recorded(s, "strain_deviatoric"), (dimension == 3 ? 2.0 / 3.0 : 1) * axial, 1e-14);
    EXPECT_NEAR(recorded(s, "strain_volumetric"), axial, 1e-14);
    EXPECT_EQ(recorded(s, "strain_axial"), axial);
  }
}

// Along an axis without periodic faces, the length of the cell is not the extent of the grains.
TEST(Recorded, ACellThatDoesNotFollowItsGrainsHasNoStressStrainOrVoidRatio) {
  io::Snapshot state = scene({at(0), at(1.99 * R), at(3.98 * R)}, false);
  state.grains.material_id.assign(3, 0);
  for (const bool closed : {true, false}) {
    state.cell.periodic = {true, true, closed};
    const Simulation s(state, linear(), undamped(1e-6));
    for (const char* name : {"strain_xx", "strain_axial", "strain_volumetric", "strain_deviatoric", "stress_xx",
                             "stress_zx", "mean_stress", "deviatoric_stress", "void_ratio"})
      EXPECT_EQ(std::isfinite(recorded(s, name)), closed) << name;
    EXPECT_EQ(std::isnan(recorded(s, "stress_ratio")), !closed);
    EXPECT_DOUBLE_EQ(recorded(s, "coordination_number"), 2.0 * 2 / 3);
  }
}

TEST(Recorded, RatiosOfNothingHaveNoValue) {
  const Simulation apart(scene({at(0), at(3 * R)}, false), linear(), undamped(1e-6));
  for (const char* name : {"stress_ratio", "mechanical_coordination_number", "sliding_fraction"})
    EXPECT_TRUE(std::isnan(recorded(apart, name))) << name;
  EXPECT_EQ(recorded(apart, "coordination_number"), 0);
}

// A contact of branch l that is strained along its normal resists with l^2 kn, over the volume. Against a plane l is
// the distance to it, between grains the distance of their centres.
TEST(Recorded, StiffnessOfTheCellIsThatOfItsBranches) {
  const double kn = E * R, overlap = 0.01 * R;
  Sphere low = at(0.1);
  low.position.z() = R - overlap;
  const Simulation on_plane(scene({low}, true), linear(), undamped(1e-6));
  Sphere high = low;
  high.position.z() += 2 * R - overlap;
  const Simulation pair(scene({low, high}, false), linear(), undamped(1e-6));
  const double plane_branch = R - overlap, branch = 2 * R - overlap;
  const Vec3 against_plane = on_plane.volume() * on_plane.measures().axial_stiffness,
             between = pair.volume() * pair.measures().axial_stiffness;
  EXPECT_NEAR(against_plane.z(), kn * plane_branch * plane_branch, 1e-9 * kn * R * R);
  EXPECT_NEAR(between.z(), kn * branch * branch, 1e-9 * kn * R * R);
  EXPECT_EQ(between.x(), 0);
}

// A grain slowed to a share of its speed and spin keeps the square of that share of its energy; damping has the rest.
TEST(Recorded, DragTakesOfMotionAndOfRotationAlike) {
  Sphere s = at(0.1);
  s.velocity = Vec3(3, 0, 4), s.spin = Vec3(0, 600, 0);
  Simulation simulation(scene({s}, false), linear(), undamped(1e-6));
  const double energy = 0.5 * s.mass() * (25 + 0.4 * R * R * 600 * 600);
  EXPECT_NEAR(simulation.kinetic_energy(), energy, 1e-12 * energy);
  simulation.slow_motion(0.5);
  EXPECT_NEAR(simulation.kinetic_energy(), 0.25 * energy, 1e-12 * energy);
  EXPECT_NEAR(simulation.energies()["damping"], 0.75 * energy, 1e-12 * energy);
}

TEST(Recorded, GrowingGrainsLeaveWhatTheLawHasTaken) {
  Simulation s(support::packed(support::sand(), 1e5, 60), support::sand(), {});
  Mat3 gradient = Mat3::Zero();
  gradient(0, 2) = 0.5;
  s.set_velocity_gradient(gradient);
  for (int k = 0; k < 200; ++k) s.step();
  const Energies before = s.energies();
  ASSERT_GT(before["frictional"], 0);
  s.scale_radii(1.0005);
  const Energies after = s.energies();
  EXPECT_NEAR(after["law"], before["law"], 1e-9 * before["frictional"]);
  EXPECT_NEAR(after["boundary_work"] - before["boundary_work"], after.stored() - before.stored(),
              1e-9 * after.stored());
}

// The step becomes so short that the fastest grain moves a hundredth of the smallest radius, and no shorter.
TEST(Recorded, AFastGrainShortensTheStep) {
  Sphere slow = at(0.02), fast = at(0.1, 2 * R);
  fast.velocity = Vec3(0, 3000, 4000);
  Simulation simulation(scene({slow, fast}, false), linear(), {});
  const double calm = simulation.time_step();
  simulation.step();
  ASSERT_LT(simulation.time_step(), calm);
  EXPECT_NEAR(simulation.time_step(), 1e-2 * R / 5000, 1e-15 * R);
}

// The cost of a run includes its part before a stop.
TEST(Recorded, APriceGoesOnFromWhatIsKept) {
  const io::Snapshot start = support::packed(support::sand(), 1e5, 60);
  Simulation before(start, support::sand(), {});
  for (int k = 0; k < 100; ++k) before.step();
  ASSERT_GT(before.step_times().looked_at, 0);
  CostClock clock, again;
  Archive kept;
  clock.archive(before, 0, kept);
  Archive given(kept.numbers(), "memory");
  const Simulation after(start, support::sand(), {});
  again.archive(after, 0, given);
  const Cost cost = again.cost(after, 0);
  EXPECT_EQ(cost.times.looked_at, before.step_times().looked_at);
  for (std::size_t k = 0; k < cost.times.seconds.size(); ++k)
    EXPECT_EQ(cost.times.seconds[k], before.step_times().seconds[k]);
}

// The limit is a share of all energy: turned over, at the start, in motion and stored.
TEST(Guard, WeighsTheErrorByAllEnergyTurnedOver) {
  Numerics numerics;
  numerics.limits.energy_error = 0.1;
  const io::Snapshot state = scene({at(0.1)}, false);
  const Guard guard(numerics, Bodies(state.grains), Cell(state.cell, 3), Planes(state.planes), 0);
  Archive::Numbers numbers = {{"energy_initial", {1}}, {"energy_turned_over", {2}}};
  for (const EnergyTerm& t : energy_terms()) numbers["energy_" + std::string(t.name)] = {0};
  numbers["energy_kinetic"] = {3}, numbers["energy_elastic_shear"] = {4};
  const auto with_error = [&](double error) {
    numbers["energy_boundary_work"] = {3 + 4 - 1 + error};
    Archive kept(numbers, "test");
    Energies e;
    e.archive(kept);
    return e;
  };
  for (const double sign : {1.0, -1.0}) {
    EXPECT_NO_THROW(guard.balance(1, with_error(sign * 0.999)));
    EXPECT_THROW(guard.balance(1, with_error(sign * 1.001)), PhysicsError);
  }
}

// Names that checkpoints of earlier runs have. A new term adds its own.
TEST(Energies, GoOnFromACheckpointUnderTheirNames) {
  Archive kept;
  Energies().archive(kept);
  for (const char* name : {"boundary_work", "damping", "elastic_normal", "elastic_rolling", "elastic_shear",
                           "elastic_twisting", "elastic_yarns", "frictional", "gravity_work", "initial", "kinetic",
                           "law", "rolling_plastic", "tangential_work", "turned_over", "viscous", "yarn_dissipation"})
    EXPECT_EQ(kept.numbers().count(std::string("energy_") + name), 1U) << name;
  EXPECT_EQ(kept.numbers().count("energy_elastic_contacts"), 0U) << "a share is computed when asked";
}

TEST(Energies, RefuseANameThatNoTermHas) { EXPECT_THROW(Energies()["frction"], std::out_of_range); }

TEST(Recorded, TwoQuantitiesOfOneColumnAreRefusedAtTheFirstRow) {
  io::Series row = {{{"step", "1", "", {0}}, {"toy", "J", "", {1}}}};
  EXPECT_NO_THROW(demand_distinct_columns(row));
  row.columns[1].values = {1, 2};
  EXPECT_THROW(demand_distinct_columns(row), std::logic_error);
  row.columns[1] = {"step", "J", "", {1}};
  EXPECT_THROW(demand_distinct_columns(row), std::logic_error);
}

TEST(Energies, AShareIsCountedOnce) {
  const Simulation s(scene({at(0), at(1.99 * R), at(3.98 * R)}, false), linear(), undamped(1e-6));
  const Energies e = s.energies();
  EXPECT_GT(e["elastic_contacts"], 0);
  EXPECT_EQ(e.stored(), e["elastic_contacts"]);
  EXPECT_EQ(e.initial(), e.stored());
}

// Powers of two show which terms a sum has.
TEST(Energies, EnterTheBalanceByTheirRoles) {
  Archive::Numbers numbers = {{"energy_initial", {1}}, {"energy_turned_over", {0}}};
  for (const EnergyTerm& t : energy_terms()) numbers["energy_" + std::string(t.name)] = {0};
  numbers["energy_kinetic"] = {2}, numbers["energy_elastic_shear"] = {4}, numbers["energy_elastic_yarns"] = {8};
  numbers["energy_damping"] = {16}, numbers["energy_yarn_dissipation"] = {32}, numbers["energy_law"] = {64};
  numbers["energy_boundary_work"] = {128}, numbers["energy_gravity_work"] = {256};
  numbers["energy_tangential_work"] = {512};
  Archive kept(numbers, "test");
  Energies e;
  e.archive(kept);
  EXPECT_EQ(e.error(), 1 + 128 + 256 - (2 + 4 + 8 + 16 + 32 + 64));
  EXPECT_EQ(e.sum(EnergyRole::internal), 512);
}

/// Returns the columns of a run's series as a table of Markdown. A term without a column has its row among the terms.
std::string printed_series() {
  std::string text = "| column | units | meaning |\n|---|---|---|\n";
  for (const io::Column& c : empty_series().columns)
    text += fmt::format("| `{}` | {} | {} |\n", c.name, c.unit, c.long_name);
  text += "\n| energy term | part of the balance | column | meaning |\n|---|---|---|---|\n";
  for (const EnergyTerm& t : energy_terms()) {
    constexpr std::array parts = {"kinetic", "stored", "dissipated", "supplied", "numerical", "none: between others"};
    text +=
        fmt::format("| {} | {}{} | {}{} | {} |\n", t.name, parts.at(static_cast<std::size_t>(t.role)),
                    t.share ? ", counted in other terms" : "", t.column.empty() ? "" : fmt::format("`{}`", t.column),
                    t.occurs ? ", in runs that have it" : "", t.sentence);
  }
  return text + "\n";
}

TEST(Recorded, SeriesIsWhatThePageSays) {
  soilweave::test::demand_on_page("lib/files/FORMAT.md",
                                  "<!-- series: printed from dem/run/record.cpp and dem/engine/energies -->\n",
                                  "<!-- end of series -->\n", printed_series());
}

}  // namespace
}  // namespace soilweave::dem
