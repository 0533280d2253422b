// Plane-strain laws of continua for verification and for setting problems up: elastic, and Mohr-Coulomb.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "fem/material_point.h"

namespace soilweave::fem {

/// Isotropic elasticity in rate form, or with a Mohr-Coulomb limit. Objective: the increment is taken on the
/// configuration midway and the stress rotated (Hughes & Winget 1980), so that a rigid rotation of any size leaves no
/// stress.
struct ContinuumLaw {
  double young_modulus = 1e7;  // Pa
  double poisson_ratio = 0.25;
  std::optional<double> friction_angle;  // rad; nothing: elastic
  double cohesion = 0;                   // Pa
  double dilation_angle = 0;             // rad
  Vec3 initial_stress = Vec3::Zero();    // Pa, xx, yy, zz, tension positive
};

class ContinuumPoint : public MaterialPoint {
 public:
  explicit ContinuumPoint(const ContinuumLaw& law);
  void advance(const Mat2& gradient) override;
  Mat2 stress() const override { return stress_; }
  Mat3 tangent() const override;
  PointEnergy energy() const override;
  void archive(Archive& archive, const std::string& prefix) override;
  double out_of_plane_stress() const { return out_of_plane_; }

 private:
  void limit();
  double elastic_energy() const;

  ContinuumLaw law_;
  double lame_, shear_;  // Pa
  Mat2 stress_;
  double out_of_plane_, work_ = 0, initial_energy_ = 0;  // Pa; J/m3
};

/// Principal stresses s (descending, tension positive) returned to the Mohr-Coulomb surface; inside it unchanged.
/// sines: of friction and dilation. (De Souza Neto, Peric & Owen 2008, box 8.4 to 8.7, perfectly plastic.)
Vec3 mohr_coulomb_return(const Vec3& trial, double bulk, double shear, double sin_friction, double sin_dilation,
                         double cohesion);

}  // namespace soilweave::fem
