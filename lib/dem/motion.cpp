// From forces to motion. Sums over grains are made in fixed chunks, whatever the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace soilweave::dem {
namespace {

Lane4 resultant(const Bodies& bodies, std::size_t i, const Lane4& gravity) {
  return bodies.force[i] + bodies.mass(i) * gravity;
}

// x, y and z squared and added.
double length2(const Lane4& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

// Force damped, velocity advanced; the row's last place, where the force is 0, stays. Returns what the damping took, J.
Lane4 kick(const Lane4& force, double damping, double dt, Lane4& velocity) {
  const Lane4 zero{}, before = velocity, change = (dt / velocity[3]) * force;
  const Lane4 power = force * fused(all<Lane4>(0.5), change, before);
  const Lane4 lost = all<Lane4>(damping);
  const Lane4 side = keep(power > zero, lost) - keep(power < zero, lost);
  velocity = fused(change, 1.0 - side, before);
  return side * force * (0.5 * dt) * (before + velocity);
}

// q <- q (1, dt w/2), of unit length again by one Newton step: the length is off by the square of half the angle.
void turn(const Lane4& spin, double dt, Lane4& q) {
  const Lane4 half = (0.5 * dt) * spin;
  const auto times = [&](double s, const Lane4& r, const Lane4& to) { return fused(all<Lane4>(s), r, to); };
  Lane4 next = times(half[0], Lane4{-q[1], q[0], -q[3], q[2]}, q);
  next = times(half[1], Lane4{-q[2], q[3], q[0], -q[1]}, next);
  next = times(half[2], Lane4{-q[3], -q[2], q[1], q[0]}, next);
  const Lane4 square = next * next;
  q = (1.5 - 0.5 * (square[0] + square[1] + square[2] + square[3])) * next;
}

}  // namespace

Motion::Motion(std::size_t grains, int threads) : threads_(threads), partial_(chunks_of(grains)) {}

template <class Body>
void Motion::chunked(std::size_t grains, const Body& body) {
#pragma omp parallel for schedule(static) num_threads(threads_) if (threads_ > 1)
  for (std::size_t c = 0; c < partial_.size(); ++c) {
    partial_[c] = {};
    const std::size_t end = std::min(grains, (c + 1) * grains_per_chunk);
    for (std::size_t i = c * grains_per_chunk; i < end; ++i) body(i, partial_[c]);
  }
}

void Motion::gather(const Contacts& contacts, Bodies& bodies) {
  chunked(bodies.size(), [&](std::size_t i, Partial&) {
    Lane4 force{}, torque{};
    for (std::uint32_t s = contacts.slot_start[i]; s < contacts.slot_start[i + 1]; ++s) {
      force += contacts.slots[s].force;
      torque += contacts.slots[s].torque;
    }
    bodies.force[i] = force;
    bodies.torque[i] = torque;
  });
}

double Motion::resultants(const Vec3& gravity, const Bodies& bodies) {
  const Lane4 g = row(gravity, 0);
  chunked(bodies.size(),
          [&](std::size_t i, Partial& partial) { partial.sum += std::sqrt(length2(resultant(bodies, i, g))); });
  double sum = 0;
  for (const Partial& p : partial_) sum += p.sum;
  return sum;
}

MotionSums Motion::advance(const Cell& cell, const Vec3& gravity, double damping, double dt, Bodies& bodies) {
  const Lane4 g = row(gravity, 0), step{dt, dt, dt, 0};
  const Mat3& gradient = cell.velocity_gradient();
  const bool deforming = !gradient.isZero(0.0);
  const Lane4 x_part = row(gradient.col(0), 0), y_part = row(gradient.col(1), 0), z_part = row(gradient.col(2), 0);
  chunked(bodies.size(), [&](std::size_t i, Partial& partial) {
    Lane4 &v = bodies.velocity[i], &w = bodies.spin[i], &x = bodies.position[i];
    const Lane4 before = v, pull = bodies.mass(i) * g;
    partial.damping += kick(bodies.force[i] + pull, damping, dt, v);
    partial.damping += kick(bodies.torque[i], damping, dt, w);
    const Lane4 work = (0.5 * dt) * pull * (before + v);
    partial.gravity_work += work[0] + work[1] + work[2];
    partial.largest = std::max(partial.largest, length2(v));
    Lane4 velocity = v;
    if (deforming) velocity += x[0] * x_part + x[1] * y_part + x[2] * z_part;
    x += step * velocity;
    turn(w, dt, bodies.orientation[i]);
  });
  MotionSums total;
  Lane4 damped{};
  for (const Partial& p : partial_) {
    damped += p.damping;
    total.gravity_work += p.gravity_work;
    total.fastest = std::max(total.fastest, p.largest);
  }
  total.damping = damped[0] + damped[1] + damped[2];
  total.fastest = std::sqrt(total.fastest);
  return total;
}

double Motion::stable_time_step(const Bodies& bodies, const Contacts& contacts) {
  chunked(bodies.size(), [&](std::size_t i, Partial& partial) {
    Lane4 translation{}, rotation{};
    for (std::uint32_t s = contacts.slot_start[i]; s < contacts.slot_start[i + 1]; ++s) {
      translation += contacts.slots[s].force;
      rotation += contacts.slots[s].torque;
    }
    const double k = std::max({translation[0], translation[1], translation[2]}) / bodies.mass(i);
    const double spin = std::max({rotation[0], rotation[1], rotation[2]}) / bodies.inertia(i);
    partial.largest = std::max({partial.largest, k, spin});
  });
  double largest = 0;
  for (const Partial& p : partial_) largest = std::max(largest, p.largest);
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
