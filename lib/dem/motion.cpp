// From forces to motion. Sums over grains are made in fixed chunks, whatever the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace soilweave::dem {
namespace {

Lane4 resultant(const Bodies& bodies, std::size_t i, const Lane4& gravity) {
  return bodies.loads[i].force + bodies.mass(i) * gravity;
}

// Adds the loads of single pairs to that of their grain and leaves them zero.
Load& collect_loads(const Contacts& contacts, std::size_t i, Bodies& bodies) {
  Load& total = bodies.loads[i];
  for (std::uint32_t s = contacts.load_start[i]; s < contacts.load_start[i + 1]; ++s) {
    Load& one = bodies.loads[s];
    total.force += one.force, total.torque += one.torque;
    one = {};
  }
  return total;
}

// First grain of a chunk; that of the next one, or how many there are.
std::size_t first_of(std::size_t chunk, const Bodies& bodies) {
  return std::min(bodies.size(), chunk * grains_per_chunk);
}

// x, y and z squared and added.
double length2(const Lane4& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

V3<Lane4> vector_part(const Columns<Lane4>& c) { return {c.a, c.b, c.c}; }

template <class Row>
void put(const V3<Lane4>& v, const Lane4& scalar, const Row& row) {
  to_rows(v.x, v.y, v.z, scalar, [&row](int i, const Lane4& value) { row(i) = value; });
}

// Force damped, velocity advanced by dt/mass. Adds to `lost` what the damping took, over half a step.
Lane4 kick(const Lane4& force, const Lane4& ratio, const Lane4& damping, const Lane4& velocity, Lane4& lost) {
  const Lane4 zero{}, change = ratio * force;
  const Lane4 power = force * fused(all<Lane4>(0.5), change, velocity);
  const Lane4 side = keep(power > zero, damping) - keep(power < zero, damping);
  const Lane4 after = fused(change, 1.0 - side, velocity);
  lost = fused(Lane4(side * force), velocity + after, lost);
  return after;
}
// Disks are not pushed out of their plane, nor turned out of it.
template <bool planar>
V3<Lane4> kick(const V3<Lane4>& f, const Lane4& ratio, const Lane4& damping, const V3<Lane4>& v, Lane4& lost) {
  const Lane4 x = kick(f.x, ratio, damping, v.x, lost), y = kick(f.y, ratio, damping, v.y, lost);
  return {x, y, planar ? v.z : kick(f.z, ratio, damping, v.z, lost)};
}
template <bool planar>
V3<Lane4> spin_up(const V3<Lane4>& torque, const Lane4& ratio, const Lane4& damping, const V3<Lane4>& w, Lane4& lost) {
  if constexpr (planar) return {w.x, w.y, kick(torque.z, ratio, damping, w.z, lost)};
  return kick<false>(torque, ratio, damping, w, lost);
}

// q <- (1, dt w/2) q, of unit length again by one Newton step: the length is off by the square of half the angle.
template <bool planar>
void turn(const V3<Lane4>& spin, const Lane4& dt, Grain* grains) {
  const Columns<Lane4> q = columns<Lane4>([grains](int i) { return grains[i].orientation; });
  const V3<Lane4> half = Lane4(0.5 * dt) * spin;
  Lane4 a = q.a, b = q.b, c = q.c, d = q.d;
  if constexpr (!planar) {
    a = fused_less(half.y, q.c, fused_less(half.x, q.b, a));
    b = fused(half.y, q.d, fused(half.x, q.a, b));
    c = fused(half.y, q.a, fused_less(half.x, q.d, c));
    d = fused_less(half.y, q.b, fused(half.x, q.c, d));
  }
  a = fused_less(half.z, q.d, a);
  b = fused_less(half.z, q.c, b);
  c = fused(half.z, q.b, c);
  d = fused(half.z, q.a, d);
  const Lane4 square = fused(d, d, fused(c, c, fused(b, b, Lane4(a * a))));
  const Lane4 scale = fused_less(all<Lane4>(0.5), square, all<Lane4>(1.5));
  to_rows(scale * a, scale * b, scale * c, scale * d,
          [grains](int i, const Lane4& row) { grains[i].orientation = row; });
}

V3<Lane4> affine(const Mat3& g, const V3<Lane4>& x, const V3<Lane4>& v) {
  const auto component = [&](int i, const Lane4& to) {
    return fused(all<Lane4>(g(i, 2)), x.z, fused(all<Lane4>(g(i, 1)), x.y, fused(all<Lane4>(g(i, 0)), x.x, to)));
  };
  return {component(0, v.x), component(1, v.y), component(2, v.z)};
}

}  // namespace

Motion::Motion(std::size_t grains, int threads)
    : threads_(threads), moved_(chunks_of(grains)), collected_(chunks_of(grains)), partial_(chunks_of(grains)) {
  for (Moved& m : moved_) m.fastest = all<Lane4>(std::numeric_limits<double>::infinity());  // not known yet
}

template <class Pass>
void Motion::pass(const Pass& over) const {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t chunk = 0; chunk < moved_.size(); ++chunk) over(chunk);
}

