// Curves of a drained triaxial test, and their rules.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/laboratory/triaxial_curves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/text/text.h"
#include "core/text/units.h"
#include "files/exchange/table.h"
#include "files/files.h"

namespace soilweave::gws {
namespace {

// Bounds of calibration (pipelines/calibration/plausible.py), which tells their reasons; strains are fractions here.
constexpr double seated = 1.3, at_rest = 5e-5, least_ratio = 0.9, most_ratio = 15, no_strength = 1.05;
constexpr double least_axial = -0.05, most_volumetric = 0.3, beyond_axial = 0.02;
constexpr double least_friction = 22, most_friction = 55;
constexpr double clear_ratio = 0.3, clear_volume = 0.0025, begun = 1.1, clear_axial = 0.005;
constexpr double expansion_share = 0.01, least_expansion = 0.001;
constexpr double drained = 0.1;
constexpr double towering = 0.2, steps_beside = 3, empty_share = 1e-3, filled_share = 0.05;
constexpr std::size_t longest = 3;
// Volumetric strain that drained tests exceed at the axial strain.
constexpr double little_volume = 0.001, much_axial = 0.02;

constexpr std::initializer_list<const char*> axial_names = {"strain_axial", "axial_strain"},
                                             volumetric_names = {"strain_volumetric", "volumetric_strain"},
                                             lateral_names = {"radial_stress", "stress_radial", "confining_pressure",
                                                              "cell_pressure"};

/// Returns the first of `names` that the table has.
const char* name_of(const io::Series& table, std::initializer_list<const char*> names, const std::string& path) {
  for (const char* name : names)
    if (table.find(name)) return name;
  throw DataError(fmt::format("{}: has no column {}", path, fmt::join(names, " or ")));
}

bool is_stress(const io::Column& column) {
  try {
    return !column.unit.empty() && unit_factor(column.unit, "Pa") > 0;
  } catch (const DataError&) {
    return false;
  }
}

bool is_pore_pressure(std::string name) {
  std::ranges::transform(name, name.begin(), [](unsigned char c) { return std::tolower(c); });
  return name.find("pore") != std::string::npos || name == "u" || name == "du";
}

/// Returns axial over radial stress, from its own column or from the deviatoric stress.
std::vector<double> stress_ratios(const io::Series& table, const std::string& from, double pressure,
                                  const std::string& path) {
  if (from == "stress_ratio") return io::in_unit(table, from, "1", path);
  std::vector<double> ratios = io::in_unit(table, from, "Pa", path);
  for (double& q : ratios) q = 1 + q / pressure;
  return ratios;
}

/// Returns the rows whose axial strain is above 0 and above that of all rows before.
std::vector<std::size_t> rising(const std::vector<double>& strain) {
  std::vector<std::size_t> rows;
  double greatest = 0;
  for (std::size_t i = 0; i < strain.size(); ++i)
    if (strain[i] > greatest) greatest = strain[i], rows.push_back(i);
  return rows;
}

/// Throws DataError for the first row whose lateral stress differs by more than 10 % from the given pressure.
void judge_pressure(const io::Series& table, double pressure, const std::string& path) {
  constexpr double most = 0.1;  // cell pressure is held to some per cent
  std::vector<double> lateral;
  for (const char* name : lateral_names)
    if (lateral.empty() && table.find(name)) lateral = io::in_unit(table, name, "Pa", path);
  if (lateral.empty() && table.find("mean_stress") && table.find("deviatoric_stress")) {
    lateral = io::in_unit(table, "mean_stress", "Pa", path);
    const std::vector<double> deviatoric = io::in_unit(table, "deviatoric_stress", "Pa", path);
    for (std::size_t i = 0; i < lateral.size(); ++i) lateral[i] -= deviatoric[i] / 3;
  }
  for (std::size_t i = 0; i < lateral.size(); ++i)
    if (std::abs(lateral[i] / pressure - 1) > most)
      throw DataError(
          fmt::format("{}: row {}: its lateral stress is {:.4g} kPa, and pressure says {:.4g} kPa: check "
                      "both, and whether the test was drained at a constant pressure",
                      path, i + 1, lateral[i] / 1e3, pressure / 1e3));
}

/// Throws DataError for a test at a constant volume, or whose pore pressure rises or falls.
void judge_drained(const io::Series& table, const Curves& curves, double pressure, const std::string& path) {
  for (const io::Column& column : table.columns) {
    if (!is_pore_pressure(column.name) || !is_stress(column)) continue;
    std::vector<double> pore = io::in_unit(table, column.name, "Pa", path);
    std::erase_if(pore, [](double u) { return std::isnan(u); });
    if (pore.empty()) continue;
    const auto [low, high] = std::ranges::minmax(pore);
    if (high - low > drained * pressure)
      throw DataError(
          fmt::format("{}: is an undrained test by its {}, at rising or falling pore pressure: give a drained one",
                      path, column.name));
  }
  if (std::ranges::all_of(curves.volumetric, [](double v) { return v == 0; }))
    throw DataError(path + ": the volumetric strain is 0 in all rows, as in an undrained test: give a drained one");
}

/// Throws DataError for the first rising row that holds 0 although the rows beside it clearly differ from 0.
void judge_empty(const Curves& curves, const std::vector<double>& values, double clear, const std::string& name,
                 const std::string& path) {
  const std::vector<std::size_t> rows = rising(curves.strain);
  double most = 0;
  for (const std::size_t row : rows) most = std::max(most, std::abs(values[row]));
  const auto full = [&](std::size_t row) { return std::abs(values[row]) > empty_share * most; };
  std::optional<std::size_t> before;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (full(rows[k])) {
      before = rows[k];
      continue;
    }
    if (!before) continue;
    const auto after = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(k), rows.end(), full);
    const double one = values[*before], other = after == rows.end() ? one : values[*after];
    if (one * other > 0 && std::min(std::abs(one), std::abs(other)) > std::max(clear, filled_share * most))
      throw DataError(
          fmt::format("{}: row {}: {} falls to nothing at an axial strain of {:.4g} %, where rows beside it do not: "
                      "leave out rows without a value",
                      path, rows[k] + 1, name, 100 * curves.strain[rows[k]]));
  }
}

