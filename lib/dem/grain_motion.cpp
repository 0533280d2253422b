// How forces move grains in a step. Compiled once for either width (vector_width.cpp); the same order of operations on
// every grain, and of sums, gives the same bits.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/grain_motion.h"

#include <algorithm>
#include <utility>

#include "core/columns.h"
#include "core/v2.h"
#include "core/v3.h"

namespace soilweave::dem {
namespace {

constexpr int at_once = width<Lanes>;

// Force damped, velocity advanced by dt/mass. Adds to `lost` what the damping took, over half a step.
Lanes kick(const Lanes& force, const Lanes& ratio, const Lanes& damping, const Lanes& velocity, Lanes& lost) {
  const Lanes zero{}, change = ratio * force;
  const Lanes power = force * fused(all<Lanes>(0.5), change, velocity);
  const Lanes side = keep(power > zero, damping) - keep(power < zero, damping);
  const Lanes after = fused(change, 1.0 - side, velocity);
  lost = fused(Lanes(side * force), velocity + after, lost);
  return after;
}
V3<Lanes> kick(const V3<Lanes>& f, const Lanes& ratio, const Lanes& damping, const V3<Lanes>& v, Lanes& lost) {
  const Lanes x = kick(f.x, ratio, damping, v.x, lost), y = kick(f.y, ratio, damping, v.y, lost);
  return {x, y, kick(f.z, ratio, damping, v.z, lost)};
}
V2<Lanes> kick(const V2<Lanes>& f, const Lanes& ratio, const Lanes& damping, const V2<Lanes>& v, Lanes& lost) {
  const Lanes x = kick(f.x, ratio, damping, v.x, lost);
  return {x, kick(f.y, ratio, damping, v.y, lost)};
}

V3<Lanes> affine(const Mat3& g, const V3<Lanes>& x, const V3<Lanes>& v) {
  const auto component = [&](int i, const Lanes& to) {
    return fused(all<Lanes>(g(i, 2)), x.z, fused(all<Lanes>(g(i, 1)), x.y, fused(all<Lanes>(g(i, 0)), x.x, to)));
  };
  return {component(0, v.x), component(1, v.y), component(2, v.z)};
}
V2<Lanes> affine(const Mat3& g, const V2<Lanes>& x, const V2<Lanes>& v) {
  const auto component = [&](int i, const Lanes& to) {
    return fused(all<Lanes>(g(i, 1)), x.y, fused(all<Lanes>(g(i, 0)), x.x, to));
  };
  return {component(0, v.x), component(1, v.y)};
}

// Of unit length again by one Newton step: the length is off by the square of half the angle turned.
Columns<Lanes> unit(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  const Lanes square = fused(d, d, fused(c, c, fused(b, b, Lanes(a * a))));
  const Lanes scale = fused_less(all<Lanes>(0.5), square, all<Lanes>(1.5));
  return {scale * a, scale * b, scale * c, scale * d};
}

// Rows of grains, read as columns and written back.
struct InSpace {
  using Vector = V3<Lanes>;
  Grain* grains;
  Load* loads;

  InSpace(const MovedGrains& of, std::size_t i) : grains(of.grains + i), loads(of.loads + i) {}

