// Geotextiles by name or by their numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/parameter.h"

namespace soilweave::gws {

/// Tensile properties of a geotextile, SI. It is perfectly elastic up to its end (thesis section 5.3, assumption 3b).
struct Geotextile {
  std::string name;
  double stiffness = 0;       // J, N/m
  double strength = 0;        // T_f, N/m
  double failure_strain = 0;  // strain at failure, 1

  /// Returns n layers: n times the stiffness and strength, at the same strain.
  Geotextile layers(double n) const;
};

inline constexpr Parameter tensile_stiffness{
    "stiffness", "N/m", 0, 1e10, true, "tensile stiffness J", "without stiffness the geotextile holds nothing"};
inline constexpr Parameter tensile_strength{
    "strength", "N/m", 0, 1e10, true, "tensile strength", "without strength the geotextile holds nothing"};
inline constexpr Parameter failure_strain_range{
    "failure_strain", "1", 0, 2, true, "strain at failure", "a strain of 1 is twice the length"};

/// Returns the names of the geotextiles in data/geotextiles, sorted.
std::vector<std::string> geotextile_names();

/// Returns a geotextile by name ("PP"), by a multiple of a name ("3PP", "0.5PP": thesis Fig. 5.15), or from a TOML file
/// (a path with "/" or ".toml"). Throws DataError that names the nearest known one.
Geotextile find_geotextile(const std::string& name);

/// Reads a geotextile from TOML text. `where` names the document in errors.
Geotextile read_geotextile(const std::string& text, const std::string& where);

}  // namespace soilweave::gws
