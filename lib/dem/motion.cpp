// From forces to motion. Sums over grains are made in fixed chunks, whatever the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace soilweave::dem {
// The rows of four grains.
struct FourGrains {
  Lane4 *position, *velocity, *spin, *orientation;
  const Lane4 *force, *torque;
};

// What four grains are moved by.
struct Push {
  Lane4 damping, dt, gyration;
  V3<Lane4> gravity;
  Mat3 gradient;
  bool heavy, deforming;
};

namespace {

Lane4 resultant(const Bodies& bodies, std::size_t i, const Lane4& gravity) {
  return bodies.force[i] + bodies.mass(i) * gravity;
}

// Everything on a grain; what was in the loads is left zero.
Load take(Contacts& contacts, std::size_t i) {
  Load total = contacts.loads[i];
  contacts.loads[i] = {};
  for (std::uint32_t s = contacts.load_start[i]; s < contacts.load_start[i + 1]; ++s) {
    total.force += contacts.loads[s].force;
    total.torque += contacts.loads[s].torque;
    contacts.loads[s] = {};
  }
  return total;
}

// x, y and z squared and added.
double length2(const Lane4& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

V3<Lane4> vector_part(const Columns<Lane4>& c) { return {c.a, c.b, c.c}; }

Columns<Lane4> columns_of(const Lane4* rows) {
  return columns<Lane4>([rows](int i) { return rows[i]; });
}

void put(const V3<Lane4>& v, const Lane4& scalar, Lane4* rows) {
  to_rows(v.x, v.y, v.z, scalar, [rows](int i, const Lane4& row) { rows[i] = row; });
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
V3<Lane4> kick(const V3<Lane4>& f, const Lane4& ratio, const Lane4& damping, const V3<Lane4>& v, Lane4& lost) {
  return {kick(f.x, ratio, damping, v.x, lost), kick(f.y, ratio, damping, v.y, lost),
          kick(f.z, ratio, damping, v.z, lost)};
}

// q <- q (1, dt w/2), of unit length again by one Newton step: the length is off by the square of half the angle.
void turn(const V3<Lane4>& spin, const Lane4& dt, Lane4* rows) {
  const Columns<Lane4> q = columns_of(rows);
  const V3<Lane4> half = Lane4(0.5 * dt) * spin;
  const Lane4 a = fused_less(half.z, q.d, fused_less(half.y, q.c, fused_less(half.x, q.b, q.a)));
  const Lane4 b = fused_less(half.z, q.c, fused(half.y, q.d, fused(half.x, q.a, q.b)));
  const Lane4 c = fused(half.z, q.b, fused(half.y, q.a, fused_less(half.x, q.d, q.c)));
  const Lane4 d = fused(half.z, q.a, fused_less(half.y, q.b, fused(half.x, q.c, q.d)));
  const Lane4 square = fused(d, d, fused(c, c, fused(b, b, Lane4(a * a))));
  const Lane4 scale = fused_less(all<Lane4>(0.5), square, all<Lane4>(1.5));
  to_rows(scale * a, scale * b, scale * c, scale * d, [rows](int i, const Lane4& row) { rows[i] = row; });
}

V3<Lane4> affine(const Mat3& g, const V3<Lane4>& x, const V3<Lane4>& v) {
  const auto component = [&](int i, const Lane4& to) {
    return fused(all<Lane4>(g(i, 2)), x.z, fused(all<Lane4>(g(i, 1)), x.y, fused(all<Lane4>(g(i, 0)), x.x, to)));
  };
  return {component(0, v.x), component(1, v.y), component(2, v.z)};
}

}  // namespace

Motion::Motion(std::size_t grains, int threads) : threads_(threads), partial_(chunks_of(grains)) {}

template <class Body>
void Motion::chunked(std::size_t grains, const Body& body) {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t c = 0; c < partial_.size(); ++c) {
    Partial partial;
    body(c * grains_per_chunk, std::min(grains, (c + 1) * grains_per_chunk), partial);
    partial_[c] = partial;
  }
}

Mat3 Motion::gather(Contacts& contacts, Bodies& bodies) {
  chunked(bodies.size(), [&](std::size_t begin, std::size_t end, Partial& partial) {
    for (std::size_t i = begin; i < end; ++i) {
      const Load load = take(contacts, i);
      const Lane4& x = bodies.position[i];
      bodies.force[i] = load.force;
      bodies.torque[i] = bodies.is_node(i) ? Lane4{} : load.torque;  // nodes do not rotate
      for (int a = 0; a < 3; ++a) partial.virial[a] = fused(all<Lane4>(x[a]), load.force, partial.virial[a]);
    }
  });
  Mat3 sum = Mat3::Zero();
  for (const Partial& p : partial_)
    for (int a = 0; a < 3; ++a) sum.col(a) += vector_of(p.virial[a]);
  return sum;
}

double Motion::resultants(const Vec3& gravity, const Bodies& bodies) {
  const Lane4 g = row(gravity, 0);
  chunked(bodies.size(), [&](std::size_t begin, std::size_t end, Partial& partial) {
    for (std::size_t i = begin; i < end; ++i) partial.sum += std::sqrt(length2(resultant(bodies, i, g)));
  });
  double sum = 0;
  for (const Partial& p : partial_) sum += p.sum;
  return sum;
}

// One step of four grains.
[[gnu::flatten]] void Motion::advance(const Push& push, const FourGrains& of, Partial& partial) {
  const Columns<Lane4> v_m = columns_of(of.velocity), w_r = columns_of(of.spin), x_r = columns_of(of.position);
  const Lane4 ratio = push.dt / v_m.d;
  V3<Lane4> force = vector_part(columns_of(of.force));
  const V3<Lane4> before = vector_part(v_m), pull = v_m.d * push.gravity;
  if (push.heavy) force = force + pull;
  const V3<Lane4> v = kick(force, ratio, push.damping, before, partial.damping);
  if (push.heavy) partial.gravity_work += dot(pull, before + v);
  partial.largest = maximum(partial.largest, norm2(v));
  put(v, v_m.d, of.velocity);

  const Lane4 spin_ratio = ratio / (push.gyration * w_r.d * w_r.d);
  const V3<Lane4> torque = vector_part(columns_of(of.torque));
  const V3<Lane4> w = kick(torque, spin_ratio, push.damping, vector_part(w_r), partial.damping);
  put(w, w_r.d, of.spin);
  turn(w, push.dt, of.orientation);

  const V3<Lane4> x = vector_part(x_r);
  put(fused(push.dt, push.deforming ? affine(push.gradient, x, v) : v, x), x_r.d, of.position);
}

MotionSums Motion::advance(const Cell& cell, const Vec3& gravity, double damping, double dt, Bodies& bodies) {
  const Push push{all<Lane4>(damping),
                  all<Lane4>(dt),
                  all<Lane4>(bodies.gyration),
                  {all<Lane4>(gravity.x()), all<Lane4>(gravity.y()), all<Lane4>(gravity.z())},
                  cell.velocity_gradient(),
                  !gravity.isZero(0.0),
                  !cell.velocity_gradient().isZero(0.0)};
  Bodies& b = bodies;
  chunked(b.size(), [&](std::size_t begin, std::size_t end, Partial& partial) {
    std::size_t i = begin;
    for (; i + 4 <= end; i += 4)
      advance(push, {&b.position[i], &b.velocity[i], &b.spin[i], &b.orientation[i], &b.force[i], &b.torque[i]},
              partial);
    if (i == end) return;
    // The last few, beside grains at rest that do not fall.
    Push last = push;
    for (std::size_t k = end; k < i + 4; ++k) last.gravity.x[k - i] = last.gravity.y[k - i] = last.gravity.z[k - i] = 0;
    const Lane4 rest{0, 0, 0, 1};
    std::array<Lane4, 4> x, v, w, q, f{}, t{};
    for (auto* rows : {&x, &v, &w, &q}) rows->fill(rest);
    for (std::size_t k = i; k < end; ++k)
      x[k - i] = b.position[k], v[k - i] = b.velocity[k], w[k - i] = b.spin[k], q[k - i] = b.orientation[k],
            f[k - i] = b.force[k], t[k - i] = b.torque[k];
    advance(last, {x.data(), v.data(), w.data(), q.data(), f.data(), t.data()}, partial);
    for (std::size_t k = i; k < end; ++k)
      b.position[k] = x[k - i], b.velocity[k] = v[k - i], b.spin[k] = w[k - i], b.orientation[k] = q[k - i];
  });
  Lane4 damped{}, work{}, fastest{};
  for (const Partial& p : partial_) {
    damped += p.damping;
    work += p.gravity_work;
    fastest = maximum(fastest, p.largest);
  }
  const auto sum = [](const Lane4& l) { return l[0] + l[1] + l[2] + l[3]; };
  return {0.5 * dt * sum(damped), 0.5 * dt * sum(work),
          std::sqrt(std::max({fastest[0], fastest[1], fastest[2], fastest[3]}))};
}

double Motion::stable_time_step(const Bodies& bodies, Contacts& contacts) {
  chunked(bodies.size(), [&](std::size_t begin, std::size_t end, Partial& partial) {
    for (std::size_t i = begin; i < end; ++i) {
      const auto [translation, rotation] = take(contacts, i);
      const Lane4 stiffness = maximum(Lane4(translation / bodies.mass(i)), Lane4(rotation / bodies.inertia(i)));
      partial.largest = maximum(partial.largest, stiffness);
    }
  });
  Lane4 all_chunks{};
  for (const Partial& p : partial_) all_chunks = maximum(all_chunks, p.largest);
  const double largest = std::max({all_chunks[0], all_chunks[1], all_chunks[2]});
  return largest > 0 ? std::numbers::sqrt2 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

double kinetic_energy(const Bodies& bodies, const Vec3& gravity, double dt) {
  const Lane4 g = row(gravity, 0);
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double m = bodies.mass(i), inertia = bodies.inertia(i);
    const Lane4 v = bodies.velocity[i] + (0.5 * dt / m) * resultant(bodies, i, g);
    const Lane4 w = bodies.spin[i] + (0.5 * dt / inertia) * bodies.torque[i];
    sum += 0.5 * m * length2(v);
    if (std::isfinite(inertia)) sum += 0.5 * inertia * length2(w);
  }
  return sum;
}

}  // namespace soilweave::dem
