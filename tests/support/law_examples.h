// A material of each law, for tests over all laws. A new law adds one function here.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "support/pair.h"

namespace soilweave::dem::test {

/// limit: of rolling and twisting; restitution: of the dashpot. `variant` 1 differs in every parameter.
template <class Law>
typename Law::Material example(int variant = 0, std::optional<double> limit = 0.1,
                               std::optional<double> restitution = std::nullopt);

template <>
inline HertzMindlin::Material example<HertzMindlin>(int variant, std::optional<double> limit,
                                                    std::optional<double> restitution) {
  const Resistance r{variant ? 0.2 : 0.13, Resistance::Scale::absolute, limit, Resistance::Arm::mean_radius};
  if (variant) return {2e9, 0.2, 25 * degree, restitution, r, r};
  return {4e9, 0.33, 29 * degree, restitution, r, r};
}

template <>
inline Linear::Material example<Linear>(int variant, std::optional<double> limit, std::optional<double> restitution) {
  const Resistance r{variant ? 0.8 : 0.56, Resistance::Scale::contact, limit, Resistance::Arm::smaller_radius};
  if (variant) return {3e8, 0.4, 25 * degree, restitution, r, r};
  return {5.449e8, 0.08, 30.2 * degree, restitution, r, r};
}

/// Returns the ratio of shear stiffnesses at two overlaps, on which the energy of an incremental law depends.
template <class Law>
double shear_stiffness_ratio(double overlap, double other);

template <>
inline double shear_stiffness_ratio<HertzMindlin>(double overlap, double other) {
  return std::sqrt(overlap / other);
}
template <>
inline double shear_stiffness_ratio<Linear>(double, double) {
  return 1;
}

}  // namespace soilweave::dem::test
