// Reinforced soil in a periodic cell: the soil around it, and the effect of the cell's strain on it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "analysis/measure/tessellation.h"
#include "analysis/tables/bag.h"
#include "core/error.h"
#include "dem/run/scenario.h"
#include "packing/expand/plan.h"
#include "packing/expand/reinforced.h"
#include "packing/expand/surround_compaction.h"
#include "packing/expand/tile.h"
#include "packing/generate/apart.h"
#include "packing/generate/cloud.h"
#include "support/assemblies.h"
#include "support/pair.h"

namespace soilweave::packing {
namespace {

constexpr const char* materials = R"(
[contact]
law = "hertz-mindlin"
young_modulus = "4 GPa"
poisson_ratio = 0.33
friction_angle = 29
[[material]]
young_modulus = "8 GPa"
poisson_ratio = 0.33
friction_angle = 21
)";

const io::Snapshot& volume() {
  static const io::Snapshot one = support::packed(support::sand(), 1e4, 60);
  return one;
}

// A box of soil, two copies of the volume wide, in a bag; not grown.
io::Snapshot bag() {
  const double size = volume().cell.matrix(0, 0);
  const std::string plan =
      std::string("[container]\nshape = \"box\"\nlow = ") +
      fmt::format("[{0}, {0}, {1}]\nhigh = [{2}, {2}, {3}]\n", -0.9 * size, -0.4 * size, 0.9 * size, 0.4 * size) +
      "copies = [2, 2, 1]\n[geotextile_mesh]\ncells = [12, 12, 6]\nnode_radius = \"2 mm\"\n" +
      "offset = 0\n[grains]\nscale = 0.99\n" + materials;
  return assemble(volume(), read_plan(plan, "bag.toml", {}));
}

Surround around(Surround::Form form = Surround::Form::wrapped) {
  Surround how;
  how.form = form;
  how.copies = {2, 2, 1};
  how.scale = 0.99;
  how.volume = volume();
  how.recipe.pressure = 1e4, how.recipe.void_ratio = 0.8, how.recipe.materials = {2};
  return how;
}

double deepest_overlap(const io::Snapshot& s, const std::vector<bool>& fill) {
  double deepest = 0;
  const Vec3 size = s.cell.matrix.diagonal();
  for (std::size_t i = 0; i < fill.size(); ++i)
    for (std::size_t j = 0; fill[i] && j < i; ++j) {
      Vec3 d = s.grains.position[i] - s.grains.position[j];
      for (int a = 0; a < 3; ++a) d[a] -= size[a] * std::round(d[a] / size[a]);
      deepest = std::max(deepest, s.grains.radius[i] + s.grains.radius[j] - d.norm());
    }
  return deepest;
}

TEST(Surround, PutsTheGrainsBackThatWereCutAwayWithoutOverlap) {
  const io::Snapshot one = bag();
  const Surrounded cell = surround(one, around(), 0);
  EXPECT_TRUE(cell.cut_away);
  const std::vector<bool> node = io::nodes(one);
  const auto soil = static_cast<std::size_t>(std::count(node.begin(), node.end(), false));
  const auto filled = static_cast<std::size_t>(std::count(cell.fill.begin(), cell.fill.end(), true));
  EXPECT_EQ(soil + filled, 4 * volume().grains.size()) << "all soil of the block is in the cell, once";
  EXPECT_EQ(deepest_overlap(cell.state, cell.fill), 0);
  std::multiset<double> radii, expected;
  for (std::size_t i = 0; i < cell.fill.size(); ++i) {
    const io::GrainsRecord& g = cell.state.grains;
    if (cell.fill[i]) {
      EXPECT_EQ(g.copy_id[i], -1);
      EXPECT_EQ(g.material_id[i], 2);
    } else {
      EXPECT_EQ(g.copy_id[i], one.grains.copy_id[i]);
      EXPECT_EQ(g.position[i], one.grains.position[i]) << "what is reinforced stays where it was";
    }
  }
  EXPECT_EQ(cell.state.contacts.size(), one.contacts.size());
  const std::set<std::int64_t> ids(cell.state.grains.body_id.begin(), cell.state.grains.body_id.end());
  EXPECT_EQ(ids.size(), cell.fill.size());
}

TEST(Surround, FindsTheBlockByItselfAndSurroundsABagOfOtherSoil) {
  Surround how = around();
  how.copies.reset();
  EXPECT_TRUE(surround(bag(), how, 0).cut_away) << "the bag's own block is found where no copies are given";
  how.volume.grains.radius[3] *= 0.999;
  const Surrounded other = surround(bag(), how, 0);
  EXPECT_FALSE(other.cut_away);
  EXPECT_EQ(deepest_overlap(other.state, other.fill), 0);
  const Inside inside(bag());
  for (std::size_t i = 0; i < other.fill.size(); ++i)
    if (other.fill[i]) {
      EXPECT_FALSE(inside(other.state.grains.position[i]));
    }
}

TEST(Surround, LayersAreTheFacesOfABagWithFreeEdges) {
  Surround how = around(Surround::Form::layered);
  how.rings = 0.25;  // of two copies: the inner three quarters
  const Surrounded cell = surround(bag(), how, 0);
  const io::YarnsRecord& yarns = cell.state.yarns;
  EXPECT_EQ(yarns.size(), 2U * 2 * 12 * 13);
  EXPECT_TRUE(std::all_of(yarns.family.begin(), yarns.family.end(), [](std::int32_t f) { return f == 0; }));
  const std::vector<bool> node = io::nodes(cell.state);
  EXPECT_EQ(std::count(node.begin(), node.end(), true), 2 * 13 * 13) << "no node of the sides is left";
  std::set<std::int32_t> fabrics(yarns.fabric.begin(), yarns.fabric.end());
  EXPECT_EQ(fabrics.size(), 2U);
  for (std::size_t y = 0; y < yarns.size(); ++y) {
    const double z = cell.state.grains.position[static_cast<std::size_t>(yarns.nodes[y][0])].z();
    const double first = cell.state.grains.position[static_cast<std::size_t>(yarns.nodes[0][0])].z();
    EXPECT_EQ(yarns.fabric[y] == yarns.fabric[0], z * first > 0) << "one fabric a face";
  }
  const double half = 0.75 * 0.99 * volume().cell.matrix(0, 0);
  std::size_t soil = 0;
  for (std::size_t i = 0; i < cell.fill.size(); ++i) soil += !node[i] && !cell.fill[i];
  EXPECT_GT(soil, 0U);
  for (std::size_t i = 0; i < cell.fill.size(); ++i)
    if (!node[i] && !cell.fill[i]) {
      EXPECT_LE(cell.state.grains.position[i].head<2>().cwiseAbs().maxCoeff(), half);
    }
}

TEST(Surround, RefusesWhatCannotBeSurrounded) {
  const auto refusal = [](const io::Snapshot& file, const Surround& how) {
    try {
      surround(file, how, 0);
    } catch (const DataError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(refusal(volume(), around()).find("has no geotextile"), std::string::npos);
  Surround how = around();
  how.copies = {1, 1, 1};
  EXPECT_NE(refusal(bag(), how).find("raise surround.copies"), std::string::npos);
  how.copies.reset(), how.scale = 9;
  EXPECT_NE(refusal(bag(), how).find("more than twice the reinforced part"), std::string::npos);
  how = around();
  how.recipe.void_ratio = 0.01;
  EXPECT_NE(refusal(bag(), how).find("surround.void_ratio 0.01"), std::string::npos);
}

TEST(Surround, WhatIsApartStandsWhileTheCellStrains) {
  const io::Snapshot cloud = packing::cloud({0.003, 0.003, 0.003}, 40, {1, 1, 1}, 3, 2650, 1);
  const auto moved = [&](const std::vector<std::int32_t>& apart) {
    dem::Simulation simulation(cloud, support::sand(), {});
    Mat3 before = Mat3::Zero();
    for (const double rate : {1e-3, 2e-3}) {
      simulation.set_velocity_gradient(-rate * Mat3::Identity());
      keep_apart(apart, simulation.cell().velocity_gradient() - before, simulation);
      before = simulation.cell().velocity_gradient();
      for (int k = 0; k < 20; ++k) simulation.step();
    }
    return (simulation.snapshot().grains.position[1] - cloud.grains.position[1]).norm();
  };
  EXPECT_LT(moved({1}), 1e-15);
  EXPECT_GT(moved({0}), 1e-9);
}

TEST(Surround, WhatIsHeldStandsWhateverItsVelocity) {
  io::Snapshot cloud = packing::cloud({0.003, 0.003, 0.003}, 40, {1, 1, 1}, 3, 2650, 1);
  for (Vec3& velocity : cloud.grains.velocity) velocity = Vec3(1e-3, 0, 0);
  dem::Simulation simulation(cloud, support::sand(), {});
  simulation.set_velocity_gradient(-1e-3 * Mat3::Identity());
  for (int k = 0; k < 20; ++k) {
    hold({1}, simulation);
    simulation.step();
  }
  const std::vector<Vec3> now = simulation.snapshot().grains.position;
  EXPECT_LT((now[1] - cloud.grains.position[1]).norm(), 1e-12);
  EXPECT_GT((now[0] - cloud.grains.position[0]).norm(), 1e-9);
}

// Evenly loose fill ends evenly dense if the room above the reinforced part and the whole room shrink by one factor.
TEST(Surround, TheRoomAboveAndBesideTheBagCloseByOneFactor) {
  const io::Snapshot one = bag();
  const Surrounded cell = surround(one, around(), 0);
  double solids = 0;
  for (const double r : cell.state.grains.radius) solids += dem::grain_volume(3, r);
  const Vec3 loose = cell.state.cell.matrix.diagonal(), way = cell.shares.cwiseProduct(loose);
  const double volume = 1.8 * solids, taken = analysis::delaunay_volume(one), height = extent(one).z();
  double low = 0, high = 1 / cell.shares.maxCoeff();
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    ((loose - middle * way).prod() > volume ? low : high) = middle;
  }
  const Vec3 dense = loose - low * way;
  EXPECT_GT(loose.prod(), 1.1 * volume);
  EXPECT_NEAR((loose.z() - height) / (dense.z() - height), (loose.prod() - taken) / (volume - taken), 1e-9);
  EXPECT_NEAR(loose.x() - dense.x(), loose.y() - dense.y(), 1e-12);
}

TEST(Surround, LowersTheFrictionOfItsOwnMaterialAlone) {
  const dem::Model three = dem::read_model(*std::make_unique<Settings>(Settings::parse(
      std::string(materials) + "[[material]]\nyoung_modulus = 1e9\npoisson_ratio = 0.3\nfriction_angle = 35\n", "m")));
  const dem::Model lowered = dem::with_friction(three, 0.01, {2});
  EXPECT_EQ(dem::friction(lowered, {2}), 0.01);
  EXPECT_EQ(dem::friction(lowered, {0, 1}), dem::friction(three));
  EXPECT_NEAR(dem::friction(three, {2}), 35 * support::degree, 1e-12);
}

}  // namespace
}  // namespace soilweave::packing
