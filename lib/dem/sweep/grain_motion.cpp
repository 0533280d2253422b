// Moves grains by their forces over one step. This file is compiled once per width (vector_width.cpp). Bits do not
// depend on the width, because the order of operations and sums is the same.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/grain_motion.h"

#include <algorithm>
#include <utility>

#include "core/simd/columns.h"
#include "core/simd/v2.h"
#include "core/simd/v3.h"

namespace soilweave::dem {
namespace {

constexpr int at_once = width<Lanes>;

// Local damping: a force that speeds a grain up loses the share `taken` and keeps `less`. A force that slows it down
// gains the share -`added` and becomes `more`.
struct Damping {
  explicit Damping(double part)
      : taken(broadcast<Lanes>(part)), added(broadcast<Lanes>(-part)), less(1.0 - taken), more(1.0 - added) {}
  Lanes taken, added, less, more;
};

// Returns the velocity after a damped force over dt/mass. Adds the energy taken by damping to `lost`, over half a step.
Lanes kick(const Lanes& force, const Lanes& ratio, const Damping& damping, const Lanes& velocity, Lanes& lost) {
  const Lanes zero{}, change = ratio * force;
  const Lanes power = force * fused(broadcast<Lanes>(0.5), change, velocity);
  // Zero power almost always means zero force, so it needs no comparison of its own.
  const Mask<Lanes> slower = power < zero;
  const Lanes share = select<Lanes>(slower, damping.more, damping.less);
  const Lanes taken = select<Lanes>(slower, damping.added, damping.taken);
  const Lanes after = fused(change, share, velocity);
  lost = fused(Lanes(taken * force), velocity + after, lost);
  return after;
}
V3<Lanes> kick(const V3<Lanes>& f, const Lanes& ratio, const Damping& damping, const V3<Lanes>& v, Lanes& lost) {
  const Lanes x = kick(f.x, ratio, damping, v.x, lost), y = kick(f.y, ratio, damping, v.y, lost);
  return {x, y, kick(f.z, ratio, damping, v.z, lost)};
}
V2<Lanes> kick(const V2<Lanes>& f, const Lanes& ratio, const Damping& damping, const V2<Lanes>& v, Lanes& lost) {
  const Lanes x = kick(f.x, ratio, damping, v.x, lost);
  return {x, kick(f.y, ratio, damping, v.y, lost)};
}

V3<Lanes> affine(const Mat3& g, const V3<Lanes>& x, const V3<Lanes>& v) {
  const auto component = [&](int i, const Lanes& to) {
    return fused(broadcast<Lanes>(g(i, 2)), x.z,
                 fused(broadcast<Lanes>(g(i, 1)), x.y, fused(broadcast<Lanes>(g(i, 0)), x.x, to)));
  };
  return {component(0, v.x), component(1, v.y), component(2, v.z)};
}
V2<Lanes> affine(const Mat3& g, const V2<Lanes>& x, const V2<Lanes>& v) {
  const auto component = [&](int i, const Lanes& to) {
    return fused(broadcast<Lanes>(g(i, 1)), x.y, fused(broadcast<Lanes>(g(i, 0)), x.x, to));
  };
  return {component(0, v.x), component(1, v.y)};
}

// Scales quaternions to unit length by one Newton step. Its error is 3/8 of the fourth power of half the angle turned.
// Beyond 0.077 rad in a step an error of 1e-6 would show in files, so the length is computed in full.
Columns<Lanes> unit(const Lanes& a, const Lanes& b, const Lanes& c, const Lanes& d) {
  constexpr double newton_suffices = 1.0015;  // squared length
  const Lanes square = fused(d, d, fused(c, c, fused(b, b, Lanes(a * a))));
  Lanes scale = fused_less(broadcast<Lanes>(0.5), square, broadcast<Lanes>(1.5));
  const Mask<Lanes> fast = square > broadcast<Lanes>(newton_suffices);
  if (any(fast)) [[unlikely]]
    scale = select<Lanes>(fast, 1.0 / square_root(square), scale);
  return {scale * a, scale * b, scale * c, scale * d};
}

// Forces and torques on grains, with their motion.
template <class Vector, class Turn>
struct Acting {
  Vector force;
  Turn torque;
};
template <class Vector, class Turn>
struct Moving {
  Vector velocity;
  Turn spin;
  Lanes mass, radius;
};

// Step over mass, and over moment of inertia.
struct Ratios {
  Lanes move, turn;
};

Columns<Lanes> read_rows(const auto& row) {
  return columns({rows<Lanes>(row, 0), rows<Lanes>(row, 1), rows<Lanes>(row, 2), rows<Lanes>(row, 3)});
}

// Rows of spheres, read as columns and written back.
struct InSpace {
  using Vector = V3<Lanes>;
  Grain* grains;
  Load* loads;

