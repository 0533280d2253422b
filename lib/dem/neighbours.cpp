// Neighbour list by a grid over the (possibly sheared) cell.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/neighbours.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

namespace soilweave::dem {
namespace {

// Skins over the largest radius. Narrow: candidates that do not touch cost as much as contacts; wide: the search costs
// as much as dozens of sweeps. The inner one measured flat from a third of this to a third more for 1000 to 70,000
// spheres, and best here for 400 disks.
constexpr double relative_skin = 0.015;
constexpr double relative_outer_skin = 0.25;
// Of the skin: what is used up when a look at what the grains have truly moved is not worth another one.
constexpr double worn = 0.8;

// Bins in reduced coordinates, at least one interaction length wide along every axis.
class Grid {
 public:
  Grid(const Bodies& bodies, const Cell& cell, double length) : bodies_(bodies), cell_(cell) {
    frame(length);
    bin_of_.resize(bodies.size());
    wrap_.resize(bodies.size());
    std::vector<std::int32_t> count(static_cast<std::size_t>(bins_.prod()) + 1, 0);
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      place(i);
      ++count[static_cast<std::size_t>(bin_of_[i]) + 1];
    }
    for (std::size_t b = 1; b < count.size(); ++b) count[b] += count[b - 1];
    start_ = count;
    members_.resize(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i)
      members_[static_cast<std::size_t>(count[static_cast<std::size_t>(bin_of_[i])]++)] = static_cast<std::int32_t>(i);
  }

  // Adds the pairs of i with grains j > i whose gap is below the skin, sorted.
  void near(std::size_t i, double skin, std::vector<Pair>& found) const {
    const auto begin = static_cast<std::ptrdiff_t>(found.size());
    const Vec3i home = coordinates(bin_of_[i]);
    const Vec3 xi = vector_of(bodies_.grains[i].position);
    const int reach_z = bodies_.dimension == 3 ? 1 : 0;
    for (int dz = -reach_z; dz <= reach_z; ++dz)
      for (int dy = -1; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          Vec3i bin = home + Vec3i(dx, dy, dz), turn;
          if (!fold(bin, turn)) continue;
          const std::size_t b = index(bin);
          for (std::int32_t m = start_[b]; m < start_[b + 1]; ++m) {
            const std::int32_t j = members_[static_cast<std::size_t>(m)];
            if (static_cast<std::size_t>(j) <= i || bodies_.in_one_fabric(i, static_cast<std::size_t>(j))) continue;
            const Vec3i image = turn + wrap_[i] - wrap_[static_cast<std::size_t>(j)];
            const Vec3 d = vector_of(bodies_.grains[static_cast<std::size_t>(j)].position) +
                           cell_.matrix() * image.cast<double>() - xi;
            const double reach = bodies_.radius(i) + bodies_.radius(static_cast<std::size_t>(j)) + skin;
            if (d.squaredNorm() < reach * reach) found.push_back({static_cast<std::int32_t>(i), j, image});
          }
        }
    std::sort(found.begin() + begin, found.end(), before);
  }

 private:
  // Periodic axes are binned over the cell, the others over the extent of the grains.
  void frame(double length) {
    inverse_ = cell_.matrix().inverse();
    const Vec3 widths = cell_.widths();
    for (int a = 0; a < 3; ++a) {
      low_[a] = 0, span_[a] = 1;
      double width = widths[a];
      if (!cell_.periodic(a)) {
        double low = 0, high = 0;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
          const double s = inverse_.row(a).dot(vector_of(bodies_.grains[i].position));
          low = i == 0 ? s : std::min(low, s), high = i == 0 ? s : std::max(high, s);
        }
        low_[a] = low, span_[a] = std::max(high - low, 1e-300) * (1 + 1e-12);
        width *= span_[a];
      }
      bins_[a] = static_cast<int>(std::clamp(std::floor(width / length), 1.0, 256.0));
    }
  }
  void place(std::size_t i) {
    Vec3i bin;
    wrap_[i].setZero();
    for (int a = 0; a < 3; ++a) {
      double s = (inverse_.row(a).dot(vector_of(bodies_.grains[i].position)) - low_[a]) / span_[a];
      if (cell_.periodic(a)) {
        wrap_[i][a] = static_cast<int>(std::floor(s));
        s -= std::floor(s);
      }
      bin[a] = static_cast<int>(std::clamp(s * bins_[a], 0.0, bins_[a] - 1.0));
    }
    bin_of_[i] = static_cast<std::int32_t>(index(bin));
  }
  bool fold(Vec3i& bin, Vec3i& turn) const {
    turn.setZero();
    for (int a = 0; a < 3; ++a) {
      if (bin[a] >= 0 && bin[a] < bins_[a]) continue;
      if (!cell_.periodic(a)) return false;
      turn[a] = bin[a] < 0 ? -1 : 1;
      bin[a] -= turn[a] * bins_[a];
    }
    return true;
  }
  std::size_t index(const Vec3i& bin) const {
    return static_cast<std::size_t>((bin[2] * bins_[1] + bin[1]) * bins_[0] + bin[0]);
  }
  Vec3i coordinates(std::int32_t b) const {
    return {b % bins_[0], (b / bins_[0]) % bins_[1], b / (bins_[0] * bins_[1])};
  }

