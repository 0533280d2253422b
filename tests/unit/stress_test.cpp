// Stress of lattices with closed forms from their contact forces; sums, rotations, parts.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/stress.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <tuple>

#include "analysis/measure/tessellation.h"
#include "analysis/measure/volume_of_interest.h"
#include "analysis/tables/tables.h"
#include "support/assembly.h"

namespace soilweave::analysis {
namespace {

using test::random_cell;
using test::simple_cubic;

// Random contacts join the first grains of a random cell; the identities need no equilibrium.
io::Snapshot loaded() {
  io::Snapshot s = random_cell(60);
  for (int k = 0; k < 59; ++k)
    test::add_contact(s, k, k + 1, Vec3i(k % 2, 0, -(k % 3)), 1 + 0.1 * k, Vec3(0.3, -0.2 * k, 0.1));
  return s;
}

TEST(Stress, OfASimpleCubicLatticeIsForceOverArea) {
  const Vec3 force(3, 5, 7);  // each contact holds one unit square
  const Mat3 stress = cell_stress(simple_cubic(4, force));
  EXPECT_LT((stress - Mat3(force.asDiagonal())).norm(), 1e-13);
  const Mat3 disks = cell_stress(simple_cubic(4, force, 2));
  EXPECT_LT((disks - Mat3(Vec3(3, 5, 0).asDiagonal())).norm(), 1e-13);
}

TEST(Stress, GrainsHoldAllOfIt) {
  const io::Snapshot s = loaded();
  Mat3 sum = Mat3::Zero();
  for (const Mat3& dyad : grain_dyads(s)) sum += dyad;
  const Mat3 stress = cell_stress(s);
  EXPECT_LT((sum / cell_volume(s) - stress).norm(), 1e-12 * stress.norm());
  const VolumeState all = volume_state(s, whole(s), grain_dyads(s), power_cell_volumes(s));
  EXPECT_LT((all.stress - stress).norm(), 1e-9 * stress.norm());
  EXPECT_NEAR(all.void_ratio, void_ratio(s), 1e-9);
}

TEST(Stress, ADyadIsSplitAtTheContactPoint) {
  io::Snapshot s;
  test::add_grain(s, Vec3(0, 0, 0), 1);
  test::add_grain(s, Vec3(4, 0, 0), 3);
  test::add_contact(s, 0, 1, Vec3i::Zero(), 2);
  const std::vector<Mat3> dyads = grain_dyads(s);
  EXPECT_DOUBLE_EQ(dyads[0](0, 0), 2 * 1);
  EXPECT_DOUBLE_EQ(dyads[1](0, 0), 2 * 3);
}

TEST(Stress, ADyadOfOverlappingGrainsIsSplitInTheMiddleOfTheirOverlap) {
  // Radii 1 and 3 with centres 3.8 apart: half of the overlap of 0.2 counts off either radius.
  io::Snapshot s;
  test::add_grain(s, Vec3(0, 0, 0), 1);
  test::add_grain(s, Vec3(3.8, 0, 0), 3);
  test::add_contact(s, 0, 1, Vec3i::Zero(), 2, Vec3(0, 5, 0));
  const std::vector<Mat3> dyads = grain_dyads(s);
  EXPECT_NEAR(dyads[0](0, 0), 2 * 0.9, 1e-14);
  EXPECT_NEAR(dyads[1](0, 0), 2 * 2.9, 1e-14);
  // In f (x) l the row is the force's axis, the column the branch's.
  EXPECT_NEAR(dyads[0](1, 0), 5 * 0.9, 1e-14);
  EXPECT_EQ(dyads[0](0, 1), 0);
  EXPECT_NEAR(cell_stress(s)(1, 0) * cell_volume(s), 5 * 3.8, 1e-13);
}

TEST(Stress, TurnsWithTheAssembly) {
  const io::Snapshot s = loaded();
  const Mat3 q = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  io::Snapshot turned = s;
  turned.cell.matrix = q * s.cell.matrix;
  for (Vec3& f : turned.contacts.shear_force) f = q * f;
  for (Vec3& n : turned.contacts.normal) n = q * n;
  for (Vec3& l : turned.contacts.branch_vector) l = q * l;
  const Mat3 expected = q * cell_stress(s) * q.transpose();
  EXPECT_LT((cell_stress(turned) - expected).norm(), 1e-12 * expected.norm());
}

TEST(Stress, PrincipalValuesAreOrderedAndRebuildIt) {
  const Mat3 q = Eigen::AngleAxisd(1.1, Vec3(1, 1, 3).normalized()).toRotationMatrix();
  const Mat3 stress = q * Vec3(1, 3, 2).asDiagonal() * q.transpose();
  const Principal p = principal(stress, 3);
  EXPECT_LT((p.values - Vec3(3, 2, 1)).norm(), 1e-14);
  EXPECT_LT((p.directions * p.values.asDiagonal() * p.directions.transpose() - stress).norm(), 1e-14);
  Mat3 plane = Mat3::Zero();
  plane.topLeftCorner<2, 2>() << 2, 1, 1, 2;
  const Principal flat = principal(plane, 2);
  EXPECT_LT((flat.values - Vec3(3, 1, 0)).norm(), 1e-14);
  EXPECT_NEAR(flat.directions(0, 0), std::numbers::sqrt2 / 2, 1e-14);
}

TEST(VolumeOfInterest, BoxesTakeWrappedGrainsOnce) {
  io::Snapshot s = simple_cubic(4, Vec3(3, 5, 7));
  s.grains.position[0] += 4 * Vec3(1, -2, 0);  // the same place, two cells away
  const Volume left = box(s, {-0.5, -0.5, -0.5}, {1.5, 4, 4}), right = box(s, {1.5, -0.5, -0.5}, {4, 4, 4});
  EXPECT_EQ(left.grains.size(), 32U);
  EXPECT_EQ(right.grains.size(), 32U);
  EXPECT_EQ(left.grains[0], 0U);
  const VolumeState v = volume_state(s, left, grain_dyads(s), power_cell_volumes(s));
  EXPECT_NEAR(v.volume, 32, 1e-10);
  EXPECT_LT((v.stress - Mat3(Vec3(3, 5, 7).asDiagonal())).norm(), 1e-10);
  EXPECT_NEAR(v.void_ratio, 6 / std::numbers::pi - 1, 1e-10);
}

TEST(VolumeOfInterest, ABoxReachesThroughAPeriodicFace) {
  // Layers at 3, 0 and 1 of a cell from 0 to 4: the first lies at -1 in this box.
  io::Snapshot s = simple_cubic(4, Vec3(3, 5, 7));
  const Volume around = box(s, {-1.5, -0.5, -0.5}, {1.5, 4, 4});
  EXPECT_EQ(around.grains.size(), 48U);
  EXPECT_LT((centre(s, around) - Vec3(0, 1.5, 1.5)).norm(), 1e-12);
  const VolumeState v = volume_state(s, around, grain_dyads(s), power_cell_volumes(s));
  EXPECT_NEAR(v.volume, 48, 1e-10);
  EXPECT_EQ(box(s, {-9, -9, -9}, {9, 9, 9}).grains.size(), 64U) << "each grain counts once";
  EXPECT_TRUE(box(s, {50, 50, 50}, {60, 60, 60}).grains.empty());
  s.cell.periodic = {false, true, true};
  EXPECT_EQ(box(s, {-1.5, -0.5, -0.5}, {1.5, 4, 4}).grains.size(), 32U) << "there are no images across an open face";
}

TEST(VolumeOfInterest, ABoxHoldsNoNodes) {
  io::Snapshot s = simple_cubic(4, Vec3(3, 5, 7));
  s.yarns.nodes = {{0, 1}};
  EXPECT_EQ(box(s, {-0.5, -0.5, -0.5}, {4, 4, 4}).grains.size(), 62U);
}

TEST(VolumeOfInterest, NoAverageIsNotANumber) {
  const io::Snapshot s = simple_cubic(4, Vec3(3, 5, 7));
  const VolumeState v = volume_state(s, whole(s), grain_dyads(s), std::vector<double>(64, 0.0));
  EXPECT_EQ(v.grains, 0);
  EXPECT_TRUE(std::isnan(v.void_ratio));
  EXPECT_TRUE(std::isnan(v.stress(0, 0)));
}

TEST(Tables, ACellThatDoesNotFollowItsGrainsHasNoStress) {
  io::Snapshot s = simple_cubic(4, Vec3(3, 5, 7));
  io::Series closed, open;
  put_cell(closed, s, false);
  s.cell.periodic = {true, true, false};
  put_cell(open, s, false);
  for (const char* name : {"strain_zz", "stress_zz", "mean_stress", "principal_1", "direction_1z", "void_ratio"}) {
    EXPECT_TRUE(std::isfinite(closed.at(name).values[0])) << name;
    EXPECT_TRUE(std::isnan(open.at(name).values[0])) << name;
  }
  EXPECT_EQ(open.at("coordination_number").values, closed.at("coordination_number").values);
}

TEST(VolumeOfInterest, ItsCentreIsWhereItsGrainsWereTold) {
  io::Snapshot s = simple_cubic(4, Vec3(3, 5, 7));
  const Vec3 still = centre(s, box(s, {-0.5, -0.5, -0.5}, {1.5, 4, 4})), all = centre(s, whole(s));
  EXPECT_LT((still - Vec3(0.5, 1.5, 1.5)).norm(), 1e-12);
  for (std::size_t i = 0; i < 16; ++i) s.grains.position[i] += 4 * Vec3(1, -2, 0);
  EXPECT_LT((centre(s, box(s, {-0.5, -0.5, -0.5}, {1.5, 4, 4})) - still).norm(), 1e-12) << "a box is one of the cell";
  EXPECT_LT((centre(s, whole(s)) - all - Vec3(1, -2, 0)).norm(), 1e-12) << "soil is where it has travelled to";
}

TEST(VolumeOfInterest, PrincipalStressesHaveDirectionsAndAPlace) {
  io::Snapshot s = simple_cubic(4, Vec3(3, 5, 7));
  io::Series table;
  put_volume(table, s, s, 0, box(s, {-0.5, -0.5, -0.5}, {1.5, 4, 4}), local(s, s));
  const auto value = [&](const std::string& name) { return table.at(name).values.at(0); };
  for (const auto& [number, stress, axis] :
       {std::tuple{"1", 7, "z"}, std::tuple{"2", 5, "y"}, std::tuple{"3", 3, "x"}}) {
    EXPECT_NEAR(value(std::string("principal_") + number), stress, 1e-9);
    EXPECT_NEAR(std::abs(value(std::string("direction_") + number + axis)), 1, 1e-9);
  }
  EXPECT_NEAR(value("centre_x"), 0.5, 1e-12);
  EXPECT_NEAR(value("centre_z"), 1.5, 1e-12);
}

TEST(VolumeOfInterest, CopiesComeInOrder) {
  io::Snapshot s = simple_cubic(2, Vec3(1, 1, 1));
  s.grains.copy_id = {1, 1, 0, 0, 1, 1, 0, 2};
  const std::vector<Volume> v = copies(s);
  ASSERT_EQ(v.size(), 3U);
  EXPECT_EQ(v[0].name, "copy 0");
  EXPECT_EQ(v[0].grains, (std::vector<std::size_t>{2, 3, 6}));
  EXPECT_EQ(v[2].grains, (std::vector<std::size_t>{7}));
}

TEST(VolumeOfInterest, GroupsKeepTheirPlaceWithoutTheOutermostCopies) {
  // Ten by ten copies of which those at the sides were cut away: numbers end at 88, and 9 by 9 copies would end at 80.
  io::Snapshot s;
  for (std::int32_t y = 1; y < 9; ++y)
    for (std::int32_t x = 1; x < 9; ++x) {
      test::add_grain(s, Vec3(x, y, 0), 0.5);
      s.grains.copy_id.back() = 10 * y + x;
    }
  const std::vector<Volume> all = groups(s);
  ASSERT_EQ(all.size(), 5U);
  const auto ids = [&](const Volume& volume) {
    std::vector<std::int32_t> found;
    for (const std::size_t i : volume.grains) found.push_back(s.grains.copy_id[i]);
    return found;
  };
  EXPECT_EQ(all[0].name, "#1");
  EXPECT_EQ(ids(all[0]), (std::vector<std::int32_t>{41, 51})) << "half as wide";
  EXPECT_EQ(ids(all[1]), (std::vector<std::int32_t>{42, 43, 52, 53}));
  EXPECT_EQ(ids(all[2]), (std::vector<std::int32_t>{44, 45, 54, 55}));
  EXPECT_EQ(ids(all[4]), (std::vector<std::int32_t>{48, 58}));
}

TEST(VolumeOfInterest, GroupsLieAlongTheMiddle) {
  io::Snapshot s;
  test::add_grain(s, Vec3(9, 9, 9), 0.5);
  for (std::int32_t k = 0; k < 25; ++k) test::add_grain(s, Vec3(k % 5, k / 5, 0), 0.5);
  // One node of a geotextile, and one grain for each of five by five copies.
  for (std::int32_t k = -1; k < 25; ++k) s.grains.copy_id[static_cast<std::size_t>(k + 1)] = k;
  const std::vector<Volume> odd = groups(s);
  ASSERT_EQ(odd.size(), 5U);
  EXPECT_EQ(odd[0].grains, (std::vector<std::size_t>{11}));
  EXPECT_EQ(odd[4].grains, (std::vector<std::size_t>{15}));
  // Without the last nine copies the bag has four by four: an even number has two copies in the middle.
  for (std::size_t k = 17; k < 26; ++k) s.grains.copy_id[k] = -1;
  for (std::int32_t k = 0; k < 16; ++k) s.grains.position[static_cast<std::size_t>(k + 1)] = Vec3(k % 4, k / 4, 0);
  const std::vector<Volume> even = groups(s);
  ASSERT_EQ(even.size(), 2U);
  EXPECT_EQ(even[1].name, "#2");
  EXPECT_EQ(even[1].grains, (std::vector<std::size_t>{7, 8, 11, 12}));
  // Eight by two copies are not four by four.
  for (std::int32_t k = 0; k < 16; ++k) s.grains.position[static_cast<std::size_t>(k + 1)] = Vec3(k % 8, k / 8, 0);
  EXPECT_TRUE(groups(s).empty());
  // A bag without copies has no groups.
  for (std::int32_t& id : s.grains.copy_id) id = 0;
  EXPECT_TRUE(groups(s).empty());
}

}  // namespace
}  // namespace soilweave::analysis
