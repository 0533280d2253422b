// The pairs of grains and a plane that one register holds.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "dem/sweep/contact_sweep.h"
#include "dem/sweep/own_history.h"
#include "dem/sweep/sweep_groups.h"

namespace soilweave::dem {

/// Sums of a step over pairs with planes, pair by pair.
template <class T>
struct PlaneSums {
  /// Sums as for pairs of grains.
  StepSums<T> step;
  /// Columns of the sum of f (x) l, N m.
  std::array<Lane4, 3> force_branch{};
  /// Force on the planes, N; last component: twice its work in the step, J.
  Lane4 force{};

  /// Adds the forces of the pairs.
  void add(const V3<T>& force_on_plane, const T& twice_the_work, const V3<T>& branch) {
    double at[3][width<T>];
    store(at[0], branch.x), store(at[1], branch.y), store(at[2], branch.z);
    const V3<T>& f = force_on_plane;
    to_rows(f.x, f.y, f.z, twice_the_work, [&](int lane, const Lane4& row) {
      for (std::size_t a = 0; a < 3; ++a) force_branch[a] = fused(broadcast<Lane4>(at[a][lane]), row, force_branch[a]);
      force += row;
    });
  }
  /// Adds these sums to those of a sweep.
  void put_into(SweepSums& s) const {
    step.put_into(s);
    for (int a = 0; a < 3; ++a) s.force_branch.col(a) += vector_of(force_branch[static_cast<std::size_t>(a)]);
    s.plane_work -= 0.5 * force[3];
  }
};

/// Lanes of a block of pairs with one plane.
template <class T>
class PlaneLanes {
 public:
  /// Takes the lanes of a block from lane k on.
  PlaneLanes(const Scene& scene, PlaneBlock& block, std::size_t k, double* own_numbers)
      : pairs(block.pairs, k),
        own(own_numbers),
        plane(scene.planes.all[static_cast<std::size_t>(block.plane)]),
        bodies_(scene.bodies),
        places_(of_grains(&Grain::position)) {}

  /// Lanes of the block.
  BlockLanes<T> pairs;
  /// First of the law's own arrays of the block, from lane k on (own_history.h).
  double* own;
  /// The plane.
  const Plane& plane;

  /// Returns the material of the grains, which the block shares.
  std::int32_t material_of_grains() const {
    return bodies_.material[static_cast<std::size_t>(ContactBlock::index(pairs.block->first[0]))];
  }

  /// Returns the geometry and motion of the pairs over a step dt.
  PairGeometry<T> geometry(double dt, double range) const {
    const Columns<T> v = of_grains(&Grain::velocity), w = of_grains(&Grain::spin);
    // The spin of a disk is the third component of its velocity row.
    const bool planar = bodies_.dimension == 2;
    const V3<T> velocity{v.a, v.b, planar ? T{} : v.c}, spin = planar ? V3<T>{T{}, T{}, v.c} : V3<T>{w.a, w.b, w.c};
    const V3<T> inward = in_lanes(plane.normal);
    const T height = dot(centres() - in_lanes(plane.point), inward);
    T number;
    for (int lane = 0; lane < width<T>; ++lane) number[lane] = static_cast<double>(pairs.lane) + lane;
    const Mask<T> listed = number < broadcast<T>(pairs.block->count);
    return plane_geometry(in_lanes(plane.velocity) - velocity, spin, places_.d, v.d, height, inward, listed, dt, range);
  }
  /// Returns the foot of the perpendicular from each grain's centre, m.
  V3<T> foot(const Kinematics<T>& k) const { return fused(T(k.r1 - k.overlap), k.normal, centres()); }
  /// Returns the history under law L, rotated to the present contact; zero for pairs that do not touch.
  template <class L, class Carry>
  HistoryOf<L, T> history(const Mask<T>& touching, const Carry& carried) const {
    HistoryOf<L, T> all{};
    all.shear = carried(masked(touching, pairs.template shear<Spatial>()));
    all.rolling = carried(masked(touching, pairs.template rolling<Spatial>()));
    all.twisting = masked(touching, pairs.twisting());
    OwnFields<L>::template read<T, Spatial>(own, touching, carried, all);
    return all;
  }

  /// Writes loads, or data laid out like them.
  void put(const V3<T>& force, const V3<T>& torque, LargeVector<Load>& loads) const {
    const bool planar = bodies_.dimension == 2;
    put_rows(force.x, force.y, planar ? torque.z : force.z, &Load::force, loads);
    if (!planar) put_rows(torque.x, torque.y, torque.z, &Load::torque, loads);
  }

  /// Returns a vector repeated in every lane.
  static V3<T> in_lanes(const Vec3& v) { return {broadcast<T>(v.x()), broadcast<T>(v.y()), broadcast<T>(v.z())}; }

 private:
  /// Returns the centres of the grains, m.
  V3<T> centres() const { return {places_.a, places_.b, places_.c}; }
  /// Returns a row of the grains as columns.
  Columns<T> of_grains(Lane4 Grain::*row) const {
    const Side side = pairs.first_side(reinterpret_cast<const std::byte*>(bodies_.grains.data()));
    const auto of = [&](int k) -> const Lane4& { return side[k].*row; };
    return columns({rows<T>(of, 0), rows<T>(of, 1), rows<T>(of, 2), rows<T>(of, 3)});
  }
  void put_rows(const T& x, const T& y, const T& z, Lane4 Load::*part, LargeVector<Load>& loads) const {
    const std::uint32_t* const distance = pairs.block->load_second + pairs.lane;
    const int listed = pairs.block->count - static_cast<int>(pairs.lane);
    to_rows(x, y, z, T{}, [&](int lane, const Lane4& row) {
      if (lane < listed) loads[distance[lane] / sizeof(Load)].*part = row;
    });
  }

  const Bodies& bodies_;
  Columns<T> places_;
};

}  // namespace soilweave::dem
