// Defaults of pack-generate: material, rate and number of grains, each fit for the grains' size.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/settings.h"
#include "dem/contact/model.h"
#include "files/records.h"
#include "packing/generate/grading.h"

namespace soilweave::packing {

/// Returns the mean radius of the grains, m.
double mean_radius(const io::Snapshot& state);

/// Returns the default rolling and twisting stiffness, N m/rad, of grains of mean radius R, m: 0.13 N m/rad of thesis
/// Table 3.1 times (R/R0)^3, with the mean radius R0 of the thesis's grains.
///
/// Reason for the cube: lengths of a packing scale with R, stresses with Young's modulus E. At equal p/E, Hertzian
/// contacts have equal overlaps over R, forces f ~ E R^2 and moments m ~ f R ~ E R^3. An angle has no dimension. So a
/// stiffness against rotation must be E R^3 times a pure number, if soil is to respond alike at any size. For the
/// thesis's grains 0.13 N m/rad = 1.26e-3 E R0^3. E is the same for all sizes here.
///
/// A size whose stiffness rounds to the published two digits is the thesis's own, and gets exactly 0.13.
double default_rotational_stiffness(double mean_radius);

/// Returns the default largest strain rate, 1/s: 1/s for the thesis's grains, in proportion to 1/R. A pressure moves a
/// grain by its size in a time R sqrt(density/p). At equal density and pressure, grains of any size are then compressed
/// in as many steps, at the same inertial number.
double default_rate(double mean_radius);

/// Returns the default material as TOML: thesis Table 3.1, soil, with the stiffness above.
std::string default_material(double mean_radius);

/// A contact law with all that a material file may contain: [contact], [grains], [numerics], [guards].
struct Contacts {
  dem::Model model;
  dem::Numerics numerics;
  double density = 0;    // kg/m3; 0: not given
  std::string resolved;  // TOML, for provenance

  /// Reads the text, which errors call `name`. Throws DataError with all mistakes.
  Contacts(std::string_view text, const std::string& name);
  /// Returns every key that a material file may have (core/text/keys.h).
  static std::vector<Key> keys();

 private:
  Contacts() = default;
  void read(Settings& document);
};

/// The cell that n grains of a grading form.
struct Room {
  Grading curve;
  int dimension;
  Vec3 proportions;
  double void_ratio;

  /// Returns the narrowest width of the cell over the diameter of the largest grain.
  double diameters(std::size_t grains) const;
  /// Returns the least number of grains whose cell is `wanted` diameters wide; nullopt if it exceeds `most`.
  std::optional<std::size_t> fewest(double wanted, std::size_t most) const;
  /// Returns the largest diameter, m, at which cutting the curve off gives n grains such a cell; nullopt if there is
  /// none.
  std::optional<double> coarsest(double wanted, std::size_t grains) const;
  /// Throws DataError with remedies if the cell of n grains is narrower than two largest grains.
  void demand(std::size_t grains) const;
  /// Throws that error for a cell that is `now` diameters of the largest grain wide.
  [[noreturn]] void refuse(std::size_t grains, double now) const;
  /// Returns the same grading at another void ratio.
  Room at(double other_void_ratio) const { return {curve, dimension, proportions, other_void_ratio}; }
};

/// Size of the grains of a grading: as the curve says, or scaled.
struct GrainSize {
  bool as_thesis = false;             // to the thesis's solid volume per grain, for any number of grains
  std::optional<double> mean_radius;  // to this mean radius, m; overrules the other
};
/// Returns the radii of n grains of the room's curve, m.
std::vector<double> grain_radii(const Room& room, std::size_t n, const GrainSize& size);
/// Returns n such grains at random places of the room (cloud.h), with a density in kg/m3. Throws DataError with
/// remedies if the room is too narrow for them, now or at the void ratio to reach.
io::Snapshot new_cloud(const Room& room, std::size_t n, const GrainSize& size, std::optional<double> void_ratio,
                       double density, std::uint64_t seed);

/// Returns `least`, or the number of grains that a wide grading needs, if that is larger and still moderate.
std::size_t enough_grains(const Room& room, std::optional<double> void_ratio, std::size_t least);

/// Least width of a cell over its largest grain: the nearest image of a touching pair must be unique (1/0.495).
inline constexpr double least_diameters = 2.03;
/// Least width when pack-generate chooses the number of grains: a margin for a cell that changes its proportions.
inline constexpr double chosen_diameters = 2.3;

}  // namespace soilweave::packing
