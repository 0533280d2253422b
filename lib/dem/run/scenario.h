// A scenario: contact law and materials, numerics, and the stages of loading, read from TOML and checked as a whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/text/named_file.h"
#include "core/text/settings.h"
#include "dem/loading/path.h"
#include "files/provenance.h"

namespace soilweave::dem {

/// One stage of loading.
struct Stage {
  /// Name of the stage.
  std::string name;
  /// Loading path.
  std::unique_ptr<Path> path;
  /// Whether the state at the start of the stage becomes the reference of the strains.
  bool reset_strain = false;
  /// Friction angle of all materials from this stage on, rad. Planes keep plate_friction if a stage has given it.
  std::optional<double> friction;
  /// Friction angle of the planes' materials against any other from this stage on, rad.
  std::optional<double> plate_friction;
  /// Local damping during this stage.
  std::optional<double> damping;
  /// Local damping while a station waits for rest.
  std::optional<double> rest_damping;
  /// Unbalanced force above which the loading slows down; 0: it never slows down.
  double way_unbalanced_force = 0;
  /// Drag on all motion, over the mass, 1/s, while a station waits for rest.
  double rest_drag = 0;
  /// Whether the drag is Swing::critical_drag(), which follows the swing during each wait, instead of rest_drag.
  bool critical_drag = false;
  /// Whether loading begins and ends with a homogeneous field of velocity (homogeneous.h).
  bool homogeneous_start = false;
};

/// Rule that selects which recorded stations get a full snapshot.
struct SnapshotRule {
  /// First and last state, every station, or stations at listed strains.
  enum class Which { ends, stations, list };
  Which which = Which::ends;
  /// Strains along the loading axis, for `list`: since the start of their stage or since the reference.
  std::vector<double> strains;
};
/// Largest difference between a listed strain and the strain of its station.
inline constexpr double station_tolerance = 1e-7;

/// Returns whether the strain is among `strains`, within station_tolerance.
bool is_at(const std::vector<double>& strains, double strain);

/// A plate or clamp that can be driven.
struct PartSetting {
  /// Plate or clamp.
  RigPart part;
  /// Corners of the upright box around the nodes that a clamp holds, m.
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

/// A whole scenario.
struct Scenario {
  /// Contact law and materials.
  Model model;
  /// Time step, damping and guards.
  Numerics numerics;
  /// Density of the grains, kg/m3, scaling included. A positive value replaces the packing's masses, except for nodes.
  double grain_density = 0;
  /// Density by material_id, kg/m3, for grains and nodes; unset for materials without `density`.
  std::vector<std::optional<double>> density;
  /// Whether masses are scaled so that all grains admit the same step (mass_scaling.h).
  bool equal_steps = false;
  /// Tolerances of a settled station.
  Tolerances tolerances;
  /// Servo of the periodic cell.
  ServoRule servo;
  /// Number of steps after which a station counts as unreachable.
  std::int64_t largest_station = 0;
  /// Rule for the states that are kept in full.
  SnapshotRule snapshots;
  /// Stages, in order.
  std::vector<Stage> stages;
  /// Planes that prepare() adds to the packing.
  io::PlanesRecord planes;
  /// Planes that prepare() moves until they touch the grains.
  std::vector<std::size_t> touching;
  /// Plates and clamps that can be driven.
  std::vector<PartSetting> parts;
  /// Files that the scenario names.
  std::vector<io::Source> sources;
  /// Stresses of stages that were given without a unit, Pa.
  std::vector<BareNumber> bare_stresses;
  /// Text of the scenario with overrides applied, for provenance.
  std::string resolved;
};

/// Returns the parts of a scenario, in its order.
std::vector<RigPart> parts_of(const Scenario& scenario);

/// Reads [contact] and [[material]]: the law and its materials. Every tool that steps grains uses it.
Model read_model(Settings& document);
/// Reads the density of [grains], kg/m3; 0 if absent.
double read_density(Settings& document);
/// Reads [numerics] and [guards].
Numerics read_numerics(Settings& document);

/// Reads and checks a scenario. Throws DataError with all mistakes.
Scenario read_scenario(std::string_view text, const std::string& name, const std::vector<std::string>& overrides);
/// Reads a scenario from a document. `files`: how file names in the scenario are resolved.
Scenario read_scenario(Settings& document, const NamedFiles& files);
/// Returns every key that a scenario may have (core/text/keys.h).
std::vector<Key> scenario_keys();

/// Returns the model with another friction angle (rad) of `materials`; an empty list means all.
Model with_friction(const Model& model, double angle, const std::vector<std::int32_t>& materials = {});
/// Returns the model in which `materials` have this friction angle (rad) against any other material, for plates.
Model with_friction_against(const Model& model, double angle, const std::vector<std::int32_t>& materials);
/// Returns the model with every friction angle multiplied.
Model with_friction_times(double factor, const Model& model);
/// Returns the smallest friction angle of `materials`, rad; an empty list means all.
double friction(const Model& model, const std::vector<std::int32_t>& materials = {});
/// Friction angle below which a packing gets no denser, rad.
inline constexpr double lowest_friction = 0.05 * std::numbers::pi / 180;

}  // namespace soilweave::dem
