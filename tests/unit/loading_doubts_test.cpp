// Doubts about the materials and stages of a scenario: what is said, and that the remedy ends it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/doubts/loading_doubts.h"

#include <gtest/gtest.h>

#include <string>

#include "analysis/doubts/idle_doubts.h"
#include "analysis/doubts/material_doubts.h"
#include "analysis/tables/doubts.h"
#include "dem/run/prepare.h"
#include "support/assembly.h"
#include "support/strip.h"

namespace soilweave {
namespace {

using analysis::test::simple_cubic;

dem::Scenario plan(const std::string& stages, const std::string& friction = "30") {
  return dem::read_scenario(
      "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = 1e9\npoisson_ratio = 0.3\nfriction_angle = " + friction +
          "\n" + stages,
      "test.toml", {});
}

std::string isotropic(const std::string& pressure) {
  return "[[stage]]\npath = \"isotropic\"\npressure = " + pressure + "\n";
}

std::string strained(const std::string& path, const std::string& stress) {
  return "[[stage]]\nname = \"shear\"\npath = \"" + path + "\"\n" + stress + "\naxial_strain = 0.1\nrate = 0.1\n";
}

std::string only(const std::vector<Doubt>& doubts) { return doubts.empty() ? "" : doubts.front().sentence; }

TEST(DoubtsOfLoading, StressThatChangesWhileAStageStrains) {
  const io::Snapshot start = simple_cubic(4, Vec3(1, 1, 1));
  const auto said = [&](const std::string& stages) { return only(analysis::jump_doubts(start, plan(stages))); };
  const std::string triaxial = strained("triaxial", "confining_pressure = 1e5");
  EXPECT_NE(said(isotropic("5e4") + triaxial).find("stage \"shear\" holds 100 kPa along x where 50 act before it"),
            std::string::npos);
  EXPECT_EQ(said(isotropic("5e4") + isotropic("1e5") + triaxial), "") << "the remedy works";
  EXPECT_EQ(said(isotropic("95e3") + triaxial), "");
  EXPECT_NE(said(triaxial), "") << "the packing is at 1 Pa";
  EXPECT_EQ(said(isotropic("1e5") + strained("constant-p", "mean_stress = 1e5")), "");
  EXPECT_NE(said(isotropic("1e5") + strained("constant-p", "mean_stress = 2e5")), "");
  EXPECT_EQ(said(strained("constant-volume", "")), "");
  EXPECT_EQ(said(isotropic("1e5") + triaxial + strained("constant-p", "mean_stress = 17e4")), "")
      << "the lateral stress follows from the axial one, which nobody knows before the run";
  EXPECT_NE(said(isotropic("1e5") + triaxial + strained("triaxial", "confining_pressure = 2e5")), "");
  const auto free = [](const std::string& lateral, const std::string& axial, const std::string& parts = "") {
    return "[[stage]]\npath = \"free\"\n" + parts + "[stage.x]\n" + lateral + "[stage.y]\n" + lateral + "[stage.z]\n" +
           axial;
  };
  EXPECT_EQ(said(isotropic("5e4") + free("stress = 1e5\n", "stress = 2e5\n") + triaxial), "") << "the other remedy";
  EXPECT_EQ(said(isotropic("5e4") + free("stress_from = 5e4\nstress = 1e5\n", "strain = 0.01\n", "parts = 5\n")), "")
      << "a ramp";
  io::Snapshot open = start;
  open.cell.periodic = {false, false, false};
  EXPECT_TRUE(analysis::jump_doubts(open, plan(triaxial)).empty());
}

TEST(DoubtsOfLoading, ForcesOfAnotherLawAndGrainsThatWereMoved) {
  const io::Snapshot start = simple_cubic(4, Vec3(1, 1, 1));
  io::Snapshot stiff = start;
  for (double& f : stiff.contacts.normal_force) f *= 1.2;
  const auto said = [&](const io::Snapshot& begun, const std::string& stages) {
    return only(analysis::start_doubts(start, begun, plan(stages)));
  };
  const std::string undrained = strained("constant-volume", "");
  EXPECT_EQ(said(start, undrained), "");
  EXPECT_NE(said(stiff, undrained).find("another law, stiffness or friction"), std::string::npos);
  EXPECT_EQ(said(stiff, isotropic("1") + undrained), "") << "the remedy works";
  io::Snapshot moved = stiff, bare = start;
  for (double& u : moved.contacts.overlap) u = 0.01;
  EXPECT_NE(said(moved, undrained).find("take a --perturb of 1e-4 or less"), std::string::npos);
  bare.contacts = {};
  EXPECT_TRUE(analysis::start_doubts(bare, stiff, plan(undrained)).empty()) << "no stress is kept";
}

TEST(DoubtsOfLoading, NumbersWithoutTheirUnit) {
  const io::Snapshot start = simple_cubic(4, Vec3(1, 1, 1));
  const auto said = [&](const std::string& stages) { return only(analysis::unit_doubts(start, plan(stages))); };
  const auto sheared = [](const std::string& strain) {
    return "[[stage]]\npath = \"constant-volume\"\naxial_strain = " + strain + "\nincrement = 0.01\n";
  };
  EXPECT_NE(said(sheared("2")).find("write \"2 %\""), std::string::npos);
  EXPECT_NE(said(sheared("-0.6")).find("write \"-0.6 %\""), std::string::npos);
  EXPECT_EQ(said(sheared("\"2 %\"")), "") << "the remedy works";
  EXPECT_EQ(said(sheared("0.3")), "");
  const auto k0 = [](const std::string& stresses) {
    return "[[stage]]\npath = \"k0\"\naxial_stress = [" + stresses + "]\n";
  };
  EXPECT_NE(said(isotropic("1e5") + k0("100, 200")).find("write \"100 kPa\""), std::string::npos);
  EXPECT_NE(said(isotropic("1e5") + k0("2e5, 200")).find("from 2e+05 to 200 Pa"), std::string::npos);
  EXPECT_EQ(said(isotropic("1e5") + k0("\"100 kPa\", 4e5, 1e4")), "") << "an unloading";
  EXPECT_EQ(said(isotropic("1e4") + isotropic("10")), "") << "an unloading between named stresses";
  const io::Snapshot light = [&] {
    io::Snapshot state = start;
    for (double& f : state.contacts.normal_force) f *= 1e-3;
    return state;
  }();
  const auto of_light = [&](const std::string& stages) { return only(analysis::unit_doubts(light, plan(stages))); };
  EXPECT_NE(of_light(isotropic("50")).find("stage.0.pressure is 50 without a unit"), std::string::npos);
  EXPECT_EQ(of_light(isotropic("\"50 Pa\"")), "") << "the remedy works";
  EXPECT_EQ(of_light(isotropic("50") + isotropic("1e5")), "") << "the other stress is in Pa, too";
  io::Snapshot loaded = start;
  for (double& f : loaded.contacts.normal_force) f *= 1e5;
  EXPECT_NE(only(analysis::unit_doubts(loaded, plan(isotropic("100")))).find("write \"100 kPa\""), std::string::npos);
}

TEST(DoubtsOfLoading, WeightsOfScaledDensity) {
  io::Snapshot state = simple_cubic(2, Vec3(1, 1, 1));  // radii are 0.5
  const auto of = [&](double density, const Vec3& gravity) {
    for (double& m : state.grains.mass) m = density * 0.5235987755982988;
    return only(analysis::weight_doubts(state, gravity));
  };
  const Vec3 down(0, 0, -9.81);
  EXPECT_EQ(of(2650e3, Vec3::Zero()), "");
  EXPECT_NE(of(2650e3, down).find("weigh 1e+03 times what sand of 2650 kg/m3 does: write grains.density = 2650"),
            std::string::npos);
  EXPECT_EQ(of(2650, down), "") << "the remedy works";
  EXPECT_EQ(of(7850, down), "") << "steel";
  EXPECT_NE(of(2.65, down), "") << "g/cm3";
}

TEST(DoubtsOfLoading, AdhesionAcrossWideGaps) {
  const io::Snapshot state = simple_cubic(2, Vec3(1, 1, 1));  // radii are 0.5
  const auto of = [&](const std::string& range) {
    return only(analysis::range_doubts(
        state, dem::read_scenario("[contact]\nlaw = \"linear-adhesion\"\nyoung_modulus = 1e9\nstiffness_ratio = 0.1\n"
                                  "friction_angle = 30\nwork_of_adhesion = 0.1\nadhesion_range = " +
                                      range + "\n" + isotropic("1"),
                                  "test.toml", {})
                   .model));
  };
  EXPECT_NE(of("0.4").find("0.8 times the grains' mean radius"), std::string::npos);
  EXPECT_EQ(of("0.05"), "");
  EXPECT_TRUE(analysis::range_doubts(state, plan(isotropic("1")).model).empty());
}

TEST(DoubtsOfLoading, FrictionAnglesInRadians) {
  const auto of_material = [](const std::string& angle) {
    return only(analysis::material_doubts({}, plan(isotropic("1e5"), angle).model, Vec3::Zero()));
  };
  EXPECT_EQ(of_material("29"), "");
  EXPECT_EQ(of_material("0"), "") << "none is meant";
  EXPECT_NE(of_material("0.5").find("0.5 degrees is nearly zero; if radians are meant, write 28.65"),
            std::string::npos);
  EXPECT_EQ(only(analysis::stage_friction_doubts(plan(isotropic("1e5"), "0.5"))), "");
  EXPECT_NE(only(analysis::stage_friction_doubts(plan(isotropic("1e5") + "friction_angle = 0.6\n"))), "");
}

TEST(DoubtsOfLoading, GrainsTooSoftForTheirStress) {
  io::Snapshot state = simple_cubic(4, Vec3(1, 1, 1));
  state.contacts.overlap.assign(state.contacts.size(), 0.02);  // radii are 0.5
  EXPECT_TRUE(analysis::overlap_doubts(state).empty());
  state.contacts.overlap.assign(state.contacts.size(), 0.03);
  EXPECT_NE(only(analysis::overlap_doubts(state)).find("the mean overlap is 0.06 of the mean radius, more than 0.05"),
            std::string::npos);
  EXPECT_TRUE(analysis::overlap_doubts({}).empty());
}

// Rows of a run whose columns hold these values, one after the other.
io::Series rows(const std::vector<std::pair<std::string, std::vector<double>>>& columns) {
  io::Series series;
  for (const auto& [name, values] : columns) series.columns.push_back({name, "1", name, values});
  return series;
}

dem::Scenario pressed(const std::string& stages) {
  return plan(
      "[[plane]]\nname = \"top\"\npoint = [0, 0, 1]\nnormal = [0, 0, -1]\n[[plane]]\nname = \"bottom\"\n"
      "point = [0, 0, 0]\nnormal = [0, 0, 1]\n" +
      stages);
}

TEST(DoubtsOfLoading, PlatesThatMoveOnAndPressNothing) {
  const dem::Scenario up_and_down =
      pressed("[[stage]]\npath = \"uniaxial\"\nheight = 1\nstations = [0.01, 0.02, 0.01, 0.02, 0.04]\nrate = 0.1\n");
  const std::vector<double> strain = {0, 0.01, 0.02, 0.01, 0.02, 0.04};
  const auto said = [&](const std::vector<double>& force) {
    const std::size_t n = force.size();
    io::Series series = rows({{"stage", std::vector<double>(n, 0.0)}});
    for (const auto& [plane, sign] : {std::pair("top", -1.0), std::pair("bottom", 1.0)})
      for (const char* axis : {"x", "y", "z"}) {
        std::vector<double> moved(n, 0.0), presses(n, 0.0);
        for (std::size_t k = 0; k < n && *axis == 'z'; ++k)
          moved[k] = sign * strain[k] / 2, presses[k] = -sign * force[k];
        series.columns.push_back({std::string("displacement_") + plane + "_" + axis, "m", "", moved});
        series.columns.push_back({std::string("force_") + plane + "_" + axis, "N", "", presses});
      }
    return only(analysis::idle_plate_doubts(up_and_down, series));
  };
  EXPECT_EQ(said({0, 1, 2, 1, 2, 4}), "");
  EXPECT_EQ(said({0, 1, 2, 0, 0, 4}), "") << "the plates move apart, and come back to grains that have settled";
  EXPECT_EQ(said({0, 0, 2, 1, 2, 4}), "") << "the plates come from afar";
  EXPECT_NE(said({0, 1, 0}).find("has pushed the plane \"top\" 0.01 m towards the grains at station 2"),
            std::string::npos);
  EXPECT_NE(said({5, 0, 0, 0, 0, 1}).find("(2 of 5 stations): a lower rate"), std::string::npos);
  EXPECT_NE(said({5, 0, 0, 0, 0, 0}).find("(3 of 5 stations)"), std::string::npos) << said({5, 0, 0, 0, 0, 0});
  EXPECT_NE(said({0, 0, 0}).find("(nor did anything before): bring it to the grains by a load"), std::string::npos);
}

TEST(DoubtsOfLoading, GrainsThatNoLongerTouch) {
  const dem::Scenario shear = plan(isotropic("1e5") + strained("constant-volume", ""));
  const auto said = [&](const std::vector<double>& contacts) {
    return only(analysis::no_contact_doubts(shear, rows({{"stage", {0, 0, 1, 1}}, {"coordination_number", contacts}})));
  };
  EXPECT_EQ(said({0, 4, 4, 3}), "") << "loose grains come together";
  EXPECT_NE(said({0, 4, 3, 0}).find("stage \"shear\": at 1 of 2 stations, first at number 2, no grains touch"),
            std::string::npos);
}

TEST(DoubtsOfLoading, ClampsFasterThanWavesInTheirYarns) {
  const auto said = [](double speed) {
    const dem::Scenario plan = support::pulled(support::pe_points, support::move(1e-3, 1, speed), 0.01);
    return only(analysis::clamp_doubts(plan, dem::prepare(support::strip(4), plan)));
  };
  io::Snapshot strip = support::strip(4);
  // The nodes of one spacing of 5 mm move along two strings of yarns of 8.4 N at 2 %.
  const double wave = std::sqrt(8.4 / 0.02 * 0.005 / strip.grains.mass[0]);
  EXPECT_EQ(said(0.09 * 0.02 * wave), "");
  const std::string fast = said(0.3 * 0.02 * wave);
  EXPECT_NE(fast.find("strains yarns by 0.6 %, where their curve bends at 2 %"), std::string::npos) << fast;
  const std::size_t remedy = fast.find("on the speed; ");
  ASSERT_NE(remedy, std::string::npos) << fast;
  EXPECT_EQ(said(std::stod(fast.substr(remedy + 14))), "") << "the remedy works";
}

TEST(DoubtsOfLoading, PlatesAreJudgedByTheirRateAndTheirForce) {
  const io::Snapshot start = simple_cubic(4, Vec3(1, 1, 1));  // centres over 3 m by 3 m; 6/pi kg/m3
  const auto said = [&](const std::string& keys) {
    io::RunFile run;
    run.snapshots = {start, start};
    run.series = rows({{"step", {0, 9}},
                       {"stage", {0, 0}},
                       {"mean_stress", {0, 0}},
                       {"coordination_number", {3, 3}},
                       {"force_top_x", {0, 0}},
                       {"force_top_y", {0, 0}},
                       {"force_top_z", {0, 9e5}},
                       {"force_bottom_x", {0, 0}},
                       {"force_bottom_y", {0, 0}},
                       {"force_bottom_z", {0, -9e5}}});
    const dem::Scenario scenario =
        pressed("[[stage]]\nname = \"press\"\npath = \"uniaxial\"\nheight = 1\nstrain = 0.01\n" + keys);
    for (const Doubt& doubt : analysis::doubts_after(start, scenario, run))
      if (doubt.key == "inertia") return doubt.sentence;
    return std::string();
  };
  EXPECT_NE(said("rate = 0.1\n").find("stage \"press\" at 0.1 1/s: inertial number 4.4e-04"), std::string::npos)
      << said("rate = 0.1\n");
  EXPECT_EQ(said("rate = 0.02\n"), "") << "the remedy works";
  EXPECT_EQ(said("rate = 0.1\nway_unbalanced_force = 0.03\n"), "");
}

}  // namespace
}  // namespace soilweave
