// The two scales together: finite elements whose points are packings of grains, and the geosynthetic beside them.
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
// A continuum law (continuum_laws.h) can stand for the grains, to verify the elements or to set a problem up.
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
  SoilSetup soil;                   // density 0: density of the grains times their solid fraction
  std::optional<ContinuumLaw> law;  // without it, points hold grains
  Grains grains;
  std::vector<io::Snapshot> packings;  // one for all points, or one per point
  std::optional<BarsSetup> bars;       // friction of the interface comes from the line
  std::vector<std::string> along;      // boundaries beside which the chain lies
  double spacing = 0, overhang = 0;    // distance of the chain's nodes, and its length before the start, m
  double seat_pressure = 0;            // pressure along y that chain and guides carry before the start, Pa
  std::optional<double> time_step;     // s; none: from the eigenvalues
  double safety = 0.5;                 // fraction of the stable step
  double interval = 0;                 // s, to be filled by a whole number of steps; 0: none
  int threads = 1;
};

/// Damping while a state comes to rest.
struct Relaxation {
  double soil = 0;              // viscous, 1/s
  double grains = 0, bars = 0;  // local, non-viscous
};

/// Energy balance of everything: external work = kinetic + stored + dissipated + error. J per metre of thickness.
struct Balance {
  double external = 0, kinetic = 0, stored = 0, dissipated = 0;
  /// Returns the energy that the balance lacks.
  double error() const { return external - kinetic - stored - dissipated; }
};

/// Both scales in motion.
class Model {
 public:
  /// ranks: processes that share the points; must outlive the model. Throws DataError for unknown boundaries, packings
  /// that do not fit, or a time step above the stable one.
  explicit Model(ModelSetup setup, const Ranks* ranks = nullptr);

  /// Takes one step of the soil. The grains of each point and the geosynthetic take smaller steps of their own. Free
  /// threads take the next point; the result does not depend on their number. Throws PhysicsError naming element and
  /// point.
  void step();

  /// Return the step of the soil, its stability limit (s), and the number of grain steps within it.
  double time_step() const { return dt_; }
  double stable_time_step() const { return 2 / std::sqrt(eigenvalue_); }
  std::int64_t substeps() const { return substeps_; }
  /// Return time, s, and number of steps so far.
  double time() const { return time_; }
  std::int64_t steps() const { return steps_; }
  /// Return the parts of the model; bars() is nullptr without a geosynthetic.
  const Soil& soil() const { return *soil_; }
  Soil& soil() { return *soil_; }
  const Points& points() const { return points_; }
  const Bars* bars() const { return bars_.get(); }
  /// Brings the points of all processes to the first one; all must call it. On other processes points() lag behind.
  void collect();
  /// Throws PhysicsError if the step of the soil or of a point's grains exceeds its limit.
  void check_steps() const;
  /// Returns the energy balance since the start.
  Balance balance() const;
  /// Stops supports, chain ends and clock, and damps everything; none: go on.
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
  std::vector<double> areas_;  // areas of the points at the start, m2
  double dt_ = 0, eigenvalue_ = 0, time_ = 0;
  std::int64_t substeps_ = 0, steps_ = 0, loading_steps_ = 0;
  bool relaxing_ = false;
};

}  // namespace soilweave::fem
