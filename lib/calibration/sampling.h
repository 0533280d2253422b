// Points that fill the unit cube evenly. Rows are points, columns parameters.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "calibration/prior.h"

namespace soilweave::calibration {

/// Returns the digits of `index` mirrored at the point (van der Corput): 6 = 110 in base 2 gives 0.011 = 3/8.
double radical_inverse(std::uint64_t index, unsigned base);

/// Returns the first primes, Halton's own bases.
std::vector<unsigned> prime_bases(std::size_t dimension);

/// Parses "2,5,7,9,11". Throws UsageError for anything but numbers from 2 on, and if two share a factor: points would
/// lie on lines. Bases need not be primes (thesis chapter 2 uses 9).
std::vector<unsigned> parse_bases(std::string_view text);

/// Returns rows from `first` of the Halton sequence (Halton 1960); row 0 is the origin.
Matrix halton(std::size_t rows, const std::vector<unsigned>& bases, std::uint64_t first);

/// Returns rows from `first` of the Sobol sequence (GSL; Bratley and Fox 1988); row 0 is the origin. Throws DataError
/// above 40 dimensions.
Matrix sobol(std::size_t rows, std::size_t dimension, std::uint64_t first);

/// Returns one random point in each of `rows` slices of every axis (McKay et al. 1979). One seed gives the same points
/// everywhere.
Matrix latin_hypercube(std::size_t rows, std::size_t dimension, std::uint64_t seed);

}  // namespace soilweave::calibration
