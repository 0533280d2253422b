// A bag as a whole: a cubic lattice of soil wrapped in nodes gives every number of its tables in closed form.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/tables/bag.h"
#include "display/display.h"
#include "support/assembly.h"

namespace soilweave::analysis {
namespace {

constexpr double pi = std::numbers::pi;

void add_yarn(io::Snapshot& s, std::int32_t first, std::int32_t second, int family, double strain, double tension,
              bool broken = false) {
  const double length =
      (s.grains.position[static_cast<std::size_t>(second)] - s.grains.position[static_cast<std::size_t>(first)]).norm();
  io::YarnsRecord& y = s.yarns;
  y.nodes.push_back({first, second});
  y.fabric.push_back(0), y.geotextile_id.push_back(0), y.family.push_back(family);
  y.rest_length.push_back(length / (1 + strain)), y.largest_strain.push_back(strain), y.tension.push_back(tension);
  y.broken.push_back(broken), y.break_time.push_back(0), y.break_position.emplace_back(Vec3::Zero());
}

// Spheres of diameter 1 at integer places from -3 to 3: soil where no coordinate is 3 in size, nodes around it.
// Contacts have the forces 3, 5, 7 along the axes; along z they shear by 4 along x in the quarter x, y > 0, by 1
// elsewhere.
io::Snapshot wrapped_lattice() {
  io::Snapshot s;
  s.cell.matrix = 7 * Mat3::Identity();
  s.cell.periodic = {false, false, false};
  const auto at = [](int x, int y, int z) { return static_cast<std::int32_t>(x + 3 + 7 * (y + 3 + 7 * (z + 3))); };
  for (int z = -3; z <= 3; ++z)
    for (int y = -3; y <= 3; ++y)
      for (int x = -3; x <= 3; ++x) test::add_grain(s, Vec3(x, y, z), 0.5);
  for (int z = -3; z <= 3; ++z)
    for (int y = -3; y <= 3; ++y)
      for (int x = -3; x <= 3; ++x) {
        if (x < 3) test::add_contact(s, at(x, y, z), at(x + 1, y, z), Vec3i::Zero(), 3);
        if (y < 3) test::add_contact(s, at(x, y, z), at(x, y + 1, z), Vec3i::Zero(), 5);
        const double shear = x > 0 && y > 0 ? 4 : 1;
        if (z < 3) test::add_contact(s, at(x, y, z), at(x, y, z + 1), Vec3i::Zero(), 7, Vec3(shear, 0, 0));
      }
  // Every node has a yarn to a neighbouring node.
  for (int z = -3; z <= 3; ++z)
    for (int y = -3; y <= 3; ++y)
      for (int x = -3; x < 3; ++x) {
        const bool along_face = std::abs(y) == 3 || std::abs(z) == 3;
        if (along_face) add_yarn(s, at(x, y, z), at(x + 1, y, z), 0, 0.1, 20);
      }
  for (const int x : {-3, 3})
    for (int z = -3; z <= 3; ++z)
      for (int y = -3; y < 3; ++y) add_yarn(s, at(x, y, z), at(x, y + 1, z), 1, y < 0 ? 0.1 : 0.3, y < 0 ? 30 : 50);
  return s;
}

TEST(WrappedSoil, HasTheStressVoidRatioAndFrictionOfItsLattice) {
  const io::Snapshot s = wrapped_lattice();
  io::Series table;
  put_bag(table, s);
  const auto value = [&](const char* name) { return table.at(name).values.at(0); };
  EXPECT_NEAR(value("soil_volume"), 125, 1e-9) << "a unit cube for each of 5^3 grains";
  EXPECT_EQ(value("soil_outside"), 0);
  EXPECT_NEAR(value("soil_void_ratio"), 6 / pi - 1, 1e-11);
  EXPECT_NEAR(value("soil_delaunay_void_ratio"), 64 / (125 * pi / 6) - 1, 1e-11) << "centres span 4^3";
  EXPECT_NEAR(value("soil_stress_xx"), 3, 1e-11);
  EXPECT_NEAR(value("soil_stress_yy"), 5, 1e-11);
  EXPECT_NEAR(value("soil_stress_zz"), 7, 1e-11);
  // 20 of the 125 grains lie in the quarter; the symmetric part halves the shear.
  const double shear = 0.5 * (20 * 4 + 105 * 1) / 125;
  EXPECT_NEAR(value("soil_stress_xz"), shear, 1e-11);
  const double q = std::sqrt(0.5 * (4 + 4 + 16) + 3 * shear * shear);
  EXPECT_NEAR(value("soil_mean_stress"), 5, 1e-11);
  EXPECT_NEAR(value("soil_deviatoric_stress"), q, 1e-11);
  EXPECT_NEAR(value("soil_obliquity"), q / 5, 1e-11);
  EXPECT_NEAR(value("face_friction_x"), std::atan(2.0 / 3) * 180 / pi, 1e-9) << "of the quarter: tau = 4/2";
  EXPECT_NEAR(value("face_friction_y"), 0, 1e-9);
  EXPECT_NEAR(value("face_friction_z"), std::atan(2.0 / 7) * 180 / pi, 1e-9);
  EXPECT_EQ(value("soil_coordination_number"), 6);
}

TEST(WrappedSoil, TakesASixthOfThePlaceOfAMissingNode) {
  // The node above (0, 0, 2) is far away, so the pyramid of its unit cube over the shared face falls to that grain.
  io::Snapshot s = wrapped_lattice();
  s.grains.position[3 + 7 * (3 + 7 * 6)].z() = 40;
  io::Series table;
  put_bag(table, s);
  const double volume = 125 + 1.0 / 6;
  EXPECT_EQ(table.at("soil_outside").values.at(0), 0);
  EXPECT_NEAR(table.at("soil_volume").values.at(0), volume, 1e-9);
  EXPECT_NEAR(table.at("soil_stress_zz").values.at(0), 7 * 125 / volume, 1e-9);
  EXPECT_NEAR(table.at("soil_void_ratio").values.at(0), volume / (125 * pi / 6) - 1, 1e-11);
}

TEST(WrappedSoil, LeavesOutGrainsWhoseCellReachesOutside) {
  // Without the nodes above them, the cells of the upper 25 grains are many times their grains. The other 100 are
  // unchanged: their stress counts no force of grains without volume.
  io::Snapshot s = wrapped_lattice();
  for (std::size_t i = 0; i < s.grains.size(); ++i)
    if (s.grains.position[i].z() == 3) s.grains.position[i].z() = 40;
  io::Series table;
  put_bag(table, s);
  EXPECT_EQ(table.at("soil_outside").values.at(0), 25);
  EXPECT_NEAR(table.at("soil_volume").values.at(0), 100, 1e-9);
  EXPECT_NEAR(table.at("soil_stress_zz").values.at(0), 7, 1e-10);
  EXPECT_NEAR(table.at("soil_void_ratio").values.at(0), 6 / pi - 1, 1e-11);
}

TEST(Yarns, StrainByTheirLengthAtRestNotByItsLogarithm) {
  io::Snapshot s;
  test::add_grain(s, Vec3(0, 0, 0), 1e-3);
  test::add_grain(s, Vec3(3e-3, 0, 4e-3), 1e-3);
  add_yarn(s, 0, 1, 2, 0.1, 8);
  io::Series table;
  put_yarns(table, s);
  EXPECT_NEAR(table.at("strain").values[0], 0.1, 1e-14) << "ln 1.1 is 0.0953";
  EXPECT_NEAR(table.at("length").values[0], 5e-3, 1e-17);
  EXPECT_NEAR(table.at("position_x").values[0], 1.5e-3, 1e-17);
  EXPECT_NEAR(table.at("direction_x").values[0], 0.6, 1e-14);
  EXPECT_NEAR(table.at("direction_z").values[0], 0.8, 1e-14);
  EXPECT_EQ(table.at("tension").values[0], 8);
  for (const io::VtkArray& array : io::show_yarns(s).cell_data)
    if (array.name == "strain") {
      EXPECT_NEAR(std::get<std::vector<double>>(array.values).at(0), 0.1, 1e-14);
    }
}

TEST(Yarns, MeansAreOverTheWholeOnesOfAFamily) {
  io::Snapshot s = wrapped_lattice();
  s.yarns.broken[0] = 1;
  s.yarns.tension[0] = 0;
  const std::array<YarnMean, 3> means = yarn_means(s);
  EXPECT_NEAR(means[0].strain, 0.1, 1e-13);
  EXPECT_NEAR(means[0].tension, 20, 1e-12) << "the broken one is left out";
  EXPECT_EQ(means[0].broken, 1U);
  // Three of the six yarns along y have 0.1, three have 0.3.
  EXPECT_NEAR(means[1].strain, 0.2, 1e-13);
  EXPECT_NEAR(means[1].tension, 40, 1e-12);
  EXPECT_EQ(means[2].whole + means[2].broken, 0U);
}

}  // namespace
}  // namespace soilweave::analysis
