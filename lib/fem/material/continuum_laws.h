// Plane-strain laws of continua: elastic and Mohr-Coulomb.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fem/material/material_point.h"

namespace soilweave::fem {

/// Isotropic elasticity in rate form, optionally with a Mohr-Coulomb limit. It is objective: strain refers to the
/// midway configuration, and stress rotates with the material (Hughes & Winget 1980). A rigid rotation of any size
/// leaves no stress.
struct ContinuumLaw {
  /// Young's modulus, Pa.
  double young_modulus = 1e7;
  /// Poisson's ratio.
  double poisson_ratio = 0.25;
  /// Friction angle, rad; none: elastic.
  std::optional<double> friction_angle;
  /// Cohesion, Pa.
  double cohesion = 0;
  /// Dilation angle, rad.
  double dilation_angle = 0;
  /// Initial stress xx, yy, zz, Pa, tension positive.
  Vec3 initial_stress = Vec3::Zero();
};

/// A material point with a continuum law.
class ContinuumPoint : public MaterialPoint {
 public:
  explicit ContinuumPoint(const ContinuumLaw& law);
  void advance(const Mat2& gradient) override;
  Mat2 stress() const override { return stress_; }
  Mat3 tangent() const override;
  PointEnergy energy() const override;
  void archive(Archive& archive, const std::string& prefix) override;

 private:
  /// Maps the stress back to the Mohr-Coulomb surface.
  void limit();
  double elastic_energy() const;

  ContinuumLaw law_;
  /// Elastic moduli, Pa.
  double lame_, shear_;
  Mat2 stress_;
  /// Out-of-plane stress, Pa; energies, J/m3.
  double out_of_plane_, work_ = 0, initial_energy_ = 0;
};

/// Returns principal stresses (descending, tension positive) mapped back to the Mohr-Coulomb surface; unchanged inside
/// it. Perfectly plastic (De Souza Neto, Peric & Owen 2008, boxes 8.4 to 8.7).
Vec3 mohr_coulomb_return(const Vec3& trial, double bulk, double shear, double sin_friction, double sin_dilation,
                         double cohesion);

}  // namespace soilweave::fem
