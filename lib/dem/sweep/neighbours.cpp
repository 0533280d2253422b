// Skins by the speed of grains, and lists of the pairs within them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/neighbours.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/in_parallel.h"
#include "dem/sweep/pair_search.h"

namespace soilweave::dem {
namespace {

// Skin of the outer list, and skin of a grain at rest, over the largest radius.
constexpr double relative_outer_skin = 0.25;
constexpr double relative_rest = 0.001;
// Steps that a list should last. With a longer horizon, pairs that do not touch cost as much as contacts. With a
// shorter one, listing costs as much as sweeping. Disks have a longer horizon, because fewer pairs lie within a skin.
constexpr double horizon_of_spheres = 24, horizon_of_disks = 56;
// Steps that a search should last. Only grains that fly fast need a wider skin for it.
constexpr double horizon_of_search = 400;
// Measured use of a skin above which pairs are listed anew, because the motion would have to be measured again soon.
constexpr double nearly_all = 0.8;

// Frees the spare memory of a large list that grew by doubling. It keeps room for a few more pairs, so that the next
// list need not grow.
void give_back_spare(std::vector<Pair>& pairs) {
  constexpr std::size_t worth_it = (std::size_t{1} << 20) / sizeof(Pair);
  if (pairs.capacity() - pairs.size() < std::max(worth_it, pairs.size() / 4)) return;
  std::vector<Pair> fitting;
  fitting.reserve(pairs.size() + pairs.size() / 128);
  fitting.assign(pairs.begin(), pairs.end());
  pairs.swap(fitting);
}

template <class Use>
void over_grains(const Bodies& bodies, int threads, const Use& use) {
  in_parallel(bodies.size(), threads, use);
}
template <class Value>
double largest_over_grains(const Bodies& bodies, int threads, const Value& value) {
  return largest_in_parallel(bodies.size(), threads, value);
}

double speed(const Bodies& bodies, std::size_t i) { return vector_of(bodies.velocity(i)).norm(); }

}  // namespace

Neighbours::Neighbours(double largest_radius, double range)
    : radius_(largest_radius), outer_skin_(relative_outer_skin * largest_radius), range_(range) {}

void Neighbours::Since::begin(const Bodies& bodies, int threads) {
  position.resize(bodies.size());
  over_grains(bodies, threads, [&](std::size_t i) { position[i] = vector_of(bodies.grains[i].position); });
  deformation.setIdentity();
}

double Neighbours::Since::moved2(const Bodies& bodies, std::size_t i) const {
  const Lane4& x = bodies.grains[i].position;
  const Mat3& f = deformation;
  const Vec3& from = position[i];
  const Lane4 a = row(f.col(0), 0), b = row(f.col(1), 0), c = row(f.col(2), 0);
  const Lane4 moved = fused_less(broadcast<Lane4>(from[2]), c,
                                 fused_less(broadcast<Lane4>(from[1]), b, fused_less(broadcast<Lane4>(from[0]), a, x)));
  const Lane4 square = moved * moved;
  return square[0] + square[1] + square[2];
}

bool Neighbours::outdated(const Bodies& bodies, double skin_rate, double fastest_plane, const Mat3& velocity_gradient,
                          double dt) {
  pace_ = {dt, fastest_plane, velocity_gradient};
  skin_rate_ = skin_rate;
  const double rate = velocity_gradient.norm();
  for (Since* since : {&filtered_, &searched_}) since->step(velocity_gradient, dt);
  used_skin_ += dt * (rate * used_skin_ + skin_rate);
  planes_moved_ += dt * (fastest_plane + rate * extent_);
  if (filtered_.strain() * longest() > cell_leeway_ || (planes_ && planes_moved_ > plane_leeway_)) return true;
  if (used_skin_ <= 1) return false;
  used_skin_ = std::sqrt(largest_over_grains(
      bodies, threads_, [&](std::size_t i) { return filtered_.moved2(bodies, i) * bodies.per_leeway2[i]; }));
  return used_skin_ > nearly_all;
}

bool Neighbours::outlast(double gain, const Mat3& velocity_gradient, double dt) const {
  constexpr double all_but_rounding = 1 - 1e-9;
  const double rate = velocity_gradient.norm(), strain = filtered_.strain();
  return (strain + dt * rate * (1 + strain)) * longest() <= all_but_rounding * cell_leeway_ &&
         used_skin_ + dt * (rate * used_skin_ + skin_rate_ + gain / least_leeway_) <= all_but_rounding;
}

void Neighbours::set_leeways(const Bodies& bodies) {
  const double at_rest = relative_rest * radius_;
  const double time = (bodies.dimension == 2 ? horizon_of_disks : horizon_of_spheres) * pace_.dt;
  leeway_.resize(bodies.size());
  over_grains(bodies, threads_, [&](std::size_t i) { leeway_[i] = speed(bodies, i); });
  const double mean = std::accumulate(leeway_.begin(), leeway_.end(), 0.0) / static_cast<double>(bodies.size());
  over_grains(bodies, threads_, [&](std::size_t i) {
    leeway_[i] = std::min(at_rest + time * (leeway_[i] + mean), 0.5 * outer_leeway_[i]);
  });
  const double rate = pace_.velocity_gradient.norm();
  cell_leeway_ = std::min(at_rest + time * rate * longest(), 0.25 * outer_skin_);
  if (!planes_) return;
  extent_ = longest() + largest_over_grains(bodies, threads_,
                                            [&](std::size_t i) { return vector_of(bodies.grains[i].position).norm(); });
  plane_leeway_ = at_rest + time * (pace_.plane + rate * extent_);
}

void Neighbours::set_outer_leeways(const Bodies& bodies) {
  const double time = horizon_of_search * pace_.dt, least = 0.5 * outer_skin_;
  outer_leeway_.resize(bodies.size());
  over_grains(bodies, threads_, [&](std::size_t i) {
    // The wider skin only makes up for a smaller radius, so that no branch exceeds longest().
    outer_leeway_[i] = std::clamp(time * speed(bodies, i), least, least + std::max(0.0, radius_ - bodies.radius(i)));
  });
}

void Neighbours::search(const Bodies& bodies, const Cell& cell) {
  set_outer_leeways(bodies);
  std::vector<double> reach(bodies.size());
  over_grains(bodies, threads_, [&](std::size_t i) { reach[i] = bodies.radius(i) + outer_leeway_[i] + 0.5 * range_; });
  find_pairs(bodies, cell, reach, longest(), threads_, outer_);
  give_back_spare(outer_);
  searched_.begin(bodies, threads_);
}

bool Neighbours::fit_outer_list(const Bodies& bodies) {
  // Pairs outside the outer list were farther apart than both skins when it was searched.
  const double by_cell = 0.5 * (searched_.strain() * longest() + cell_leeway_);
  const double lack = largest_over_grains(bodies, threads_, [&](std::size_t i) {
    const double left = outer_leeway_[i] - by_cell - std::sqrt(searched_.moved2(bodies, i));
    const double wanted = 0.5 * leeway_[i];
    leeway_[i] = std::min(leeway_[i], left);
    return wanted - left;
  });
  return lack <= 0;
}

void Neighbours::filter(const Bodies& bodies, const Cell& cell) {
  near_.resize(outer_.size());
  const auto shares = static_cast<std::size_t>(threads_);
  const auto begin = [&](std::size_t share) { return share * outer_.size() / shares; };
  listed_before_.assign(shares + 1, 0);
  in_parallel(shares, threads_, [&](std::size_t share) {
    std::size_t count = 0;
    for (std::size_t k = begin(share); k < begin(share + 1); ++k) count += near_[k] = is_near(outer_[k], bodies, cell);
    listed_before_[share + 1] = count;
  });
  std::partial_sum(listed_before_.begin(), listed_before_.end(), listed_before_.begin());
  listed_.resize(listed_before_.back());
  in_parallel(shares, threads_, [&](std::size_t share) {
    // A branch on near_[k] would be mispredicted. Each pair is copied, and the next one overwrites a pair that is far.
    Pair* const end = listed_.data() + listed_before_[share + 1];
    std::size_t k = begin(share);
    for (Pair* next = listed_.data() + listed_before_[share]; next != end; ++k) {
      *next = outer_[k];
      next += near_[k];
    }
  });
  give_back_spare(listed_);
}

bool Neighbours::is_near(const Pair& p, const Bodies& bodies, const Cell& cell) const {
  const auto i = static_cast<std::size_t>(p.first), j = static_cast<std::size_t>(p.second);
  const Lane4 &a = bodies.grains[i].position, &b = bodies.grains[j].position;
  Lane4 d = b - a;
  if (p.image != 0) d += row(shift_of(p.image, cell.matrix()), 0);
  const double reach = a[3] + b[3] + leeway_[i] + leeway_[j] + cell_leeway_ + range_;
  return d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach;
}

std::vector<PlanePair> Neighbours::near_planes(const Bodies& bodies, const Planes& planes) const {
  // Each plane's chunks of grains are searched in parallel. The results are joined in the order of planes and grains.
  const std::size_t stretches = chunks_of(bodies.size());
  std::vector<std::vector<PlanePair>> near(stretches * planes.all.size());
  in_parallel(near.size(), threads_, [&](std::size_t k) {
    const std::size_t p = k / stretches, stretch = k % stretches;
    const Plane& plane = planes.all[p];
    for (std::size_t i = first_grain(stretch, bodies); i < first_grain(stretch + 1, bodies); ++i) {
      const double height = (vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal);
      if (height - bodies.radius(i) < leeway_[i] + plane_leeway_ + range_ && plane.touches(bodies.is_node(i)))
        near[k].push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(p)});
    }
  });
  std::vector<PlanePair> all;
  for (const std::vector<PlanePair>& some : near) all.insert(all.end(), some.begin(), some.end());
  return all;
}

void Neighbours::rebuild(Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts) {
  planes_ = !planes.all.empty(), threads_ = contacts.threads;
  if (searched_.position.empty()) search(bodies, cell);
  set_leeways(bodies);
  if (!fit_outer_list(bodies)) {
    search(bodies, cell);
    set_leeways(bodies);
  }
  filter(bodies, cell);
  contacts.list(listed_, near_planes(bodies, planes), bodies);
  begin_list(bodies);
}

void Neighbours::begin_list(Bodies& bodies) {
  filtered_.begin(bodies, threads_);
  least_leeway_ = *std::min_element(leeway_.begin(), leeway_.end());
  used_skin_ = planes_moved_ = 0;
  bodies.per_leeway2.resize(bodies.size());
  skin_rate_ = largest_over_grains(bodies, threads_, [&](std::size_t i) {
    bodies.per_leeway2[i] = 1 / (leeway_[i] * leeway_[i]);
    return speed(bodies, i) / leeway_[i];
  });
}

}  // namespace soilweave::dem
