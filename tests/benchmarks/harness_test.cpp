// Tests that hang or skip on request, with which tests/tools/harness.bats tries the runner of the test programs
// (tests/main.cpp).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>

#include "support/worse.h"

namespace {

TEST(Harness, TheWorstErrorIsANanWhereOneIs) {
  using soilweave::test::worse;
  EXPECT_EQ(worse(worse(0, 2), 1), 2);
  EXPECT_TRUE(std::isnan(worse(worse(worse(0, 1), std::nan("")), 2)));
}

TEST(Harness, HangsWhereAskedTo) {
  if (std::getenv("SOILWEAVE_TRY_HANGING") != nullptr) pause();
}

TEST(Harness, SkipsWhereAskedTo) {
  if (std::getenv("SOILWEAVE_TRY_SKIPPING") != nullptr) GTEST_SKIP() << "asked to";
}

}  // namespace
