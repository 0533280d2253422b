// Plane-strain laws of continua, for verification and for setting up problems: elastic, and Mohr-Coulomb.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fem/material/material_point.h"

namespace soilweave::fem {

/// Isotropic elasticity in rate form, optionally with a Mohr-Coulomb limit. It is objective: the increment is taken on
/// the midway configuration and the stress is rotated (Hughes & Winget 1980), so that a rigid rotation of any size
/// leaves no stress.
struct ContinuumLaw {
  double young_modulus = 1e7;  // Pa
  double poisson_ratio = 0.25;
  std::optional<double> friction_angle;  // rad; none: elastic
  double cohesion = 0;                   // Pa
  double dilation_angle = 0;             // rad
  Vec3 initial_stress = Vec3::Zero();    // xx, yy, zz, tension positive, Pa
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
  void limit();
  double elastic_energy() const;

  ContinuumLaw law_;
  double lame_, shear_;  // Pa
  Mat2 stress_;
  double out_of_plane_, work_ = 0, initial_energy_ = 0;  // Pa; J/m3
};

/// Returns principal stresses (descending, tension positive) mapped back to the Mohr-Coulomb surface; unchanged inside
/// it. sines: of friction and dilation. Perfectly plastic (De Souza Neto, Peric & Owen 2008, boxes 8.4 to 8.7).
Vec3 mohr_coulomb_return(const Vec3& trial, double bulk, double shear, double sin_friction, double sin_dilation,
                         double cohesion);

}  // namespace soilweave::fem
