// Geotextiles by name or by their numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/parameter.h"

namespace soilweave::gws {

/// Tension against strain, straight between points that both rise, from the origin on. Strains 1, tensions N/m.
struct TensionCurve {
  std::vector<double> strain, tension;

  bool known() const { return strain.size() > 1; }
  /// Returns the tension at a strain; beyond the last point that point's.
  double tension_at(double at) const;
  /// Returns the strain at a tension; beyond the last point that point's.
  double strain_at(double held) const;
};

/// Tensile properties of a geotextile, SI. It is perfectly elastic up to its end (thesis section 5.3, assumption 3b).
struct Geotextile {
  std::string name;
  double stiffness = 0;       // J, N/m
  double strength = 0;        // T_f, N/m
  double failure_strain = 0;  // strain at failure, 1
  TensionCurve curve = {};    // of its data sheet; empty: one stiffness
  double secant_at = 0;       // hoop strain where `stiffness` is the secant of the curve; 0: no curve

  /// Returns n layers: n times the tensions, at the same strain.
  Geotextile layers(double n) const;
};

inline constexpr Parameter tensile_stiffness{
    "stiffness", "N/m", 0, 1e10, true, "tensile stiffness J", "without stiffness the geotextile holds nothing"};
inline constexpr Parameter tensile_strength{
    "strength", "N/m", 0, 1e10, true, "tensile strength", "without strength the geotextile holds nothing"};
inline constexpr Parameter failure_strain_range{"failure_strain",
                                                "1",
                                                0,
                                                2,
                                                true,
                                                "strain at failure",
                                                "a strain of 1 is twice the length; per cent are written \"12 %\""};

/// Returns the names of the geotextiles in data/geotextiles, sorted.
std::vector<std::string> geotextile_names();

/// Returns a geotextile by name ("PP"), by a multiple of a name ("3PP", "0.5PP": thesis Fig. 5.15), from a TOML file (a
/// path with "/" or ".toml"), or from a catalogue ("FILE.toml:NAME", whose tables [[product]] are such files). With
/// "@machine" or "@cross" after it, that direction of a data sheet counts; else the lesser value of both. Throws
/// DataError that names the nearest known one.
Geotextile find_geotextile(const std::string& name);

/// Reads a geotextile from TOML text: stiffness, strength and failure_strain, or a data sheet
/// (gws/solution/data_sheet.h). `where` names the document in errors.
Geotextile read_geotextile(const std::string& text, const std::string& where, const std::string& direction = "");

/// Adds a usage mistake where the stiffness or strength of an option is below those of any geotextile, as a number in
/// kN/m is that was taken for N/m. `name`: the option, without hyphens.
void doubt_unit(const std::string& name, double value, std::vector<std::string>& wrong);

}  // namespace soilweave::gws
