// Arrangement of contacts and forces: fabric tensors and anisotropies, coordination, orientation rose, force chains.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Under load, contacts turn towards the major stress, and forces grow along it. Three tensors measure this. With
// contact normals n, normal forces f_n and shear forces f_t, over N contacts,
//
//   phi = (1/N) sum n (x) n                  where contacts point           thesis Eq. 3.6
//   chi_n ~ (1/N) sum f_n n (x) n            how large forces are there     Eq. 3.7
//   chi_t ~ (1/N) sum f_t (x) n              how much they shear            Eq. 3.8
//
// Both force tensors divide each contact by the density of contacts in its direction. The deviators (of phi times 15/2)
// give the anisotropies a_c, a_n, a_t (Eq. 3.9). Their sign is positive if they align with the stress. They measure the
// strength: q/p is about 2/5 (a_c + a_n + 3/2 a_t) (Rothenburg & Bathurst 1989).
#pragma once

#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// Fabric tensors of thesis Eqs. 3.6-3.8 and their anisotropies. In 2D all prefactors are 4 (Fourier expansion over the
/// circle).
struct Fabric {
  /// phi^c
  Mat3 normals = Mat3::Zero();
  /// chi^n, N
  Mat3 normal_force = Mat3::Zero();
  /// chi^t, N
  Mat3 tangential_force = Mat3::Zero();
  /// Deviators of the three, scaled.
  Mat3 a_normals = Mat3::Zero(), a_normal_force = Mat3::Zero(), a_tangential_force = Mat3::Zero();
  /// Anisotropies (Eq. 3.9), with the sign of a : dev(stress).
  double a_c = 0, a_n = 0, a_t = 0;
  /// Trace of chi^n, N.
  double mean_normal_force = 0;
};
/// Computes the fabric tensors and anisotropies of all contacts; all are NaN without contacts.
Fabric fabric(const io::Snapshot& state);

/// Both sides of the stress-force-fabric relation (Rothenburg & Bathurst 1989, Guo & Zhao 2013).
struct StressForceFabric {
  /// q/p from the stress, and 2/5 (a_c + a_n + 3/2 a_t) from the fabric; 2D: 1/2 (a_c + a_n + a_t).
  double stress = 0, fabric = 0;
};
/// Returns both sides of the relation, NaN without contacts.
StressForceFabric stress_force_fabric(const io::Snapshot& state, const Fabric& fabric);

/// Mean numbers of contacts and their distribution.
struct Coordination {
  /// 2 Nc/N over contacts between grains; a contact with a plane counts once. NaN without grains.
  double all = 0;
  /// (2 Nc - N1)/(N - N0 - N1), Thornton 2000. NaN if no grain has two contacts.
  double mechanical = 0;
  /// Mean after repeated removal of grains with fewer than 2 contacts. NaN if none is left.
  double backbone = 0;
  /// Number of grains outside the backbone.
  std::size_t rattlers = 0;
  /// Number of grains with 0, 1, 2 ... contacts.
  std::vector<std::size_t> histogram;
};
/// Returns the coordination of the grains marked in `counted`, which has one entry per body. Their contacts with other
/// grains count, but the other grains are never rattlers.
Coordination coordination(const io::Snapshot& state, const std::vector<bool>& counted);
/// Returns the coordination of all grains except geotextile nodes.
Coordination coordination(const io::Snapshot& state);

/// Contacts and normal forces by angle of the contact normal.
struct Rose {
  /// Middle of each class, rad.
  std::vector<double> angle;
  /// Number in each class.
  std::vector<double> contacts;
  /// Contacts per solid angle (or angle), over the isotropic value; NaN without contacts.
  std::vector<double> density;
  /// Mean force, N; NaN in an empty class.
  std::vector<double> normal_force;
};
/// Returns the rose over angles of 0 to 90 deg from the loading axis (3D only).
Rose polar_rose(const io::Snapshot& state, std::size_t classes);
/// Returns the rose in the plane of axes a and b, 0 to 360 deg. Normals within 45 deg of the plane count, in both
/// directions.
Rose plane_rose(const io::Snapshot& state, int a, int b, std::size_t classes);

/// Chains of contacts above the mean normal force, within 45 deg of the major principal stress of both grains (after
/// Peters et al. 2005).
struct ForceChains {
  /// Chain of each contact; -1: none.
  std::vector<std::int32_t> chain;
  /// Number of chains of three grains or more.
  std::size_t count = 0;
  /// Mean number of grains in a chain; NaN without chains.
  double mean_length = 0;
  /// Grains in chains over all grains except fill.
  double grains_in_chains = 0;
};
/// Finds the force chains of a state.
ForceChains force_chains(const io::Snapshot& state);

}  // namespace soilweave::analysis
