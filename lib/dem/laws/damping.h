// Normal viscous damping from a coefficient of restitution.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace soilweave::dem {

/// beta = -ln e/sqrt(pi^2 + ln^2 e): the fraction of critical damping that returns a grain with e times its speed, exact
/// for a linear spring and, with the dashpot of Tsuji, Tanaka & Ishida (1992), for a Hertzian one, both with the dashpot's
/// attraction at the end of the rebound allowed. The smaller e counts; none: no damping.
inline double damping_ratio(std::optional<double> e1, std::optional<double> e2) {
  if (!e1 && !e2) return 0;
  const double l = std::log(std::min(e1.value_or(1), e2.value_or(1)));
  return -l / std::sqrt(std::numbers::pi * std::numbers::pi + l * l);
}

}  // namespace soilweave::dem