/// Throws DataError for the first row that is impossible in a drained test.
void judge(const Curves& curves, const std::string& path) {
  double greatest_axial = 0;
  for (std::size_t i = 0; i < curves.strain.size(); ++i) {
    const double strain = curves.strain[i], volumetric = curves.volumetric[i], ratio = curves.ratio[i];
    const auto refuse = [&](const std::string& what) {
      throw DataError(fmt::format("{}: row {}: {}", path, i + 1, what));
    };
    if (!std::isfinite(strain + volumetric + ratio)) refuse("a value is not a number: leave the row out");
    if (!(std::abs(strain) < 1))
      refuse(fmt::format("axial strain {:.4g}, which must be below 1: per cent are written [%] in the header", strain));
    if (!(strain > least_axial))
      refuse(fmt::format("the axial strain is {:.4g} %: compression is positive; correct the row", 100 * strain));
    if (i > 0 && strain < curves.strain[i - 1])
      refuse("the axial strain falls: leave out unloading, and give rows in the order of the test");
    if (!(std::abs(volumetric) < most_volumetric))
      refuse(fmt::format("volumetric strain {:.4g}, more than a test has: per cent are written [%] in the header",
                         volumetric));
    greatest_axial = std::max(greatest_axial, std::abs(strain));
    if (!(std::abs(volumetric) < greatest_axial + beyond_axial))
      refuse(
          fmt::format("the volumetric strain is {:.4g} % at an axial strain of {:.4g} %, more than a drained test has: "
                      "correct the row, or the unit of one of the columns, as [%] or [1]",
                      100 * volumetric, 100 * strain));
    if (!(ratio >= least_ratio && ratio <= most_ratio) || (strain <= at_rest && ratio > seated))
      refuse(
          fmt::format("axial over radial stress is {:.4g} at an axial strain of {:.3g}; it is 1 at rest and no soil "
                      "bears more than {:g}: check stress_ratio or deviatoric_stress, its unit, and the pressure",
                      ratio, strain, most_ratio));
  }
  if (const double most = std::ranges::max(curves.ratio); most < no_strength)
    throw DataError(fmt::format("{}: axial over radial stress never exceeds {:.4g}: check the unit of {} and pressure",
                                path, most, curves.stress));
  std::vector<double> sheared = curves.ratio;
  for (double& ratio : sheared) ratio -= 1;
  judge_empty(curves, sheared, clear_ratio, curves.stress, path);
  judge_empty(curves, curves.volumetric, clear_volume, "volumetric strain", path);
}

