// From forces to motion. Sums over grains are made in fixed chunks, whatever the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/motion.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace soilweave::dem {
namespace {

constexpr std::size_t chunk_size = 512;

std::size_t chunks_of(std::size_t n) { return (n + chunk_size - 1) / chunk_size; }

// Runs body(first, last, chunk) over fixed chunks of n.
template <class Body>
void chunked(std::size_t n, int threads, const Body& body) {
  const std::size_t chunks = chunks_of(n);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (std::size_t c = 0; c < chunks; ++c) body(c * chunk_size, std::min(n, (c + 1) * chunk_size), c);
}

double sign(double x) { return static_cast<double>((x > 0) - (x < 0)); }

// One component: force damped, velocity advanced. Returns the energy the damping took.
double kick(double force, double inertia, double damping, double dt, double& velocity) {
  const double acceleration = force / inertia;
  const double side = sign(acceleration * (velocity + 0.5 * dt * acceleration));
  const double before = velocity;
  velocity += dt * acceleration * (1 - damping * side);
  return damping * side * force * dt * 0.5 * (before + velocity);
}

void turn(const V3<double>& spin, double dt, Vec4& q) {
  const Vec3 half = 0.5 * dt * Vec3(spin.x, spin.y, spin.z);
  const Vec3 v = q.tail<3>();
  Vec4 next;
  next[0] = q[0] - half.dot(v);
  next.tail<3>() = v + q[0] * half + half.cross(v);
  q = next.normalized();
}

V3<double> resultant(const Bodies& bodies, std::size_t i, const Vec3& gravity) {
  const double m = bodies.mass[i];
  return bodies.force[i] + V3<double>{m * gravity.x(), m * gravity.y(), m * gravity.z()};
}

}  // namespace

double gather(const Contacts& contacts, const Vec3& gravity, int threads, Bodies& bodies) {
  std::vector<double> sums(chunks_of(bodies.size()), 0.0);
  chunked(bodies.size(), threads, [&](std::size_t begin, std::size_t end, std::size_t c) {
    for (std::size_t i = begin; i < end; ++i) {
      V3<double> force{0, 0, 0}, torque{0, 0, 0};
      for (std::int32_t s = contacts.body_start[i]; s < contacts.body_start[i + 1]; ++s) {
        const auto k = static_cast<std::size_t>(contacts.body_pairs[static_cast<std::size_t>(s)]);
        const bool is_first = static_cast<std::size_t>(contacts.first[k]) == i;
        force = is_first ? force - contacts.force[k] : force + contacts.force[k];
        torque = torque + (is_first ? contacts.torque_first[k] : contacts.torque_second[k]);
      }
      bodies.force[i] = force;
      bodies.torque[i] = torque;
      sums[c] += norm(resultant(bodies, i, gravity));
    }
  });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

MotionSums advance(const Cell& cell, const Vec3& gravity, double damping, double dt, int threads, Bodies& bodies) {
  std::vector<MotionSums> sums(chunks_of(bodies.size()));
  const Mat3& L = cell.velocity_gradient();
  chunked(bodies.size(), threads, [&](std::size_t begin, std::size_t end, std::size_t c) {
    MotionSums& s = sums[c];
    for (std::size_t i = begin; i < end; ++i) {
      const V3<double> f = resultant(bodies, i, gravity);
      V3<double>&v = bodies.velocity[i], &w = bodies.angular_velocity[i];
      const V3<double> before = v;
      const double m = bodies.mass[i], inertia = bodies.inertia[i];
      const V3<double>& t = bodies.torque[i];
      s.damping += kick(f.x, m, damping, dt, v.x) + kick(f.y, m, damping, dt, v.y) + kick(f.z, m, damping, dt, v.z);
      s.damping += kick(t.x, inertia, damping, dt, w.x) + kick(t.y, inertia, damping, dt, w.y) +
                   kick(t.z, inertia, damping, dt, w.z);
      const V3<double> mean = 0.5 * (before + v);
      s.gravity_work += m * dt * (gravity.x() * mean.x + gravity.y() * mean.y + gravity.z() * mean.z);
      s.fastest = std::max(s.fastest, norm2(v));
      V3<double>& x = bodies.position[i];
      const Vec3 affine = L * Vec3(x.x, x.y, x.z);
      x = x + dt * (v + V3<double>{affine.x(), affine.y(), affine.z()});
      turn(w, dt, bodies.orientation[i]);
    }
  });
  MotionSums total;
  for (const MotionSums& s : sums) {
    total.damping += s.damping;
    total.gravity_work += s.gravity_work;
    total.fastest = std::max(total.fastest, s.fastest);
  }
  total.fastest = std::sqrt(total.fastest);
  return total;
}

double kinetic_energy(const Bodies& bodies, const Vec3& gravity, double dt) {
  double sum = 0;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const double m = bodies.mass[i], inertia = bodies.inertia[i];
    const V3<double> v = bodies.velocity[i] + (0.5 * dt / m) * resultant(bodies, i, gravity);
    const V3<double> w = bodies.angular_velocity[i] + (0.5 * dt / inertia) * bodies.torque[i];
    sum += 0.5 * m * norm2(v) + 0.5 * inertia * norm2(w);
  }
  return sum;
}

double stable_time_step(const Bodies& bodies, const Contacts& contacts, int threads) {
  std::vector<double> ratio(chunks_of(bodies.size()), 0.0);
  chunked(bodies.size(), threads, [&](std::size_t begin, std::size_t end, std::size_t c) {
    for (std::size_t i = begin; i < end; ++i) {
      V3<double> k{0, 0, 0}, rotational{0, 0, 0};
      const double r2 = bodies.radius[i] * bodies.radius[i];
      for (std::int32_t s = contacts.body_start[i]; s < contacts.body_start[i + 1]; ++s) {
        const auto p = static_cast<std::size_t>(contacts.body_pairs[static_cast<std::size_t>(s)]);
        if (!contacts.touching[p]) continue;
        const double kn = contacts.normal_stiffness[p], ks = contacts.shear_stiffness[p];
        const double kr = contacts.rolling_stiffness[p] + ks * r2, kt = contacts.twisting_stiffness[p];
        const V3<double>& n = contacts.normal[p];
        const V3<double> n2{n.x * n.x, n.y * n.y, n.z * n.z}, one{1, 1, 1};
        k = k + ks * one + (kn - ks) * n2;
        rotational = rotational + kr * one + (kt - kr) * n2;
      }
      const double largest = std::max({k.x, k.y, k.z}) / bodies.mass[i];
      const double spin = std::max({rotational.x, rotational.y, rotational.z}) / bodies.inertia[i];
      ratio[c] = std::max({ratio[c], largest, spin});
    }
  });
  const double largest = ratio.empty() ? 0.0 : *std::max_element(ratio.begin(), ratio.end());
  return largest > 0 ? std::numbers::sqrt2 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

}  // namespace soilweave::dem
