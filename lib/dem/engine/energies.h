// Energies of an assembly since the start, and their balance. Each term is one file in energies/ (energy_term.h).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/archive.h"

namespace soilweave::dem {

struct AssemblyState;
struct Intervention;
struct StepWork;

/// Part of the balance to which a term belongs. Columns of the series stand in this order.
enum class EnergyRole {
  kinetic,     // energy of motion
  stored,      // energy that unloading returns
  dissipated,  // energy that is lost for good
  supplied,    // work done on the assembly from outside
  numerical,   // energy that the numerical scheme takes out (+) or creates (-)
  internal,    // work between other terms, which counts as turned over and enters no sum
};

/// A column of the series that holds an energy, J.
struct EnergyColumn {
  /// Name in files, and description.
  std::string_view name, sentence;
  /// Energy, J.
  double value = 0;
};

/// All terms, J (2D: J per metre of thickness). Sums leave out the shares of other terms.
class Energies {
 public:
  Energies();

  /// Returns the term of this name. Throws std::out_of_range if no term has it.
  double operator[](std::string_view name) const;
  /// Returns the sum over the terms of one role.
  double sum(EnergyRole role) const { return add_up(role, 0); }
  /// Returns the kinetic energy.
  double kinetic() const { return sum(EnergyRole::kinetic); }
  /// Returns the energy that unloading returns.
  double stored() const { return sum(EnergyRole::stored); }
  /// Returns kinetic and stored energy at the start.
  double initial() const { return initial_; }
  /// Returns the sum of |work| and |dissipation| of every step.
  double turned_over() const { return turned_over_; }
  /// Returns the remainder of the balance: initial + supplied - kinetic - stored - dissipated - numerical.
  double error() const;
  /// Returns the columns of all runs, the error last; or those that only some runs have, if this one has them.
  std::vector<EnergyColumn> columns() const;
  std::vector<EnergyColumn> further_columns() const;

  /// Sets what terms begin with, and takes kinetic and stored energy as the initial one.
  void start(const AssemblyState& now);
  /// Add what a step did, and what was changed from outside between two steps.
  void add(const StepWork& step);
  void add(const Intervention& change);
  /// Returns these energies with the terms that belong to a moment, such as the stored ones, computed for `now`.
  Energies at(const AssemblyState& now) const;
  /// Keeps or restores the numbers.
  void archive(Archive& archive);

 private:
  double add_up(EnergyRole role, double sum) const;
  std::vector<EnergyColumn> columns_where(bool of_some_runs) const;

  /// Energies in the order of energy_terms(), J.
  std::vector<double> values_;
  /// Whether the assembly has the term.
  std::vector<bool> occurs_;
  double initial_ = 0, turned_over_ = 0;
};

}  // namespace soilweave::dem
