// Finite elements whose points are packings of grains, and the geosynthetic beside them.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nobody writes down a constitutive law for the soil. Each integration point holds a packing of disks instead:
//
//   nodes move -> displacement gradient at a point -> its packing deforms as much -> Love-Weber stress of its grains
//              -> internal forces at the nodes -> accelerations -> nodes move
//
// One step of both scales is explicit (central differences, thesis Eqs. 6.1 to 6.3):
//
//   1  soil       stresses, tractions and interface forces move the lumped masses; gradients at the points   soil.h
//   2  bars       the chain moves in small steps between old and new positions of the soil's boundary        bars.h
//   3  points     each follows its gradient in many small steps of its grains; points are independent        rve.h
//
// A continuum law (continuum_laws.h) can replace the grains, to verify the elements or to set up a problem.
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.h"
#include "fem/material/continuum_laws.h"
#include "fem/material/rve.h"
#include "fem/model/bars.h"
#include "fem/model/ranks.h"
#include "fem/model/soil.h"

namespace soilweave::fem {

/// Input of a model.
struct ModelSetup {
  /// Elements. Density 0 means the density of the grains times their solid fraction.
  SoilSetup soil;
  /// Law of the points; none: they hold grains.
  std::optional<ContinuumLaw> law;
  Grains grains;
  /// One for all points, or one per point; with a law none.
  std::vector<io::Snapshot> packings;
  std::optional<BarsSetup> bars;  // interface and chain are made from `along`
  /// Boundaries along which the chain lies.
  std::vector<std::string> along;
  /// Spacing of the chain's nodes, and length of the chain before the start of the boundaries, m.
  double spacing = 0, overhang = 0;
  /// Pressure along y on chain and guides before the start, Pa.
  double seat_pressure = 0;
  /// Step of the soil, s; none: from the eigenvalues.
  std::optional<double> time_step;
  /// Fraction of the stable step.
  double safety = 0.5;
  /// Time filled by a whole number of steps, s; 0: none.
  double interval = 0;
  int threads = 1;
};

/// Damping while a state comes to rest.
struct Relaxation {
  /// Viscous damping, 1/s.
  double soil = 0;
  /// Local, non-viscous damping.
  double grains = 0, bars = 0;
};

/// Energy balance, J per metre: external work = kinetic + stored + dissipated + error.
struct Balance {
  double external = 0, kinetic = 0, stored = 0, dissipated = 0;
  /// Returns the energy that the balance lacks.
  double error() const { return external - kinetic - stored - dissipated; }
};

/// Both scales in motion.
class Model {
 public:
  /// ranks: processes that share the points; must outlive the model. Throws DataError for unknown boundaries, unfit
  /// packings, or an unstable time step.
  explicit Model(ModelSetup setup, const Ranks* ranks = nullptr);

  /// Takes one step of the soil. Grains and geosynthetic take smaller ones. Free threads take the next point; results
  /// do not depend on their number. Throws PhysicsError naming element and point.
  void step();

  /// Returns the setup with the chain and its interface, and without packings.
  const ModelSetup& setup() const { return setup_; }
  /// Returns the step of the soil, s.
  double time_step() const { return dt_; }
  /// Returns the stability limit of the soil's step, s.
  double stable_time_step() const { return 2 / std::sqrt(eigenvalue_); }
  /// Returns the number of grain steps within one step of the soil.
  std::int64_t substeps() const { return substeps_; }
  /// Returns the time, s.
  double time() const { return time_; }
  /// Returns the number of steps so far.
  std::int64_t steps() const { return steps_; }
  /// Return the parts; bars() is nullptr without a geosynthetic.
  const Soil& soil() const { return *soil_; }
  Soil& soil() { return *soil_; }
  const Points& points() const { return points_; }
  const Bars* bars() const { return bars_.get(); }
  /// Copies the state of all points to the first process. All processes must call it. On the others points() is not up
  /// to date.
  void collect();
  /// Throws PhysicsError if a step exceeds its limit.
  void check_steps() const;
  /// Returns the energy balance since the start.
  Balance balance() const;
  /// Stops supports, chain ends and clock, and damps all motion. none: resumes the loading.
  void relax(const std::optional<Relaxation>& how);
  /// Keeps or restores everything that steps change.
  void archive(Archive& archive);

 private:
  void make_points();
  void make_bars();
  double interface_eigenvalue() const;
  double soil_eigenvalue() const;

  bool owns(Index point) const { return !ranks_ || ranks_->owns(point); }
  void share_stresses();
  std::string failure_of(Index task, const std::exception_ptr& failure) const;

  ModelSetup setup_;
  const Ranks* ranks_;
  std::vector<Index> line_;
  std::unique_ptr<Soil> soil_;
  std::unique_ptr<Bars> bars_;
  Points points_;
  std::vector<Mat2> stresses_;
  std::vector<double> areas_;  // initial areas of the points, m2
  double dt_ = 0, eigenvalue_ = 0, time_ = 0;
  std::int64_t substeps_ = 0, steps_ = 0, loading_steps_ = 0;
  bool relaxing_ = false;
};

}  // namespace soilweave::fem
