// A grading curve by mass, and the grains that follow it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/grading.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/embedded.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/text/text.h"
#include "files/exchange/table.h"

SOILWEAVE_EMBED(toyoura, "data/gradings/toyoura.tsv")

namespace soilweave::packing {
namespace {

// Number of slices of equal mass that turn mass into number; the error falls with its square.
constexpr std::size_t slices = 100'000;

// Returns "; did you mean diameter instead of Diameter?" if a column has nearly this name.
std::string meant(const io::Series& table, const std::string& name) {
  for (const io::Column& column : table.columns)
    if (!nearest(column.name, {name}).empty())
      return fmt::format("; did you mean {} instead of {}?", name, column.name);
  return "";
}

}  // namespace

Grading Grading::from_tsv(std::string_view text, const std::string& where) {
  const io::Series table = io::from_tsv(text, where);
  for (const char* name : {"diameter", "finer_by_mass"})
    if (!table.find(name))
      throw DataError(fmt::format("{}: no column {} among {}{}: head the columns diameter [mm] and finer_by_mass [%]",
                                  where, name, io::column_names(table), meant(table, name)));
  Grading g;
  for (const char* name : {"diameter", "finer_by_mass"}) io::demand_one(table, name, where);
  for (const io::Column& column : table.columns)
    if (column.name != "diameter" && column.name != "finer_by_mass") g.unread.push_back(column.name);
  g.diameter = io::in_unit(table, "diameter", "m", where);
  g.finer = io::in_unit(table, "finer_by_mass", "1", where);
  const std::vector<double>&given = table.at("finer_by_mass").values, &sizes = table.at("diameter").values;
  const bool fractions = table.at("finer_by_mass").unit != "%";
  const bool percents = fractions && std::any_of(given.begin(), given.end(), [](double f) { return f > 1; });
  for (std::size_t k = 0; k < table.rows(); ++k) {
    const double f = g.finer[k];
    if (!(g.diameter[k] > 0 && std::isfinite(g.diameter[k])) || (k > 0 && g.diameter[k] <= g.diameter[k - 1]))
      throw DataError(fmt::format("{}: row {}: diameter {} is not above the one before: sort the sizes, all positive",
                                  where, k + 1, sizes[k]));
    if (!(f >= 0 && f <= 1) || (k > 0 && f < g.finer[k - 1]))
      throw DataError(fmt::format("{}: row {}: finer_by_mass {} must rise from 0 to {}{}", where, k + 1, given[k],
                                  fractions ? "1" : "100 %",
                                  percents ? ": are these per cent? head the column finer_by_mass [%]" : ""));
  }
  if (g.finer.empty()) throw DataError(where + ": no rows below the header");
  if (std::abs(g.finer.back() - 1) > 1e-12)
    throw DataError(
        fmt::format("{}: the last finer_by_mass is {}{}, not all: add the row of the largest diameter, with {}", where,
                    given.back(), fractions ? "" : " %", fractions ? "1" : "100"));
  return g;
}

Grading Grading::toyoura() { return from_tsv({toyoura_begin, toyoura_end}, "grading toyoura"); }

std::string Grading::left_out() const {
  if (!(finer.front() > 0) || diameter.size() == 1) return "";
  return fmt::format("the part finer than {:.4g} mm, {:.3g} % of the mass, is left out", 1e3 * diameter.front(),
                     100 * finer.front());
}

std::vector<std::string> Grading::notes(bool finest) const {
  std::vector<std::string> all;
  if (!unread.empty()) all.push_back(fmt::format("columns left out: {}", fmt::join(unread, ", ")));
  if (const std::string lack = left_out(); finest && !lack.empty()) all.push_back(lack);
  return all;
}

Grading Grading::up_to(double coarsest) const {
  if (coarsest < diameter.front() || (coarsest == diameter.front() && finer.front() == 0))
    throw DataError(fmt::format("nothing of the grading is finer than {:.4g} mm: its finest size is {:.4g} mm",
                                1e3 * coarsest, 1e3 * diameter.front()));
  if (coarsest >= diameter.back()) return *this;
  Grading cut;
  double share = finer.front();
  for (std::size_t k = 0; k < diameter.size() && diameter[k] <= coarsest; ++k) {
    cut.diameter.push_back(diameter[k]), cut.finer.push_back(finer[k]);
    share = finer[k];
  }
  const std::size_t next = cut.diameter.size();
  if (cut.diameter.back() < coarsest) {
    share += (finer[next] - share) * (coarsest - diameter[next - 1]) / (diameter[next] - diameter[next - 1]);
    cut.diameter.push_back(coarsest), cut.finer.push_back(share);
  }
  for (double& f : cut.finer) f /= share;
  return cut;
}

double Grading::quantile(double fraction) const {
  fraction = finer.front() + fraction * (1 - finer.front());
  const auto above = std::upper_bound(finer.begin(), finer.end(), fraction);
  if (above == finer.begin()) return diameter.front();
  if (above == finer.end()) return diameter.back();
  const auto i = static_cast<std::size_t>(above - finer.begin());
  const double share = (fraction - finer[i - 1]) / (finer[i] - finer[i - 1]);
  return diameter[i - 1] + share * (diameter[i] - diameter[i - 1]);
}

std::vector<double> Grading::radii(std::size_t n, int dimension) const {
  demand_memory(bytes_of_grain * static_cast<double>(n), std::to_string(n) + " grains", "give fewer");
  const auto number = [&](std::size_t k) {
    const double d = quantile((static_cast<double>(k) + 0.5) / slices);
    return std::pow(d, -dimension);
  };
  double total = 0;
  for (std::size_t k = 0; k < slices; ++k) total += number(k);
  std::vector<double> radius;
  double below = 0;
  std::size_t slice = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double goal = (static_cast<double>(i) + 0.5) / static_cast<double>(n) * total;
    while (slice + 1 < slices && below + number(slice) < goal) below += number(slice++);
    radius.push_back(0.5 * quantile((static_cast<double>(slice) + 0.5) / slices));
  }
  std::sort(radius.rbegin(), radius.rend());
  return radius;
}

}  // namespace soilweave::packing