  static Vector part(const V3<Lanes>& of_space) { return of_space; }
  static Columns<Lanes> read(const auto& row) {
    return columns({rows<Lanes>(row, 0), rows<Lanes>(row, 1), rows<Lanes>(row, 2), rows<Lanes>(row, 3)});
  }
  template <Lane4 Grain::*row>
  std::pair<Vector, Lanes> read() const {
    const Columns<Lanes> c = read([this](int k) -> const Lane4& { return grains[k].*row; });
    return {{c.a, c.b, c.c}, c.d};
  }
  template <Lane4 Load::*row>
  Vector of_loads() const {
    const Columns<Lanes> c = read([this](int k) -> const Lane4& { return loads[k].*row; });
    return {c.a, c.b, c.c};
  }
  template <Lane4 Grain::*row>
  void put(const Vector& v, const Lanes& scalar) const {
    to_rows(v.x, v.y, v.z, scalar, [this](int k, const Lane4& value) { grains[k].*row = value; });
  }
  Vector force() const { return of_loads<&Load::force>(); }
  Vector torque() const { return of_loads<&Load::torque>(); }
  void use_up() const {
    // Not `loads[k] = {}`, of which the compiler would make one string instruction, slower than all before it.
    for (int k = 0; k < at_once; ++k) loads[k].force = loads[k].torque = Lane4{};
  }
  std::pair<Vector, Lanes> velocity_and_mass() const { return read<&Grain::velocity>(); }
  void put_velocity(const Vector& v, const Lanes& mass) const { put<&Grain::velocity>(v, mass); }
  std::pair<Vector, Lanes> spin_and_radius() const { return read<&Grain::spin>(); }
  void put_spin(const Vector& spin, const Lanes& radius) const { put<&Grain::spin>(spin, radius); }
  std::pair<Vector, Lanes> position_and_radius() const { return read<&Grain::position>(); }
  void put_position(const Vector& x, const Lanes& radius) const { put<&Grain::position>(x, radius); }
  // q <- (1, half the turn) q.
  void turn(const Vector& by) const {
    const Vector half = all<Lanes>(0.5) * by;
    const Columns<Lanes> q = read([this](int k) -> const Lane4& { return grains[k].orientation; });
    const Lanes a = fused_less(half.z, q.d, fused_less(half.y, q.c, fused_less(half.x, q.b, q.a)));
    const Lanes b = fused_less(half.z, q.c, fused(half.y, q.d, fused(half.x, q.a, q.b)));
    const Lanes c = fused(half.z, q.b, fused(half.y, q.a, fused_less(half.x, q.d, q.c)));
    const Lanes d = fused(half.z, q.a, fused_less(half.y, q.b, fused(half.x, q.c, q.d)));
    const Columns<Lanes> turned = unit(a, b, c, d);
    to_rows(turned.a, turned.b, turned.c, turned.d, [this](int k, const Lane4& row) { grains[k].orientation = row; });
  }
};

// Disks have halves of rows to read and write: they are not pushed out of their plane, nor turned out of it.
struct InPlane {
  using Vector = V2<Lanes>;
  Grain* grains;
  Load* loads;
  double* angle;

  InPlane(const MovedGrains& of, std::size_t i) : grains(of.grains + i), loads(of.loads + i), angle(of.angle + i) {}

