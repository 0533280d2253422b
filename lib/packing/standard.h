// Defaults of pack-generate: material, rate and number of grains, each fit for the grains' size.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dem/model.h"
#include "io/records.h"
#include "packing/grading.h"

namespace soilweave::packing {

/// Returns the mean radius of the grains, m.
double mean_radius(const io::Snapshot& state);

/// Returns the default rolling and twisting stiffness, N m/rad, of grains of this mean radius R, m: thesis Table 3.1's
/// 0.13 N m/rad times (R/R0)^3, R0 being the mean radius of the thesis's grains.
///
/// Why the cube: lengths of a packing are measured in R, stresses in Young's modulus E. At equal p/E Hertz's contacts
/// have equal overlaps over R, forces f ~ E R^2 and moments m ~ f R ~ E R^3. An angle has no dimension, so that a
/// stiffness against rotation must be E R^3 times a pure number, if the soil is to answer alike at any size. The
/// thesis's grains have 0.13 N m/rad = 1.26e-3 E R0^3. E is the same here for all sizes.
///
/// A size whose stiffness rounds to the published two digits is the thesis's own, and has exactly 0.13.
double default_rotational_stiffness(double mean_radius);

/// Returns the default largest strain rate, 1/s, in proportion to 1/R from 1/s for the thesis's own grains. The time
/// that a pressure takes to move a grain by its size is R sqrt(density/p): at equal density and pressure, grains of any
/// size are then compressed in as many steps, and at the same inertial number.
double default_rate(double mean_radius);

/// Returns the default material as TOML: thesis Table 3.1, soil, with the stiffness above.
std::string default_material(double mean_radius);

/// A contact law with all that a material file may say: [contact], [grains], [numerics], [guards].
struct Contacts {
  dem::Model model;
  dem::Numerics numerics;
  double density;        // kg/m3; 0: not said
  std::string resolved;  // TOML, for provenance

  /// Throws DataError with all mistakes of the text, which errors call `name`.
  Contacts(std::string_view text, const std::string& name);
};

/// The cell that n grains of a grading make.
struct Room {
  Grading curve;
  int dimension;
  Vec3 proportions;
  double void_ratio;

  /// Narrowest width of the cell over the diameter of the largest grain.
  double diameters(std::size_t grains) const;
  /// Fewest grains whose cell is `wanted` diameters wide; nullopt where that is more than `most`.
  std::optional<std::size_t> fewest(double wanted, std::size_t most) const;
  /// Largest diameter, m, at which the curve may be cut off for n grains to have such a cell; nullopt if there is none.
  std::optional<double> coarsest(double wanted, std::size_t grains) const;
  /// Throws DataError where the cell of n grains is narrower than two largest grains, with what would mend it.
  void demand(std::size_t grains) const;
  /// Throws that error of a cell that is `now` diameters of the largest grain wide.
  [[noreturn]] void refuse(std::size_t grains, double now) const;
  Room at(double other_void_ratio) const { return {curve, dimension, proportions, other_void_ratio}; }
};

/// Scales radii, m, to a mean radius.
void scale_to_mean(double mean_radius, std::vector<double>& radii);
/// Scales radii, m, to the thesis's solid volume a grain: the size of the built-in grading, however many grains there
/// are.
void scale_to_thesis(std::vector<double>& radii);

/// Returns `least`, or the number of grains that a wide grading takes where that is more and still of moderate size.
std::size_t enough_grains(const Room& room, std::optional<double> void_ratio, std::size_t least);

/// Least cell width over the largest grain: the nearest image of a touching pair must be the only one (1/0.495).
inline constexpr double least_diameters = 2.03;
/// Least cell width where pack-generate chooses the number of grains: a margin for a cell that changes its proportions.
inline constexpr double chosen_diameters = 2.3;

}  // namespace soilweave::packing
