// A term of the energy balance, and its data.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The balance of an assembly:
//
//   initial + supplied = kinetic + stored + dissipated + numerical + error
//
// Every part is a sum of terms (EnergyRole). A term is one header in energies/.
// Its struct has the file's name in camel case and declares
//
//   name          its name in Energies; a checkpoint has it after "energy_"
//   sentence      its meaning, for the series and FORMAT.md
//   role          its part of the balance
//
// and either now(state, energies), which returns its value, J, or functions whose results are added up:
//
//   in_step(step)           energy of one step, J; its magnitude counts as turned over
//   between_steps(change)   energy of a change from outside, J
//   at_start(state)         value to begin with, J; 0 if there is no such function
//
// Further members are optional:
//
//   column        column of the series, if not `name`; "" for a term without a column
//   share         true for an energy that other terms already contain: it enters no sum
//   place         its place among the terms, which fixes the last digits of sums and the order of columns.
//                 Terms without a place come last, by name. now() may read all earlier terms, and all added-up ones.
//   occurs(state) whether an assembly has the term; constant in a run. The columns of such terms come last.
//
// The build lists the headers (Makefile): no other file names a term.
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "dem/engine/energies.h"
#include "dem/engine/motion.h"
#include "dem/engine/yarns.h"
#include "dem/sweep/contact_sweep.h"

namespace soilweave::dem {

/// Results of one step: positions and forces at its end, velocities at its middle.
struct StepWork {
  /// Time step, s.
  double dt;
  /// Grains at the end of the step.
  const Bodies& bodies;
  /// Velocity gradient of the cell, 1/s.
  const Mat3& velocity_gradient;
  /// Sums over the contacts at the start and the end of the step.
  /// In a periodic cell force_branch includes the yarns.
  const SweepSums &before, &contacts;
  /// Sums over the grains.
  const MotionSums& grains;
  /// Sums over the yarns.
  const YarnSums& yarns;
  /// Work of the clamps on their grains, J.
  double clamps;
};

/// Energies of a change from outside between two steps.
struct Intervention {
  /// Work done on the assembly, J.
  double supplied = 0;
  /// Kinetic energy taken from the grains, J.
  double damped = 0;
  /// Energy that offsets the change of the numerical terms, J.
  double numerical = 0;
};

/// An assembly at the moment of its energies.
struct AssemblyState {
  const Bodies& bodies;
  const Cell& cell;
  const Planes& planes;
  const Contacts& contacts;
  const Yarns& yarns;
  /// Energies stored in the contacts, J.
  StoredEnergies in_contacts;
  /// Acceleration of gravity, m/s2.
  const Vec3& gravity;
  /// Time step, s: velocities lag half of it behind positions; 0 at the start.
  double dt;
  /// Number of threads.
  int threads;
};

/// One term as its file declares it.
struct EnergyTerm {
  std::string_view name, column, sentence;
  EnergyRole role;
  bool share = false;
  int place = std::numeric_limits<int>::max();
  double (*in_step)(const StepWork&) = nullptr;
  double (*between_steps)(const Intervention&) = nullptr;
  double (*at_start)(const AssemblyState&) = nullptr;
  double (*now)(const AssemblyState&, const Energies&) = nullptr;
  bool (*occurs)(const AssemblyState&) = nullptr;
};

/// Returns all terms, by place and name.
const std::vector<EnergyTerm>& energy_terms();

}  // namespace soilweave::dem
