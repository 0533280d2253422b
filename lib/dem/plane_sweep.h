// What a sweep does with pairs of a grain and a plane, one after the other.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact_action.h"
#include "dem/contact_sweep.h"
#include "dem/contact_work.h"
#include "dem/couples.h"
#include "dem/transport.h"

namespace soilweave::dem {

template <class Law>
class PlaneSweep {
 public:
  explicit PlaneSweep(const Couples<Law>& couples) : couples_(couples), moments_(couples.use_moments()) {}

  /// Updates the contact over a step dt and sets its load; work and dissipation go to `sums`, the rest to `total`.
  template <class Sums>
  void act(const Scene& scene, double dt, PlanePair& pair, Sums& sums, SweepSums& total) const {
    const PairGeometry<double> g = geometry(scene, dt, pair);
    const Kinematics<double>& k = g.kinematics;
    History& history = pair.history;
    if (!g.touching) {
      history = {};
      return;
    }
    const V3<double> n = k.normal, force_before = history.normal_force * pair.normal + history.memory.shear;
    Memory<double>& memory = history.memory;
    if (dt > 0 && history.touching) {
      const Rotation<double> turn(g.turn);
      memory.shear = turn(memory.shear), memory.rolling = turn(memory.rolling);
    }
    const Memory<double> before = memory;
    Books<double> books;
    const auto response = Law::respond(couple(scene, pair), k, dt, memory, books);
    if (dt == 0) memory = before;
    const Action<double> act = action(n, k.r1, 0.0, memory, response.normal_force);
    pair.normal = n;
    history.normal_force = response.normal_force;
    history.touching = true, history.sliding = response.sliding;
    put(-act.force, -act.torque_first, scene.bodies.dimension == 2, scene.bodies.loads[pair.load]);
    add_to(sums.work, work_of(g, before, memory, moments_, books));
    sums.overlap = maximum(sums.overlap, k.overlap + decltype(sums.overlap){});
    ++sums.contacts;
    // Of f (x) l what is not F (x) x: f at the foot of the perpendicular.
    const double height = k.r1 - k.overlap;
    const Vec3 foot =
        vector_of(scene.bodies.grains[static_cast<std::size_t>(pair.grain)].position) + to_eigen(height * n);
    total.force_branch += to_eigen(act.force) * foot.transpose();
    const Vec3& velocity = scene.planes.all[static_cast<std::size_t>(pair.plane)].velocity;
    total.plane_work -= 0.5 * dt * dot(force_before + act.force, from_eigen(velocity));
  }

  /// Sets the pair's stiffness; the affine one is added to `total` (ContactSweep).
  void stiffen(const Scene& scene, const PlanePair& pair, Lane4& total) const {
    const PairGeometry<double> g = geometry(scene, 0, pair);
    if (!g.touching) return;
    const Kinematics<double>& k = g.kinematics;
    Memory<double> memory = pair.history.memory;
    Books<double> books;
    const auto r = Law::respond(couple(scene, pair), k, 0.0, memory, books);
    add_to(total, affine_stiffness(k.normal, k.r1 - k.overlap, r));
    const auto [translation, rotation] = axis_stiffness(k.normal, r, k.r1);
    put(translation, rotation, scene.bodies.dimension == 2, scene.bodies.stiffness[pair.load]);
  }

  /// Adds normal, shear, rolling and twisting energy, J.
  void store_up(const Scene& scene, const PlanePair& pair, Lane4& total) const {
    if (!pair.history.touching) return;
    Memory<double> memory = pair.history.memory;
    Books<double> b;
    Law::respond(couple(scene, pair), geometry(scene, 0, pair).kinematics, 0.0, memory, b);
    add_to(total, b.elastic_normal, b.elastic_shear, b.elastic_rolling, b.elastic_twisting);
  }

 private:
  // As the sweep puts it, in the plane too.
  static void put(const V3<double>& force, const V3<double>& torque, bool planar, Load& load) {
    load.force = Lane4{force.x, force.y, planar ? torque.z : force.z, 0};
    load.torque = planar ? Lane4{} : Lane4{torque.x, torque.y, torque.z, 0};
  }

  static PairGeometry<double> geometry(const Scene& scene, double dt, const PlanePair& pair) {
    const auto i = static_cast<std::size_t>(pair.grain);
    const Bodies& bodies = scene.bodies;
    const Plane& p = scene.planes.all[static_cast<std::size_t>(pair.plane)];
    const auto v3 = [](const Lane4& row) { return V3<double>{row[0], row[1], row[2]}; };
    const V3<double> inward = from_eigen(p.normal);
    const double height = dot(v3(bodies.grains[i].position) - from_eigen(p.point), inward);
    return plane_geometry(from_eigen(p.velocity) - v3(bodies.velocity(i)), v3(bodies.spin(i)), bodies.radius(i),
                          bodies.mass(i), height, inward, pair.normal, dt);
  }

  const typename Law::Couple& couple(const Scene& scene, const PlanePair& pair) const {
    return couples_.of(scene.bodies.material[static_cast<std::size_t>(pair.grain)],
                       scene.planes.all[static_cast<std::size_t>(pair.plane)].material);
  }

  const Couples<Law>& couples_;
  bool moments_;
};

}  // namespace soilweave::dem
