// A million steps of a thousand grains at rest. It takes minutes and therefore stands apart from the tests of every
// build.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/long_run.h"

#include <gtest/gtest.h>

namespace soilweave {
namespace {

TEST(LongRun, OfAThousandGrainsAtRestDriftsByRoundingAlone) { support::expect_no_drift(1000, 1'000'000); }

}  // namespace
}  // namespace soilweave
