// A scenario: contact law and materials, numerics, and the stages of loading, read from TOML and checked whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "core/settings.h"
#include "dem/path.h"
#include "io/provenance.h"

namespace soilweave::dem {

struct Stage {
  std::string name;
  std::unique_ptr<Path> path;
  bool reset_strain = false;             // the state at its start becomes the reference of the strains
  std::optional<double> friction;        // rad, of all materials from here on
  std::optional<double> plate_friction;  // rad, of the materials of planes against any other
  std::optional<double> damping;         // local damping during this stage
  std::optional<double> rest_damping;    // the same while a station waits for rest
  double way_unbalanced_force = 0;       // what goes a given way slows down to keep to it; 0: goes as fast as given
  double rest_drag = 0;                  // 1/s, of all motion, over the mass, while a station waits for rest
  bool critical_drag = false;            // rest_drag from the slowest homogeneous swing, as each wait begins
  bool homogeneous_start = false;        // ways begin and end with the homogeneous field of velocity (homogeneous.h)
};

/// Which recorded stations get a full snapshot beside their row in the series.
struct SnapshotRule {
  enum class Which { ends, stations, list };
  Which which = Which::ends;
  std::vector<double> strains;  // loading-axis strains, for `list`
};
/// Distance below which a strain to record is a station's.
inline constexpr double station_tolerance = 1e-7;

/// A plane or clamp that can be driven, and for a clamp the upright box of the nodes it holds, m.
struct PartSetting {
  RigPart part;
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

struct Scenario {
  Model model;
  Numerics numerics;
  /// kg/m3 by material_id, scaled; replaces the packing's masses where positive.
  std::vector<double> density;
  bool equal_steps = false;  // masses by which grains of any size bear the same step (mass_scaling.h)
  Tolerances tolerances;
  ServoRule servo;
  std::int64_t largest_station = 0;  // steps after which a station counts as unreachable
  SnapshotRule snapshots;
  std::vector<Stage> stages;
  io::PlanesRecord planes;
  std::vector<std::size_t> touching;  // planes whose point prepare() finds, where they touch the grains
  std::vector<PartSetting> parts;
  std::vector<io::Source> sources;  // files that the scenario named
  std::string resolved;             // the TOML with overrides applied, for provenance
};

/// [contact] (and [[material]]): the law and its materials. Used by every tool that steps grains.
Model read_model(Settings& document);
/// density key of [grains], kg/m3; 0 where absent.
double read_density(Settings& document);
/// [numerics] and [guards].
Numerics read_numerics(Settings& document);

/// Reads and checks everything; all mistakes are reported at once. Throws DataError.
Scenario read_scenario(std::string_view text, const std::string& name, const std::vector<std::string>& overrides);

/// Model with the friction angle of these materials replaced, rad; of every material where the list is empty.
Model with_friction(const Model& model, double angle, const std::vector<std::int32_t>& materials = {});
/// Model with these materials' friction angle, rad, against any other material: of plates, rough or smooth.
Model with_friction_against(const Model& model, double angle, const std::vector<std::int32_t>& materials);
/// Model with every friction angle multiplied.
Model with_friction_times(double factor, const Model& model);
/// Smallest friction angle of these materials, rad; of all of a model's materials where the list is empty.
double friction(const Model& model, const std::vector<std::int32_t>& materials = {});
/// rad; below this friction angle a packing is as dense as friction can make it.
inline constexpr double lowest_friction = 0.05 * std::numbers::pi / 180;

}  // namespace soilweave::dem
