// A scenario: contact law and materials, numerics, and the stages of loading, read from TOML and checked whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "core/settings.h"
#include "dem/path.h"

namespace soilweave::dem {

struct Stage {
  std::string name;
  std::unique_ptr<Path> path;
  bool reset_strain = false;       // the state at its start becomes the reference of the strains
  std::optional<double> friction;  // rad, of all materials from here on
  std::optional<double> damping;   // local damping during this stage
};

/// Which recorded stations get a full snapshot beside their row in the series.
struct SnapshotRule {
  enum class Which { ends, stations, list };
  Which which = Which::ends;
  std::vector<double> strains;  // loading-axis strains, for `list`
};

struct Scenario {
  Model model;
  Numerics numerics;
  double density = 0;  // kg/m3, scaled; replaces the packing's masses where positive
  Tolerances tolerances;
  ServoRule servo;
  std::int64_t largest_station = 0;  // steps after which a station counts as unreachable
  SnapshotRule snapshots;
  std::vector<Stage> stages;
  io::PlanesRecord planes;
  std::string resolved;  // the TOML with overrides applied, for provenance
};

/// [contact] (and [[material]]): the law and its materials. Used by every tool that steps grains.
Model read_model(Settings& document);
/// density key of [grains], kg/m3; 0 where absent.
double read_density(Settings& document);
/// [numerics] and [guards].
Numerics read_numerics(Settings& document);

/// Reads and checks everything; all mistakes are reported at once. Throws DataError.
Scenario read_scenario(std::string_view text, const std::string& name, const std::vector<std::string>& overrides);

/// Model with every friction angle replaced, rad.
Model with_friction(const Model& model, double angle);
/// Smallest friction angle of a model's materials, rad.
double friction(const Model& model);

}  // namespace soilweave::dem
