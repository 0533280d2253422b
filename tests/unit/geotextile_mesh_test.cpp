// The geotextile around a container: its nodes and yarns, and the chart that divides surfaces evenly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <tuple>
#include <vector>

#include "core/error.h"
#include "packing/container/chart.h"
#include "packing/container/shapes/box.h"
#include "packing/container/shapes/cushion.h"
#include "packing/expand/lay_fabrics.h"
#include "packing/expand/plan.h"
#include "support/assemblies.h"
#include "support/bags.h"

namespace soilweave::packing {
namespace {

using std::numbers::pi;

TEST(Geotextile, WrapsTheBagOfTheThesisInItsNumberOfYarns) {
  const Pillow bag;
  const Fabric fabric = wrap(bag, {91, 91, 20}, 0.0025);
  EXPECT_EQ(fabric.nodes.size(), 23844U);
  std::map<int, int> family;
  double shortest = 1, longest = 0, hoop = 0;
  for (const Fabric::Yarn& yarn : fabric.yarns) {
    ++family[yarn.family];
    const Vec3 a = fabric.nodes[static_cast<std::size_t>(yarn.first)],
               b = fabric.nodes[static_cast<std::size_t>(yarn.second)];
    const double length = (b - a).norm();
    shortest = std::min(shortest, length), longest = std::max(longest, length);
    // These yarns go around the bag in the plane next to y = 0.
    if (std::abs(a.y()) < 0.003 && a.y() > 0 && std::abs(a.y() - b.y()) < 1e-4) hoop += length;
  }
  EXPECT_EQ(family[0], 33488);
  EXPECT_EQ(family[1], 6916);
  EXPECT_EQ(family[2], 7280);
  EXPECT_EQ(fabric.yarns.size(), 47684U) << "as recorded of the thesis' model";
  for (const Vec3& x : fabric.nodes) EXPECT_NEAR(bag.depth(x), -0.0025, 1e-12);
  EXPECT_GT(shortest, 0.0043);
  EXPECT_LT(longest, 0.0049) << "yarns are equally long, around corners too";
  // The hoop has straight faces and half circles of 42.5 mm; chords of the arcs are shorter by less than a thousandth.
  EXPECT_NEAR(hoop, 2 * bag.width + 2 * pi * 0.0425, 1e-3 * hoop);
}

TEST(Geotextile, CanBeMeshedFaceByFace) {
  const Pillow bag;
  const Fabric fabric = wrap(bag, {91, 91, 20}, 0.0025, false);
  const double radius = bag.half_height + 0.0025;
  for (const Fabric::Yarn& yarn : fabric.yarns) {
    const Vec3 a = fabric.nodes[static_cast<std::size_t>(yarn.first)],
               b = fabric.nodes[static_cast<std::size_t>(yarn.second)];
    if (yarn.family == 0) {
      EXPECT_NEAR(std::abs(a.z()), radius, 1e-12) << "faces end where they cease to be flat";
    } else if (yarn.family == 2 && std::abs(a.y()) < 0.003) {
      // The yarn is a twentieth of half a circle, as a chord.
      EXPECT_NEAR((b - a).norm(), 2 * radius * std::sin(pi / 40), 1e-5);
    }
    if (a.norm() < radius + 0.001) {
      EXPECT_NEAR((b - a).norm(), bag.width / 91, 0.01 * bag.width / 91) << "in the middle the grid is regular";
    }
  }
  for (const Vec3& x : fabric.nodes) EXPECT_NEAR(bag.depth(x), -0.0025, 1e-12);
}

TEST(Geotextile, FacesOfAnInextensibleBagAreAsWideAsTheEmptyOne) {
  const Pillow bag = support::inextensible();
  double hoop = 0;
  const Fabric fabric = wrap(bag, {91, 91, 20}, 0.0025, false);
  for (const Fabric::Yarn& yarn : fabric.yarns) {
    const Vec3 a = fabric.nodes[static_cast<std::size_t>(yarn.first)],
               b = fabric.nodes[static_cast<std::size_t>(yarn.second)];
    if (yarn.family == 0) {
      EXPECT_NEAR(std::abs(a.z()), bag.half_height + 0.0025, 1e-12);
    }
    if (std::abs(a.y()) < 0.003 && a.y() > 0 && std::abs(a.y() - b.y()) < 1e-4) hoop += (b - a).norm();
  }
  for (const Vec3& x : fabric.nodes) EXPECT_NEAR(bag.depth(x), -0.0025, 1e-12);
  EXPECT_NEAR(hoop, 2 * (0.4 + 0.1) + 2 * pi * 0.0025, 1e-3) << "that of the surface 2.5 mm outside";
}

TEST(Geotextile, WrapsACushionFaceByFace) {
  for (const double corner_radius : {0.0, 0.02})
    for (const double outside : {0.0, 0.0025}) {
      const Cushion bag = support::straight(corner_radius);
      const Fabric fabric = wrap(bag, {91, 91, 20}, outside, false);
      EXPECT_EQ(fabric.yarns.size(), 47684U);
      for (const Vec3& x : fabric.nodes) EXPECT_NEAR(bag.depth(x), -outside, 1e-12);
      double ring = 0;
      for (const Fabric::Yarn& yarn : fabric.yarns) {
        const Vec3 a = fabric.nodes[static_cast<std::size_t>(yarn.first)],
                   b = fabric.nodes[static_cast<std::size_t>(yarn.second)];
        if (yarn.family == 1 && a.z() == 0 && b.z() == 0) ring += (b - a).norm();
      }
      // Chords cut the corners of the outline around the middle.
      const double outline = 8 * bag.reach() - (8 - 2 * pi) * corner_radius + 2 * pi * outside;
      EXPECT_NEAR(ring, outline, 2e-3 * outline);
    }
}

TEST(Geotextile, IsMirroredBitByBit) {
  for (const Fabric& fabric : {wrap(Pillow(), {9, 9, 4}, 0.0025), wrap(support::straight(0.02), {9, 9, 4}, 0.0025)}) {
    const auto less = [](const Vec3& a, const Vec3& b) {
      return std::tuple(a.x(), a.y(), a.z()) < std::tuple(b.x(), b.y(), b.z());
    };
    std::vector<Vec3> nodes = fabric.nodes;
    std::sort(nodes.begin(), nodes.end(), less);
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<Vec3> mirrored = fabric.nodes;
      for (Vec3& x : mirrored) x[axis] = 0.0 - x[axis];
      std::sort(mirrored.begin(), mirrored.end(), less);
      EXPECT_EQ(nodes, mirrored) << "axis " << axis;
    }
  }
}

TEST(Geotextile, SheetsAddNodesOfTheirDensityAndYarnsWithoutTension) {
  io::Snapshot s;
  NodeRecipe recipe;
  recipe.radius = 1e-3, recipe.density = 1500, recipe.material = 2;
  const Fabric flat = sheet({2, 1}, 0.01, 0.5);
  add(flat, recipe, s);
  add(flat, recipe, s);
  ASSERT_EQ(s.grains.size(), 12U);
  for (std::size_t i = 0; i < 12; ++i) {
    EXPECT_NEAR(s.grains.mass[i], 1500 * 4 * pi / 3 * 1e-9, 1e-20);
    EXPECT_EQ(s.grains.body_id[i], static_cast<std::int64_t>(i));
    EXPECT_EQ(s.grains.copy_id[i], -1);
    EXPECT_EQ(s.grains.material_id[i], 2);
  }
  EXPECT_LT((s.grains.position[0] - Vec3(-0.01, -0.005, 0.5)).norm(), 1e-16);
  EXPECT_LT((s.grains.position[5] - Vec3(0.01, 0.005, 0.5)).norm(), 1e-16);
  // Each fabric has two rows of two yarns and three across.
  ASSERT_EQ(s.yarns.size(), 14U);
  for (std::size_t k = 0; k < 14; ++k) {
    const std::int32_t base = k < 7 ? 0 : 6;
    EXPECT_EQ(s.yarns.fabric[k], k < 7 ? 0 : 1);
    EXPECT_EQ(s.yarns.nodes[k][0] - base, flat.yarns[k % 7].first);
    EXPECT_EQ(s.yarns.nodes[k][1] - base, flat.yarns[k % 7].second);
    EXPECT_NEAR(s.yarns.rest_length[k], 0.01, 1e-17);
    EXPECT_EQ(s.yarns.tension[k], 0);
  }
}

// Returns the mistakes of a plan, or the refusal of its assembly; empty if it is taken.
std::string refusal_of(const std::string& fabrics, const std::vector<std::string>& overrides = {}) {
  const std::string sand =
      "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = \"4 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 29\n"
      "[[material]]\nyoung_modulus = \"8 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 21\n";
  try {
    io::Snapshot state;
    const Plan plan = read_plan(fabrics + sand, "plan", overrides);
    if (!plan.container) assemble({}, plan);
    if (plan.container) lay_fabrics(plan, {}, state);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(Geotextile, FabricsThatLieInOneAnotherAreRefusedByTheirKeys) {
  const std::string bare = "[container]\nshape = \"none\"\n", sheet = "[[sheet]]\ncells = [4, 4, 1]\n";
  EXPECT_EQ(
      refusal_of(bare + sheet + sheet),
      "sheet.1: a node at (-0.01, -0.01, 0) m lies in one of sheet.0 by 200 % of its radius, and a run begins with "
      "50 % at most (guards.overlap); give sheet.0.height and sheet.1.height that are 0.005 m apart");
  EXPECT_EQ(refusal_of(bare + sheet + sheet + "height = 0.005\n"), "") << "the remedy";
  EXPECT_NE(refusal_of(bare + sheet + sheet + "height = 0.001\n").find("by 160 % of its radius"), std::string::npos);
  EXPECT_EQ(refusal_of(bare + sheet + sheet + "height = 0.004\n"), "") << "as the guard has it";
  EXPECT_EQ(refusal_of(bare + sheet + "spacing = 0.001\n"), "") << "nodes of one fabric";
  const std::string box =
      "[container]\nshape = \"box\"\nlow = [-0.03, -0.03, -0.03]\nhigh = [0.03, 0.03, 0.03]\n"
      "[geotextile_mesh]\ncells = [12, 12, 12]\n";
  EXPECT_NE(
      refusal_of(box + sheet + "height = 0.0325\n").find("change sheet.0.height or sheet.0.cells so that its nodes"),
      std::string::npos);
  EXPECT_NE(refusal_of(box + "[[sheet]]\ncells = [20, 20, 1]\n").find("sheet.0: a node"), std::string::npos);
  EXPECT_EQ(refusal_of(box + sheet), "") << "inside";
}

TEST(Geotextile, KeysOfASheetThatCannotBeMeantAreRefused) {
  const std::string box = "[container]\nshape = \"box\"\nlow = [-0.03, -0.03, -0.03]\nhigh = [0.03, 0.03, 0.03]\n";
  const std::string sheet = box + "[[sheet]]\ncells = [4, 4, 1]\n";
  const auto says = [&](const std::string& set, const std::string& words) {
    EXPECT_NE(refusal_of(sheet, {set}).find(words), std::string::npos) << set << ": " << refusal_of(sheet, {set});
  };
  says("sheet.0.cells=[4,4,9]", "sheet.0.cells: has 9 cells along z, and a sheet is flat: give 1 there");
  says("sheet.0.height=5", "sheet.0.height: is 5 m where the container is 0.06 m across");
  says("sheet.0.spacing=5", "sheet.0.spacing: is 5 m where the container is 0.06 m across");
  says("sheet.0.node_radius=2.5", "sheet.0.node_radius: is 2.5 m where the container is 0.06 m across");
  EXPECT_EQ(refusal_of(sheet, {"sheet.0.height=\"5 mm\""}), "") << "the remedy";
  EXPECT_EQ(refusal_of(sheet, {"sheet.0.height=-0.05"}), "") << "below the soil";
  EXPECT_NE(refusal_of(box + "[geotextile_mesh]\nspacing = 5\n").find("geotextile_mesh.spacing: is 5 m where"),
            std::string::npos);
}

// Returns the shortest, mean and longest yarn of a fabric, m.
std::array<double, 3> lengths(const Fabric& fabric) {
  std::array<double, 3> l = {1e9, 0, 0};
  for (const Fabric::Yarn& y : fabric.yarns) {
    const double length =
        (fabric.nodes[static_cast<std::size_t>(y.second)] - fabric.nodes[static_cast<std::size_t>(y.first)]).norm();
    l[0] = std::min(l[0], length), l[2] = std::max(l[2], length);
    l[1] += length / static_cast<double>(fabric.yarns.size());
  }
  return l;
}

TEST(Geotextile, OfAGivenSpacingWrapsBagsAndBoxes) {
  const Pillow bag;
  const std::array<int, 3> around = cells_of(bag, 0.00457, 0.0025);
  EXPECT_EQ(around[0], around[1]);
  EXPECT_EQ(around[0] + around[2], 111) << "the hoop of the thesis' model has 222 yarns";
  Box box;
  box.lower = {-0.05, -0.03, 0}, box.upper = {0.05, 0.03, 0.04};
  const std::array<int, 3> cells = cells_of(box, 0.005, 0.0025);
  // Half a hoop has two straight sides and half a circle of 2.5 mm: 147.9 and 107.9 mm.
  EXPECT_EQ(cells, (std::array<int, 3>{21, 13, 9}));
  const Fabric fabric = wrap(box, cells, 0.0025);
  for (const Vec3& x : fabric.nodes) {
    const Vec3 beyond = (box.lower - x).cwiseMax(x - box.upper).cwiseMax(0);
    EXPECT_NEAR(beyond.norm(), 0.0025, 1e-12);
  }
  const auto [shortest, mean, longest] = lengths(fabric);
  EXPECT_NEAR(mean, 0.005, 0.0003);
  EXPECT_GT(shortest, 0.8 * mean);
  EXPECT_LT(longest, 1.2 * mean);
}

TEST(Chart, DividesASphereEvenlyAndAlikeOnAllSides) {
  const Vec3 middle(0.1, 0.2, -0.3);
  const Chart sphere(middle, Vec3::Constant(0.5), [](const Vec3&) { return 0.5; });
  const std::array<int, 3> cells = {8, 8, 8};
  const auto at = [&](double u, double v, double w) { return Vec3(sphere.at({u, v, w}, cells) - middle); };
  // Chords of a section lie below the arc by less than a hundred thousandth.
  EXPECT_LT((at(0, 0, 1) - Vec3(0, 0, 0.5)).norm(), 1e-5);
  EXPECT_LT((at(1, 0, 0) - Vec3(0.5, 0, 0)).norm(), 1e-4);
  EXPECT_LT((at(0, -1, 0) - Vec3(0, -0.5, 0)).norm(), 1e-4);
  EXPECT_LT((at(1, 1, 0) - Vec3(0.5, 0.5, 0).normalized() * 0.5).norm(), 1e-4);
  // The rim of the upper face is a quarter of the way from pole to pole; a quarter of the equator belongs to one side.
  EXPECT_LT((at(1, 0, 1) - Vec3(0.5, 0, 0.5).normalized() * 0.5).norm(), 1e-4);
  EXPECT_LT((at(1, 0.5, 0) - 0.5 * Vec3(std::cos(pi / 8), std::sin(pi / 8), 0)).norm(), 1e-4);
  for (const double w : {-1.0, -0.5, 0.0, 0.5, 1.0})
    EXPECT_LT((at(-1, 0.25, w) - Vec3(at(1, 0.25, w)).cwiseProduct(Vec3(-1, 1, 1))).norm(), 1e-4) << w;
}

}  // namespace
}  // namespace soilweave::packing
