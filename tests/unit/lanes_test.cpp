// The loops that other processors take give the bits of x86-64's vector instructions.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simd/lanes.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <limits>
#include <random>
#include <vector>

namespace soilweave {
namespace {

// Numbers of all sizes, with those that rounding, signs and limits treat in their own way.
std::vector<double> numbers() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> all{0.0,        -0.0, 1.0,    -1.0,    1.0 + 0x1p-52, 1.0 - 0x1p-53, 0x1p-1074,
                          -0x1p-1022, 1e16, -1e-16, 1.7e308, -infinity,     infinity};
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> digits(-2, 2);
  std::uniform_int_distribution<int> exponent(-60, 60);
  for (int k = 0; k < 400; ++k) all.push_back(std::ldexp(digits(random), exponent(random)));
  return all;
}

void expect_same(const Lane4& a, const Lane4& b) {
  for (int i = 0; i < 4; ++i)
    if (std::isnan(a[i]))
      EXPECT_TRUE(std::isnan(b[i]));
    else
      EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i]), std::bit_cast<std::uint64_t>(b[i])) << a[i] << " and " << b[i];
}

TEST(Lanes, OfLoopsHaveTheBitsOfTheInstructions) {
  const std::vector<double> x = numbers();
  const auto four = [&x](std::size_t k) {
    const auto at = [&](std::size_t i) { return x[i % x.size()]; };
    return Lane4{at(k), at(3 * k + 1), at(7 * k + 2), at(k * k + 3)};
  };
  for (std::size_t k = 0; k < x.size(); ++k) {
    const Lane4 a = four(k), b = four(5 * k + 11), c = four(13 * k + 4);
    expect_same(square_root(a), portable::square_root(a));
    expect_same(fused(a, b, c), portable::fused(a, b, c));
    expect_same(fused_less(a, b, c), portable::fused_less(a, b, c));
    // Where the product nearly cancels the third number, a second rounding would show.
    expect_same(fused(a, b, -(a * b)), portable::fused(a, b, -(a * b)));
    EXPECT_EQ(bits(a < b), portable::bits(a < b));
    std::array<double, 4> halves{}, other{};
    store_halves(halves.data(), halves.data() + 2, a);
    portable::store_halves(other.data(), other.data() + 2, a);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(halves[1]), std::bit_cast<std::uint64_t>(other[1]));
    EXPECT_EQ(std::bit_cast<std::uint64_t>(halves[2]), std::bit_cast<std::uint64_t>(other[2]));
  }
}

}  // namespace
}  // namespace soilweave