/// Returns the first row of a short run of rows that lies far beyond the rows on both sides of it; nothing if there is
/// none. The rows rise from rest, where the value is `rest`. The last row is compared with the slope before it.
std::optional<std::size_t> outlier(const Curves& curves, const std::vector<double>& values, double rest, double clear) {
  const std::vector<std::size_t> rows = rising(curves.strain);
  std::vector<double> strain{0}, value{rest}, step;
  for (const std::size_t row : rows) strain.push_back(curves.strain[row]), value.push_back(values[row]);
  const std::size_t count = value.size();
  for (std::size_t k = 1; k < count; ++k) step.push_back(value[k] - value[k - 1]);
  const auto far = [&](std::size_t first, std::size_t length, double height, double beside) {
    std::vector<double> rest_of = value;
    const auto at = rest_of.begin() + static_cast<std::ptrdiff_t>(first);
    rest_of.erase(at, at + static_cast<std::ptrdiff_t>(length));
    const auto [low, high] = std::ranges::minmax(rest_of);
    return height > std::max(clear, steps_beside * beside) && height > towering * (high - low);
  };
  for (std::size_t length = 1; length <= longest; ++length)
    for (std::size_t k = 1; k + length < count; ++k) {
      const double up = step[k - 1], down = step[k + length - 1];
      double beside = std::abs(value[k + length] - value[k - 1]);
      if (k > 1) beside = std::max(beside, std::abs(step[k - 2]));
      if (k + length < step.size()) beside = std::max(beside, std::abs(step[k + length]));
      if (up * down < 0 && far(k, length, std::min(std::abs(up), std::abs(down)), beside)) return rows[k - 1];
    }
  if (count <= longest) return std::nullopt;
  const double stretch =
      std::max(1.0, (strain[count - 1] - strain[count - 2]) / (strain[count - 2] - strain[count - 3]));
  const double beside = stretch * std::max(std::abs(step[count - 3]), std::abs(step[count - 4]));
  if (far(count - 1, 1, std::abs(step.back()), beside)) return rows.back();
  return std::nullopt;
}

/// Returns sentences on strains at the beginning that shearing did not cause: they are there where the stresses are
/// still those of rest, or the first row lies far from rest and near the next rows, or its volume changes more than its
/// height.
std::vector<std::string> before_shearing(const Curves& curves) {
  constexpr std::size_t next_rows = 5;
  std::vector<std::string> all;
  const std::vector<std::size_t> rows = rising(curves.strain);
  const std::size_t first = rows.front(), row = curves.ratio[first] < begun ? first : 0;
  const bool rests = curves.ratio[row] < begun;
  const auto say = [&](const char* name, double value, std::size_t at, const std::string& why) {
    all.push_back(fmt::format(
        "the {} strain is {:.3g} % in row {}, {}: strains count from the end of the isotropic compression; subtract "
        "what was there before, or give the rows from rest on",
        name, 100 * value, at + 1, why));
  };
  const std::string still = fmt::format("where axial over radial stress is still {:.4g}", curves.ratio[row]);
  const double axial = curves.strain[first], volumetric = curves.volumetric[first];
  double step = 0;
  for (std::size_t k = 1; k < rows.size() && k <= next_rows; ++k)
    step = std::max(step, curves.strain[rows[k]] - curves.strain[rows[k - 1]]);
  if (rests && std::abs(curves.strain[row]) > clear_axial)
    say("axial", curves.strain[row], row, still);
  else if (step > 0 && axial > std::max(clear_axial, steps_beside * step))
    say("axial", axial, first, fmt::format("and rises by {:.3g} % at most from row to row after it", 100 * step));
  if (rests && std::abs(curves.volumetric[row]) > clear_volume)
    say("volumetric", curves.volumetric[row], row, still);
  else if (std::abs(volumetric) > std::max(clear_volume, axial))
    say("volumetric", volumetric, first, "more than the axial strain");
  return all;
}

/// Returns whether the volume expands first and contracts then.
bool changed_signs(const std::vector<double>& volumetric) {
  const auto most = std::ranges::max_element(volumetric);
  const double expansion = -*std::min_element(volumetric.begin(), most + 1);
  return *most >= -std::ranges::min(volumetric) && expansion > std::max(least_expansion, expansion_share * *most);
}

}  // namespace

