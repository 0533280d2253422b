// Points that fill the unit cube evenly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/sampling.h"

#include <fmt/format.h>
#include <gsl/gsl_qrng.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <numeric>
#include <random>

#include "core/error.h"
#include "core/text/number_word.h"

namespace soilweave::calibration {
namespace {

/// Returns a uniform number in [0, 1) from the engine's bits alone, because standard distributions differ between
/// libraries.
double uniform(std::mt19937_64& engine) { return static_cast<double>(engine() >> 11) * 0x1.0p-53; }

}  // namespace

double radical_inverse(std::uint64_t index, unsigned base) {
  double value = 0, place = 1;
  for (; index > 0; index /= base) {
    place /= base;
    value += place * static_cast<double>(index % base);
  }
  return value;
}

std::vector<unsigned> prime_bases(std::size_t dimension) {
  std::vector<unsigned> primes;
  for (unsigned candidate = 2; primes.size() < dimension; ++candidate)
    if (std::none_of(primes.begin(), primes.end(), [&](unsigned p) { return candidate % p == 0; }))
      primes.push_back(candidate);
  return primes;
}

std::vector<unsigned> parse_bases(std::string_view text) {
  std::vector<unsigned> bases;
  for (const std::string& part : parts_of_list(text)) {
    unsigned base = 0;
    const auto [stop, status] = std::from_chars(part.data(), part.data() + part.size(), base);
    if (status != std::errc() || stop != part.data() + part.size() || base < 2)
      throw UsageError(
          fmt::format("--bases {}: '{}' is no base; give whole numbers from 2 on, as in 2,3,5", text, part));
    for (const unsigned other : bases)
      if (std::gcd(base, other) > 1)
        throw UsageError(
            fmt::format("--bases {}: {} and {} share a factor, so that the points would lie on lines; choose others",
                        text, other, base));
    bases.push_back(base);
  }
  return bases;
}

Matrix halton(std::size_t rows, const std::vector<unsigned>& bases, std::uint64_t first) {
  Matrix points(index(rows), index(bases.size()));
  for (std::size_t i = 0; i < rows; ++i)
    for (std::size_t k = 0; k < bases.size(); ++k) points(index(i), index(k)) = radical_inverse(first + i, bases[k]);
  return points;
}

Matrix sobol(std::size_t rows, std::size_t dimension, std::uint64_t first) {
  if (dimension > gsl_qrng_sobol->max_dimension)
    throw DataError(fmt::format("{} parameters; the Sobol sequence has {} at most: use halton or latin-hypercube",
                                dimension, gsl_qrng_sobol->max_dimension));
  const std::unique_ptr<gsl_qrng, decltype(&gsl_qrng_free)> sequence(
      gsl_qrng_alloc(gsl_qrng_sobol, static_cast<unsigned>(dimension)), gsl_qrng_free);
  Matrix points = Matrix::Zero(index(rows), index(dimension));
  std::vector<double> point(dimension);
  // GSL leaves the origin out.
  for (std::uint64_t skipped = 1; skipped < first; ++skipped) gsl_qrng_get(sequence.get(), point.data());
  for (std::size_t i = first == 0 ? 1 : 0; i < rows; ++i) {
    gsl_qrng_get(sequence.get(), point.data());
    for (std::size_t k = 0; k < dimension; ++k) points(index(i), index(k)) = point[k];
  }
  return points;
}

Matrix latin_hypercube(std::size_t rows, std::size_t dimension, std::uint64_t seed) {
  std::mt19937_64 engine(seed);
  Matrix points(index(rows), index(dimension));
  std::vector<std::size_t> slice(rows);
  for (std::size_t k = 0; k < dimension; ++k) {
    std::iota(slice.begin(), slice.end(), std::size_t{0});
    for (std::size_t i = rows; i > 1; --i)
      std::swap(slice[i - 1], slice[static_cast<std::size_t>(uniform(engine) * static_cast<double>(i))]);
    for (std::size_t i = 0; i < rows; ++i)
      points(index(i), index(k)) = (static_cast<double>(slice[i]) + uniform(engine)) / static_cast<double>(rows);
  }
  return points;
}

}  // namespace soilweave::calibration
