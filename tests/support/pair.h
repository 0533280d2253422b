// Two spheres on prescribed or free paths with one contact: the minimum for the test of a law.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include "dem/contact/contact_kinematics.h"
#include "dem/contact/laws.h"
#include "dem/contact/transport.h"

namespace soilweave::dem::test {

inline constexpr double degree = std::numbers::pi / 180;

struct Body {
  double radius = 3e-3, mass = 1e-4;
  V3<double> x{0, 0, 0}, v{0, 0, 0}, w{0, 0, 0};  // positions; velocities that led there
};

/// The contact of two bodies, with the history that a simulation would keep.
template <class Law>
struct Pair {
  typename Law::MaterialPair mixed;
  Body one, two;
  HistoryOf<Law, double> history{};
  bool touching = false;
  V3<double> normal{};
  Kinematics<double> kinematics{};
  Response<double> response{};
  ContactEnergies<double> energies{};

  Kinematics<double> motion(double dt) const {
    const V3<double> d = two.x - one.x;
    PairMotion<double> m;
    m.velocity = two.v - one.v;
    m.spin_1 = one.w, m.spin_2 = two.w;
    m.lever_1 = one.radius, m.lever_2 = two.radius;
    const double distance = norm(d);
    m.inverse_distance = 1 / distance;
    Kinematics<double> k;
    k.normal = m.inverse_distance * d;
    set_increments(m, dt, k);
    k.overlap = one.radius + two.radius - distance;
    k.r1 = one.radius, k.r2 = two.radius;
    k.per_reach = 1 / (k.r1 + k.r2), k.R_star = k.r1 * k.r2 * k.per_reach;
    k.m1 = one.mass, k.m2 = two.mass;
    return k;
  }

  /// Returns the gap across which the law acts, m.
  double range() const {
    if constexpr (ActsAcrossGaps<Law>)
      return Law::range(mixed);
    else
      return 0;
  }

  /// Evaluates the law at the present positions. Without contact everything is zero and the history is lost.
  void update(double dt) {
    kinematics = motion(dt);
    if (kinematics.overlap < -range()) {
      history = {};
      response = {};
      energies = {};
      touching = false;
      return;
    }
    if (touching) {
      const double angle = 0.5 * dt * dot(kinematics.normal, one.w + two.w);
      history.shear = transport(history.shear, normal, kinematics.normal, angle);
      history.rolling = transport(history.rolling, normal, kinematics.normal, angle);
    }
    response = Law::respond(mixed, kinematics, dt, history, energies);
    normal = kinematics.normal;
    touching = true;
  }

  void advance(double dt) {
    one.x = one.x + dt * one.v;
    two.x = two.x + dt * two.v;
    update(dt);
  }

  V3<double> force_on_two() const { return response.normal_force * kinematics.normal + history.shear; }
  V3<double> moment_on_two() const { return history.rolling + history.twisting * kinematics.normal; }
  V3<double> torque_on_one() const {
    return -1.0 * ((one.radius - 0.5 * kinematics.overlap) * cross(kinematics.normal, history.shear) + moment_on_two());
  }
  V3<double> torque_on_two() const {
    return moment_on_two() - (two.radius - 0.5 * kinematics.overlap) * cross(kinematics.normal, history.shear);
  }
};

/// Places body 1 at the origin and body 2 along `direction` (any length) with the given overlap.
template <class Law>
Pair<Law> touching_pair(const typename Law::MaterialPair& mixed, double r1, double r2, double overlap,
                        V3<double> direction = {0, 0, 1}) {
  Pair<Law> p;
  p.mixed = mixed;
  p.one.radius = r1, p.two.radius = r2;
  p.two.x = ((r1 + r2 - overlap) / norm(direction)) * direction;
  return p;
}

}  // namespace soilweave::dem::test
