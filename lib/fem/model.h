// The two scales together: finite elements whose points are material, beside them the geosynthetic, and the order of
// one step of both.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.h"
#include "fem/bars.h"
#include "fem/continuum_laws.h"
#include "fem/ranks.h"
#include "fem/rve.h"
#include "fem/soil.h"

namespace soilweave::fem {

struct ModelSetup {
  SoilSetup soil;                   // density 0: that of the grains times their solid fraction
  std::optional<ContinuumLaw> law;  // nothing: grains
  Grains grains;
  std::vector<io::Snapshot> packings;  // one for all points, or one a point
  std::optional<BarsSetup> bars;       // interface filled in from the line
  std::vector<std::string> along;      // boundaries that the chain lies beside
  double spacing = 0, overhang = 0;    // m, of the chain's nodes; before its start
  double seat_pressure = 0;            // Pa, along y, carried by chain and guides before the start
  std::optional<double> time_step;     // s; nothing: from the eigenvalues
  double safety = 0.5;                 // of the stable step
  double interval = 0;                 // s, that a whole number of steps is to fill; 0: none
  int threads = 1;
};

/// Damping while a state comes to rest.
struct Relaxation {
  double soil = 0;              // viscous, 1/s
  double grains = 0, bars = 0;  // local, non-viscous
};

/// Energy of everything: external work = kinetic + stored + dissipated + error. J per metre of thickness.
struct Balance {
  double external = 0, kinetic = 0, stored = 0, dissipated = 0;
  double error() const { return external - kinetic - stored - dissipated; }
};

class Model {
 public:
  /// ranks: the processes that share the points; outlives the model. Throws DataError: unknown boundaries, packings
  /// that do not fit, a time step over the stable one.
  explicit Model(ModelSetup setup, const Ranks* ranks = nullptr);

  /// One step of the soil; the grains of every point, and the geosynthetic, take their own smaller ones. Points are
  /// shared out among the threads as they come free; the result is the same with any number. Throws PhysicsError naming
  /// element and point.
  void step();

  double time_step() const { return dt_; }
  double stable_time_step() const { return 2 / std::sqrt(eigenvalue_); }
  std::int64_t substeps() const { return substeps_; }
  double time() const { return time_; }
  std::int64_t steps() const { return steps_; }
  const Soil& soil() const { return *soil_; }
  Soil& soil() { return *soil_; }
  const Points& points() const { return points_; }
  const Bars* bars() const { return bars_.get(); }
  const std::vector<Index>& interface_nodes() const { return line_; }
  /// Brings the points of all processes to the first one; called by all together. On others points() lag behind.
  void collect();
  /// Throws PhysicsError where the step of the soil or of a point's grains has come over its limit.
  void check_steps() const;
  Balance balance() const;
  /// Supports and ends of the chain stand and the clock with them, while everything is damped; nothing: go on.
  void relax(const std::optional<Relaxation>& how);
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
  std::vector<double> areas_;  // m2, of the points at the start
  double dt_ = 0, eigenvalue_ = 0, time_ = 0;
  std::int64_t substeps_ = 0, steps_ = 0, loading_steps_ = 0;
  bool relaxing_ = false;
};

}  // namespace soilweave::fem
