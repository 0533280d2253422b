// A material point made of a periodic packing of disks (RVE). The packing follows the displacement gradient and returns
// the symmetric Love-Weber stress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/contact/model.h"
#include "dem/engine/simulation.h"
#include "fem/material/material_point.h"

namespace soilweave::fem {

/// Properties of the grains of all points.
struct Grains {
  dem::Model model;
  dem::Numerics numerics;
  /// Density of the grains, kg/m3; positive: replaces the packing's masses.
  double density = 0;
};

/// Prepares a packing: sets masses; zeroes clock, strains and rotations. Throws DataError unless it has disks of known
/// materials in a periodic cell.
io::Snapshot prepare(const io::Snapshot& packing, const Grains& grains);

/// Data for the time steps of both scales.
struct Probe {
  /// Stability limit of the grains, s.
  double limit = 0;
  /// Stiffness as in MaterialPoint::tangent.
  Mat3 tangent = Mat3::Zero();
  /// Stress, Pa, tension positive.
  Mat2 stress = Mat2::Zero();
  double solid_fraction = 0;
};
/// Measures a packing before the run.
Probe probe(const io::Snapshot& packing, const Grains& grains);

/// A packing of disks as a material point.
class Rve : public MaterialPoint {
 public:
  /// Takes `substeps` substeps of step/substeps s in each step, with equal parts of the gradient.
  Rve(const io::Snapshot& packing, const Grains& grains, double step, std::int64_t substeps);

  void advance(const Mat2& gradient) override;
  Mat2 stress() const override;
  Mat3 tangent() const override;
  Local local() const override;
  PointEnergy energy() const override;
  void set_damping(std::optional<double> damping) override;
  double step_over_limit() override;
  std::optional<io::Snapshot> packing() const override { return simulation_.snapshot(); }
  std::int64_t steps() const override { return simulation_.steps(); }
  std::int64_t contact_steps() const override { return simulation_.contact_steps(); }
  std::size_t grains() const override { return simulation_.grains(); }
  void archive(Archive& archive, const std::string& prefix) override;

 private:
  io::Snapshot identities_;
  Grains grains_;
  /// Step of the soil, s.
  double step_;
  std::int64_t substeps_;
  /// Area of the cell at the start, m2.
  double area_;
  dem::Simulation simulation_;
};

/// Returns F_a = sqrt(F:F/2) in the plane (Guo & Zhao 2013); -1 without contacts. F = 4 (phi - tr(phi)/2 I), phi the
/// mean of n n^T.
double anisotropy(const io::ContactsRecord& contacts);

}  // namespace soilweave::fem
