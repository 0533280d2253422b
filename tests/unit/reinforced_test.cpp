// Reinforced soil within fill: a periodic lattice of soil, the nodes around it and the fill around them gives every
// number in closed form.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/reinforced.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/measure/fabric.h"
#include "analysis/measure/stress.h"
#include "analysis/tables/bag.h"
#include "analysis/tables/tables.h"
#include "core/error.h"
#include "packing/expand/run_tables.h"
#include "support/assembly.h"
#include "support/same_state.h"

namespace soilweave::analysis {
namespace {

using io::test::expect_error;

constexpr double pi = std::numbers::pi;
constexpr int side = 9, half = 4;

std::int32_t at(int x, int y, int z) {
  const auto wrapped = [](int c) { return (c + half + side) % side; };
  return wrapped(x) + side * (wrapped(y) + side * wrapped(z));
}
int ring(int x, int y, int z) { return std::max({std::abs(x), std::abs(y), std::abs(z)}); }

// Unit spheres at integer places of a cell of 9, whose middle is at (20, 20, 20). Soil lies where no coordinate is over
// 2 from there, one copy per column along z. Nodes lie at 3, with yarns along x at a tension of 4 and slack ones along
// y; fill lies at 4. Contacts have the forces 3, 5, 7 along the axes, twice as much with fill.
io::Snapshot filled_lattice() {
  io::Snapshot s;
  s.cell.matrix = side * Mat3::Identity();
  s.cell.periodic = {true, true, true};
  const auto over = [](const auto& act) {
    for (int z = -half; z <= half; ++z)
      for (int y = -half; y <= half; ++y)
        for (int x = -half; x <= half; ++x) act(x, y, z);
  };
  over([&](int x, int y, int z) {
    test::add_grain(s, Vec3(20 + x, 20 + y, 20 + z), 0.5);
    s.grains.copy_id.back() = ring(x, y, z) <= 2 ? x + 2 + 5 * (y + 2) : -1;
  });
  over([&](int x, int y, int z) {
    for (int a = 0; a < 3; ++a) {
      const Vec3i to = Vec3i(x, y, z) + Vec3i::Unit(a);
      const bool across = to[a] > half, filled = across || ring(x, y, z) == 4 || ring(to[0], to[1], to[2]) == 4;
      const double force = (3 + 2 * a) * (filled ? 2 : 1);
      const Vec3i image = across ? Vec3i(Vec3i::Unit(a)) : Vec3i(Vec3i::Zero());
      test::add_contact(s, at(x, y, z), at(to[0], to[1], to[2]), image, force);
    }
  });
  const auto add_yarn = [&s](std::int32_t one, std::int32_t two, int family) {
    io::YarnsRecord& y = s.yarns;
    y.nodes.push_back({one, two}), y.fabric.push_back(0), y.geotextile_id.push_back(0), y.family.push_back(family);
    y.rest_length.push_back(1 / 1.1), y.largest_strain.push_back(0.1), y.tension.push_back(family == 0 ? 4 : 0);
    y.broken.push_back(0), y.break_time.push_back(0), y.break_position.emplace_back(Vec3::Zero());
  };
  over([&](int x, int y, int z) {
    if (ring(x, y, z) != 3) return;
    if (x < 3 && ring(x + 1, y, z) == 3) add_yarn(at(x, y, z), at(x + 1, y, z), 0);
    if (std::abs(x) == 3 && y < 3) add_yarn(at(x, y, z), at(x, y + 1, z), 1);
  });
  return s;
}

double value(const io::Series& table, const std::string& name) { return table.at(name).values.back(); }

TEST(Reinforced, SoilIsToldFromFillAndNodes) {
  io::Snapshot s = filled_lattice();
  const std::vector<Part> part = parts(s);
  EXPECT_EQ(std::ranges::count(part, Part::soil), 125);
  EXPECT_EQ(std::ranges::count(part, Part::node), 218);
  EXPECT_EQ(std::ranges::count(part, Part::fill), 386);
  EXPECT_EQ(copies(s).size(), 25U);
  // A node with a copy_id stays a node, and a bag of soil without copies is soil.
  s.grains.copy_id[static_cast<std::size_t>(at(3, 0, 0))] = 7;
  EXPECT_EQ(parts(s)[static_cast<std::size_t>(at(3, 0, 0))], Part::node);
  EXPECT_EQ(copies(s)[7].grains.size(), 5U);
  s.grains.copy_id.assign(s.grains.size(), -1);
  EXPECT_EQ(std::ranges::count(parts(s), Part::soil), 125 + 386);
  EXPECT_FALSE(has_fill(s));
}

TEST(Reinforced, EachPartHasItsOwnStressAndVoidRatio) {
  const io::Snapshot s = filled_lattice();
  io::Series table;
  put_bag(table, s, 2);
  EXPECT_NEAR(value(table, "soil_volume"), 125, 1e-9);
  EXPECT_NEAR(value(table, "soil_void_ratio"), 6 / pi - 1, 1e-11);
  EXPECT_NEAR(value(table, "soil_delaunay_void_ratio"), 64 / (125 * pi / 6) - 1, 1e-11) << "no tetrahedra around it";
  EXPECT_NEAR(value(table, "fill_void_ratio"), 6 / pi - 1, 1e-11);
  const double stress[] = {3, 5, 7};
  for (int a = 0; a < 3; ++a) {
    const std::string axis = std::string("_") + "xyz"[a] + "xyz"[a];
    EXPECT_NEAR(value(table, "soil_stress" + axis), stress[a], 1e-10);
    EXPECT_NEAR(value(table, "fill_stress" + axis), 2 * stress[a], 1e-10);
  }
  EXPECT_NEAR(value(table, "face_friction_x"), 0, 1e-9);
  EXPECT_EQ(value(table, "soil_coordination_number"), 6);
  EXPECT_EQ(value(table, "fill_coordination_number"), 6);
  for (const char* group : {"group_1", "group_2", "group_3", "group_4", "group_5"}) {
    EXPECT_NEAR(value(table, std::string(group) + "_mean_stress"), 5, 1e-10);
    EXPECT_NEAR(value(table, std::string(group) + "_deviatoric_stress"), std::sqrt(12.0), 1e-10);
  }
  const auto yarns = static_cast<double>(std::ranges::count(s.yarns.family, 0));
  EXPECT_NEAR(value(table, "yarn_stress_xx"), -4 * yarns / 729, 1e-12);
  // The cell's stress includes contacts of soil, nodes and fill, and yarns.
  io::Series cell;
  put_cell(cell, s, false);
  double contacts = 0;
  for (std::size_t c = 0; c < s.contacts.size(); ++c) contacts += s.contacts.force(c).x() / 729;
  EXPECT_NEAR(value(cell, "stress_xx"), contacts - 4 * yarns / 729, 1e-12);
  EXPECT_NEAR(value(cell, "void_ratio"), 6 / pi - 1, 1e-12) << "nodes are solids";
}

// The quarter whose stress gives the friction at the faces belongs to the bag, wherever the bag lies in the cell.
TEST(Reinforced, TheQuarterIsThatOfTheBag) {
  io::Snapshot s = filled_lattice();
  for (std::size_t c = 0; c < s.contacts.size(); ++c)
    if (s.contacts.normal[c].z() == 1) {
      const Vec3& x = s.grains.position[static_cast<std::size_t>(s.contacts.bodies[c][0])];
      if (x.x() > 20 && x.y() > 20) s.contacts.shear_force[c] = Vec3(4, 0, 0);
    }
  io::Series table;
  put_bag(table, s);
  EXPECT_NEAR(value(table, "face_friction_z"), std::atan(2.0 / 7) * 180 / pi, 1e-9);
}

TEST(Reinforced, FabricAndTablesOfGrainsTellSoilFromFill) {
  const io::Snapshot s = filled_lattice();
  EXPECT_EQ(soil_contacts(s).contacts.size(), 300U + 150U);
  EXPECT_EQ(soil_contacts(s, true).contacts.size(), 300U);
  io::Series fabric, histogram, grains;
  put_fabric(fabric, soil_contacts(s));
  EXPECT_EQ(value(fabric, "coordination_number"), 6) << "contacts with nodes count, fill does not";
  EXPECT_EQ(value(fabric, "rattlers"), 0);
  put_histogram(histogram, soil_contacts(s));
  EXPECT_EQ(value(histogram, "grains"), 125);
  put_grains(grains, s, local(s, s));
  double sum = 0;
  for (const double part : grains.at("part").values) sum += part;
  EXPECT_EQ(sum, 386 + 2 * 218);
}

// Returns a run of four rows: two of the isotropic stage, the row where strains restart, and a station of compression.
// Without `bag`, the series lacks the columns of the bag, whose Delaunay tetrahedra take most of the time.
io::RunFile compressed(bool bag) {
  io::RunFile run;
  io::Snapshot s = filled_lattice();
  run.snapshots = {s};
  run.scenario =
      "[[stage]]\npath = \"isotropic\"\npressure = 1e4\n[[stage]]\npath = \"triaxial\"\nconfining_pressure = 1e4\n"
      "reset_strain = true\naxial_strain = 0.1\nincrement = 0.1\nrate = 0.1\n";
  io::Series& t = run.series;
  const std::vector<std::pair<const char*, std::array<double, 4>>> columns = {{"step", {0, 10, 10, 20}},
                                                                              {"time", {0, 2, 2, 5}},
                                                                              {"stage", {0, 0, 1, 1}},
                                                                              {"strain_xx", {0, 0.01, 0, -0.03}},
                                                                              {"strain_yy", {0, 0.02, 0, -0.04}},
                                                                              {"strain_zz", {0, 0.03, 0, 0.1}},
                                                                              {"stress_xx", {0, 9, 9, 10}},
                                                                              {"stress_yy", {0, 11, 11, 10}},
                                                                              {"stress_zz", {0, 10, 10, 60}},
                                                                              {"void_ratio", {0.9, 0.8, 0.8, 0.7}}};
  for (const auto& [name, values] : columns) t.columns.push_back({name, "1", name, {values.begin(), values.end()}});
  for (const double height : {1.0, 0.95, 0.95, 0.9}) {
    for (Vec3& x : s.grains.position) x.z() = 20 + height * (x.z() - 20);
    s.cell.matrix(2, 2) *= height;
    if (bag) put_bag(t, s);
  }
  for (const char* name : {"kinetic_energy", "unbalanced_force", "boundary_work", "energy_error"})
    t.columns.push_back({name, "1", name, {0, 0, 0, 0}});
  s.yarns.broken[3] = 1, s.yarns.break_time[3] = 2.4;
  s.step = 20;
  run.snapshots.push_back(s);
  return run;
}

TEST(Reinforced, TheTableOfARunHasCellSoilGroupsAndFillSideBySide) {
  const io::RunFile run = compressed(true);
  const io::Series table = reinforced(run.series, reinforced_cell(run, "run"));
  const auto column = [&](const char* name) { return table.at(name).values; };
  EXPECT_EQ(strain_origin(run.series), 2U);
  const std::vector<double> axial = column("strain_axial");
  EXPECT_NEAR(axial[0], -0.03, 1e-15) << "before the origin the cell was higher";
  EXPECT_EQ(axial[1], 0);
  EXPECT_EQ(axial[2], 0);
  EXPECT_EQ(axial[3], 0.1);
  EXPECT_NEAR(column("strain_axial_engineering")[3], 1 - std::exp(-0.1), 1e-15);
  EXPECT_NEAR(column("strain_volumetric")[3], 0.03, 1e-15);
  EXPECT_EQ(column("axial_stress")[3], 60);
  EXPECT_EQ(column("lateral_stress")[2], 10);
  EXPECT_EQ(column("stress_ratio")[3], 6);
  EXPECT_TRUE(std::isnan(column("stress_ratio")[0])) << "an unloaded cell has no ratio";
  EXPECT_NEAR(column("soil_lateral_stress")[0], 4, 1e-10);
  EXPECT_NEAR(column("fill_axial_stress")[0], 14, 1e-10);
  EXPECT_NEAR(column("group_3_mean_stress")[0], 5, 1e-10);
  EXPECT_EQ(column("face_friction_z"), run.series.at("face_friction_z").values) << "of the quarter, as in the series";
  EXPECT_NEAR(column("soil_strain_volumetric")[3], -std::log(0.9), 1e-12) << "of its own tetrahedra";
  EXPECT_NEAR(column("soil_strain_deviatoric")[3], 0.1 + std::log(0.9) / 3, 1e-12);
  EXPECT_NEAR(column("first_break_strain")[0], 0.04, 1e-15) << "0.4 s at 0.1 /s";
}

TEST(Reinforced, RunsWithoutACellLackTheTableByName) {
  io::RunFile run = compressed(false);
  const auto refused = [&](const std::string& reason) {
    expect_error<DataError>([&] { reinforced_cell(run, "x.h5"); }, reason);
  };
  std::erase_if(run.series.columns, [](const io::Column& c) { return c.name == "stress_zz"; });
  refused("x.h5: its series has");
  run.snapshots.front().cell.periodic = {true, true, false};
  refused("open along z");
  run.snapshots.front().yarns = {};
  run.snapshots.front().grains.copy_id.assign(729, 0);
  refused("neither a geotextile nor soil within fill");
  run.series = {};
  refused("has no series");
}

}  // namespace
}  // namespace soilweave::analysis