Curves read_curves(const std::string& path, double pressure, std::vector<io::Source>& sources) {
  const io::TextFile file = io::read_text(path, "triaxial test");
  sources.push_back(file.source);
  const io::Series table = io::from_tsv(file.text, path);
  const std::string axial = name_of(table, axial_names, path), volumetric = name_of(table, volumetric_names, path);
  Curves curves;
  curves.strain = io::in_unit(table, axial, "1", path);
  curves.volumetric = io::in_unit(table, volumetric, "1", path);
  curves.stress = name_of(table, {"stress_ratio", "deviatoric_stress"}, path);
  curves.ratio = stress_ratios(table, curves.stress, pressure, path);
  for (const std::string& name : {axial, volumetric})
    if (table.at(name).unit.empty()) curves.without_unit.push_back(name);
  const std::vector<std::string> like_stress = io::columns_like(table, curves.stress);
  for (const io::Column& column : table.columns)
    if (is_stress(column) && column.name != "mean_stress" && column.name != "deviatoric_stress" &&
        std::ranges::find(lateral_names, column.name) == lateral_names.end() &&
        std::ranges::find(like_stress, column.name) == like_stress.end())
      curves.unread.push_back(column.name);
  for (const auto& [name, names] : {std::pair{axial, axial_names}, std::pair{volumetric, volumetric_names}})
    for (const char* other : names)
      if (name != other && table.find(other)) curves.unread.emplace_back(other);
  for (const std::string& name : {axial, volumetric, curves.stress})
    for (const std::string& other : io::columns_like(table, name))
      curves.alike.push_back(
          fmt::format("the column {} is not read, but {}: if it is meant, leave {} out and give it that "
                      "name",
                      other, name, name));
  if (table.rows() == 0) throw DataError(path + ": has no rows below its header");
  judge(curves, path);
  judge_drained(table, curves, pressure, path);
  judge_pressure(table, pressure, path);
  return curves;
}

std::vector<Doubt> doubts(const Curves& curves, const std::string& path) {
  std::vector<Doubt> all;
  const auto say = [&](const char* key, const std::vector<std::string>& said) {
    if (!said.empty()) all.push_back({key, fmt::format("{}: {}", path, fmt::join(said, "; "))});
  };
  std::vector<std::string> units, unread = curves.alike, outliers;
  for (const std::string& name : curves.without_unit)
    units.push_back(name + " has no unit and is taken for a fraction; write [%] or [1]");
  say("triaxial-units", units);
  say("triaxial-rest", before_shearing(curves));
  if (changed_signs(curves.volumetric))
    say("triaxial-signs",
        {"the volume expands first and contracts then, where tests do the opposite: contraction is positive; change "
         "the signs of the volumetric strain if they are others"});
  double most = 0;
  for (const double v : curves.volumetric) most = std::max(most, std::abs(v));
  if (most < little_volume && curves.strain.back() > much_axial)
    say("triaxial-volume",
        {fmt::format(
            "the volumetric strain stays below {:.2g} % up to an axial strain of {:.3g} %, "
            "as in an undrained test, or with fractions under a head in [%]: give a drained test, or correct the head",
            100 * little_volume, 100 * curves.strain.back())});
  for (const std::string& name : curves.unread)
    unread.push_back(
        fmt::format("the column {} is not read{}", name,
                    is_pore_pressure(name) ? ", and the confining pressure has to be the effective one" : ""));
  say("triaxial-unread", unread);
  const auto look = [&](const std::string& name, const std::vector<double>& values, double rest, double clear) {
    if (const auto row = outlier(curves, values, rest, clear))
      outliers.push_back(
          fmt::format("{} of row {}, at an axial strain of {:.4g} %, lies far from the rows beside it: leave it out if "
                      "it is an error",
                      name, *row + 1, 100 * curves.strain[*row]));
  };
  look(curves.stress, curves.ratio, 1, clear_ratio);
  look("the volumetric strain", curves.volumetric, 0, clear_volume);
  say("triaxial-outlier", outliers);
  const double strength = std::ranges::max(curves.ratio);
  const double angle = std::asin((strength - 1) / (strength + 1)) / degree;
  if (angle > most_friction || (angle < least_friction && curves.ratio.back() < strength))
    say("triaxial-strength", {fmt::format("its friction angle is {:.3g} deg, where granular soils have {:g} to {:g}: "
                                          "check its stress and its confining pressure",
                                          angle, least_friction, most_friction)});
  return all;
}

}  // namespace soilweave::gws