void Motion::collect(std::size_t chunk, const Contacts& contacts, Bodies& bodies) {
  const Mask<Lane4> in_plane{-1, -1, 0, 0};
  const bool planar = bodies.dimension == 2;
  Collected sums;
  for (std::size_t i = first_of(chunk, bodies), end = first_of(chunk + 1, bodies); i < end; ++i) {
    Load& load = collect_loads(contacts, i, bodies);
    if (planar) load = {keep(in_plane, load.force), keep(~in_plane, load.force)};  // as the sweep left them
    if (bodies.is_node(i)) load.torque = Lane4{};                                  // nodes do not rotate
    const Lane4& x = bodies.grains[i].position;
    for (int a = 0; a < 3; ++a) sums.virial[a] = fused(all<Lane4>(x[a]), load.force, sums.virial[a]);
    sums.force = maximum(sums.force, Lane4(load.force * load.force));
  }
  collected_[chunk] = sums;
}

Mat3 Motion::collected() const {
  Mat3 sum = Mat3::Zero();
  for (const Collected& c : collected_)
    for (int a = 0; a < 3; ++a) sum.col(a) += vector_of(c.virial[a]);
  return sum;
}

double Motion::resultants(const Vec3& gravity, const Bodies& bodies) {
  const Lane4 g = row(gravity, 0);
  pass([&](std::size_t chunk) {
    double sum = 0;
    for (std::size_t i = first_of(chunk, bodies), end = first_of(chunk + 1, bodies); i < end; ++i)
      sum += std::sqrt(length2(resultant(bodies, i, g)));
    partial_[chunk] = sum;
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

// One step of four grains; their loads are used up.
template <bool planar>
[[gnu::flatten]] void Motion::advance(const Push& push, Grain* grains, Load* loads, Moved& moved) {
  const Columns<Lane4> v_m = columns<Lane4>([grains](int i) { return grains[i].velocity; });
  const Columns<Lane4> w_r = columns<Lane4>([grains](int i) { return grains[i].spin; });
  const Columns<Lane4> x_r = columns<Lane4>([grains](int i) { return grains[i].position; });
  V3<Lane4> force = vector_part(columns<Lane4>([loads](int i) { return loads[i].force; }));
  const V3<Lane4> torque = vector_part(columns<Lane4>([loads](int i) { return loads[i].torque; }));
  // Not `loads[i] = {}`, of which the compiler would make one string instruction, slower than all before it.
  for (int i = 0; i < width<Lane4>; ++i) loads[i].force = loads[i].torque = Lane4{};
  const Lane4 ratio = push.dt / v_m.d;
  const V3<Lane4> before = vector_part(v_m), pull = v_m.d * push.gravity;
  if (push.heavy) force = force + pull;
  const V3<Lane4> v = kick<planar>(force, ratio, push.damping, before, moved.damping);
  if (push.heavy) moved.gravity_work += dot(pull, before + v);
  moved.fastest = maximum(moved.fastest, norm2(v));
  put(v, v_m.d, [grains](int i) -> Lane4& { return grains[i].velocity; });

  const Lane4 spin_ratio = ratio / (push.gyration * w_r.d * w_r.d);
  const V3<Lane4> w = spin_up<planar>(torque, spin_ratio, push.damping, vector_part(w_r), moved.damping);
  put(w, w_r.d, [grains](int i) -> Lane4& { return grains[i].spin; });
  turn<planar>(w, push.dt, grains);

  const V3<Lane4> x = vector_part(x_r);
  put(fused(push.dt, push.deforming ? affine(push.gradient, x, v) : v, x), x_r.d,
      [grains](int i) -> Lane4& { return grains[i].position; });
}

void Motion::set_out(const Cell& cell, const Vec3& gravity, double damping, double dt, const Bodies& bodies) {
  push_ = {all<Lane4>(damping),
           all<Lane4>(dt),
           all<Lane4>(bodies.gyration),
           {all<Lane4>(gravity.x()), all<Lane4>(gravity.y()), all<Lane4>(gravity.z())},
           cell.velocity_gradient(),
           !gravity.isZero(0.0),
           !cell.velocity_gradient().isZero(0.0),
           bodies.dimension == 2};
}

void Motion::advance(std::size_t chunk, Bodies& bodies) {
  const auto four = push_.planar ? &Motion::advance<true> : &Motion::advance<false>;
  std::size_t i = first_of(chunk, bodies);
  const std::size_t end = first_of(chunk + 1, bodies);
  Moved moved;
  for (; i + 4 <= end; i += 4) four(push_, &bodies.grains[i], &bodies.loads[i], moved);
  if (i < end) {
    // The last few, beside grains at rest that do not fall.
    Push last = push_;
    for (std::size_t k = end; k < i + 4; ++k) last.gravity.x[k - i] = last.gravity.y[k - i] = last.gravity.z[k - i] = 0;
    const Lane4 rest{0, 0, 0, 1};
    std::array<Grain, 4> grains;
    grains.fill({rest, rest, rest, rest});
    std::array<Load, 4> loads;
    for (std::size_t k = i; k < end; ++k)
      grains[k - i] = bodies.grains[k], loads[k - i] = bodies.loads[k], bodies.loads[k] = {};
    four(last, grains.data(), loads.data(), moved);
    for (std::size_t k = i; k < end; ++k) bodies.grains[k] = grains[k - i];
  }
  moved_[chunk] = moved;
}

void Motion::advance_all(Bodies& bodies) {
  pass([&](std::size_t chunk) { advance(chunk, bodies); });
}

MotionSums Motion::advanced() const {
  Moved all_chunks;
  for (const Moved& m : moved_) {
    all_chunks.damping += m.damping;
    all_chunks.gravity_work += m.gravity_work;
    all_chunks.fastest = maximum(all_chunks.fastest, m.fastest);
  }
  const auto sum = [](const Lane4& l) { return l[0] + l[1] + l[2] + l[3]; };
  const Lane4& fastest = all_chunks.fastest;
  const double dt = push_.dt[0];
  return {0.5 * dt * sum(all_chunks.damping), 0.5 * dt * sum(all_chunks.gravity_work),
          std::sqrt(std::max({fastest[0], fastest[1], fastest[2], fastest[3]}))};
}

double Motion::speed_bound(double smallest_mass) const {
  Lane4 force{};
  for (const Collected& c : collected_) force = maximum(force, c.force);
  const auto length = [](double x2, double y2, double z2) { return std::sqrt(x2 + y2 + z2); };
  const V3<Lane4>& g = push_.gravity;
  const double gravity = length(g.x[0] * g.x[0], g.y[0] * g.y[0], g.z[0] * g.z[0]);
  const double acceleration = length(force[0], force[1], force[2]) / smallest_mass + gravity;
  constexpr double rounding = 1 + 1e-9;
  return rounding * (advanced().fastest + push_.dt[0] * (1 + push_.damping[0]) * acceleration);
}

double Motion::stable_time_step(const Contacts& contacts, Bodies& bodies) {
  pass([&](std::size_t chunk) {
    Lane4 largest{};
    for (std::size_t i = first_of(chunk, bodies), end = first_of(chunk + 1, bodies); i < end; ++i) {
      Load& load = collect_loads(contacts, i, bodies);
      largest = maximum(largest, maximum(Lane4(load.force / bodies.mass(i)), Lane4(load.torque / bodies.inertia(i))));
      load = {};
    }
    partial_[chunk] = std::max({largest[0], largest[1], largest[2]});
  });
  double largest = 0;
  for (const double one : partial_) largest = std::max(largest, one);
  return largest > 0 ? std::numbers::sqrt2 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

double kinetic_energy(const Bodies& bodies, const Vec3& gravity, double dt) {
  const Lane4 g = row(gravity, 0);
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double m = bodies.mass(i), inertia = bodies.inertia(i);
    const Lane4 v = bodies.grains[i].velocity + (0.5 * dt / m) * resultant(bodies, i, g);
    const Lane4 w = bodies.grains[i].spin + (0.5 * dt / inertia) * bodies.loads[i].torque;
    sum += 0.5 * m * length2(v);
    if (std::isfinite(inertia)) sum += 0.5 * inertia * length2(w);
  }
  return sum;
}

}  // namespace soilweave::dem
