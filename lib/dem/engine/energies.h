// Energies of an assembly since the start, and their balance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>
#include <vector>

#include "core/archive.h"

namespace soilweave::dem {

struct AssemblyState;
struct Intervention;
struct StepWork;

/// Part of the balance to which a term belongs, in the order of columns.
enum class EnergyRole {
  /// Energy of motion.
  kinetic,
  /// Energy that unloading returns.
  stored,
  /// Energy that is lost for good.
  dissipated,
  /// Work done on the assembly from outside.
  supplied,
  /// Energy that the numerical scheme takes out (+) or creates (-).
  numerical,
  /// Work exchanged between other terms. It counts as turned over, but enters no sum.
  internal,
};

/// A column of the series that holds an energy, J.
struct EnergyColumn {
  /// Name in files, and description.
  std::string_view name, sentence;
  /// Energy, J.
  double value = 0;
};

/// All terms, J (2D: J/m), one file each in energies/ (energy_term.h).
/// Sums leave out terms whose energy other terms contain (EnergyTerm::share).
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
  /// Returns the balance's error: initial + supplied - kinetic - stored - dissipated - numerical.
  double error() const;
  /// Returns the columns that every run has, the error last.
  std::vector<EnergyColumn> columns() const;
  /// Returns the columns of this run that other runs may lack.
  std::vector<EnergyColumn> further_columns() const;

  /// Starts all terms. Takes kinetic and stored energy as the initial one.
  void start(const AssemblyState& now);
  /// Adds the energies of a step.
  void add(const StepWork& step);
  /// Adds the energies of a change from outside between two steps.
  void add(const Intervention& change);
  /// Returns these energies, with kinetic, stored and other terms that follow from the state evaluated at `now`.
  Energies at(const AssemblyState& now) const;
  /// Keeps or restores the numbers.
  void archive(Archive& archive);

 private:
  /// Returns `sum` plus the terms of a role.
  double add_up(EnergyRole role, double sum) const;
  std::vector<EnergyColumn> columns_where(bool of_some_runs) const;

  /// Energies in the order of energy_terms(), J.
  std::vector<double> values_;
  /// Whether the assembly has each term.
  std::vector<bool> occurs_;
  /// Kinetic and stored energy at the start, and energy turned over, J.
  double initial_ = 0, turned_over_ = 0;
};

}  // namespace soilweave::dem
