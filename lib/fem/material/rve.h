// A material point made of grains: a representative volume element, a periodic packing of disks that follows the
// displacement gradient of its point and gives back the symmetric Love-Weber stress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/contact/model.h"
#include "dem/engine/simulation.h"
#include "fem/material/material_point.h"

namespace soilweave::fem {

/// Properties that the grains of all points share.
struct Grains {
  dem::Model model;
  dem::Numerics numerics;
  double density = 0;  // kg/m3; positive: replaces the packing's masses
};

/// Prepares a packing: masses; clock, strains and rotations of the disks from zero. Throws DataError unless it consists
/// of disks in a periodic cell, of known materials.
io::Snapshot prepare(const io::Snapshot& packing, const Grains& grains);

/// Data from which the time steps of both scales are chosen.
struct Probe {
  double limit = 0;             // stability limit of the grains, s
  Mat3 tangent = Mat3::Zero();  // stiffness as in MaterialPoint::tangent
  Mat2 stress = Mat2::Zero();   // Pa, tension positive
  double solid_fraction = 0;
};
/// Measures a packing before the run.
Probe probe(const io::Snapshot& packing, const Grains& grains);

/// A packing of disks as a material point.
class Rve : public MaterialPoint {
 public:
  /// Each step takes `substeps` substeps of step/substeps s, with equal parts of the gradient.
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
  double step_;
  std::int64_t substeps_;
  double area_;  // area of the cell at the start, m2
  dem::Simulation simulation_;
};

/// Returns F_a = sqrt(F:F/2) with F = 4 (phi - tr(phi)/2 I) and phi the mean of n n^T (Guo & Zhao 2013, in the plane);
/// -1 without contacts.
double anisotropy(const io::ContactsRecord& contacts);

}  // namespace soilweave::fem
