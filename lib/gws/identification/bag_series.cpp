// Series of one bag under rising surcharge.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/bag_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.h"
#include "files/exchange/table.h"

namespace soilweave::gws {

BagSeries BagSeries::from_row(std::size_t n) const {
  BagSeries rest = *this;
  const auto begun = static_cast<std::ptrdiff_t>(n);
  for (auto* values : {&rest.strain_axial, &rest.strain_volumetric, &rest.mean_stress, &rest.deviatoric_stress})
    values->erase(values->begin(), values->begin() + begun);
  if (!rest.contracting.empty()) rest.contracting.erase(rest.contracting.begin(), rest.contracting.begin() + begun);
  rest.row.erase(rest.row.begin(), rest.row.begin() + begun);
  return rest;
}

namespace {

// Greatest ratio of volumetric to axial strain: 3 for equal strains along all axes. Wrapped soil spreads and has less.
constexpr double greatest_volumetric = 3;

// Keeps the rows up to `last` whose axial strain is not below any earlier one. Returns the number of rows left out.
std::size_t keep_loading(BagSeries& s, std::size_t last) {
  std::size_t kept = 0;
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i <= last; ++i) {
    if (s.strain_axial[i] < greatest) continue;
    greatest = s.strain_axial[i];
    for (auto* values : {&s.strain_axial, &s.strain_volumetric, &s.mean_stress, &s.deviatoric_stress})
      (*values)[kept] = (*values)[i];
    if (!s.contracting.empty()) s.contracting[kept] = s.contracting[i];
    s.row[kept++] = s.row[i];
  }
  for (auto* values : {&s.strain_axial, &s.strain_volumetric, &s.mean_stress, &s.deviatoric_stress})
    values->resize(kept);
  if (!s.contracting.empty()) s.contracting.resize(kept);
  s.row.resize(kept);
  return last + 1 - kept;
}

// Throws DataError if row i has no numbers, or no compression.
void check_row(const BagSeries& s, std::size_t i, const std::string& where, std::size_t row) {
  if (!(s.mean_stress[i] > 0))
    throw DataError(
        fmt::format("{}: row {}: mean stress {} Pa; must be above 0, compression", where, row, s.mean_stress[i]));
  if (!std::isfinite(s.strain_axial[i] + s.strain_volumetric[i] + s.deviatoric_stress[i]))
    throw DataError(
        fmt::format("{}: row {}: a strain or stress is not a number; leave the row out, or mend it", where, row));
}

// Throws DataError for rows of loading that no wrapped soil under compression has: a strain of 1 or more, q/p of 3 or
// more, q of extension at the greatest axial stress, or volumetric strains far beyond the axial ones. natural: strains
// were logarithmic.
void check_loading(const BagSeries& s, const std::string& where, bool natural) {
  double axial = 0, volumetric = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    const auto judge = [&](const char* name, double strain, double& greatest) {
      greatest = std::max(greatest, std::abs(strain));
      if (const double given = natural ? -std::log1p(-strain) : strain; !(std::abs(given) < 1))
        throw DataError(
            fmt::format("{}: row {}: {} = {:.4g}; must be between -1 and 1: per cent are written {} [%] in the header",
                        where, s.row[i] + 1, name, given, name));
    };
    judge("strain_axial", s.strain_axial[i], axial);
    judge("strain_volumetric", s.strain_volumetric[i], volumetric);
    if (const double obliquity = s.deviatoric_stress[i] / s.mean_stress[i]; !(obliquity < 3))
      throw DataError(
          fmt::format("{}: row {}: q/p = {:.4g}; must be below 3, where the lateral stress is zero: check the units of "
                      "deviatoric_stress and mean_stress",
                      where, s.row[i] + 1, obliquity));
  }
  if (!(s.deviatoric_stress.back() > 0))
    throw DataError(
        fmt::format("{}: row {}: q = {:.4g} kPa at the greatest axial stress; must be above 0, sigma_a - "
                    "sigma_r with compression positive",
                    where, s.row.back() + 1, s.deviatoric_stress.back() / 1e3));
  if (volumetric > greatest_volumetric * axial)
    throw DataError(fmt::format(
        "{}: volumetric strains up to {:.4g} beside axial ones up to {:.4g}: check the units in the header, "
        "per cent are written [%]",
        where, volumetric, axial));
}

