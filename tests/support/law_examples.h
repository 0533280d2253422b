// A material of each law, for tests over all laws, from the examples that the law itself declares.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "core/text/settings.h"
#include "support/pair.h"

namespace soilweave::dem::test {

/// limit: of rolling and twisting; restitution: of the dashpot. `variant` 1 differs in every parameter.
template <class Law>
typename Law::Material example(std::size_t variant = 0, std::optional<double> limit = 0.1,
                               std::optional<double> restitution = std::nullopt) {
  Settings table = Settings::parse(Law::examples.at(variant), "example of " + std::string(Law::name));
  typename Law::Material m = Law::read(table);
  table.finish();
  m.rolling.limit = m.twisting.limit = limit;
  m.restitution = restitution;
  return m;
}

/// Returns the ratio of shear stiffnesses at two overlaps of the kinematics, on which the energy of an incremental law
/// depends.
template <class Law>
double shear_stiffness_ratio(const typename Law::MaterialPair& mixed, Kinematics<double> k, double overlap,
                             double other) {
  const auto at = [&](double value) {
    k.overlap = value;
    HistoryOf<Law, double> history{};
    ContactEnergies<double> energies;
    return Law::respond(mixed, k, 0.0, history, energies).shear_stiffness;
  };
  return at(overlap) / at(other);
}

}  // namespace soilweave::dem::test
