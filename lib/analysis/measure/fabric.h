// Arrangement of contacts and forces: fabric tensors and anisotropies, coordination, orientation rose, force chains.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A packing under load is not the same in all directions: contacts turn towards the major stress, and forces grow along
// it. Three tensors measure this. With contact normals n, normal forces f_n and shear forces f_t, over N contacts,
//
//   phi = (1/N) sum n (x) n                  where contacts point           thesis Eq. 3.6
//   chi_n ~ (1/N) sum f_n n (x) n            how large forces are there     Eq. 3.7
//   chi_t ~ (1/N) sum f_t (x) n              how much they shear            Eq. 3.8
//
// with each contact in the two force tensors divided by the density of contacts in its direction. The deviators, scaled
// by 15/2 for phi, give the anisotropies a_c, a_n, a_t (Eq. 3.9), each with the sign of its inclination to the stress.
// They carry the strength of the assembly: q/p is about 2/5 (a_c + a_n + 3/2 a_t) (Rothenburg & Bathurst 1989).
#pragma once

#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// Fabric tensors of thesis Eqs. 3.6-3.8 and their anisotropies. In 2D the prefactors are 4, 4 and 4, from the
/// second-order Fourier expansion over the circle instead of the sphere.
struct Fabric {
  Mat3 normals = Mat3::Zero();           // phi^c
  Mat3 normal_force = Mat3::Zero();      // chi^n, N
  Mat3 tangential_force = Mat3::Zero();  // chi^t, N
  Mat3 a_normals = Mat3::Zero(), a_normal_force = Mat3::Zero(), a_tangential_force = Mat3::Zero();
  double a_c = 0, a_n = 0, a_t = 0;  // Eq. 3.9, with the sign of a : dev(stress)
  double mean_normal_force = 0;      // tr chi^n, N
};
/// Computes the fabric tensors and anisotropies of all contacts.
Fabric fabric(const io::Snapshot& state);

/// Both sides of the stress-force-fabric relation: q/p from the stress, and 2/5 (a_c + a_n + 3/2 a_t) from the fabric
/// (2D: 1/2 (a_c + a_n + a_t)), after Rothenburg & Bathurst 1989, Guo & Zhao 2013.
struct StressForceFabric {
  double stress = 0, fabric = 0;
};
/// Returns both sides of the relation, to check stress and fabric against each other.
StressForceFabric stress_force_fabric(const io::Snapshot& state, const Fabric& fabric);

/// Mean numbers of contacts, and the distribution behind them.
struct Coordination {
  double all = 0;         // 2 Nc/N over grain-grain contacts; a plane contact counts once
  double mechanical = 0;  // Thornton 2000: (2 Nc - N1)/(N - N0 - N1)
  double backbone = 0;    // mean over grains that remain when grains with fewer than 2 contacts are removed repeatedly
  std::size_t rattlers = 0;            // grains outside that backbone
  std::vector<std::size_t> histogram;  // grains with 0, 1, 2 ... contacts
};
/// Returns the coordination of the counted grains, with one entry per body. Their contacts with other grains count.
/// Other grains never count as rattlers.
Coordination coordination(const io::Snapshot& state, const std::vector<bool>& counted);
/// Returns the coordination of all grains except nodes of a geotextile.
Coordination coordination(const io::Snapshot& state);

/// Number of contacts and mean normal force by class of the angle of the contact normal.
struct Rose {
  std::vector<double> angle;         // middle of each class, rad
  std::vector<double> contacts;      // number in the class
  std::vector<double> density;       // contacts per solid angle (or angle), over the isotropic value
  std::vector<double> normal_force;  // mean, N; 0 in an empty class
};
/// Returns the rose over the angle from the loading axis, 0 to 90 deg, normalised by solid angle (3D only).
Rose polar_rose(const io::Snapshot& state, std::size_t classes);
/// Returns the rose in the plane of axes a and b, 0 to 360 deg, for normals within 45 deg of it. Each normal counts in
/// both directions.
Rose plane_rose(const io::Snapshot& state, int a, int b, std::size_t classes);

/// Chains of contacts with more than the mean normal force, followed from grain to grain within 45 deg of the larger
/// principal direction of the grain's stress (after Peters et al. 2005).
struct ForceChains {
  std::vector<std::int32_t> chain;  // chain of each contact; -1: in no chain
  std::size_t count = 0;            // number of chains of three grains or more
  double mean_length = 0;           // mean number of grains in a chain
  double grains_in_chains = 0;      // share of the grains
};
/// Finds the force chains of a state.
ForceChains force_chains(const io::Snapshot& state);

}  // namespace soilweave::analysis
