// Constants of the wrapped soil (thesis Table 5.2).
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
// Here X = d eps_v^p / d eps_d^p is positive in contraction, and J is the geotextile's stiffness. Strains in the first
// three relations are in percent, because the thesis calibrated kappa, lambda and C_t so. Each line is one TOML table,
// as in data/soils or from `gws-solve identify`.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/doubts.h"
#include "core/parameter.h"
#include "core/text/named_file.h"
#include "core/text/settings.h"
#include "files/provenance.h"

namespace soilweave::gws {

/// Constants of the soil, SI. kappa, lambda, xi and C_t apply to strains in percent, alpha to J in MN/m. Defaults:
/// Toyoura sand at a void ratio of 0.68 (thesis Table 5.2). Poisson's ratio of 0.33, absent there, fits the author's
/// DEM series.
struct Soil {
  /// Compression line, Eq. 5.6.
  double C_t = 1.372, m = 0.3, p_a = 100e3, p_0 = 2.6e3;
  /// Failure-state line, Eq. 5.5.
  double M = 1.35, n = 0.0723, p_c = 3.255e6;
  /// Near-failure-state line, Eq. 5.4.
  double kappa = 1.386, lambda = 1.27, xi = 0.035;
  /// Stress-dilatancy line, Eq. 5.12.
  double p_1 = 1.68, p_2 = 0.344;
  /// Young's modulus E = alpha J^beta, Fig. 5.14.
  double alpha = 26.1e6, beta = 0.74;
  double poisson_ratio = 0.33;

  /// Returns Young's modulus of the wrapped soil, Pa. J: stiffness of the geotextile, N/m.
  double young_modulus(double J) const;
  bool operator==(const Soil&) const = default;
};

/// Description of one constant.
struct Constant {
  /// TOML table, as "failure_line".
  std::string_view line;
  /// Name, unit and range.
  Parameter parameter;
  /// Its member of Soil.
  double Soil::*field;

  /// Returns the full key, as "compression_line.C_t".
  std::string key() const;
};
/// Returns all constants in the order of Table 5.2.
std::span<const Constant> constants();

/// Scatter of the constants of one line. A 95 % interval is estimate ± t * standard error.
struct Scatter {
  /// Keys, as "near_failure_line.kappa".
  std::vector<std::string> keys;
  /// Correlation row by row; the unit matrix if unknown.
  std::vector<double> standard_errors, correlation;
  /// Degrees of freedom of Student's t.
  double freedom = 0;

  /// Returns Student's t for 95 %.
  double quantile() const;
};

/// Least and greatest value of some data.
struct Span {
  /// A high below low means unknown.
  double low = 0, high = -1;

  /// Returns whether it is known.
  bool known() const { return high >= low; }
  /// Widens it to include the value.
  void add(double value);
};

/// Ranges of the bags that the constants were identified on. Beyond them the constants are extrapolated.
struct Identified {
  /// Geotextile's stiffness, N/m; soil's mean stress, Pa; axial strain, 1.
  Span stiffness, mean_stress, axial_strain;
};

/// A soil with its name, scatter and ranges.
struct SoilFile {
  std::string name;
  Soil soil;
  std::vector<Scatter> scatter;
  Identified identified = {};
  /// How constants were estimated without bags; empty: they were not.
  std::string estimated = {};
  /// Doubts about the test that they were estimated from.
  std::vector<Doubt> doubts = {};
  /// Files that the soil's own file names.
  std::vector<io::Source> sources = {};
  /// Lines fitted to as many points as they have constants, whose scatter from point to point is unknown.
  std::vector<std::string> exact = {};
};

/// Reads a soil. With [estimate] absent constants are estimated; without it all are required. files: resolves the
/// document's file names. Mistakes go to the document, on which the caller calls finish().
SoilFile read_soil(Settings& document, const NamedFiles& files = {});
/// Returns TOML text that read_soil() reads back, after the lines of `comment`.
std::string soil_text(const SoilFile& file, std::string_view comment);

/// Returns the scatter with constant `key`, and its `place` there; nullptr if there is none.
const Scatter* scatter_of(const SoilFile& file, std::string_view key, std::size_t& place);

}  // namespace soilweave::gws
