// Sums of contact forces and stiffness on grains, pair by pair.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <bit>

#include "core/simd/columns.h"
#include "dem/contact/contact_action.h"
#include "dem/sweep/sweep_groups.h"

namespace soilweave::dem {

inline void add(double* row, const Lane4& part) { store(row, Lane4(load<Lane4>(row) + part)); }
inline void take(double* row, const Lane4& part) { store(row, Lane4(load<Lane4>(row) - part)); }

/// Adds the forces of pairs across the cell's faces to the sums by image.
template <class Lanes>
void add_across(const V3<Lanes>& force, const BlockLanes<Lanes>& lanes, const Surroundings& s) {
  unsigned folded = lanes.folded();
  if (!folded) return;
  double x[width<Lanes>], y[width<Lanes>], z[width<Lanes>];
  store(x, force.x), store(y, force.y), store(z, force.z);
  for (; folded; folded &= folded - 1) {
    const auto lane = static_cast<std::size_t>(std::countr_zero(folded));
    add(s.across + width<Lane4> * lanes.image(lane), Lane4{x[lane], y[lane], z[lane], 0});
  }
}

/// Adds forces and torques to the loads of the grains, pair by pair.
template <class Lanes>
void add_to_loads(const Action<Lanes, Spatial>& act, const BlockLanes<Lanes>& lanes, const Surroundings& s) {
  double* const loads = s.loads;  // a reference would be read again after every store
  std::array<Lane4, width<Lanes>> force, torque;
  const auto& f = act.force;
  const auto &t1 = act.torque_first, &t2 = act.torque_second;
  const Lanes zero{};
  to_rows(f.x, f.y, f.z, zero, [&](int lane, const Lane4& row) { force[static_cast<std::size_t>(lane)] = row; });
  to_rows(t1.x, t1.y, t1.z, zero, [&](int lane, const Lane4& row) { torque[static_cast<std::size_t>(lane)] = row; });
  to_rows(t2.x, t2.y, t2.z, zero, [&](int lane, const Lane4& row) {
    const auto k = static_cast<std::size_t>(lane);
    double *one = lanes.load_first(k, loads), *two = lanes.load_second(k, loads);
    take(one, force[k]), take(one + width<Lane4>, torque[k]);
    add(two, force[k]), add(two + width<Lane4>, row);
  });
  add_across(f, lanes, s);
}
/// Adds forces and torques to the loads of disks, whose torque is the third component of the force.
template <class Lanes>
void add_to_loads(const Action<Lanes, Planar>& act, const BlockLanes<Lanes>& lanes, const Surroundings& s) {
  double* const loads = s.loads;
  const auto& f = act.force;
  std::array<Lane4, width<Lanes>> first;
  to_rows(f.x, f.y, act.torque_first, Lanes{},
          [&](int lane, const Lane4& row) { first[static_cast<std::size_t>(lane)] = row; });
  to_rows(f.x, f.y, act.torque_second, Lanes{}, [&](int lane, const Lane4& row) {
    const auto k = static_cast<std::size_t>(lane);
    take(lanes.load_first(k, loads), first[k]);
    add(lanes.load_second(k, loads), row);
  });
  add_across(V3<Lanes>{f.x, f.y, Lanes{}}, lanes, s);
}

/// Adds the stiffness of contacts against translation and rotation to both grains, laid out like the loads.
/// Each pair is added completely before the next one, so that a grain's sum does not depend on the register width.
template <class Lanes>
void add_stiffness(const V3<Lanes>& translation, const V3<Lanes>& rotation_first, const V3<Lanes>& rotation_second,
                   const BlockLanes<Lanes>& lanes, double* stiffness) {
  std::array<Lane4, width<Lanes>> along, about_first;
  const V3<Lanes>&t = translation, &r1 = rotation_first, &r2 = rotation_second;
  const Lanes zero{};
  to_rows(t.x, t.y, t.z, zero, [&](int lane, const Lane4& row) { along[static_cast<std::size_t>(lane)] = row; });
  to_rows(r1.x, r1.y, r1.z, zero,
          [&](int lane, const Lane4& row) { about_first[static_cast<std::size_t>(lane)] = row; });
  to_rows(r2.x, r2.y, r2.z, zero, [&](int lane, const Lane4& row) {
    const auto k = static_cast<std::size_t>(lane);
    double *one = lanes.load_first(k, stiffness), *two = lanes.load_second(k, stiffness);
    add(one, along[k]), add(one + width<Lane4>, about_first[k]);
    add(two, along[k]), add(two + width<Lane4>, row);
  });
}
/// Adds the stiffness of contacts between disks, whose rotation is the third component.
template <class Lanes>
void add_stiffness(const V2<Lanes>& translation, const Lanes& rotation_first, const Lanes& rotation_second,
                   const BlockLanes<Lanes>& lanes, double* stiffness) {
  std::array<Lane4, width<Lanes>> first;
  const V2<Lanes>& t = translation;
  const Lanes zero{};
  to_rows(t.x, t.y, rotation_first, zero,
          [&](int lane, const Lane4& row) { first[static_cast<std::size_t>(lane)] = row; });
  to_rows(t.x, t.y, rotation_second, zero, [&](int lane, const Lane4& row) {
    const auto k = static_cast<std::size_t>(lane);
    add(lanes.load_first(k, stiffness), first[k]);
    add(lanes.load_second(k, stiffness), row);
  });
}

}  // namespace soilweave::dem
