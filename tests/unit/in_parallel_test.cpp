// Loops shared by threads give the same bits on any number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/in_parallel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace soilweave {
namespace {

TEST(InParallel, UsesEveryNumberOnce) {
  for (const int threads : {1, 2, 3}) {
    std::vector<int> used(50, 0);
    in_parallel(used.size(), threads, [&](std::size_t i) { ++used[i]; });
    EXPECT_EQ(used, std::vector<int>(50, 1));
  }
}

TEST(InParallel, SumsHaveTheSameBitsOnAnyNumberOfThreads) {
  const auto value = [](std::size_t i) { return std::sqrt(static_cast<double>(i)) - 3; };
  const double one = sum_in_parallel(1000, 64, 1, value);
  double in_order = 0;
  for (std::size_t i = 0; i < 1000; ++i) in_order += value(i);
  EXPECT_NEAR(one, in_order, 1e-9);
  for (const int threads : {2, 3, 7}) EXPECT_EQ(sum_in_parallel(1000, 64, threads, value), one);
  EXPECT_EQ(sum_in_parallel(1000, 1000, 2, value), in_order) << "one stretch is summed as it comes";
  EXPECT_EQ(sum_in_parallel(0, 64, 2, value), 0);
}

TEST(InParallel, FindsTheLargest) {
  const auto value = [](std::size_t i) { return i == 17 ? 5.0 : -1.0; };
  for (const int threads : {1, 2, 3}) {
    EXPECT_EQ(largest_in_parallel(40, threads, value), 5);
    EXPECT_EQ(largest_in_parallel(10, threads, value), 0);
  }
}

}  // namespace
}  // namespace soilweave