  const Bodies& bodies_;
  const Cell& cell_;
  Mat3 inverse_;
  Vec3 low_, span_;
  Vec3i bins_;
  std::vector<std::int32_t> bin_of_, start_, members_;
  std::vector<Vec3i> wrap_;  // whole cells between a grain's unwrapped position and its bin
};

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

}  // namespace

Neighbours::Neighbours(double largest_radius)
    : radius_(largest_radius),
      outer_skin_(relative_outer_skin * largest_radius),
      skin_(relative_skin * largest_radius) {}

void Neighbours::Since::begin(const Bodies& bodies) {
  position.clear();
  for (const Grain& g : bodies.grains) position.push_back(vector_of(g.position));
  deformation.setIdentity();
  planes = closed = 0;
}

double Neighbours::Since::closing(double fastest, double fastest_plane, const Mat3& velocity_gradient, double dt,
                                  double longest) {
  return dt * (2 * fastest + fastest_plane + velocity_gradient.norm() * longest);
}

void Neighbours::Since::move(double fastest, double fastest_plane, const Mat3& velocity_gradient, double dt,
                             double longest) {
  deformation += dt * velocity_gradient * deformation;
  planes += dt * fastest_plane;
  closed += closing(fastest, fastest_plane, velocity_gradient, dt, longest);
}

void Neighbours::Since::look(const Bodies& bodies, double longest) {
  const Mat3& f = deformation;
  const Lane4 a = row(f.col(0), 0), b = row(f.col(1), 0), c = row(f.col(2), 0);
  double largest = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Lane4& x = bodies.grains[i].position;
    const Vec3& from = position[i];
    const Lane4 moved =
        fused_less(all<Lane4>(from[2]), c, fused_less(all<Lane4>(from[1]), b, fused_less(all<Lane4>(from[0]), a, x)));
    const Lane4 square = moved * moved;
    largest = std::max(largest, square[0] + square[1] + square[2]);
  }
  closed = 2 * std::sqrt(largest) + planes + (f - Mat3::Identity()).norm() * longest;
}

bool Neighbours::outdated(const Bodies& bodies, double fastest, double fastest_plane, const Mat3& velocity_gradient,
                          double dt) {
  for (Since* since : {&filtered_, &searched_}) since->move(fastest, fastest_plane, velocity_gradient, dt, longest());
  if (filtered_.closed <= skin_) return false;
  // Planes do not move with the cell: grains close in on them by all that they move.
  if (planes_) return true;
  filtered_.look(bodies, longest());
  return filtered_.closed > worn * skin_;
}

bool Neighbours::outlast(double fastest, const Mat3& velocity_gradient, double dt) const {
  return filtered_.closed + Since::closing(fastest, 0, velocity_gradient, dt, longest()) <= skin_;
}

void Neighbours::search(const Bodies& bodies, const Cell& cell) {
  const Grid grid(bodies, cell, longest());
  outer_.clear();
  for (std::size_t i = 0; i < bodies.size(); ++i) grid.near(i, outer_skin_, outer_);
  give_back_spare(outer_);
  searched_.begin(bodies);
}

void Neighbours::rebuild(Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts) {
  planes_ = !planes.all.empty();
  if (searched_.closed + skin_ > outer_skin_ && !planes_ && !searched_.position.empty())
    searched_.look(bodies, longest());
  if (searched_.position.empty() || searched_.closed + skin_ > outer_skin_) search(bodies, cell);
  listed_.clear();
  for (const Pair& p : outer_) {
    const Lane4& a = bodies.grains[static_cast<std::size_t>(p.first)].position;
    const Lane4& b = bodies.grains[static_cast<std::size_t>(p.second)].position;
    Lane4 d = b - a;
    if (!p.image.isZero()) d += row(cell.matrix() * p.image.cast<double>(), 0);
    const double reach = a[3] + b[3] + skin_;
    if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] < reach * reach) listed_.push_back(p);
  }
  give_back_spare(listed_);
  std::vector<PlanePair> with_planes;
  if (!planes.all.empty())
    for (std::size_t i = 0; i < bodies.size(); ++i)
      for (std::size_t p = 0; p < planes.all.size(); ++p) {
        const Plane& plane = planes.all[p];
        if (!plane.touches(bodies.is_node(i))) continue;
        if ((vector_of(bodies.grains[i].position) - plane.point).dot(plane.normal) - bodies.radius(i) < skin_)
          with_planes.push_back({static_cast<std::int32_t>(i), static_cast<std::int32_t>(p), 0, {0, 0, 0}, {}});
      }
  contacts.list(listed_, std::move(with_planes), bodies);
  filtered_.begin(bodies);
}

}  // namespace soilweave::dem
