// Geotextiles by name or by their numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/parameter.h"

namespace soilweave::gws {

/// Tension against strain. Straight pieces rise from the origin.
struct TensionCurve {
  /// Strains 1, tensions N/m.
  std::vector<double> strain, tension;

  /// Returns whether there is a curve.
  bool known() const { return strain.size() > 1; }
  /// Returns the tension at a strain; the last one beyond the end.
  double tension_at(double at) const;
  /// Returns the strain at a tension; the last one beyond the end.
  double strain_at(double held) const;
};

/// Tensile properties. The geotextile is elastic up to its end (thesis section 5.3, assumption 3b).
struct Geotextile {
  std::string name;
  /// Stiffness J, N/m.
  double stiffness = 0;
  /// Strength T_f, N/m.
  double strength = 0;
  /// Strain at failure, 1.
  double failure_strain = 0;
  /// Curve of its data sheet; empty: one stiffness.
  TensionCurve curve = {};
  /// Hoop strain at which `stiffness` is the secant; 0: no curve.
  double secant_at = 0;

  /// Returns n layers: n times the tensions, at the same strain.
  Geotextile layers(double n) const;
};

inline constexpr Parameter tensile_stiffness{
    "stiffness", "N/m", 0, 1e10, true, "tensile stiffness J", "without stiffness the geotextile holds nothing"};
inline constexpr Parameter tensile_strength{
    "strength", "N/m", 0, 1e10, true, "tensile strength", "without strength the geotextile holds nothing"};
// Even glass and carbon fibres break at more than the lower bound.
inline constexpr Parameter failure_strain_range{"failure_strain",
                                                "1",
                                                0.01,
                                                2,
                                                true,
                                                "strain at failure",
                                                "a strain of 1 is twice the length; per cent are written \"12 %\""};

/// Returns the names of the geotextiles in data/geotextiles, sorted.
std::vector<std::string> geotextile_names();

/// Returns a geotextile by name ("PP"), multiple ("3PP", "0.5PP": thesis Fig. 5.15), TOML file (a path with "/" or
/// ".toml") or catalogue entry ("FILE.toml:NAME", with tables [[product]]; only this product is checked). "@machine" or
/// "@cross" after it chooses a direction of a data sheet; default: the softer and weaker of both. Throws DataError that
/// names the nearest known one.
Geotextile find_geotextile(const std::string& name);

/// Reads TOML text: stiffness, strength and failure_strain, or a data sheet (gws/solution/data_sheet.h). where: name of
/// the document in errors.
Geotextile read_geotextile(const std::string& text, const std::string& where, const std::string& direction = "");

/// Returns an error text if a stiffness or strength, N/m, is below any geotextile's, probably because kN/m were given
/// without their unit. Returns an empty text otherwise. name: the parameter's name.
std::string unit_mistake(const std::string& name, double value);

}  // namespace soilweave::gws