  InSpace(const MovedGrains& of, std::size_t i) : grains(of.grains + i), loads(of.loads + i) {}

  static Vector part(const V3<Lanes>& of_space) { return of_space; }
  Acting<Vector, Vector> acting() const {
    const Columns<Lanes> f = read_rows([this](int k) -> const Lane4& { return loads[k].force; });
    const Columns<Lanes> t = read_rows([this](int k) -> const Lane4& { return loads[k].torque; });
    return {{f.a, f.b, f.c}, {t.a, t.b, t.c}};
  }
  void use_up() const {
    // `loads[k] = {}` would compile to a string instruction, slower than everything before it.
    for (int k = 0; k < at_once; ++k) loads[k].force = loads[k].torque = Lane4{};
  }
  Moving<Vector, Vector> moving() const {
    const Columns<Lanes> v = read<&Grain::velocity>(), w = read<&Grain::spin>();
    return {{v.a, v.b, v.c}, {w.a, w.b, w.c}, v.d, w.d};
  }
  void put(const Moving<Vector, Vector>& m) const {
    put<&Grain::velocity>(m.velocity, m.mass), put<&Grain::spin>(m.spin, m.radius);
  }
  std::pair<Lanes, Lanes> mass_and_radius() const { return {read<&Grain::velocity>().d, read<&Grain::spin>().d}; }
  Vector place() const {
    const Columns<Lanes> x = read<&Grain::position>();
    return {x.a, x.b, x.c};
  }
  void put_place(const Vector& x, const Lanes& radius) const { put<&Grain::position>(x, radius); }
  // q <- (1, half the rotation) q.
  void turn(const Vector& by) const {
    const Vector half = broadcast<Lanes>(0.5) * by;
    const Columns<Lanes> q = read<&Grain::orientation>();
    const Lanes a = fused_less(half.z, q.d, fused_less(half.y, q.c, fused_less(half.x, q.b, q.a)));
    const Lanes b = fused_less(half.z, q.c, fused(half.y, q.d, fused(half.x, q.a, q.b)));
    const Lanes c = fused(half.z, q.b, fused(half.y, q.a, fused_less(half.x, q.d, q.c)));
    const Lanes d = fused(half.z, q.a, fused_less(half.y, q.b, fused(half.x, q.c, q.d)));
    const Columns<Lanes> turned = unit(a, b, c, d);
    to_rows(turned.a, turned.b, turned.c, turned.d, [this](int k, const Lane4& row) { grains[k].orientation = row; });
  }

 private:
  template <Lane4 Grain::*row>
  Columns<Lanes> read() const {
    return read_rows([this](int k) -> const Lane4& { return grains[k].*row; });
  }
  template <Lane4 Grain::*row>
  void put(const Vector& v, const Lanes& scalar) const {
    to_rows(v.x, v.y, v.z, scalar, [this](int k, const Lane4& value) { grains[k].*row = value; });
  }
};

// Rows of disks: force and motion have three components each, the third one for rotation.
struct InPlane {
  using Vector = V2<Lanes>;
  Grain* grains;
  Load* loads;
  double* angle;

  InPlane(const MovedGrains& of, std::size_t i) : grains(of.grains + i), loads(of.loads + i), angle(of.angle + i) {}

  static Vector part(const V3<Lanes>& of_space) { return {of_space.x, of_space.y}; }
  Acting<Vector, Lanes> acting() const {
    const Columns<Lanes> f = read_rows([this](int k) -> const Lane4& { return loads[k].force; });
    return {{f.a, f.b}, f.c};
  }
  void use_up() const {
    for (int k = 0; k < at_once; ++k) loads[k].force = Lane4{};
  }
  Moving<Vector, Lanes> moving() const {
    const Columns<Lanes> v = velocity();
    return {{v.a, v.b}, v.c, v.d, position().d};
  }
  std::pair<Lanes, Lanes> mass_and_radius() const { return {velocity().d, position().d}; }
  void put(const Moving<Vector, Lanes>& m) const {
    to_rows(m.velocity.x, m.velocity.y, m.spin, m.mass, [this](int k, const Lane4& row) { grains[k].velocity = row; });
  }
  Vector place() const {
    const Columns<Lanes> x = position();
    return {x.a, x.b};
  }
  void put_place(const Vector& x, const Lanes&) const {
    to_halves(x.x, x.y, [this](int k) { return reinterpret_cast<double*>(&grains[k].position); });
  }
  void turn(const Lanes& by) const { store(angle, Lanes(load<Lanes>(angle) + by)); }