  static Vector part(const V3<Lanes>& of_space) { return {of_space.x, of_space.y}; }
  static Halves<Lanes> read(const auto& half) {
    Lane4 piece[at_once / 2];
    for (int i = 0; i < at_once / 2; ++i) piece[i] = halves<Lanes>(half, i);
    return columns_of_halves<Lanes>(piece);
  }
  template <int from>
  Halves<Lanes> of_forces() const {
    return read([this](int k) { return reinterpret_cast<const double*>(&loads[k].force) + from; });
  }
  template <Lane4 Grain::*row, int from>
  Halves<Lanes> read() const {
    return read([this](int k) { return reinterpret_cast<const double*>(&(grains[k].*row)) + from; });
  }
  template <Lane4 Grain::*row, int from>
  void put(const Lanes& a, const Lanes& b) const {
    to_halves(a, b, [this](int k) { return reinterpret_cast<double*>(&(grains[k].*row)) + from; });
  }
  Vector force() const {
    const auto f = of_forces<0>();
    return {f.a, f.b};
  }
  Lanes torque() const { return of_forces<2>().a; }
  void use_up() const {
    for (int k = 0; k < at_once; ++k) loads[k].force = Lane4{};
  }
  std::pair<Vector, Lanes> velocity_and_mass() const {
    const auto v = read<&Grain::velocity, 0>();
    return {{v.a, v.b}, read<&Grain::velocity, 2>().b};
  }
  void put_velocity(const Vector& v, const Lanes&) const { put<&Grain::velocity, 0>(v.x, v.y); }
  std::pair<Lanes, Lanes> spin_and_radius() const {
    const auto s = read<&Grain::spin, 2>();
    return {s.a, s.b};
  }
  void put_spin(const Lanes& spin, const Lanes& radius) const { put<&Grain::spin, 2>(spin, radius); }
  std::pair<Vector, Lanes> position_and_radius() const {
    const auto x = read<&Grain::position, 0>();
    return {{x.a, x.b}, Lanes{}};
  }
  void put_position(const Vector& x, const Lanes&) const { put<&Grain::position, 0>(x.x, x.y); }
  void turn(const Lanes& by) const { store(angle, Lanes(load<Lanes>(angle) + by)); }
};

double largest_of(const Lane4& x) { return std::max({x[0], x[1], x[2], x[3]}); }
#ifdef SOILWEAVE_EIGHT_LANES
void add_up(Lane4& sum, const Lane8& of_grains) { sum += low(of_grains), sum += high(of_grains); }
double largest(const Lane8& x) { return std::max(largest_of(low(x)), largest_of(high(x))); }
#else
void add_up(Lane4& sum, const Lane4& of_grains) { sum += of_grains; }
double largest(const Lane4& x) { return largest_of(x); }
#endif

// What is moved three rounds later, 24 grains at the width of eight: the hardware begins anew at every chunk and page.
void call_for(const MovedGrains& at, std::size_t i) {
  constexpr std::size_t ahead = 24, line = 64;
  for (std::size_t k = i + ahead; k < i + ahead + at_once; ++k) {
    const char* const grain = reinterpret_cast<const char*>(at.grains + k);
    __builtin_prefetch(grain, 1), __builtin_prefetch(grain + line, 1);
    __builtin_prefetch(at.loads + k, 1);
  }
}

// Sums stay in registers: through memory each addition would wait for the one before it to be stored.
template <class Rows>
[[gnu::flatten]] void move(const Push& push, const MovedGrains at, std::size_t begin, std::size_t end,
                           MotionTally& tally) {
  using Vector = typename Rows::Vector;
  const Lanes dt = all<Lanes>(push.dt), damping = all<Lanes>(push.damping), gyration = all<Lanes>(push.gyration);
  const Vector gravity = Rows::part(
      {load<Lanes>(push.gravity[0].data()), load<Lanes>(push.gravity[1].data()), load<Lanes>(push.gravity[2].data())});
  const bool heavy = push.heavy, deforming = push.deforming;
  Lane4 all_lost = tally.damping, gravity_work = tally.gravity_work;
  Lanes fastest{}, haste{};
  for (std::size_t i = begin; i < end; i += at_once) {
    const Rows of(at, i);
    call_for(at, i);
    Vector force = of.force();
    const auto torque = of.torque();
    of.use_up();
    const auto [before, mass] = of.velocity_and_mass();
    const auto [spin, radius] = of.spin_and_radius();
    // One division for both.
    const Lanes shape = gyration * radius * radius, spin_ratio = dt / (mass * shape), ratio = spin_ratio * shape;
    const Vector pull = mass * gravity;
    if (heavy) force = force + pull;
    Lanes lost{};
    const Vector v = kick(force, ratio, damping, before, lost);
    if (heavy) add_up(gravity_work, dot(pull, before + v));
    const Lanes speed2 = norm2(v);
    fastest = maximum(fastest, speed2), haste = maximum(haste, Lanes(speed2 * load<Lanes>(at.per_leeway2 + i)));
    of.put_velocity(v, mass);

    const auto w = kick(torque, spin_ratio, damping, spin, lost);
    of.put_spin(w, radius);
    of.turn(dt * w);
    add_up(all_lost, lost);

    const auto [x, r] = of.position_and_radius();
    of.put_position(fused(dt, deforming ? affine(push.gradient, x, v) : v, x), r);
  }
  tally.damping = all_lost, tally.gravity_work = gravity_work;
  tally.fastest2 = std::max(tally.fastest2, largest(fastest));
  tally.haste2 = std::max(tally.haste2, largest(haste));
}

}  // namespace

#ifdef SOILWEAVE_EIGHT_LANES
GrainMotion grain_motion_of_eight() {
#else
GrainMotion grain_motion_of_four() {
#endif
  return {move<InSpace>, move<InPlane>, at_once};
}

}  // namespace soilweave::dem
