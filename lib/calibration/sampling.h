// Points that fill the unit cube evenly: Halton, Sobol, Latin hypercube. Rows are points, columns parameters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "calibration/prior.h"

namespace soilweave::calibration {

/// The digits of `index` in the base, mirrored at the point (van der Corput): 6 = 110 in base 2 gives 0.011 = 3/8.
double radical_inverse(std::uint64_t index, unsigned base);

/// The first primes: Halton's own bases.
std::vector<unsigned> prime_bases(std::size_t dimension);

/// "2,5,7,9,11". Throws UsageError where it is no list of numbers from 2 on, or two share a factor (the points would
/// lie on lines); bases need not be primes (thesis chapter 2 has 9 among them).
std::vector<unsigned> parse_bases(std::string_view text);

/// Rows first, first + 1, ... of the Halton sequence (Halton 1960); row 0 is the origin.
Matrix halton(std::size_t rows, const std::vector<unsigned>& bases, std::uint64_t first);

/// Rows first, first + 1, ... of the Sobol sequence (GSL; Bratley and Fox 1988); row 0 is the origin. Up to 40
/// dimensions, else DataError.
Matrix sobol(std::size_t rows, std::size_t dimension, std::uint64_t first);

/// One point at random in each of `rows` equal slices of every axis (McKay et al. 1979). The same seed gives the same
/// points everywhere.
Matrix latin_hypercube(std::size_t rows, std::size_t dimension, std::uint64_t seed);

}  // namespace soilweave::calibration
