// Defaults of pack-generate, scaled to the size of the grains.
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

/// Returns the default rolling and twisting stiffness, N m/rad, for the mean radius R, m. It is 0.13 N m/rad (thesis
/// Table 3.1) times (R/R0)^3, with the mean radius R0 of the thesis's grains.
///
/// Reason for the cube: at equal pressure over Young's modulus E, Hertzian contacts have equal overlaps over R. Forces
/// are then f ~ E R^2, moments m ~ f R ~ E R^3. Soil responds alike at any size if the stiffness is a pure number times
/// E R^3. For the thesis's grains 0.13 N m/rad = 1.26e-3 E R0^3. E is the same for all sizes here.
///
/// A size whose stiffness rounds to the two published digits gets exactly 0.13.
double default_rotational_stiffness(double mean_radius);

/// Returns the default largest strain rate, 1/s: 1/s for the thesis's grains, in proportion to 1/R. A pressure moves a
/// grain by its size in a time R sqrt(density/p). So grains of any size are compressed in the same number of steps, at
/// the same inertial number.
double default_rate(double mean_radius);

/// Returns the default material as TOML: soil of thesis Table 3.1, with the stiffness above.
std::string default_material(double mean_radius);

/// A material file: [contact], [grains], [numerics], [guards].
struct Contacts {
  dem::Model model;
  dem::Numerics numerics;
  /// Density of the grains, kg/m3; 0: not given.
  double density = 0;
  /// TOML, for provenance.
  std::string resolved;

  /// Reads the text, called `name` in errors. Throws DataError with all mistakes.
  Contacts(std::string_view text, const std::string& name);
  /// Returns every key of a material file (core/text/keys.h).
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

  /// Returns the cell's narrowest width over the largest diameter.
  double diameters(std::size_t grains) const;
  /// Returns the least number of grains whose cell is `wanted` diameters wide; nullopt if it exceeds `most`.
  std::optional<std::size_t> fewest(double wanted, std::size_t most) const;
  /// Returns the largest cut-off diameter, m, at which n grains have a cell `wanted` diameters wide; nullopt if none.
  std::optional<double> coarsest(double wanted, std::size_t grains) const;
  /// Throws DataError with remedies if the cell is narrower than two largest grains.
  void demand(std::size_t grains) const;
  /// Throws the error of demand() for a cell `now` largest diameters wide.
  [[noreturn]] void refuse(std::size_t grains, double now) const;
  /// Returns the same grading at another void ratio.
  Room at(double other_void_ratio) const { return {curve, dimension, proportions, other_void_ratio}; }
};

/// Size of the grains: the curve's, or scaled.
struct GrainSize {
  /// Scale to the thesis's solid volume per grain.
  bool as_thesis = false;
  /// Scale to this mean radius, m; overrules as_thesis.
  std::optional<double> mean_radius;
};
/// Returns the radii of n grains of the curve, m.
std::vector<double> grain_radii(const Room& room, std::size_t n, const GrainSize& size);
/// Returns n such grains at random places (cloud.h). density: kg/m3. Throws DataError with remedies if the room is too
/// narrow for them, now or at the target void ratio.
io::Snapshot new_cloud(const Room& room, std::size_t n, const GrainSize& size, std::optional<double> void_ratio,
                       double density, std::uint64_t seed);

/// Returns the number of grains, from `least` to 20,000, that makes the cell of a wide grading wide enough. Returns
/// `least` if even 20,000 grains are too few.
std::size_t enough_grains(const Room& room, std::optional<double> void_ratio, std::size_t least);

/// Least width of a cell over its largest grain, so that the nearest image of a touching pair is unique (1/0.495).
inline constexpr double least_diameters = 2.03;
/// Least width where pack-generate chooses the number of grains. The margin allows for changing proportions.
inline constexpr double chosen_diameters = 2.3;

}  // namespace soilweave::packing
