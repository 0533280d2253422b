// The arrangement of contacts and forces: fabric tensors and anisotropies, coordination, orientation rose, force
// chains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/records.h"

namespace soilweave::analysis {

/// Fabric tensors of thesis Eqs. 3.6-3.8 and their anisotropies. In 2D the prefactors are 4, 4 and 4 (a second-order
/// Fourier expansion over the circle instead of the sphere).
struct Fabric {
  Mat3 normals = Mat3::Zero();           // phi^c
  Mat3 normal_force = Mat3::Zero();      // chi^n, N
  Mat3 tangential_force = Mat3::Zero();  // chi^t, N
  Mat3 a_normals = Mat3::Zero(), a_normal_force = Mat3::Zero(), a_tangential_force = Mat3::Zero();
  double a_c = 0, a_n = 0, a_t = 0;  // Eq. 3.9, with the sign of a : dev(stress)
  double mean_normal_force = 0;      // tr chi^n, N
};
Fabric fabric(const io::Snapshot& state);

/// The stress-force-fabric relation: q/p from the stress, and 2/5 (a_c + a_n + 3/2 a_t) from the fabric (2D:
/// 1/2 (a_c + a_n + a_t)), after Rothenburg & Bathurst 1989, Guo & Zhao 2013.
struct StressForceFabric {
  double stress = 0, fabric = 0;
};
StressForceFabric stress_force_fabric(const io::Snapshot& state, const Fabric& fabric);

struct Coordination {
  double all = 0;            // 2 Nc/N over grain-grain contacts, each plane contact counting once
  double mechanical = 0;     // Thornton 2000: (2 Nc - N1)/(N - N0 - N1)
  double backbone = 0;       // of what is left when grains with fewer than 2 contacts are taken out again and again
  std::size_t rattlers = 0;  // grains outside that backbone
  std::vector<std::size_t> histogram;  // grains with 0, 1, 2 ... contacts
};
/// Coordination of the counted grains alone, one entry a body: the contacts of others count for them, and others never
/// rattle.
Coordination coordination(const io::Snapshot& state, const std::vector<bool>& counted);
/// Coordination of all grains that are no nodes of a geotextile.
Coordination coordination(const io::Snapshot& state);

/// Share of contacts, and mean normal force, per class of angle of the contact normal.
struct Rose {
  std::vector<double> angle;         // rad, middle of each class
  std::vector<double> contacts;      // in the class
  std::vector<double> density;       // contacts per unit of solid angle (or of angle), over the isotropic value
  std::vector<double> normal_force;  // N, mean; 0 in an empty class
};
/// Over the angle from the loading axis, 0 to 90 deg, normalised by solid angle (3D only).
Rose polar_rose(const io::Snapshot& state, std::size_t classes);
/// Over the angle in the plane of axes a and b, 0 to 360 deg, of the normals within 45 deg of it; both directions of
/// each.
Rose plane_rose(const io::Snapshot& state, int a, int b, std::size_t classes);

/// Chains of contacts that carry more than the mean normal force, followed grain to grain within 45 deg of the larger
/// principal direction of the grain's stress (after Peters et al. 2005).
struct ForceChains {
  std::vector<std::int32_t> chain;  // per contact; -1 where it belongs to none
  std::size_t count = 0;            // chains of three grains or more
  double mean_length = 0;           // grains
  double grains_in_chains = 0;      // share
};
ForceChains force_chains(const io::Snapshot& state);

}  // namespace soilweave::analysis
