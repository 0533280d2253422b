// No touching pair is missing in the lists, however grains, cell and planes move, and lists last.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/neighbours.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "dem/engine/motion.h"
#include "dem/sweep/pair_search.h"
#include "support/assemblies.h"
#include "support/distance.h"

namespace soilweave::dem {
namespace {

using Key = std::tuple<std::int32_t, std::int32_t, CellOffset>;

// Returns all pairs that are nearer than the sum of their reaches, by testing every image.
std::set<Key> near_by(const Bodies& bodies, const Cell& cell, const std::vector<double>& reaches) {
  const auto reach = [&](int axis) { return cell.periodic(axis) ? 3 : 0; };
  std::vector<std::pair<Vec3, CellOffset>> images;
  for (int x = -reach(0); x <= reach(0); ++x)
    for (int y = -reach(1); y <= reach(1); ++y)
      for (int z = -reach(2); z <= reach(2); ++z)
        images.emplace_back(cell.matrix() * Vec3(x, y, z), cell_offset({x, y, z}));
  std::set<Key> found;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t j = i + 1; j < bodies.size(); ++j) {
      const Vec3 back = vector_of(bodies.grains[i].position) - vector_of(bodies.grains[j].position);
      const double touching = reaches[i] + reaches[j];
      for (const auto& [shift, offset] : images)
        if (support::squared_distance(shift, back) < touching * touching)
          found.emplace(static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), offset);
    }
  return found;
}

// Returns all pairs with a gap below the skin.
std::set<Key> near_by(const Bodies& bodies, const Cell& cell, double skin) {
  std::vector<double> reaches(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) reaches[i] = bodies.radius(i) + 0.5 * skin;
  return near_by(bodies, cell, reaches);
}

std::set<Key> listed(const Contacts& contacts) {
  std::set<Key> found;
  for (const auto& chunk : contacts.chunks)
    for (const ContactBlock& block : chunk)
      for (int k = 0; k < block.count; ++k) {
        const Pair p = contacts.pair(block, k);
        found.emplace(p.first, p.second, p.image);
      }
  return found;
}

// Grains that fly through one another in a deforming cell; one of ten is fast.
struct Flight {
  explicit Flight(int dimension)
      : state(support::packed(support::sand(), 1e5, 60, dimension)),
        bodies(state.grains),
        cell(state.cell, dimension),
        neighbours(bodies.largest_radius()),
        motion(bodies.size(), 1) {
    std::mt19937 engine(7);
    std::normal_distribution<double> part(0, 0.01);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (int a = 0; a < dimension; ++a) bodies.grains[i].velocity[a] = (i % 10 == 0 ? 20 : 1) * part(engine);
    Mat3 gradient = Vec3(-0.5, 0.4, dimension == 3 ? -0.2 : 0).asDiagonal();
    gradient(0, 1) = 0.7;
    cell.set_velocity_gradient(gradient);
    neighbours.rebuild(bodies, cell, planes, contacts);
  }
  void step(double dt) {
    motion.set_out(cell, Vec3::Zero(), 0, dt, bodies);
    motion.advance_all(bodies);
    cell.advance(dt);
    planes.advance(dt);
    const double plane = planes.all.empty() ? 0 : planes.all[0].velocity.norm();
    if (!neighbours.outdated(bodies, motion.advanced().skin_rate, plane, cell.velocity_gradient(), dt)) return;
    neighbours.rebuild(bodies, cell, planes, contacts);
    ++lists;
  }

  double longest_leeway() const {
    return 1 / std::sqrt(*std::min_element(bodies.per_leeway2.begin(), bodies.per_leeway2.end()));
  }

  io::Snapshot state;
  Bodies bodies;
  Cell cell;
  Planes planes;
  Contacts contacts;
  Neighbours neighbours;
  Motion motion;
  int lists = 0;
};

class NeighboursIn : public ::testing::TestWithParam<int> {};

