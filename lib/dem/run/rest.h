// Estimate of how long the stations of a run wait until their grains are at rest.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A wait is the number of e-folds by which the motion has to fall, times the time of one e-fold.
//
// In a cell, rearranging grains move by their own size in the inertial time t = d sqrt(rho/p). The unbalanced force on
// arrival grows with the inertial number I = rate t. An e-fold takes a fixed share of t, which is smaller for more
// damping. Under a drag, the wait depends on the slowest swing of the assembly (swing.h), whose kinetic energy falls
// last. Between plates without a drag, waves are reflected, and the wait grows with the number of grains across.
//
// The numbers in rest.cpp are measured on the studies' runs. Waits differ by a factor of two from bag to bag.
#pragma once

#include "dem/engine/simulation.h"
#include "dem/run/scenario.h"

namespace soilweave::dem {

/// Data of the loading to one station that determine the wait at this station.
struct Arrival {
  /// Mean stress of the goals, Pa; 0: the present one.
  double pressure = 0;
  /// Velocity gradient that strain goals and moved parts prescribe, 1/s.
  Mat3 gradient = Mat3::Zero();
  /// Whether strains or displacements are prescribed.
  bool sheared = false;
  /// Whether a plate or clamp gets a new load.
  bool new_load = false;
  /// Whether this is the first station, where the initial unbalanced force has to fall too.
  bool first = false;
};

/// Estimate for one run.
class RestEstimate {
 public:
  /// Measures the simulation at its start. The scenario must outlive the estimate.
  RestEstimate(const Simulation& simulation, const Scenario& scenario);

  /// Returns the steps that a station waits for rest.
  double steps(const Stage& stage, const Arrival& arrival) const;
  /// Learns from tried steps how the time step depends on the pressure.
  void learn(const Simulation& tried);
  /// Returns the mean time step on the way to a station over the time step at the start.
  /// It falls with pressure, and in sheared soil that yarns confine, because contacts get stiffer.
  double step_share(const Arrival& arrival) const;
  /// Returns the least number of steps to a station. `moving`, `waiting`: forecast steps of loading and of waiting.
  double fewest(const Arrival& arrival, double moving, double waiting) const;
  /// Returns the greatest number of steps to a station, from the same forecasts as fewest().
  double most(const Arrival& arrival, double moving, double waiting) const;
  /// Returns the pressure of a load (N) along a unit vector on the soil between plates, Pa.
  double pressure_of(double force, const Vec3& direction) const;

 private:
  /// Returns the mean stress of the soil, Pa.
  double pressure_of(const Simulation& simulation) const;
  /// Returns d sqrt(rho/p), s.
  double inertial_time(double pressure) const;
  /// Returns the unbalanced force when the loading to a station ends.
  double unbalanced_at_arrival(const Stage& stage, const Arrival& arrival) const;
  /// Returns the steps of a wait in a periodic cell.
  double in_cell(const Stage& stage, const Arrival& arrival, double damping) const;
  /// Returns the steps of a wait between plates without a drag.
  double between_plates(const Arrival& arrival, double damping) const;
  /// Returns the steps of a wait under a drag. `half`: half of the drag, 1/s.
  double under_drag(const Stage& stage, const Arrival& arrival, double half) const;

  const Scenario& scenario_;
  /// Time step, s.
  double dt_;
  /// Unbalanced force at the start.
  double unbalanced_;
  /// Number of grains across.
  double across_ = 0;
  /// Mean diameter, m, and density, kg/m3, of the soil; 0: no soil.
  double diameter_ = 0, density_ = 0;
  /// Present mean stress of the soil, Pa.
  double pressure_ = 0;
  /// Volume of the soil with its pores, m3 (2D: m2).
  double volume_ = 0;
  /// Extent of the soil along the axes, m.
  Vec3 extent_ = Vec3::Zero();
  /// Exponent n of the time step, which falls as pressure^-n.
  double power_ = 0;
  /// Frequency of the slowest swing, 1/s.
  double swing_ = 0;
  /// Second moments of mass along the open axes, kg m2.
  Vec3 moments_ = Vec3::Zero();
  /// Whether there are both soil and nodes of geotextiles.
  bool wrapped_ = false;
};

}  // namespace soilweave::dem
