// Leeways by how fast grains are, and the pairs within them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/neighbours.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "dem/pair_search.h"

namespace soilweave::dem {
namespace {

// Skins over the largest radius: of the search, and of what grains at rest are given.
constexpr double relative_outer_skin = 0.25;
constexpr double relative_rest = 0.001;
// Steps that a list is to last. Longer: candidates that do not touch cost as much as contacts; shorter: a list costs as
// much as a sweep.
constexpr double horizon = 24;
// When so much of a leeway is truly used up, another look at what the grains have moved is not worth it.
constexpr double nearly_all = 0.8;

// A list that grew by doubling may hold twice what it needs. A small one keeps that; a large one has room for the few
// pairs more that the next list will have, so that neither grows at every list.
void give_back_spare(std::vector<Pair>& pairs) {
  constexpr std::size_t worth_it = (std::size_t{1} << 20) / sizeof(Pair);
  if (pairs.capacity() - pairs.size() < std::max(worth_it, pairs.size() / 4)) return;
  std::vector<Pair> fitting;
  fitting.reserve(pairs.size() + pairs.size() / 128);
  fitting.assign(pairs.begin(), pairs.end());
  pairs.swap(fitting);
}

double speed(const Grain& grain) { return vector_of(grain.velocity).norm(); }

}  // namespace

Neighbours::Neighbours(double largest_radius)
    : radius_(largest_radius), outer_skin_(relative_outer_skin * largest_radius) {}

void Neighbours::Since::begin(const Bodies& bodies) {
  position.clear();
  for (const Grain& g : bodies.grains) position.push_back(vector_of(g.position));
  deformation.setIdentity();
}

template <class Use>
void Neighbours::Since::moved(const Bodies& bodies, const Use& use) const {
  const Mat3& f = deformation;
  const Lane4 a = row(f.col(0), 0), b = row(f.col(1), 0), c = row(f.col(2), 0);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Lane4& x = bodies.grains[i].position;
    const Vec3& from = position[i];
    const Lane4 moved =
        fused_less(all<Lane4>(from[2]), c, fused_less(all<Lane4>(from[1]), b, fused_less(all<Lane4>(from[0]), a, x)));
    const Lane4 square = moved * moved;
    use(i, square[0] + square[1] + square[2]);
  }
}

bool Neighbours::outdated(const Bodies& bodies, double haste, double fastest_plane, const Mat3& velocity_gradient,
                          double dt) {
  pace_ = {dt, fastest_plane, velocity_gradient};
  haste_ = haste;
  const double rate = velocity_gradient.norm();
  for (Since* since : {&filtered_, &searched_}) since->step(velocity_gradient, dt);
  worn_ += dt * (rate * worn_ + haste);
  planes_moved_ += dt * (fastest_plane + rate * extent_);
  if (filtered_.strain() * longest() > cell_leeway_ || (planes_ && planes_moved_ > plane_leeway_)) return true;
  if (worn_ <= 1) return false;
  double most = 0;
  filtered_.moved(bodies, [&](std::size_t i, double square) { most = std::max(most, square * bodies.per_leeway2[i]); });
  worn_ = std::sqrt(most);
  return worn_ > nearly_all;
}

bool Neighbours::outlast(double gain, const Mat3& velocity_gradient, double dt) const {
  constexpr double all_but_rounding = 1 - 1e-9;
  const double rate = velocity_gradient.norm(), strain = filtered_.strain();
  return (strain + dt * rate * (1 + strain)) * longest() <= all_but_rounding * cell_leeway_ &&
         worn_ + dt * (rate * worn_ + haste_ + gain / least_leeway_) <= all_but_rounding;
}

void Neighbours::set_leeways(const Bodies& bodies) {
  const double at_rest = relative_rest * radius_, most = 0.25 * outer_skin_, time = horizon * pace_.dt;
  double mean = 0;
  for (const Grain& g : bodies.grains) mean += speed(g) / static_cast<double>(bodies.size());
  leeway_.clear();
  for (const Grain& g : bodies.grains) leeway_.push_back(std::min(at_rest + time * (speed(g) + mean), most));
  const double rate = pace_.velocity_gradient.norm();
  cell_leeway_ = std::min(at_rest + time * rate * longest(), most);
  extent_ = longest();
  for (const Grain& g : bodies.grains) extent_ = std::max(extent_, longest() + vector_of(g.position).norm());
  plane_leeway_ = at_rest + time * (pace_.plane + rate * extent_);
}

bool Neighbours::fit_outer_list(const Bodies& bodies) {
  if (searched_.position.empty()) return false;
  // What is not in the outer list was farther off than its skin, when it was searched.
  const double each = 0.5 * (outer_skin_ - searched_.strain() * longest() - cell_leeway_);
  bool fits = true;
  searched_.moved(bodies, [&](std::size_t i, double square) {
    const double left = each - std::sqrt(square);
    fits = fits && left >= 0.5 * leeway_[i];
    leeway_[i] = std::min(leeway_[i], left);
  });
  return fits;
}

void Neighbours::filter(const Bodies& bodies, const Cell& cell) {
  listed_.clear();
  for (const Pair& p : outer_) {
    const auto i = static_cast<std::size_t>(p.first), j = static_cast<std::size_t>(p.second);
    const Lane4 &a = bodies.grains[i].position, &b = bodies.grains[j].position;
    Lane4 d = b - a;
    if (p.image != 0) d += row(shift_of(p.image, cell.matrix()), 0);
    const double reach = a[3] + b[3] + leeway_[i] + leeway_[j] + cell_leeway_;
    if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach) listed_.push_back(p);
  }
  give_back_spare(listed_);
}

std::vector<PlanePair> Neighbours::near_planes(const Bodies& bodies, const Planes& planes) const {
  std::vector<PlanePair> near;
  if (planes.all.empty()) return near;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (std::size_t p = 0; p < planes.all.size(); ++p) {
      const Plane& plane = planes.all[p];
      const double height = (vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal);
      if (plane.touches(bodies.is_node(i)) && height - bodies.radius(i) < leeway_[i] + plane_leeway_)
        near.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(p), 0, {0, 0, 0}, {}});
    }
  return near;
}

void Neighbours::rebuild(Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts) {
  planes_ = !planes.all.empty();
  set_leeways(bodies);
  if (!fit_outer_list(bodies)) {
    find_pairs(bodies, cell, outer_skin_, longest(), outer_);
    give_back_spare(outer_);
    searched_.begin(bodies);
    set_leeways(bodies);
  }
  filter(bodies, cell);
  contacts.list(listed_, near_planes(bodies, planes), bodies);
  filtered_.begin(bodies);
  least_leeway_ = *std::min_element(leeway_.begin(), leeway_.end());
  haste_ = worn_ = planes_moved_ = 0;
  bodies.per_leeway2.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    bodies.per_leeway2[i] = 1 / (leeway_[i] * leeway_[i]);
    haste_ = std::max(haste_, speed(bodies.grains[i]) / leeway_[i]);
  }
}

}  // namespace soilweave::dem
