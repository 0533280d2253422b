// The worst of many errors, for tests that compare it with a limit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace soilweave::test {

/// Returns the larger of the two. A NaN among them stays, as std::max would not let it: no comparison with a limit
/// passes.
inline double worse(double worst, double error) { return std::isnan(worst) || error <= worst ? worst : error; }

}  // namespace soilweave::test
