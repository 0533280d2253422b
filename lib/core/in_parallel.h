// Loops shared by threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace soilweave {

/// Calls use(i) once for every i < n. Each thread takes a contiguous range.
template <class Use>
void in_parallel(std::size_t n, int threads, const Use& use) {
  // OpenMP would create a new team at each call.
  if (threads == 1) {
    for (std::size_t i = 0; i < n; ++i) use(i);
    return;
  }
#pragma omp parallel for schedule(static) num_threads(threads)
  for (std::size_t i = 0; i < n; ++i) use(i);
}

/// Returns the largest value(i) for i < n, at least 0.
template <class Value>
double largest_in_parallel(std::size_t n, int threads, const Value& value) {
  const auto shares = static_cast<std::size_t>(threads);
  std::vector<double> largest(shares, 0.0);
  in_parallel(shares, threads, [&](std::size_t share) {
    double most = 0;
    const std::size_t end = (share + 1) * n / shares;
    for (std::size_t i = share * n / shares; i < end; ++i) most = std::max(most, value(i));
    largest[share] = most;
  });
  return *std::max_element(largest.begin(), largest.end());
}

/// Returns the sum of value(i) for i < n, with the same bits for any number of threads.
/// Sums each stretch of `stretch` values, then the stretches in order.
template <class Value>
auto sum_in_parallel(std::size_t n, std::size_t stretch, int threads, const Value& value) {
  using Sum = decltype(value(n));
  std::vector<Sum> sums((n + stretch - 1) / stretch, Sum{});
  in_parallel(sums.size(), threads, [&](std::size_t k) {
    Sum sum{};
    const std::size_t end = std::min(n, (k + 1) * stretch);
    for (std::size_t i = k * stretch; i < end; ++i) sum += value(i);
    sums[k] = sum;
  });
  Sum all{};
  for (const Sum& sum : sums) all += sum;
  return all;
}

}  // namespace soilweave