// Returns the stiffness of a column. Throws DataError if it changes, or differs by a per cent from the given stiffness
// (0: none).
double one_stiffness(const std::vector<double>& values, double given, const std::string& where, std::size_t first_row) {
  for (std::size_t i = 1; i < values.size(); ++i)
    if (!(std::abs(values[i] - values[0]) <= 1e-9 * std::abs(values[0])))
      throw DataError(
          fmt::format("{}: row {}: tensile_stiffness is {} N/m after {} N/m; a bag has one geotextile: give "
                      "each its own table",
                      where, first_row + i + 1, values[i], values[0]));
  if (given > 0 && std::abs(given - values[0]) > 0.01 * values[0])
    throw DataError(fmt::format(
        "{}: its column tensile_stiffness tells {:.4g} kN/m, --geotextile {:.4g} kN/m: leave one of them out", where,
        values[0] / 1e3, given / 1e3));
  return values[0];
}

}  // namespace

BagSeries bag_series(const io::Series& table, const std::string& where, double stiffness, bool natural,
                     std::size_t first_row) {
  BagSeries s;
  s.name = where;
  const auto column = [&](const char* name, const char* unit) { return io::in_unit(table, name, unit, where); };
  s.strain_axial = column(!table.find("strain_axial") && table.find("strain_zz") ? "strain_zz" : "strain_axial", "1");
  s.strain_volumetric = column("strain_volumetric", "1");
  s.mean_stress = column("mean_stress", "Pa");
  s.deviatoric_stress = column("deviatoric_stress", "Pa");
  if (table.rows() == 0) throw DataError(where + ": has no rows below its header");
  s.stiffness = table.find("tensile_stiffness")
                    ? one_stiffness(column("tensile_stiffness", "N/m"), stiffness, where, first_row)
                    : stiffness;
  if (!(s.stiffness > 0))
    throw DataError(fmt::format(
        "{}: no stiffness of the geotextile: give --geotextile for it, or a column tensile_stiffness", where));
  if (const io::Column* flags = table.find("contracting"))
    for (const double v : flags->values) s.contracting.push_back(v != 0);
  s.row.resize(s.size());
  std::iota(s.row.begin(), s.row.end(), first_row);
  std::size_t peak = 0;
  for (std::size_t i = 0; i < s.size(); ++i) {
    check_row(s, i, where, first_row + i + 1);
    if (natural) {
      s.strain_axial[i] = -std::expm1(-s.strain_axial[i]);
      s.strain_volumetric[i] = -std::expm1(-s.strain_volumetric[i]);
    }
    const auto axial = [&](std::size_t k) { return s.mean_stress[k] + 2 * s.deviatoric_stress[k] / 3; };
    if (axial(i) > axial(peak)) peak = i;
  }
  const std::size_t unloading = keep_loading(s, peak);
  if (s.size() < 3)
    throw DataError(fmt::format(
        "{}: rows up to the greatest axial stress whose axial strain does not fall: {}; at least 3 are needed: "
        "sort the rows by time, with compression positive",
        where, s.size()));
  check_loading(s, where, natural);
  if (s.size() < table.rows())
    s.note = fmt::format("{}: {} of {} rows, up to {}{}", where, s.size(), table.rows(),
                         peak + 1 < table.rows() ? "the greatest axial stress" : "the last",
                         unloading > 0 ? fmt::format(", less {} of unloading and reloading", unloading) : "");
  return s;
}

Identified range_of(const std::vector<BagSeries>& series) {
  Identified range;
  for (const BagSeries& one : series) {
    range.stiffness.add(one.stiffness);
    for (const double p : one.mean_stress) range.mean_stress.add(p);
    for (const double strain : one.strain_axial) range.axial_strain.add(strain);
  }
  return range;
}

}  // namespace soilweave::gws
