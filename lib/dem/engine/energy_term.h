// A term of the energy balance: what its file states, and what it is made from.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy that an assembly had and was given is the energy that it has or has lost:
//
//   initial + supplied = kinetic + stored + dissipated + numerical + error
//
// Every part is a sum of terms (EnergyRole). A term is one header in energies/, whose struct has the file's name in
// camel case. It declares
//
//   name          word by which code asks for it (Energies); after "energy_", the name of its number in a checkpoint
//   sentence      its meaning, for the series and FORMAT.md
//   role          its part of the balance
//
// and either now(state, energies), its value, J, or the functions whose results are added up from step to step:
//
//   in_step(step)           energy of one step, J; its magnitude counts as turned over
//   between_steps(change)   energy of a change from outside, J
//   at_start(state)         value to begin with, J; 0 if there is no such function
//
// Further members are for those that need them:
//
//   column        column of the series, where it is not `name`; "" for a term without a column
//   share         true for a part of an energy that other terms hold: it stays out of all sums
//   place         its place among the terms. It fixes the last digits of sums and the order of columns within a role.
//                 Terms without it come last, by name. now() may read all terms before it, and those added up.
//   occurs(state) whether an assembly has the term; the answer must be the same throughout a run. The column then comes
//                 after all others, in runs that have the term.
//
// The build lists the headers of the folder (Makefile), so that no other file names a term.
#pragma once

#include <limits>
#include <string_view>
#include <vector>

#include "dem/engine/energies.h"
#include "dem/engine/motion.h"
#include "dem/engine/yarns.h"
#include "dem/sweep/contact_sweep.h"

namespace soilweave::dem {

/// Results of one step. Positions and forces are those at its end, velocities those of its middle.
struct StepWork {
  double dt;  // s
  const Bodies& bodies;
  const Mat3& velocity_gradient;  // of the cell in this step, 1/s
  // Sums over the contacts at the start and the end of the step. In a periodic cell force_branch has the yarns' part.
  const SweepSums &before, &contacts;
  const MotionSums& grains;
  const YarnSums& yarns;
  /// Work of the clamps on their grains, J.
  double clamps;
};

/// Energies that a change from outside between two steps takes and gives, J.
struct Intervention {
  /// Work done on the assembly, J.
  double supplied = 0;
  /// Kinetic energy taken from the grains.
  double damped = 0;
  /// Energy that the numerical terms must get, so that the change leaves them as they were.
  double numerical = 0;
};

/// An assembly at the moment for which energies are asked.
struct AssemblyState {
  const Bodies& bodies;
  const Cell& cell;
  const Planes& planes;
  const Contacts& contacts;
  const Yarns& yarns;
  StoredEnergies in_contacts;
  const Vec3& gravity;  // m/s2
  /// Time step by half of which velocities lag behind positions, s; 0 at the start.
  double dt;
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
