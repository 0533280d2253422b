// Energies of an assembly since the start, and their balance.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/energies.h"

#include <cmath>
#include <stdexcept>
#include <string>

#include "dem/engine/energy_term.h"

namespace soilweave::dem {

Energies::Energies() : values_(energy_terms().size(), 0.0), occurs_(values_.size(), false) {}

double Energies::operator[](std::string_view name) const {
  const auto& terms = energy_terms();
  for (std::size_t k = 0; k < terms.size(); ++k)
    if (terms[k].name == name) return values_[k];
  throw std::out_of_range("no energy term is named " + std::string(name));
}

// Adds one by one, because sums of sums would have other last digits.
double Energies::add_up(EnergyRole role, double sum) const {
  const auto& terms = energy_terms();
  for (std::size_t k = 0; k < terms.size(); ++k)
    if (terms[k].role == role && !terms[k].share) sum += values_[k];
  return sum;
}

double Energies::error() const {
  const double given = add_up(EnergyRole::supplied, initial_);
  return given - add_up(EnergyRole::numerical, add_up(EnergyRole::dissipated, kinetic() + stored()));
}

std::vector<EnergyColumn> Energies::columns() const {
  std::vector<EnergyColumn> columns = columns_where(false);
  columns.push_back({"energy_error", "remainder of the energy balance", error()});
  return columns;
}

std::vector<EnergyColumn> Energies::further_columns() const { return columns_where(true); }

std::vector<EnergyColumn> Energies::columns_where(bool of_some_runs) const {
  const auto& terms = energy_terms();
  std::vector<EnergyColumn> columns;
  for (int role = 0; role <= static_cast<int>(EnergyRole::internal); ++role)
    for (std::size_t k = 0; k < terms.size(); ++k) {
      const EnergyTerm& t = terms[k];
      if (static_cast<int>(t.role) != role || t.column.empty() || (t.occurs != nullptr) != of_some_runs) continue;
      if (!of_some_runs || occurs_[k]) columns.push_back({t.column, t.sentence, values_[k]});
    }
  return columns;
}

void Energies::start(const AssemblyState& now) {
  const auto& terms = energy_terms();
  for (std::size_t k = 0; k < terms.size(); ++k)
    if (terms[k].at_start) values_[k] = terms[k].at_start(now);
  const Energies present = at(now);
  initial_ = present.kinetic() + present.stored();
}

void Energies::add(const StepWork& step) {
  const auto& terms = energy_terms();
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (!terms[k].in_step) continue;
    const double part = terms[k].in_step(step);
    values_[k] += part;
    if (!terms[k].share) turned_over_ += std::abs(part);
  }
}

void Energies::add(const Intervention& change) {
  const auto& terms = energy_terms();
  for (std::size_t k = 0; k < terms.size(); ++k)
    if (terms[k].between_steps) values_[k] += terms[k].between_steps(change);
}

Energies Energies::at(const AssemblyState& now) const {
  Energies present = *this;
  const auto& terms = energy_terms();
  for (std::size_t k = 0; k < terms.size(); ++k) {
    if (terms[k].now) present.values_[k] = terms[k].now(now, present);
    present.occurs_[k] = !terms[k].occurs || terms[k].occurs(now);
  }
  return present;
}

void Energies::archive(Archive& archive) {
  const auto& terms = energy_terms();
  for (std::size_t k = 0; k < terms.size(); ++k)
    if (!terms[k].share || !terms[k].now) archive.item("energy_" + std::string(terms[k].name), values_[k]);
  archive.item("energy_initial", initial_), archive.item("energy_turned_over", turned_over_);
}

}  // namespace soilweave::dem
