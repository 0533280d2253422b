// The constants of the wrapped soil (thesis Table 5.2): what they are, where they may lie, how they are read and
// written. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"
#include "core/settings.h"

namespace soilweave::gws {

/// SI. kappa, lambda, xi and C_t belong to strains in percent, alpha to J in MN/m. Defaults: thesis Table 5.2, Toyoura
/// sand at a void ratio of 0.68; Poisson's ratio is not in the table: 0.33 is what the author's DEM series are met
/// with.
struct Soil {
  double C_t = 1.372, m = 0.3, p_a = 100e3, p_0 = 2.6e3;  // compression line, Eq. 5.6
  double M = 1.35, n = 0.0723, p_c = 3.255e6;             // failure-state line, Eq. 5.5
  double kappa = 1.386, lambda = 1.27, xi = 0.035;        // near-failure-state line, Eq. 5.4
  double p_1 = 1.68, p_2 = 0.344;                         // stress-dilatancy line, Eq. 5.12
  double alpha = 26.1e6, beta = 0.74;                     // Young's modulus E = alpha J^beta, Fig. 5.14
  double poisson_ratio = 0.33;

  /// Young's modulus of the wrapped soil, Pa, for a geotextile of stiffness J, N/m.
  double young_modulus(double J) const;
};

/// One constant: its table in the TOML, its description, its place.
struct Constant {
  std::string_view line;  // "compression_line", "failure_line", ...
  Parameter parameter;
  double Soil::*field;

  std::string key() const;  // "compression_line.C_t"
};
std::span<const Constant> constants();

/// What is known of the scatter of the constants of one line: the standard errors, and the correlation (row by row; the
/// unit matrix where the source gives none). An interval of 95 % is estimate ± t * standard error, t of `freedom`
/// degrees.
struct Scatter {
  std::vector<std::string> keys;  // "near_failure_line.kappa", ...
  std::vector<double> standard_errors, correlation;
  double freedom = 0;

  double quantile() const;  // Student's t for 95 %
};

/// From the least to the greatest value of some data.
struct Span {
  double low = 0, high = -1;  // high below low: not known

  bool known() const { return high >= low; }
  /// Widens the range to hold the value.
  void add(double value);
};

/// Ranges of the bags that the constants were identified on: stiffness of the geotextile, N/m, mean stress of the soil,
/// Pa, axial strain as a fraction. Beyond them the constants are extrapolated.
struct Identified {
  Span stiffness, mean_stress, axial_strain;
};

struct SoilFile {
  std::string name;
  Soil soil;
  std::vector<Scatter> scatter;
  Identified identified = {};
};

/// Reads a soil, absent keys from the defaults. Mistakes go to the document; the caller calls finish().
SoilFile read_soil(Settings& document);
/// The same as TOML text that read_soil reads back. `comment` lines come first.
std::string soil_text(const SoilFile& file, std::string_view comment);

/// The constants with their scatter, nullptr where a constant has none.
const Scatter* scatter_of(const SoilFile& file, std::string_view key, std::size_t& place);

}  // namespace soilweave::gws