 private:
  Columns<Lanes> velocity() const {
    return read_rows([this](int k) -> const Lane4& { return grains[k].velocity; });
  }
  Columns<Lanes> position() const {
    return read_rows([this](int k) -> const Lane4& { return grains[k].position; });
  }
};

double largest_of(const Lane4& x) { return std::max({x[0], x[1], x[2], x[3]}); }
#ifdef SOILWEAVE_EIGHT_LANES
void add_up(Lane4& sum, const Lane8& of_grains) { sum += low(of_grains), sum += high(of_grains); }
double largest(const Lane8& x) { return std::max(largest_of(low(x)), largest_of(high(x))); }
#else
void add_up(Lane4& sum, const Lane4& of_grains) { sum += of_grains; }
double largest(const Lane4& x) { return largest_of(x); }
#endif

// Prefetches the grains that come 24 later (three rounds at the width of eight), since the hardware prefetcher restarts
// at every chunk and page.
void call_for(const MovedGrains& at, std::size_t i) {
  constexpr std::size_t ahead = 24, line = 64;
  for (std::size_t k = i + ahead; k < i + ahead + at_once; ++k) {
    const char* const grain = reinterpret_cast<const char*>(at.grains + k);
    __builtin_prefetch(grain, 1), __builtin_prefetch(grain + line, 1);
    __builtin_prefetch(at.loads + k, 1);
  }
}

// Sums stay in registers: in memory each addition would wait until the one before is stored.
template <class Rows>
[[gnu::flatten]] void move(const Push& push, const MovedGrains at, std::size_t begin, std::size_t end,
                           MotionTally& tally) {
  using Vector = typename Rows::Vector;
  const Lanes dt = broadcast<Lanes>(push.dt), gyration = broadcast<Lanes>(push.gyration);
  const Damping damping(push.damping);
  // One division serves both ratios.
  const auto ratios_of = [&](const Rows& of) -> Ratios {
    const auto [mass, radius] = of.mass_and_radius();
    const Lanes shape = gyration * radius * radius, turn = dt / (mass * shape);
    return {turn * shape, turn};
  };
  const Vector gravity = Rows::part(
      {load<Lanes>(push.gravity[0].data()), load<Lanes>(push.gravity[1].data()), load<Lanes>(push.gravity[2].data())});
  const bool heavy = push.heavy, deforming = push.deforming, in_cache = push.in_cache;
  Lane4 all_lost = tally.damping, gravity_work = tally.gravity_work;
  Lanes fastest{}, skin_rate{};
  for (std::size_t i = begin; i < end; i += at_once) {
    const Rows of(at, i);
    if (!in_cache) call_for(at, i);
    // The division comes first, because all else waits for it. The rows are therefore read twice.
    const Ratios ratio = ratios_of(of);
    auto [force, torque] = of.acting();
    of.use_up();
    const auto [before, spin, mass, radius] = of.moving();
    const Vector pull = mass * gravity;
    if (heavy) force = force + pull;
    Lanes lost{};
    const Vector v = kick(force, ratio.move, damping, before, lost);
    if (heavy) add_up(gravity_work, dot(pull, before + v));
    const Lanes speed2 = norm2(v);
    fastest = maximum(fastest, speed2), skin_rate = maximum(skin_rate, Lanes(speed2 * load<Lanes>(at.per_leeway2 + i)));
    const auto w = kick(torque, ratio.turn, damping, spin, lost);
    of.put({v, w, mass, radius});
    of.turn(dt * w);
    add_up(all_lost, lost);

    const Vector x = of.place();
    of.put_place(fused(dt, deforming ? affine(push.gradient, x, v) : v, x), radius);
  }
  tally.damping = all_lost, tally.gravity_work = gravity_work;
  tally.fastest2 = std::max(tally.fastest2, largest(fastest));
  tally.skin_rate2 = std::max(tally.skin_rate2, largest(skin_rate));
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
