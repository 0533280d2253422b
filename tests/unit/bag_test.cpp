// Copies of a packing, and their part inside a container.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include "core/error.h"
#include "dem/engine/simulation.h"
#include "packing/expand/plan.h"
#include "packing/expand/tile.h"
#include "packing/generate/spatial_order.h"
#include "support/assemblies.h"
#include "support/assembly.h"
#include "support/bags.h"
#include "support/distance.h"
#include "support/same_state.h"

namespace soilweave::packing {
namespace {

using std::numbers::pi;

TEST(Tile, CopiesCarryContactsAndMemoryAcrossTheirFaces) {
  const dem::Model model = support::sand();
  const io::Snapshot one = support::packed(model, 1e5);
  const std::array<int, 3> copies = {2, 3, 1};
  const io::Snapshot block = tile(one, copies, {true, true, true});
  const std::size_t n = one.grains.size(), all = 6;
  ASSERT_EQ(block.grains.size(), all * n);
  ASSERT_EQ(block.contacts.size(), all * one.contacts.size());
  // Equal forces give equal stress and rest, because the simulation finds every contact with its history.
  dem::Simulation small(one, model, {}), large(block, model, {});
  EXPECT_LT((small.measures().stress - large.measures().stress).norm(), 1e-9 * small.measures().stress.norm());
  EXPECT_EQ(large.measures().contacts, static_cast<std::int64_t>(all) * small.measures().contacts);
  EXPECT_NEAR(large.unbalanced_force(), small.unbalanced_force(), 1e-9);
  for (std::size_t c = 0; c < block.contacts.size(); ++c)
    if (c > 0) {
      EXPECT_LE(block.contacts.bodies[c - 1], block.contacts.bodies[c]);
    }
  const std::int32_t last = *std::max_element(block.grains.copy_id.begin(), block.grains.copy_id.end());
  EXPECT_EQ(last, 5);
}

TEST(Tile, CopiesAreNumberedAlongXThenYThenZAndTheirContactsReachFromGrainToGrain) {
  // The cell is sheared, and some grains lie two cells away. Vectors of a contact are multiples of its branch, which
  // shows whether they turn with it.
  io::Snapshot one = analysis::test::random_cell(20);
  for (int k = 0; k < 19; ++k) {
    analysis::test::add_contact(one, k, k + 1, Vec3i(k % 3 - 1, k % 2, -(k % 2)), 1 + k);
    one.contacts.shear_force.back() = 2 * one.contacts.branch_vector.back();
    one.contacts.rolling_moment.back() = 3 * one.contacts.branch_vector.back();
    one.contacts.twisting_moment.back() = 5 + k;
  }
  const std::array<int, 3> copies = {2, 3, 4};
  const io::Snapshot block = tile(one, copies, {true, true, true});
  const std::size_t n = one.grains.size();
  ASSERT_EQ(block.grains.size(), 24 * n);
  for (int a = 0; a < 3; ++a)
    EXPECT_EQ(block.cell.matrix.col(a), copies[static_cast<std::size_t>(a)] * one.cell.matrix.col(a));
  const Mat3 inverse = one.cell.matrix.inverse();
  for (std::size_t i = 0; i < block.grains.size(); ++i) {
    const Vec3 away = inverse * (block.grains.position[i] - block.grains.position[i % n]);
    const Vec3i copy = away.array().round().cast<int>();
    EXPECT_LT((away - copy.cast<double>()).norm(), 1e-12);
    EXPECT_EQ(block.grains.copy_id[i], copy.x() + 2 * copy.y() + 6 * copy.z());
  }
  ASSERT_EQ(block.contacts.size(), 24 * one.contacts.size());
  const io::ContactsRecord& c = block.contacts;
  for (std::size_t k = 0; k < c.size(); ++k) {
    const auto [first, second] = c.bodies[k];
    EXPECT_LT(first, second);
    const Vec3 branch = block.grains.position[static_cast<std::size_t>(second)] +
                        block.cell.matrix * c.image[k].cast<double>() -
                        block.grains.position[static_cast<std::size_t>(first)];
    EXPECT_LT((branch - c.branch_vector[k]).norm(), 1e-12);
    EXPECT_LT((c.normal[k] - branch.normalized()).norm(), 1e-12);
    EXPECT_LT((c.shear_force[k] - 2 * branch).norm() + (c.rolling_moment[k] - 3 * branch).norm(), 1e-11);
    EXPECT_EQ(c.twisting_moment[k], 4 + c.normal_force[k]);
  }
}

TEST(Tile, OpenBlocksLoseOnlyTheContactsThroughTheirOutside) {
  const io::Snapshot one = support::packed(support::sand(), 1e5);
  const io::Snapshot closed = tile(one, {2, 2, 2}, {true, true, true}), open = tile(one, {2, 2, 2});
  std::size_t inside = 0;
  for (const Vec3i& image : closed.contacts.image) inside += image.isZero();
  EXPECT_EQ(open.contacts.size(), inside);
  EXPECT_LT(inside, closed.contacts.size());
}

TEST(Bag, DepthAndVolumeAgree) {
  EXPECT_NEAR(Pillow().volume(), 0.0150, 1e-6) << "parameters of the reference";
  const Pillow round, flatter = support::inextensible();
  const Cushion sharp = support::straight(0), rounded = support::straight(0.03);
  for (const Container* bag : std::initializer_list<const Container*>{&round, &flatter, &sharp, &rounded}) {
    std::mt19937_64 engine(1);
    const Vec3 high = bag->high();
    std::uniform_real_distribution<double> share(-1, 1);
    const int n = 400'000;
    int inside = 0, deep = 0;
    for (int k = 0; k < n; ++k) {
      const double x = share(engine), y = share(engine), z = share(engine);
      const double depth = bag->depth(Vec3(x, y, z).cwiseProduct(high));
      inside += depth > 0;
      deep += depth > 0.01;
    }
    const double box = 8 * high.prod();
    for (const auto& [count, volume] : {std::pair{inside, bag->volume()}, std::pair{deep, bag->volume(0.01)}}) {
      const double share_inside = volume / box;
      EXPECT_NEAR(static_cast<double>(count) / n, share_inside, 4 * std::sqrt(share_inside * (1 - share_inside) / n))
          << "four standard deviations of the sampling";
    }
    EXPECT_NEAR(bag->depth(Vec3(0, 0, 0.03)), 0.01, 1e-15);
    EXPECT_NEAR(bag->depth(Vec3(high.x() - 0.03, 0, 0)), 0.03, 1e-15);
    EXPECT_NEAR(bag->depth(Vec3(0.1, high.y() + 0.01, 0)), -0.01, 1e-15);
  }
}

TEST(Cushion, IsWhatItsTwoSectionsShareLessItsCorners) {
  const double reach = support::straight(0).reach();
  EXPECT_NEAR(support::straight(0).depth(Vec3(reach, reach, 0)), 0, 1e-15);
  EXPECT_NEAR(support::straight(0).depth(Vec3(0.2, -0.2, 0.04)), 0, 1e-15);
  EXPECT_NEAR(support::straight(0).depth(Vec3(-reach - 0.003, reach + 0.004, 0)), -0.005, 1e-15);
  const double corner = reach - 0.02 + 0.02 * std::sqrt(0.5);
  EXPECT_NEAR(support::straight(0.02).depth(Vec3(corner, -corner, 0)), 0, 1e-15);
  EXPECT_NEAR(support::straight(0.02).depth(Vec3(corner - 0.003, 0.003 - corner, 0)), 0.003 * std::sqrt(2), 1e-15);
  for (const Cushion& bag : {support::straight(0), support::straight(0.02)}) {
    std::vector<Vec3> surface;
    const int n = 200;
    for (int k = 0; k <= n; ++k)
      for (int i = 0; i <= n; ++i) {
        const double z = 0.04 * k / n, a = bag.core() + std::sqrt(bag.side_radius * bag.side_radius - z * z);
        const double r = bag.corner_radius, turn = 0.5 * pi * i / n;
        surface.emplace_back(a, (a - r) * i / n, z), surface.emplace_back((a - r) * i / n, a, z);
        surface.emplace_back(a - r + r * std::cos(turn), a - r + r * std::sin(turn), z);
        const Vec3 face(0.2 * i / n, 0.2 * k / n, 0.04);
        if (std::min(face.x(), face.y()) < 0.2 - r || std::hypot(face.x() - 0.2 + r, face.y() - 0.2 + r) < r)
          surface.push_back(face);
      }
    std::mt19937_64 engine(1);
    std::uniform_real_distribution<double> share(0, 1);
    for (int k = 0; k < 200; ++k) {
      const double x = share(engine), y = share(engine), z = share(engine);
      const Vec3 point(0.18 + 0.05 * x, 0.18 + 0.05 * y, 0.06 * z);
      double nearest = 1;
      for (const Vec3& s : surface) nearest = std::min(nearest, support::squared_distance(point, s));
      nearest = std::sqrt(nearest);
      const double depth = bag.depth(point);
      EXPECT_NEAR(std::abs(depth), nearest, 5e-4) << "by points of its surface half a millimetre apart";
      if (depth > 0) continue;
      const Vec3 on = bag.nearest(point, 0.0025);
      EXPECT_NEAR(bag.depth(on), -0.0025, 1e-12) << point.transpose();
      EXPECT_NEAR((on - point).norm(), std::abs(depth + 0.0025), 1e-9);
    }
  }
}

TEST(Pillow, SidesFlatterThanHalfCirclesMeetTheFacesAtAnEdge) {
  const Pillow bag = support::inextensible();
  EXPECT_NEAR(2 * bag.side_radius * std::asin(bag.half_height / bag.side_radius), 0.1, 1e-5) << "arc of a side";
  const Vec3 edge(0.2, 0.05, 0.04);
  EXPECT_NEAR(bag.depth(edge), 0, 1e-15);
  EXPECT_NEAR(bag.depth(edge + Vec3(0.0003, 0, 0.002)), -std::hypot(0.0003, 0.002), 1e-15) << "beyond, by its edge";
  for (const Vec3& towards : {Vec3(-0.01, 0, 0.003), Vec3(0.0003, 0, 0.002), Vec3(0.003, 0, 0.001)}) {
    const Vec3 on = bag.nearest(edge + towards, 0.0025);
    EXPECT_NEAR(bag.depth(on), -0.0025, 1e-15);
  }
}

const std::string sand =
    "law = \"hertz-mindlin\"\nyoung_modulus = \"4 GPa\"\npoisson_ratio = 0.33\nfriction_angle = 29\n";
const std::string materials = "[contact]\n" + sand + "[[material]]\n" + sand.substr(sand.find('\n') + 1);

const std::string small_bag =
    "[container]\nshape = \"pillow\"\nwidth = 0.03\nhalf_height = 0.014\ncorner_radius = 0.005\ncopies = [4, 4, 2]\n"
    "[geotextile_mesh]\ncells = [10, 10, 6]\n" +
    materials;

TEST(Plan, RefusesWhatCannotBeFilled) {
  const io::Snapshot one = support::packed(support::sand(), 1e5);
  const std::string size = "width = \"374 mm\"\nhalf_height = \"40 mm\"\n";
  const std::string pillow = "[container]\nshape = \"pillow\"\n" + size,
                    cushion = "[container]\nshape = \"cushion\"\n" + size;
  const std::string bag = pillow + "corner_radius = \"36 mm\"\ncopies = [2, 2, 1]\n" + materials;
  EXPECT_THROW(assemble(one, read_plan(bag, "plan", {})), DataError) << "too few copies";
  EXPECT_THROW(read_plan(pillow + "corner_radius = 1\n" + materials, "plan", {}), DataError);
  EXPECT_THROW(read_plan(cushion + "corner_radius = 1\n" + materials, "plan", {}), DataError);
  EXPECT_THROW(read_plan("[container]\nshape = \"box\"\nlow = [0, 0, 0]\nhigh = [1, 1, 0]\n" + materials, "plan", {}),
               DataError);
  const auto refuses = [&](const std::string& plan, const std::string& words) {
    io::test::expect_error<DataError>([&] { assemble(one, read_plan(plan + materials, "plan", {})); }, words);
  };
  const std::string box = "[container]\nshape = \"box\"\nlow = [0, 0, 0]\nhigh = [0.1, 0.1, 0.1]\n";
  refuses("[container]\nshape = \"cushion\"\nhalf_height = 0.04\n", "container.width: is missing");
  refuses("[container]\nshape = \"pillow\"\nwidth = 0.4\n", "container.half_height: is missing");
  refuses(box + "[geotextile_mesh]\nnode_radius = 0.002\n", "geotextile_mesh.cells: is missing");
  refuses(box + "[geotextile_mesh]\ncells = [10, 10, 6]\nnode_radius = 2.5\n",
          "is 2.5 m where the container is 0.1 m across");
  refuses("[container]\nshape = \"surface\"\nfile = \"\"\n[geotextile_mesh]\ncells = [10, 10, 6]\n",
          "container.file: is empty");
  refuses("[container]\nshape = \"box\"\nlow = [0, 0, 0]\nhigh = [1e-4, 1e-4, 1e-4]\n",
          "fits into the container of 0.0001 x 0.0001 x 0.0001 m: the smallest is");
  io::Snapshot open = one;
  open.cell.periodic[1] = false;
  EXPECT_THROW(tile(open, {1, 1, 1}), DataError);
}

TEST(Plan, ScalesARepresentativeVolumeAtEqualStrainsAndStresses) {
  // At twice the lengths, masses and moments are eightfold and forces fourfold. Factors of two are exact.
  io::Snapshot one = support::packed(support::sand(), 1e5);
  for (Vec3& v : one.grains.velocity) v = Vec3(1, 2, 3);
  const auto in_box = [&](const std::string& half, const std::string& scale) {
    return assemble(one, read_plan("[container]\nshape = \"box\"\nlow = [-" + half + ", -" + half + ", -" + half +
                                       "]\nhigh = [" + half + ", " + half + ", " + half +
                                       "]\ncopies = [2, 2, 2]\n[grains]\nscale = " + scale + "\n" + materials,
                                   "plan", {}));
  };
  const io::Snapshot small = in_box("0.02", "1"), large = in_box("0.04", "2");
  ASSERT_GT(small.contacts.size(), 50U);
  ASSERT_EQ(large.grains.size(), small.grains.size());
  for (std::size_t i = 0; i < small.grains.size(); ++i) {
    EXPECT_LT((large.grains.position[i] - 2 * small.grains.position[i]).norm(), 1e-15);
    EXPECT_EQ(large.grains.radius[i], 2 * small.grains.radius[i]);
    EXPECT_EQ(large.grains.mass[i], 8 * small.grains.mass[i]);
    EXPECT_EQ(large.grains.velocity[i], 2 * small.grains.velocity[i]);
  }
  ASSERT_EQ(large.contacts.bodies, small.contacts.bodies);
  double rolled = 0;
  for (std::size_t k = 0; k < small.contacts.size(); ++k) {
    const io::ContactsRecord &a = small.contacts, &b = large.contacts;
    EXPECT_EQ(b.overlap[k], 2 * a.overlap[k]);
    EXPECT_EQ(b.branch_vector[k], 2 * a.branch_vector[k]);
    EXPECT_EQ(b.normal_force[k], 4 * a.normal_force[k]);
    EXPECT_EQ(b.shear_force[k], 4 * a.shear_force[k]);
    EXPECT_EQ(b.rolling_moment[k], 8 * a.rolling_moment[k]);
    EXPECT_EQ(b.twisting_moment[k], 8 * a.twisting_moment[k]);
    rolled += a.rolling_moment[k].norm();
  }
  EXPECT_GT(rolled, 0);
}

TEST(Plan, AimsAtTheContainerWithOrWithoutStretching) {
  const Pillow bag;
  // The soil fills nine tenths of the bag, cut equally far from all of its surface.
  io::Snapshot soil;
  soil.grains.copy_id = {0, -1};
  soil.grains.radius = {std::cbrt(0.9 * bag.volume() / 1.7 / (4.0 / 3.0 * pi)), 1};
  soil.grains.position.resize(2);
  Growth stretched, half_way, alone;
  half_way.stretch_share = 0.5, alone.stretch_share = 0;
  aim(stretched, soil, 0.7, bag);
  aim(half_way, soil, 0.7, bag);
  aim(alone, soil, 0.7, bag);
  EXPECT_NEAR(std::cbrt(stretched.stretch.prod()), stretched.filling, 1e-12);
  EXPECT_GT(stretched.stretch.z(), stretched.stretch.x()) << "the same gap is more of the height";
  const Vec3 half = bag.high();
  EXPECT_NEAR(half.x() - half.x() / stretched.stretch.x(), half.z() - half.z() / stretched.stretch.z(), 1e-12);
  EXPECT_NEAR(bag.volume(half.z() - half.z() / stretched.stretch.z()), 0.9 * bag.volume(), 1e-9 * bag.volume());
  EXPECT_NEAR(half_way.stretch.x() * half_way.stretch.x(), stretched.stretch.x(), 1e-12);
  EXPECT_EQ(alone.stretch, Vec3::Ones());
  EXPECT_EQ(alone.filling, stretched.filling);
  // With nodes that reach inside, the same soil fills the rest of the bag.
  Growth within;
  const double depth = 1e-3;
  aim(within, soil, 0.7, bag, depth);
  const Vec3 rest = bag.high() - Vec3::Constant(depth), gap = rest - rest.cwiseQuotient(within.stretch);
  EXPECT_NEAR(bag.volume(depth + gap.z()), 0.9 * bag.volume(), 1e-9 * bag.volume());
  EXPECT_NEAR(gap.x(), gap.z(), 1e-12);
}

// An enlarged representative volume keeps its density and, at equal strains, its stresses: the force of a contact is
// still Hertz's for its overlap, 4/3 E* sqrt(R*) overlap^1.5.
TEST(Plan, AScaledVolumeIsOfTheSameMaterial) {
  const io::Snapshot small = support::packed(support::sand(), 1e5, 60);
  const double density = small.grains.mass[0] / dem::grain_volume(3, small.grains.radius[0]);
  const double E_star = 4e9 / (2 * (1 - 0.33 * 0.33));
  const std::string box = "[container]\nshape = \"box\"\nlow = [-0.03, -0.03, -0.03]\nhigh = [0.03, 0.03, 0.03]\n";
  for (const double scale : {1.0, 1.5, 2.0}) {
    const io::Snapshot large =
        assemble(small, read_plan(box + materials, "plan", {"grains.scale=" + std::to_string(scale)}));
    const io::GrainsRecord& g = large.grains;
    for (std::size_t i = 0; i < g.size(); ++i)
      EXPECT_NEAR(g.mass[i] / dem::grain_volume(3, g.radius[i]), density, 1e-9 * density) << scale;
    ASSERT_GT(large.contacts.size(), 3U);
    for (std::size_t c = 0; c < large.contacts.size(); ++c) {
      const double a = g.radius[static_cast<std::size_t>(large.contacts.bodies[c][0])],
                   b = g.radius[static_cast<std::size_t>(large.contacts.bodies[c][1])];
      const double force = 4.0 / 3.0 * E_star * std::sqrt(a * b / (a + b)) * std::pow(large.contacts.overlap[c], 1.5);
      EXPECT_NEAR(large.contacts.normal_force[c], force, 1e-6 * force) << scale;
      EXPECT_LT(large.contacts.shear_force[c].norm(), std::tan(29 * support::degree) * force * (1 + 1e-6)) << scale;
    }
  }
}

// Nodes come after the soil: mixed with it, they made steps slower (lib/PERFORMANCE.md).
TEST(Plan, SoilIsSortedInSpaceAndNodesFollowIt) {
  const io::Snapshot one = support::packed(support::sand(), 1e5);
  const double wide = 1.9 * one.cell.matrix(0, 0), high = 0.45 * one.cell.matrix(2, 2);
  const std::string plan = fmt::format(
      "[container]\nshape = \"box\"\nlow = [-{0}, -{0}, -{1}]\nhigh = [{0}, {0}, {1}]\ncopies = [4, 4, 1]\n"
      "[geotextile_mesh]\ncells = [10, 10, 4]\nnode_radius = \"2 mm\"\noffset = 0\n",
      wide, high);
  const io::Snapshot state = assemble(one, read_plan(plan + materials, "plan", {}));
  const std::vector<std::int32_t>& copy = state.grains.copy_id;
  ASSERT_TRUE(std::is_partitioned(copy.begin(), copy.end(), [](std::int32_t c) { return c >= 0; }));
  const io::Snapshot soil = filter(state, [&](std::size_t i) { return copy[i] >= 0; });
  ASSERT_GT(soil.grains.size(), dem::grains_per_chunk);
  EXPECT_EQ(in_spatial_order(soil).grains.body_id, soil.grains.body_id);
  EXPECT_FALSE(std::is_sorted(soil.grains.body_id.begin(), soil.grains.body_id.end()));
}

TEST(Plan, SoilBeginsWhereTheNodesOnTheSurfaceEnd) {
  const std::vector<std::string> offset = {"geotextile_mesh.node_radius=0.002", "geotextile_mesh.offset=0.0005"};
  const Plan plan = read_plan(small_bag, "plan", offset);
  const io::Snapshot state = assemble(support::packed(support::sand(), 1e5), plan);
  double least = 1;
  int nodes = 0;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const double depth = plan.container->depth(state.grains.position[i]);
    if (state.grains.copy_id[i] < 0) {
      EXPECT_NEAR(depth, -0.0005, 1e-12);
      ++nodes;
    } else {
      least = std::min(least, depth - state.grains.radius[i]);
    }
  }
  EXPECT_EQ(nodes, 2 * 11 * 11 + 5 * 40);
  EXPECT_GE(least, 0.0015);
  EXPECT_LT(least, 0.0025) << "some grain of the many lies near";
  EXPECT_THROW(read_plan(small_bag, "plan", {"geotextile_mesh.offset=0.003"}), DataError);
}

// Returns the mirror image across x = 0; contacts are found anew.
io::Snapshot mirrored(io::Snapshot state) {
  for (auto* rows : {&state.grains.position, &state.grains.velocity, &state.planes.point, &state.planes.normal,
                     &state.planes.velocity})
    for (Vec3& v : *rows) v.x() = 0.0 - v.x();
  return state;
}

TEST(Bag, MirroredBagsMoveAsMirrorImages) {
  const Plan plan = read_plan(small_bag, "plan", {});
  io::Snapshot state = assemble(support::packed(support::sand(), 1e5), plan);
  ASSERT_GT(state.grains.size(), 300U);
  state.contacts = {};
  for (auto* rows : {&state.grains.velocity, &state.grains.angular_velocity})
    for (Vec3& v : *rows) v.setZero();
  // The direction is oblique, so that all axes take part.
  const double from_middle = 0.0185;
  state.planes.point = {Vec3(0, 0, -from_middle), Vec3(0, 0, from_middle)};
  state.planes.normal = {Vec3(0, 0, 1), Vec3(0, 0, -1)};
  state.planes.velocity = {Vec3(0.02, 0.01, 0.05), Vec3(-0.02, -0.01, -0.05)};
  state.planes.material_id = {1, 1};
  dem::Simulation one(state, plan.model, plan.numerics), other(mirrored(state), plan.model, plan.numerics);
  for (int k = 0; k < 300; ++k) one.step(), other.step();
  const io::Snapshot moved = one.snapshot(), image = mirrored(other.snapshot());
  double apart = 0, way = 0;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    apart = std::max(apart, (moved.grains.position[i] - image.grains.position[i]).norm());
    way = std::max(way, (moved.grains.position[i] - state.grains.position[i]).norm());
  }
  EXPECT_GT(moved.contacts.size(), 200U);
  EXPECT_GT(way, 1e-5);
  EXPECT_LT(apart, 1e-9 * way) << "round-off, and what grows of it";
}

}  // namespace
}  // namespace soilweave::packing