TEST_P(NeighboursIn, ListAllThatTouchesAndLast) {
  Flight flight(GetParam());
  constexpr int steps = 4000;
  for (int k = 0; k < steps; ++k) {
    flight.step(2e-5);
    if (k % 50 != 0) continue;
    const auto known = listed(flight.contacts), touching = near_by(flight.bodies, flight.cell, 0);
    ASSERT_TRUE(std::includes(known.begin(), known.end(), touching.begin(), touching.end())) << "step " << k;
    ASSERT_GT(touching.size(), 20u);
    // A single skin for all grains that lasts as long has to be twice the largest leeway.
    ASSERT_LT(known.size(), near_by(flight.bodies, flight.cell, 2 * flight.longest_leeway()).size());
  }
  EXPECT_GT(flight.lists, 10);
  EXPECT_LT(flight.lists, steps / 10);
}

TEST_P(NeighboursIn, AreAllThatTheSearchFinds) {
  Flight flight(GetParam());
  for (int k = 0; k < 3; ++k) {
    for (int step = 0; step < 300; ++step) flight.step(1e-3);  // cells away from their start
    const double largest = flight.bodies.largest_radius();
    std::vector<double> reaches(flight.bodies.size());
    for (std::size_t i = 0; i < reaches.size(); ++i)
      reaches[i] = flight.bodies.radius(i) + 0.1 * static_cast<double>(i % 4) * largest;
    std::vector<Pair> pairs;
    find_pairs(flight.bodies, flight.cell, reaches, 2.6 * largest, 1 + k, pairs);
    EXPECT_TRUE(std::is_sorted(pairs.begin(), pairs.end(), before));
    std::set<Key> found;
    for (const Pair& p : pairs) found.emplace(p.first, p.second, p.image);
    EXPECT_EQ(found.size(), pairs.size());
    const auto near = near_by(flight.bodies, flight.cell, reaches);
    EXPECT_GT(near.size(), 30u);
    EXPECT_TRUE(std::includes(found.begin(), found.end(), near.begin(), near.end()));
  }
}
INSTANTIATE_TEST_SUITE_P(Dimensions, NeighboursIn, ::testing::Values(2, 3));

TEST(Neighbours, OfAPlaneThatMovesAreListedBeforeTheyTouch) {
  Flight flight(3);
  flight.cell.set_velocity_gradient(Mat3::Zero());
  flight.planes.all = {{Vec3::Zero(), Vec3::UnitZ(), Vec3(0, 0, 0.05), 0}};
  flight.neighbours.rebuild(flight.bodies, flight.cell, flight.planes, flight.contacts);
  std::size_t most = 0;
  for (int k = 0; k < 1000; ++k) {
    flight.step(1e-4);
    std::set<std::int32_t> known;
    for (const PlanePair& p : flight.contacts.planes.pairs()) known.insert(p.grain);
    most = std::max(most, known.size());
    for (std::size_t i = 0; i < flight.bodies.size(); ++i)
      if (vector_of(flight.bodies.grains[i].position)[2] - flight.planes.all[0].point[2] < flight.bodies.radius(i)) {
        ASSERT_TRUE(known.count(static_cast<std::int32_t>(i)) > 0) << "step " << k << " grain " << i;
      }
  }
  EXPECT_GT(most, 5u);
  EXPECT_LT(flight.lists, 250);
}

TEST(CellOffset, AddsAndOrdersAsCellsDo) {
  std::mt19937 engine(3);
  const auto cells = [&](int most) {
    std::uniform_int_distribution<int> along(-most, most);
    return Vec3i(along(engine), along(engine), along(engine));
  };
  for (int k = 0; k < 1000; ++k) {
    const Vec3i a = cells(k % 2 ? 2 : 400'000), b = cells(k % 2 ? 2 : 400'000);
    EXPECT_EQ(cells_of(cell_offset(a)), a);
    EXPECT_EQ(cells_of(cell_offset(a) - cell_offset(b)), Vec3i(a - b));
    EXPECT_EQ(cell_offset(a) < cell_offset(b), std::tuple(a[0], a[1], a[2]) < std::tuple(b[0], b[1], b[2]));
  }
  EXPECT_EQ(cell_offset(Vec3i::Zero()), 0);
  const Vec3i beyond(2'000'000'000, -2'000'000'000, 0);
  EXPECT_EQ(cells_of(cell_offset(beyond)), Vec3i(1'048'575, -1'048'575, 0));
}

}  // namespace
}  // namespace soilweave::dem
