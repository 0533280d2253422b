// From forces to motion. Sums over grains are made in fixed chunks, whatever the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/in_parallel.h"

namespace soilweave::dem {
namespace {

Lane4 resultant(const Bodies& bodies, std::size_t i, const Lane4& gravity) {
  return bodies.force(i) + bodies.mass(i) * gravity;
}

// Adds the loads, or stiffnesses, of single pairs to those of a chunk's grains, and leaves them zero. The loop runs
// over pairs, because the number of pairs of a grain cannot be predicted.
void collect_singles(const Contacts& contacts, std::size_t chunk, const Bodies& bodies, LargeVector<Load>& loads) {
  constexpr std::ptrdiff_t ahead = 8;
  const auto from = [&](std::size_t c) {
    return contacts.single_loads.data() + contacts.single_loads_start[first_grain(c, bodies)];
  };
  const Contacts::SingleLoad* const end = from(chunk + 1);
  for (const Contacts::SingleLoad* s = from(chunk); s != end; ++s) {
    if (end - s > ahead) __builtin_prefetch(&loads[s[ahead].load], 1);
    Load &one = loads[s->load], &total = loads[static_cast<std::size_t>(s->grain)];
    total.force += one.force, total.torque += one.torque;
    one.force = one.torque = Lane4{};
  }
}

// Returns x^2 + y^2 + z^2.
double length2(const Lane4& v) { return v[0] * v[0] + v[1] * v[1] + v[2] * v[2]; }

double kinetic_energy_of(std::size_t i, const Bodies& bodies, const Lane4& gravity, double dt) {
  const double m = bodies.mass(i), inertia = bodies.inertia(i);
  const Lane4 v = bodies.velocity(i) + (0.5 * dt / m) * resultant(bodies, i, gravity);
  const Lane4 w = bodies.spin(i) + (0.5 * dt / inertia) * bodies.torque(i);
  const double turning = std::isfinite(inertia) ? 0.5 * inertia * length2(w) : 0;
  return 0.5 * m * length2(v) + turning;
}

}  // namespace

Motion::Motion(std::size_t grains, int threads, const GrainMotion& how)
    : how_(how),
      threads_(threads),
      moved_(chunks_of(grains)),
      collected_(chunks_of(grains)),
      partial_(chunks_of(grains)) {
  for (Collected& c : collected_) c.force = broadcast<Lane4>(std::numeric_limits<double>::infinity());  // not known yet
}

template <class Pass>
void Motion::pass(const Pass& over) const {
  in_parallel(moved_.size(), threads_, over);
}

void Motion::collect(std::size_t chunk, const Contacts& contacts, Bodies& bodies) {
  collected_[chunk] = bodies.dimension == 2 ? collect<2>(chunk, contacts, bodies) : collect<3>(chunk, contacts, bodies);
}

template <int dimension>
Motion::Collected Motion::collect(std::size_t chunk, const Contacts& contacts, Bodies& bodies) {
  collect_singles(contacts, chunk, bodies, bodies.loads);
  const bool nodes = !bodies.fabric.empty();
  const auto collect_one = [&](std::size_t i, Collected& sums) {
    Load& load = bodies.loads[i];
    if (nodes && bodies.is_node(i)) load.torque = Lane4{};  // nodes do not rotate
    const Lane4& x = bodies.grains[i].position;
    for (int a = 0; a < dimension; ++a) sums.virial[a] = fused(broadcast<Lane4>(x[a]), load.force, sums.virial[a]);
    sums.force = maximum(sums.force, Lane4(load.force * load.force));
  };
  // Two sums alternate, because each addition waits for the one before it.
  Collected sums, others;
  std::size_t i = first_grain(chunk, bodies);
  const std::size_t end = first_grain(chunk + 1, bodies);
  for (; i + 1 < end; i += 2) collect_one(i, sums), collect_one(i + 1, others);
  if (i < end) collect_one(i, sums);
  for (int a = 0; a < dimension; ++a) sums.virial[a] += others.virial[a];
  sums.force = maximum(sums.force, others.force);
  if (dimension == 2) {  // the third component is the torque
    for (Lane4& v : sums.virial) v[2] = 0;
    sums.force[2] = 0;
  }
  return sums;
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
    for (std::size_t i = first_grain(chunk, bodies), end = first_grain(chunk + 1, bodies); i < end; ++i)
      sum += std::sqrt(length2(resultant(bodies, i, g)));
    partial_[chunk] = sum;
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

void Motion::set_out(const Cell& cell, const Vec3& gravity, double damping, double dt, const Bodies& bodies) {
  push_ = {damping,
           dt,
           bodies.gyration,
           {},
           cell.velocity_gradient(),
           !gravity.isZero(0.0),
           !cell.velocity_gradient().isZero(0.0),
           moved_.size() == 1};
  for (std::size_t a = 0; a < push_.gravity.size(); ++a) push_.gravity[a].fill(gravity[static_cast<Eigen::Index>(a)]);
}

void Motion::advance(std::size_t chunk, Bodies& bodies) {
  const MoveGrains move = bodies.dimension == 2 ? how_.in_plane : how_.in_space;
  const std::size_t begin = first_grain(chunk, bodies), end = first_grain(chunk + 1, bodies);
  const std::size_t rest = (end - begin) % how_.at_once, whole = end - rest;
  const MovedGrains all{bodies.grains.data(), bodies.loads.data(), bodies.angle.data(), bodies.per_leeway2.data()};
  MotionTally tally;
  move(push_, all, begin, whole, tally);
  if (rest > 0) {
    // The last few grains are moved together with dummies, which are at rest and have no weight.
    Push last = push_;
    std::array<Grain, 8> few;
    const Lane4 unit{0, 0, 0, 1};
    few.fill({unit, unit, unit, unit});
    std::array<Load, 8> on_few{};
    for (auto& along : last.gravity) std::fill(along.begin() + rest, along.end(), 0.0);
    std::array<double, 8> angle_of_few{}, per_leeway2_of_few{};
    const bool planar = bodies.dimension == 2;
    for (std::size_t k = 0; k < rest; ++k) {
      few[k] = bodies.grains[whole + k], on_few[k] = std::exchange(bodies.loads[whole + k], {});
      per_leeway2_of_few[k] = bodies.per_leeway2[whole + k];
      if (planar) angle_of_few[k] = bodies.angle[whole + k];
    }
    move(last, {few.data(), on_few.data(), angle_of_few.data(), per_leeway2_of_few.data()}, 0, how_.at_once, tally);
    for (std::size_t k = 0; k < rest; ++k) {
      bodies.grains[whole + k] = few[k];
      if (planar) bodies.angle[whole + k] = angle_of_few[k];
    }
  }
  moved_[chunk] = tally;
}

void Motion::advance_all(Bodies& bodies) {
  pass([&](std::size_t chunk) { advance(chunk, bodies); });
}

MotionSums Motion::advanced() const {
  MotionTally all_chunks;
  for (const MotionTally& m : moved_) {
    all_chunks.damping += m.damping;
    all_chunks.gravity_work += m.gravity_work;
    all_chunks.fastest2 = std::max(all_chunks.fastest2, m.fastest2);
    all_chunks.skin_rate2 = std::max(all_chunks.skin_rate2, m.skin_rate2);
  }
  const auto sum = [](const Lane4& l) { return l[0] + l[1] + l[2] + l[3]; };
  const double half = 0.5 * push_.dt;
  return {half * sum(all_chunks.damping), half * sum(all_chunks.gravity_work), std::sqrt(all_chunks.fastest2),
          std::sqrt(all_chunks.skin_rate2)};
}

double Motion::gain_bound(double smallest_mass) const {
  Lane4 force{};
  for (const Collected& c : collected_) force = maximum(force, c.force);
  const auto length = [](double x2, double y2, double z2) { return std::sqrt(x2 + y2 + z2); };
  const double gx = push_.gravity[0][0], gy = push_.gravity[1][0], gz = push_.gravity[2][0];
  const double acceleration = length(force[0], force[1], force[2]) / smallest_mass + length(gx * gx, gy * gy, gz * gz);
  return push_.dt * (1 + push_.damping) * acceleration;
}

double Motion::stable_time_step(const Contacts& contacts, Bodies& bodies) {
  const bool planar = bodies.dimension == 2;
  pass([&](std::size_t chunk) {
    collect_singles(contacts, chunk, bodies, bodies.stiffness);
    double largest = 0;
    for (std::size_t i = first_grain(chunk, bodies), end = first_grain(chunk + 1, bodies); i < end; ++i) {
      Load& stiffness = bodies.stiffness[i];
      const Lane4 &k = stiffness.force, &about = stiffness.torque;
      const double along = std::max({k[0], k[1], planar ? 0 : k[2]});
      const double rotation = planar ? k[2] : std::max({about[0], about[1], about[2]});
      largest = std::max({largest, along / bodies.mass(i), rotation / bodies.inertia(i)});
      stiffness.force = stiffness.torque = Lane4{};
    }
    partial_[chunk] = largest;
  });
  const double largest = *std::max_element(partial_.begin(), partial_.end());
  return largest > 0 ? std::numbers::sqrt2 / std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

Slowed slow(Bodies& bodies, double share, const Vec3& gravity, double dt, int threads) {
  const Lane4 g = row(gravity, 0);
  return sum_in_parallel(bodies.size(), grains_per_chunk, threads, [&](std::size_t i) {
    Slowed one;
    one.energy_before = kinetic_energy_of(i, bodies, g, dt);
    bodies.set_velocity(i, share * vector_of(bodies.velocity(i)));
    bodies.set_spin(i, share * vector_of(bodies.spin(i)));
    one.energy_after = kinetic_energy_of(i, bodies, g, dt);
    return one;
  });
}

double kinetic_energy(const Bodies& bodies, const Vec3& gravity, double dt, int threads) {
  const Lane4 g = row(gravity, 0);
  return sum_in_parallel(bodies.size(), grains_per_chunk, threads,
                         [&](std::size_t i) { return kinetic_energy_of(i, bodies, g, dt); });
}

double kinetic_energy_of_acted_on(const Bodies& bodies, const Vec3& gravity, double dt, int threads) {
  const Lane4 g = row(gravity, 0);
  return sum_in_parallel(bodies.size(), grains_per_chunk, threads, [&](std::size_t i) {
    const bool acted_on = length2(resultant(bodies, i, g)) > 0 || length2(bodies.torque(i)) > 0;
    return acted_on ? kinetic_energy_of(i, bodies, g, dt) : 0.0;
  });
}

}  // namespace soilweave::dem
