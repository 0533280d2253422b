// The constants of the wrapped soil (thesis Table 5.2): what they are, where they may lie, how they are read and
// written.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The soil in a bag obeys five relations, each a line through results of tests (thesis section 5.3):
//
//   compression line      eps_v^e = C_t [(p/p_a)^m - (p_0/p_a)^m]       elastic volume, percent     Eq. 5.6
//   failure line          M_f = M (p/p_c)^-n                            q/p at failure falls with p Eq. 5.5
//   near-failure line     M_f - q/p = kappa/(eps_d + lambda) - xi       q/p climbs towards M_f      Eq. 5.4
//   dilatancy line        -X = (M_f - M) - [p_1 (M_f - q/p) - p_2]      contraction, then dilation  Eq. 5.12
//   stiffness             E = alpha J^beta                              of the soil in its wrap     Fig. 5.14
//
// Here X = d eps_v^p / d eps_d^p is positive in contraction, and J is the geotextile's stiffness. The constants of a
// line stand in one TOML table: of data/soils, of a user's file, or as `gws-solve identify` writes them, with scatter.
// Strains in the first three relations are in percent, because the thesis calibrated kappa, lambda and C_t so.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"
#include "core/text/settings.h"

namespace soilweave::gws {

/// Constants of the soil, SI. kappa, lambda, xi and C_t apply to strains in percent, alpha to J in MN/m. Defaults:
/// thesis Table 5.2 for Toyoura sand at a void ratio of 0.68. The table lacks Poisson's ratio: 0.33 fits the author's
/// DEM series.
struct Soil {
  double C_t = 1.372, m = 0.3, p_a = 100e3, p_0 = 2.6e3;  // compression line, Eq. 5.6
  double M = 1.35, n = 0.0723, p_c = 3.255e6;             // failure-state line, Eq. 5.5
  double kappa = 1.386, lambda = 1.27, xi = 0.035;        // near-failure-state line, Eq. 5.4
  double p_1 = 1.68, p_2 = 0.344;                         // stress-dilatancy line, Eq. 5.12
  double alpha = 26.1e6, beta = 0.74;                     // Young's modulus E = alpha J^beta, Fig. 5.14
  double poisson_ratio = 0.33;

  /// Returns Young's modulus of the wrapped soil, Pa, for a geotextile of stiffness J, N/m.
  double young_modulus(double J) const;
};

/// Description of one constant: its line (a TOML table), its parameter, its field in Soil.
struct Constant {
  std::string_view line;  // "compression_line", "failure_line", ...
  Parameter parameter;
  double Soil::*field;

  std::string key() const;  // "compression_line.C_t"
};
/// Returns all constants in the order of Table 5.2.
std::span<const Constant> constants();

/// Scatter of the constants of one line: standard errors and correlation (row by row; the unit matrix if the source
/// gives none). A 95 % interval is estimate ± t * standard error, with Student's t for `freedom` degrees.
struct Scatter {
  std::vector<std::string> keys;  // "near_failure_line.kappa", ...
  std::vector<double> standard_errors, correlation;
  double freedom = 0;

  double quantile() const;  // Student's t for 95 %
};

/// Least and greatest value of some data.
struct Span {
  double low = 0, high = -1;  // high < low: not known

  /// Returns whether the range is known.
  bool known() const { return high >= low; }
  /// Widens the range to include the value.
  void add(double value);
};

/// Ranges of the bags on which the constants were identified: stiffness of the geotextile (N/m), mean stress of the
/// soil (Pa), axial strain (1). Beyond them the constants are extrapolated.
struct Identified {
  Span stiffness, mean_stress, axial_strain;
};

/// A soil with its name, scatter and ranges.
struct SoilFile {
  std::string name;
  Soil soil;
  std::vector<Scatter> scatter;
  Identified identified = {};
  std::string estimated = {};  // how the constants were estimated where no bags were computed; empty: they were not
};

/// Reads a soil; absent keys take their defaults. Mistakes go to the document, on which the caller calls finish().
SoilFile read_soil(Settings& document);
/// Returns a soil as TOML text that read_soil() reads back. `comment` lines come first.
std::string soil_text(const SoilFile& file, std::string_view comment);

/// Returns the scatter that includes constant `key`, and its `place` there; nullptr if it has none.
const Scatter* scatter_of(const SoilFile& file, std::string_view key, std::size_t& place);

}  // namespace soilweave::gws
