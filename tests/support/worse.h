// The worst of many errors, to compare with a limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace soilweave::test {

/// Returns the larger number. A NaN stays, unlike in std::max, and fails every comparison with a limit.
inline double worse(double worst, double error) { return std::isnan(worst) || error <= worst ? worst : error; }

}  // namespace soilweave::test
