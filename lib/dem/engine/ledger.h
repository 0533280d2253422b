// Numbers that a checkpoint keeps besides the snapshot and the energies.
// A member added to SweepSums or Measures must be added here.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <utility>

#include "core/archive.h"
#include "core/error.h"
#include "core/simd/v3.h"
#include "dem/engine/simulation.h"
#include "dem/sweep/contact_sweep.h"

namespace soilweave::dem {

static_assert(sizeof(SweepSums) == 16 * sizeof(double) && sizeof(Measures) == 13 * sizeof(double),
              "a number was added that is not in the lists below");

/// Keeps or restores the sums of a sweep.
inline void archive(Archive& a, SweepSums& s) {
  a.item("sum_force_branch", s.force_branch), a.item("sum_contacts", s.contacts);
  a.item("sum_tangential_work", s.tangential_work), a.item("sum_frictional", s.frictional);
  a.item("sum_rolling_plastic", s.rolling_plastic), a.item("sum_viscous", s.viscous);
  a.item("sum_plane_work", s.plane_work), a.item("sum_largest_overlap", s.largest_overlap);
}

/// Keeps or restores measurements.
inline void archive(Archive& a, Measures& m) {
  a.item("stress", m.stress), a.item("axial_stiffness", m.axial_stiffness), a.item("contacts", m.contacts);
}

/// Keeps or restores forces and torques of the grains, and the rotation of disks.
/// Throws DataError if the archive holds another number of grains.
inline void archive(Archive& a, Bodies& bodies) {
  const auto of_as_many = [&bodies](const std::string& name, std::size_t numbers, std::size_t of_each) {
    if (numbers != of_each * bodies.size()) throw DataError(name + ": is of another number of grains; begin anew");
  };
  if (bodies.dimension == 2) {
    std::vector<double> angle(bodies.angle.begin(), bodies.angle.end());
    a.item("angle", angle);
    of_as_many("angle", angle.size(), 1);
    bodies.angle.assign(angle.begin(), angle.end());
  }
  for (const auto& [name, part] : {std::pair("force", &Load::force), std::pair("torque", &Load::torque)}) {
    std::vector<double> flat;
    if (!a.giving_back())
      for (std::size_t i = 0; i < bodies.size(); ++i) {
        const Lane4& r = bodies.loads[i].*part;
        flat.insert(flat.end(), {r[0], r[1], r[2]});
      }
    a.item(name, flat);
    if (!a.giving_back()) continue;
    of_as_many(name, flat.size(), 3);
    for (std::size_t i = 0; i < bodies.size(); ++i)
      bodies.loads[i].*part = Lane4{flat[3 * i], flat[3 * i + 1], flat[3 * i + 2], 0};
  }
}

}  // namespace soilweave::dem
