// From forces to motion. Sums over grains are made in fixed chunks, whatever the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

namespace soilweave::dem {
namespace {

Lane4 resultant(const Bodies& bodies, std::size_t i, const Lane4& gravity) {
  return bodies.force(i) + bodies.mass(i) * gravity;
}

// Adds the loads of single pairs, or their stiffnesses, to that of their grain and leaves them zero.
Load& collect_single(const Contacts& contacts, std::size_t i, LargeVector<Load>& loads) {
  Load& total = loads[i];
  for (std::uint32_t s = contacts.load_start[i]; s < contacts.load_start[i + 1]; ++s) {
    Load& one = loads[s];
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
  const Lane4 x = kick(f.x, ratio, damping, v.x, lost), y = kick(f.y, ratio, damping, v.y, lost);
  return {x, y, kick(f.z, ratio, damping, v.z, lost)};
}
V2<Lane4> kick(const V2<Lane4>& f, const Lane4& ratio, const Lane4& damping, const V2<Lane4>& v, Lane4& lost) {
  const Lane4 x = kick(f.x, ratio, damping, v.x, lost);
  return {x, kick(f.y, ratio, damping, v.y, lost)};
}

V3<Lane4> affine(const Mat3& g, const V3<Lane4>& x, const V3<Lane4>& v) {
  const auto component = [&](int i, const Lane4& to) {
    return fused(all<Lane4>(g(i, 2)), x.z, fused(all<Lane4>(g(i, 1)), x.y, fused(all<Lane4>(g(i, 0)), x.x, to)));
  };
  return {component(0, v.x), component(1, v.y), component(2, v.z)};
}
V2<Lane4> affine(const Mat3& g, const V2<Lane4>& x, const V2<Lane4>& v) {
  const auto component = [&](int i, const Lane4& to) {
    return fused(all<Lane4>(g(i, 1)), x.y, fused(all<Lane4>(g(i, 0)), x.x, to));
  };
  return {component(0, v.x), component(1, v.y)};
}

// Of unit length again by one Newton step: the length is off by the square of half the angle turned.
Columns<Lane4> unit(const Lane4& a, const Lane4& b, const Lane4& c, const Lane4& d) {
  const Lane4 square = fused(d, d, fused(c, c, fused(b, b, Lane4(a * a))));
  const Lane4 scale = fused_less(all<Lane4>(0.5), square, all<Lane4>(1.5));
  return {scale * a, scale * b, scale * c, scale * d};
}

// Rows of four grains, read as columns and written back.
struct FourInSpace {
  using Vector = V3<Lane4>;
  Grain* grains;
  Load* loads;

  static Vector part(const V3<Lane4>& of_space) { return of_space; }
  static std::pair<Vector, Lane4> read(const auto& row) {
    const Columns<Lane4> c = columns({row(0), row(1), row(2), row(3)});
    return {{c.a, c.b, c.c}, c.d};
  }
  static void put(const Vector& v, const Lane4& scalar, const auto& row) {
    to_rows(v.x, v.y, v.z, scalar, [&row](int i, const Lane4& value) { row(i) = value; });
  }
  Vector force() const {
    return read([this](int i) { return loads[i].force; }).first;
  }
  Vector torque() const {
    return read([this](int i) { return loads[i].torque; }).first;
  }
  void use_up() const {
    // Not `loads[i] = {}`, of which the compiler would make one string instruction, slower than all before it.
    for (int i = 0; i < width<Lane4>; ++i) loads[i].force = loads[i].torque = Lane4{};
  }
  std::pair<Vector, Lane4> velocity_and_mass() const {
    return read([this](int i) { return grains[i].velocity; });
  }
  void put_velocity(const Vector& v, const Lane4& mass) const {
    put(v, mass, [this](int i) -> Lane4& { return grains[i].velocity; });
  }
  std::pair<Vector, Lane4> spin_and_radius() const {
    return read([this](int i) { return grains[i].spin; });
  }
  void put_spin(const Vector& spin, const Lane4& radius) const {
    put(spin, radius, [this](int i) -> Lane4& { return grains[i].spin; });
  }
  std::pair<Vector, Lane4> position_and_radius() const {
    return read([this](int i) { return grains[i].position; });
  }
  void put_position(const Vector& x, const Lane4& radius) const {
    put(x, radius, [this](int i) -> Lane4& { return grains[i].position; });
  }
  // q <- (1, half) q.
  void turn(const Vector& half) const {
    const Columns<Lane4> q =
        columns({grains[0].orientation, grains[1].orientation, grains[2].orientation, grains[3].orientation});
    const Lane4 a = fused_less(half.z, q.d, fused_less(half.y, q.c, fused_less(half.x, q.b, q.a)));
    const Lane4 b = fused_less(half.z, q.c, fused(half.y, q.d, fused(half.x, q.a, q.b)));
    const Lane4 c = fused(half.z, q.b, fused(half.y, q.a, fused_less(half.x, q.d, q.c)));
    const Lane4 d = fused(half.z, q.a, fused_less(half.y, q.b, fused(half.x, q.c, q.d)));
    const Columns<Lane4> turned = unit(a, b, c, d);
    to_rows(turned.a, turned.b, turned.c, turned.d, [this](int i, const Lane4& row) { grains[i].orientation = row; });
  }
};

// Disks have halves of rows to read and write: they are not pushed out of their plane, nor turned out of it.
struct FourInPlane {
  using Vector = V2<Lane4>;
  Grain* grains;
  Load* loads;

  static Vector part(const V3<Lane4>& of_space) { return {of_space.x, of_space.y}; }
  static Halves<Lane4> half_columns(const auto& half) {
    return columns_of_halves<Lane4>({halves<Lane4>(half, 0), halves<Lane4>(half, 1)});
  }
  template <Lane4 Load::*row, int from>
  Halves<Lane4> of_loads() const {
    return half_columns([this](int i) { return reinterpret_cast<const double*>(&(loads[i].*row)) + from; });
  }
  template <Lane4 Grain::*row, int from>
  Halves<Lane4> read() const {
    return half_columns([this](int i) { return reinterpret_cast<const double*>(&(grains[i].*row)) + from; });
  }
  template <Lane4 Grain::*row, int from>
  void put(const Lane4& a, const Lane4& b) const {
    to_halves(a, b, [this](int i) { return reinterpret_cast<double*>(&(grains[i].*row)) + from; });
  }
  Vector force() const {
    const auto f = of_loads<&Load::force, 0>();
    return {f.a, f.b};
  }
  Lane4 torque() const { return of_loads<&Load::force, 2>().a; }
  void use_up() const {
    for (int i = 0; i < width<Lane4>; ++i) loads[i].force = Lane4{};
  }
  std::pair<Vector, Lane4> velocity_and_mass() const {
    const auto v = read<&Grain::velocity, 0>();
    return {{v.a, v.b}, read<&Grain::velocity, 2>().b};
  }
  void put_velocity(const Vector& v, const Lane4&) const { put<&Grain::velocity, 0>(v.x, v.y); }
  std::pair<Lane4, Lane4> spin_and_radius() const {
    const auto s = read<&Grain::spin, 2>();
    return {s.a, s.b};
  }
  void put_spin(const Lane4& spin, const Lane4& radius) const { put<&Grain::spin, 2>(spin, radius); }
  std::pair<Vector, Lane4> position_and_radius() const {
    const auto x = read<&Grain::position, 0>();
    return {{x.a, x.b}, Lane4{}};
  }
  void put_position(const Vector& x, const Lane4&) const { put<&Grain::position, 0>(x.x, x.y); }
  void turn(const Lane4& half) const {
    const auto ab = read<&Grain::orientation, 0>(), cd = read<&Grain::orientation, 2>();
    const Columns<Lane4> turned = unit(fused_less(half, cd.b, ab.a), fused_less(half, cd.a, ab.b),
                                       fused(half, ab.b, cd.a), fused(half, ab.a, cd.b));
    put<&Grain::orientation, 0>(turned.a, turned.b), put<&Grain::orientation, 2>(turned.c, turned.d);
  }
};

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
  collected_[chunk] = bodies.dimension == 2 ? collect<2>(chunk, contacts, bodies) : collect<3>(chunk, contacts, bodies);
}

template <int dimension>
Motion::Collected Motion::collect(std::size_t chunk, const Contacts& contacts, Bodies& bodies) {
  const bool nodes = !bodies.fabric.empty();
  Collected sums;
  for (std::size_t i = first_of(chunk, bodies), end = first_of(chunk + 1, bodies); i < end; ++i) {
    Load& load = collect_single(contacts, i, bodies.loads);
    if (nodes && bodies.is_node(i)) load.torque = Lane4{};  // nodes do not rotate
    const Lane4& x = bodies.grains[i].position;
    for (int a = 0; a < dimension; ++a) sums.virial[a] = fused(all<Lane4>(x[a]), load.force, sums.virial[a]);
    sums.force = maximum(sums.force, Lane4(load.force * load.force));
  }
  if (dimension == 2) {  // what the torque, third in the row, has added
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
    for (std::size_t i = first_of(chunk, bodies), end = first_of(chunk + 1, bodies); i < end; ++i)
      sum += std::sqrt(length2(resultant(bodies, i, g)));
    partial_[chunk] = sum;
  });
  return std::accumulate(partial_.begin(), partial_.end(), 0.0);
}

// One step of a multiple of four grains; their loads are used up. Sums go on from those before: in registers, since
// through memory each addition would wait for the one before it to be stored.
template <class Four>
[[gnu::flatten]] Motion::Moved Motion::advance(const Push& push, Grain* grains, const Grain* end, Load* loads,
                                               const Moved& before) {
  using Vector = typename Four::Vector;
  Lane4 lost = before.damping, gravity_work = before.gravity_work, fastest = before.fastest;
  for (; grains != end; grains += width<Lane4>, loads += width<Lane4>) {
    const Four four{grains, loads};
    Vector force = four.force();
    const auto torque = four.torque();
    four.use_up();
    const auto [v_before, mass] = four.velocity_and_mass();
    const Lane4 ratio = push.dt / mass;
    const Vector pull = mass * Four::part(push.gravity);
    if (push.heavy) force = force + pull;
    const Vector v = kick(force, ratio, push.damping, v_before, lost);
    if (push.heavy) gravity_work += dot(pull, v_before + v);
    fastest = maximum(fastest, norm2(v));
    four.put_velocity(v, mass);

    const auto [spin, radius] = four.spin_and_radius();
    const Lane4 spin_ratio = ratio / (push.gyration * radius * radius);
    const auto w = kick(torque, spin_ratio, push.damping, spin, lost);
    four.put_spin(w, radius);
    four.turn(Lane4(0.5 * push.dt) * w);

    const auto [x, r] = four.position_and_radius();
    four.put_position(fused(push.dt, push.deforming ? affine(push.gradient, x, v) : v, x), r);
  }
  return {lost, gravity_work, fastest};
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
  const auto move = push_.planar ? &Motion::advance<FourInPlane> : &Motion::advance<FourInSpace>;
  const std::size_t begin = first_of(chunk, bodies), end = first_of(chunk + 1, bodies);
  const std::size_t rest = (end - begin) % width<Lane4>, whole = end - rest;
  Grain* const grains = bodies.grains.data();
  Load* const loads = bodies.loads.data();
  moved_[chunk] = move(push_, grains + begin, grains + whole, loads + begin, {});
  if (rest == 0) return;
  // The last few, beside grains at rest that do not fall.
  Push last = push_;
  for (std::size_t k = rest; k < width<Lane4>; ++k) last.gravity.x[k] = last.gravity.y[k] = last.gravity.z[k] = 0;
  const Lane4 unit_row{0, 0, 0, 1};
  std::array<Grain, 4> few;
  few.fill({unit_row, unit_row, unit_row, unit_row});
  std::array<Load, 4> on_few;
  for (std::size_t k = 0; k < rest; ++k) few[k] = grains[whole + k], on_few[k] = std::exchange(loads[whole + k], {});
  moved_[chunk] = move(last, few.data(), few.data() + few.size(), on_few.data(), moved_[chunk]);
  std::copy_n(few.begin(), rest, grains + whole);
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
  const bool planar = bodies.dimension == 2;
  pass([&](std::size_t chunk) {
    Lane4 largest{};
    for (std::size_t i = first_of(chunk, bodies), end = first_of(chunk + 1, bodies); i < end; ++i) {
      Load& stiffness = collect_single(contacts, i, bodies.stiffness);
      if (planar) {
        stiffness.torque = Lane4{0, 0, stiffness.force[2], 0};
        stiffness.force[2] = 0;
      }
      largest = maximum(largest,
                        maximum(Lane4(stiffness.force / bodies.mass(i)), Lane4(stiffness.torque / bodies.inertia(i))));
      stiffness = {};
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
    const Lane4 w = bodies.grains[i].spin + (0.5 * dt / inertia) * bodies.torque(i);
    sum += 0.5 * m * length2(v);
    if (std::isfinite(inertia)) sum += 0.5 * inertia * length2(w);
  }
  return sum;
}

}  // namespace soilweave::dem
