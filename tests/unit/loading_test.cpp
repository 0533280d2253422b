// Loading paths and whole runs: constraints of each path, recorded quantities, refusals.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <string>
#include <thread>

#include "core/error.h"
#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/run/run.h"
#include "dem/state/perturbed.h"
#include "support/assemblies.h"
#include "support/scenario.h"
#include "support/worse.h"

namespace soilweave::dem {
namespace {

Scenario scenario(const std::string& stages, const std::vector<std::string>& overrides = {}) {
  return read_scenario(support::sand_toml + stages, "test.toml", overrides);
}

io::RunFile loaded(const std::string& stages) {
  const Scenario plan = scenario(stages);
  return run(prepare(support::packed(plan.model, 1e5), plan), plan, {}).file;
}

double last(const io::RunFile& run, std::string_view column) { return run.series.at(column).values.back(); }

TEST(Path, TriaxialHoldsTheLateralStressAtEveryStation) {
  const io::RunFile run = loaded(
      "[[stage]]\npath = \"triaxial\"\nconfining_pressure = \"100 kPa\"\naxial_strain = 0.02\nincrement = 0.005\n"
      "[record]\nsnapshots = \"stations\"\n");
  ASSERT_EQ(run.series.rows(), 5U);
  ASSERT_EQ(run.snapshots.size(), 5U);
  for (std::size_t k = 1; k < 5; ++k) {
    EXPECT_NEAR(run.series.at("strain_axial").values[k], 0.005 * static_cast<double>(k), 1e-9);
    EXPECT_NEAR(run.series.at("stress_xx").values[k], 1e5, 1e2);
    EXPECT_NEAR(run.series.at("stress_yy").values[k], 1e5, 1e2);
    EXPECT_LE(run.series.at("unbalanced_force").values[k], 1e-3);
  }
  EXPECT_GT(last(run, "stress_ratio"), 1.5);
}

TEST(Path, CountsStrainsFromTheStartOfItsStage) {
  const io::RunFile run = loaded(
      "[[stage]]\npath = \"triaxial\"\nconfining_pressure = 1e5\naxial_strain = 0.006\nincrement = 0.003\n"
      "[[stage]]\npath = \"triaxial\"\nconfining_pressure = 1e5\naxial_strain = -0.002\nincrement = 0.001\n"
      "[[stage]]\npath = \"constant-volume\"\naxial_strain = 0.001\n"
      "[[stage]]\npath = \"free\"\nparts = 2\n[stage.x]\nstrain = 0\n[stage.y]\nstrain = 0\n[stage.z]\nstrain = 0.002\n"
      "[[stage]]\npath = \"k0\"\naxial_stress = [2e5]\n");
  const std::vector<double> expected = {0, 0.003, 0.006, 0.005, 0.004, 0.005, 0.006, 0.007};
  const std::vector<double>& axial = run.series.at("strain_axial").values;
  ASSERT_EQ(run.series.rows(), expected.size() + 1);
  for (std::size_t k = 0; k < expected.size(); ++k) EXPECT_NEAR(axial[k], expected[k], 1e-8) << "station " << k;
  // Constant volume comes first, then loading without lateral strain.
  const std::vector<double>&x = run.series.at("strain_xx").values, &v = run.series.at("strain_volumetric").values;
  EXPECT_NEAR(v[5], v[4], 1e-8);
  for (std::size_t k = 6; k < x.size(); ++k) EXPECT_NEAR(x[k], x[5], 1e-8);
}

TEST(Path, ConstantVolumeKeepsTheVoidRatio) {
  const io::RunFile run = loaded("[[stage]]\npath = \"constant-volume\"\naxial_strain = 0.02\nincrement = 0.01\n");
  EXPECT_NEAR(last(run, "void_ratio"), run.series.at("void_ratio").values.front(), 1e-9);
  EXPECT_NEAR(last(run, "strain_axial"), 0.02, 1e-9);
}

TEST(Path, ConstantPHoldsTheMeanStress) {
  const io::RunFile run =
      loaded("[[stage]]\npath = \"constant-p\"\nmean_stress = 1e5\naxial_strain = 0.02\nincrement = 0.01\n");
  EXPECT_NEAR(last(run, "mean_stress"), 1e5, 3e2);
  EXPECT_GT(last(run, "deviatoric_stress"), 2e4);
}

TEST(Path, K0AllowsNoLateralStrain) {
  const io::RunFile run = loaded("[[stage]]\npath = \"k0\"\naxial_stress = [1.5e5, 3e5]\n");
  EXPECT_NEAR(last(run, "stress_zz"), 3e5, 3e2);
  EXPECT_NEAR(last(run, "strain_xx"), 0, 1e-9);
  EXPECT_NEAR(last(run, "strain_yy"), 0, 1e-9);
  EXPECT_LT(last(run, "stress_xx"), 3e5);
}

TEST(Path, FreeCombinesGoalsAxisByAxis) {
  const io::RunFile run = loaded(
      "[[stage]]\npath = \"free\"\nparts = 2\n[stage.x]\nstress = 1.2e5\n[stage.y]\nstrain = -0.002\nmax_rate = 0.1\n"
      "[stage.z]\nstress = 2e5\nstress_from = 1e5\n");
  EXPECT_NEAR(last(run, "stress_xx"), 1.2e5, 1.3e2);
  EXPECT_NEAR(last(run, "strain_yy"), -0.002, 1e-9);
  EXPECT_NEAR(last(run, "stress_zz"), 2e5, 2.1e2);
}

TEST(Run, AStageMayChangeFrictionAndDamping) {
  const io::RunFile run =
      loaded("[[stage]]\npath = \"isotropic\"\npressure = 1.1e5\nfriction_angle = 5\ndamping = 0.5\n");
  EXPECT_LT(last(run, "void_ratio"), run.series.at("void_ratio").values.front());
}

TEST(Run, PlatesKeepTheirFrictionUntilAStageGivesThemAnother) {
  const std::string plates =
      "[[material]]\nyoung_modulus = \"4 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 29\n"
      "[[plane]]\nname = \"bottom\"\npoint = \"touch\"\nnormal = [0, 0, 1]\nmaterial = 1\n"
      "[[plane]]\nname = \"top\"\npoint = \"touch\"\nnormal = [0, 0, -1]\nmaterial = 1\n"
      "[equilibrium]\nunbalanced_force = 0.1\n[record]\nsnapshots = \"stations\"\n";
  const auto held = [](const std::string& keys) { return "[[stage]]\npath = \"free\"\n" + keys; };
  const auto squeezed = [&](const std::string& keys) { return held(keys) + "[stage.x]\nstrain = 0.002\n"; };
  const io::Snapshot packing = [] {
    io::Snapshot state = support::packed(support::sand(), 1e5);
    state.cell.periodic[2] = false;
    state.contacts = {};
    return state;
  }();
  // Between plates the series has no cell stress, so the positions of grains distinguish the runs.
  const auto moved = [](const io::Snapshot& start, const std::string& text) {
    const Scenario plan = scenario(text);
    const Outcome outcome = run(prepare(start, plan), plan, {});
    double sum = 0;
    for (const Vec3& place : outcome.file.snapshots.back().grains.position) sum += place.norm();
    return sum;
  };
  const double smooth = moved(packing, plates + held("plate_friction_angle = 0\n") + squeezed(""));
  EXPECT_EQ(moved(packing, plates + held("plate_friction_angle = 0\n") + squeezed("friction_angle = 29\n")), smooth);
  EXPECT_NE(moved(packing, plates + held("") + squeezed("")), smooth);
  // Planes of the input obey too.
  io::Snapshot inherited = packing;
  inherited.planes = prepare(packing, scenario(plates + held(""))).planes;
  const std::string bare = plates.substr(0, plates.find("[[plane]]")) + "[equilibrium]\nunbalanced_force = 0.1\n";
  EXPECT_NE(moved(inherited, bare + squeezed("plate_friction_angle = 0\n")), moved(inherited, bare + squeezed("")));
}

TEST(Run, RecordsStrainsThatCountFromTheStartOfTheirStage) {
  const io::RunFile run = loaded(
      "[record]\nsnapshots = \"list\"\nstrains = [0.002]\n[[stage]]\npath = \"isotropic\"\npressure = 1.2e5\n"
      "[[stage]]\npath = \"triaxial\"\nconfining_pressure = 1.2e5\naxial_strain = 0.003\nincrement = 0.001\n");
  ASSERT_EQ(run.snapshots.size(), 4U);  // start, end of the first stage, the station, end of the second
  const std::vector<double>& steps = run.series.at("step").values;
  EXPECT_EQ(static_cast<double>(run.snapshots[2].step), steps[3]);
}

TEST(Run, SaysWhatHasNotArrived) {
  const auto complains = [](const std::string& stages, const std::string& words) {
    const Scenario plan = scenario("[equilibrium]\nsteps = 200\n" + stages);
    io::Snapshot packing = support::packed(plan.model, 1e5);
    if (!plan.planes.point.empty()) packing.cell.periodic[2] = false;
    try {
      run(prepare(packing, plan), plan, {});
      ADD_FAILURE() << "reached";
    } catch (const TargetNotReached& e) {
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  };
  complains("[[stage]]\npath = \"constant-volume\"\naxial_strain = 0.001\nrate = 1e-6\n",
            "axis z is still 0.001 away from its strain: raise equilibrium.steps or the rate");
  const std::string plates =
      "[[plane]]\nname = \"bottom\"\npoint = \"touch\"\nnormal = [0, 0, 1]\n"
      "[[plane]]\nname = \"top\"\npoint = \"touch\"\nnormal = [0, 0, -1]\n[[stage]]\npath = \"drive\"\n";
  complains(plates + "[[stage.move]]\npart = \"top\"\nalong = [0, 0, -1]\ndistance = 0.001\nspeed = 1e-9\n",
            "\"top\" has moved");
  complains(plates + "[[stage.load]]\npart = \"top\"\nalong = [0, 0, 1]\nforce = 50\nspeed = 1\n",
            "\"top\" touches no grain: turn its load of 50 N towards the grains");
}

TEST(Run, AStageMayDampMoreWhereItOnlyWaitsForRest) {
  const auto stage = [](double strain, const std::string& keys) {
    return fmt::format("[[stage]]\npath = \"constant-volume\"\naxial_strain = {}\nincrement = 0.001\n{}", strain, keys);
  };
  const std::string little = "damping = 0.1\n", more = "damping = 0.1\nrest_damping = 0.7\n";
  const io::RunFile same = loaded(stage(0.002, little)), said = loaded(stage(0.002, little + "rest_damping = 0.1\n"));
  EXPECT_EQ(said.series.at("stress_zz").values, same.series.at("stress_zz").values);
  EXPECT_EQ(said.series.at("step").values, same.series.at("step").values);
  const io::RunFile calmed = loaded(stage(0.002, more));
  EXPECT_LT(last(calmed, "step"), last(same, "step")) << "rest comes sooner";
  // On the way to the second station the small damping holds again, as in another stage.
  const io::RunFile anew = loaded(stage(0.001, more) + stage(0.001, more));
  const io::RunFile held = loaded(stage(0.001, more) + stage(0.001, "damping = 0.7\n"));
  // A new stage measures its loading anew: a step sooner or later.
  EXPECT_NEAR(last(anew, "step"), last(calmed, "step"), 2);
  EXPECT_GT(std::abs(last(held, "step") - last(calmed, "step")), 20);
}

TEST(Run, AStageMayDragWhatWaitsForRest) {
  // A packing with hardly any damping swings until it falls apart.
  const std::string swinging =
      "[equilibrium]\nkinetic_energy = 1e-8\nsteps = 20000\n[[stage]]\npath = \"constant-volume\"\n"
      "axial_strain = 0.001\nincrement = 0.001\ndamping = 0.02\n";
  const io::RunFile run = loaded(swinging + "rest_drag = 200\n");
  EXPECT_LE(last(run, "unbalanced_force"), 1e-3);
  EXPECT_LT(last(run, "kinetic_energy"), 1e-6);
  EXPECT_GT(last(run, "mean_stress"), 1.5 * last(loaded(swinging), "mean_stress"));
  EXPECT_LT(std::abs(last(run, "energy_error")), 1e-2 * last(run, "damping_dissipation"))
      << "what was slowed counts too";
}

TEST(Run, AStageMayGoAsFastAsItsGrainsFollow) {
  const auto compressed = [](double rate, double unbalanced_force) {
    return loaded(
        fmt::format("[equilibrium]\nsteps = 1000000\n[[stage]]\npath = \"free\"\nway_unbalanced_force = {}\n"
                    "[stage.x]\nstrain = 0\n[stage.y]\nstrain = 0\n[stage.z]\nstrain = 0.01\nmax_rate = {}\n",
                    unbalanced_force, rate));
  };
  const io::RunFile slow = compressed(0.02, 0), fast = compressed(2, 0), kept = compressed(2, 0.02),
                    capped = compressed(0.5, 0.02);
  const double right = last(slow, "stress_zz");
  EXPECT_LT(last(fast, "stress_zz"), 0.7 * right) << "slow enough as given: the test tells nothing";
  // The remaining difference of these 150 grains is chance: it has either sign at a quarter of the unbalanced force.
  EXPECT_NEAR(last(kept, "stress_zz"), right, 0.06 * right);
  EXPECT_NEAR(last(capped, "stress_zz"), last(kept, "stress_zz"), 0.03 * right);
  EXPECT_NEAR(last(kept, "strain_zz"), 0.01, 1e-8);
  EXPECT_LT(last(kept, "step"), 0.5 * last(slow, "step")) << "no better than slow all the way";
}

TEST(Prepare, KeepsContactsWithPlanesOnlyWherePlanesAreParallel) {
  const auto between = [](const std::string& normal) {
    return "[[plane]]\npoint = [0, 0, -1]\nnormal = " + normal + "\n[[stage]]\npath = \"free\"\n";
  };
  const Scenario upright = scenario(between("[0, 0, 1]")), leaning = scenario(between("[0, 0.1, 1]"));
  io::Snapshot packing = support::packed(upright.model, 1e5);
  packing.planes = upright.planes;
  packing.cell.periodic = {false, false, false};
  const std::size_t pairs = packing.contacts.size();
  // The last contact is with the plane.
  packing.contacts.bodies.back()[1] = -1;
  EXPECT_EQ(prepare(packing, upright).contacts.size(), pairs);
  EXPECT_EQ(prepare(packing, leaning).contacts.size(), pairs - 1);
  packing.planes = {};
  EXPECT_EQ(prepare(packing, upright).contacts.size(), pairs - 1);
}

TEST(Run, SaysWhichStationCannotBeReached) {
  const Scenario plan =
      scenario("[equilibrium]\nsteps = 50\n[[stage]]\nname = \"far\"\npath = \"isotropic\"\npressure = 1e6\n");
  try {
    run(prepare(support::packed(plan.model, 1e5), plan), plan, {});
    FAIL() << "reached";
  } catch (const TargetNotReached& e) {
    EXPECT_NE(std::string(e.what()).find("stage \"far\", station 1: not settled after 50 steps"), std::string::npos)
        << e.what();
  }
}

TEST(Run, SaysWhenOnlyTheKineticEnergyKeepsItFromRest) {
  const auto plan = [](const std::string& energy, int steps) {
    return scenario("[equilibrium]\nunbalanced_force = 0.1\nkinetic_energy = " + energy +
                    "\nsteps = " + std::to_string(steps) + "\n[[stage]]\npath = \"isotropic\"\npressure = 1e5\n");
  };
  const io::Snapshot packing = support::packed(support::sand(), 1e5);
  const auto ran = [&packing](const Scenario& s) { return run(prepare(packing, s), s, {}).cost; };
  const Cost soon = ran(plan("1", 20000)), late = ran(plan("1e-12", 20000));
  EXPECT_EQ(soon.waiting_for_energy, 0);
  EXPECT_EQ(soon.line().find("kinetic"), std::string::npos);
  EXPECT_GT(late.waiting_for_energy, 0.5 * static_cast<double>(late.steps)) << late.steps;
  EXPECT_LE(late.waiting_for_energy, late.waiting);
  EXPECT_NE(late.line().find(" % for the kinetic energy alone)"), std::string::npos) << late.line();
  try {
    ran(plan("1e-30", 500));
    FAIL() << "came to rest";
  } catch (const TargetNotReached& e) {
    EXPECT_NE(std::string(e.what()).find("of 1.00e-30 J): only the kinetic energy is above"), std::string::npos)
        << e.what();
  }
}

// Otherwise the steps of a run with few stations and many grains would seem slower than they are.
TEST(Run, TheTimeOfRowsCountsAsOutputNotAsSteps) {
  const Scenario plan = scenario("[[stage]]\npath = \"constant-volume\"\naxial_strain = 0.0005\n");
  const io::Snapshot start = prepare(support::packed(plan.model, 1e5), plan);
  const double quick = run(start, plan, {}).cost.output;
  static constexpr std::chrono::duration<double> wait(0.5);
  const Outcome slow = run(start, plan, {}, {}, [](auto&, auto&) { std::this_thread::sleep_for(wait); });
  ASSERT_EQ(slow.file.series.rows(), 2U);
  EXPECT_GE(slow.cost.output, 2 * wait.count());
  EXPECT_LT(quick, wait.count());
}

TEST(Run, TwinsDifferByTheSeedAndByNoMoreThanAsked) {
  const io::Snapshot packing = support::packed(support::sand(), 1e5);
  const io::Snapshot one = perturbed(packing, 1e-6, 1), again = perturbed(packing, 1e-6, 1),
                     two = perturbed(packing, 1e-6, 2);
  double largest = 0;
  for (std::size_t i = 0; i < packing.grains.size(); ++i) {
    EXPECT_EQ(one.grains.position[i], again.grains.position[i]);
    largest =
        soilweave::test::worse(largest, (one.grains.position[i] - packing.grains.position[i]).cwiseAbs().maxCoeff() /
                                            packing.grains.radius[i]);
  }
  EXPECT_NE(one.grains.position[0], two.grains.position[0]);
  EXPECT_LE(largest, 1.001e-6);
  EXPECT_GT(largest, 0.9e-6);
}

TEST(Scenario, TellsAllMistakesAtOnceWithTheNearestKey) {
  try {
    scenario("[[stage]]\npath = \"triaxial\"\nconfinig_pressure = 1e5\naxial_strain = 5\n[numerics]\ndamping = 1.5\n");
    FAIL() << "accepted";
  } catch (const DataError& e) {
    const std::string what = e.what();
    for (const char* part : {"confinig_pressure", "confining_pressure", "axial_strain", "damping"})
      EXPECT_NE(what.find(part), std::string::npos) << part << " in: " << what;
  }
}

TEST(Scenario, OverridesReplaceValuesBeforeTheyAreChecked) {
  const Scenario plan = scenario("[[stage]]\npath = \"isotropic\"\npressure = 1e5\n",
                                 {"numerics.damping=0.35", "stage.0.pressure=2e5", "contact.friction_angle=20"});
  EXPECT_EQ(plan.numerics.damping, 0.35);
  EXPECT_NEAR(friction(plan.model), 20 * support::degree, 1e-12);
}

TEST(Scenario, NoLimitAndALimitOfZeroAreDifferentThings) {
  const auto rolling = [](const std::string& limit) {
    const Scenario plan =
        scenario("[[stage]]\npath = \"isotropic\"\npressure = 1e5\n", {"contact.rolling.limit=" + limit});
    return plan.model.materials.of<HertzMindlin::Material>()[0].rolling.limit;
  };
  EXPECT_FALSE(rolling("\"none\"").has_value());
  EXPECT_EQ(rolling("0").value(), 0);
}

TEST(Prepare, RefusesMaterialsTheScenarioLacks) {
  const Scenario plan = scenario("[[stage]]\npath = \"isotropic\"\npressure = 1e5\n");
  io::Snapshot packing = support::packed(plan.model, 1e5);
  packing.grains.material_id[3] = 2;
  EXPECT_THROW(prepare(packing, plan), DataError);
}

}  // namespace
}  // namespace soilweave::dem
