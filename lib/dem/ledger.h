// What a simulation counts from step to step, as items of an archive: THE lists of what a checkpoint keeps beyond the
// state of the grains. What is added to SweepSums, Measures or Energies is added here.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/archive.h"
#include "core/error.h"
#include "core/v3.h"
#include "dem/contact_sweep.h"
#include "dem/simulation.h"

namespace soilweave::dem {

static_assert(sizeof(SweepSums) == 19 * sizeof(double) && sizeof(Measures) == 13 * sizeof(double) &&
                  sizeof(Energies) == 16 * sizeof(double),
              "a number was added that is not in the lists below");

inline void archive(Archive& a, SweepSums& s) {
  a.item("sum_force_branch", s.force_branch), a.item("sum_contacts", s.contacts);
  a.item("sum_elastic_normal", s.elastic_normal), a.item("sum_elastic_tangential", s.elastic_tangential);
  a.item("sum_tangential_before", s.tangential_before), a.item("sum_frictional", s.frictional);
  a.item("sum_rolling_plastic", s.rolling_plastic), a.item("sum_viscous", s.viscous);
  a.item("sum_kinematic", s.kinematic), a.item("sum_plane_work", s.plane_work);
  a.item("sum_largest_overlap", s.largest_relative_overlap);
}

inline void archive(Archive& a, Measures& m) {
  a.item("stress", m.stress), a.item("axial_stiffness", m.axial_stiffness), a.item("contacts", m.contacts);
}

inline void archive(Archive& a, Energies& e) {
  a.item("energy_elastic_yarns", e.elastic_yarns), a.item("energy_yarn_dissipation", e.yarn_dissipation);
  a.item("energy_kinetic", e.kinetic), a.item("energy_elastic_normal", e.elastic_normal);
  a.item("energy_elastic_shear", e.elastic_shear), a.item("energy_elastic_rolling", e.elastic_rolling);
  a.item("energy_elastic_twisting", e.elastic_twisting), a.item("energy_frictional", e.frictional);
  a.item("energy_rolling_plastic", e.rolling_plastic), a.item("energy_viscous", e.viscous);
  a.item("energy_damping", e.damping), a.item("energy_boundary_work", e.boundary_work);
  a.item("energy_gravity_work", e.gravity_work), a.item("energy_law", e.law);
  a.item("energy_initial", e.initial), a.item("energy_turned_over", e.turned_over);
}

/// The vectors of rows; their last places are left as they are.
inline void archive_rows(Archive& a, const std::string& name, std::vector<Lane4>& rows) {
  std::vector<double> flat;
  if (!a.giving_back())
    for (const Lane4& r : rows) flat.insert(flat.end(), {r[0], r[1], r[2]});
  a.item(name, flat);
  if (!a.giving_back()) return;
  if (flat.size() != 3 * rows.size()) throw DataError(name + ": is of another number of grains; begin anew");
  for (std::size_t i = 0; i < rows.size(); ++i)
    rows[i] = Lane4{flat[3 * i], flat[3 * i + 1], flat[3 * i + 2], rows[i][3]};
}

}  // namespace soilweave::dem
