// A scenario of two scales: mesh, material of the points, supports, geosynthetic, duration, read from TOML and checked
// whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/text/settings.h"
#include "fem/model/model.h"

namespace soilweave::fem {

/// Quasi-static loading: at every output the loading stops until the kinetic energy is this small.
struct QuasiStatic {
  Relaxation damping;
  double kinetic_energy = 0;      // limit for the soil, J per metre
  std::int64_t largest_rest = 0;  // steps after which it counts as unreachable
};

/// A whole two-scale scenario.
struct Scenario {
  ModelSetup model;  // model without packings
  double duration = 0;
  std::vector<Index> recorded;  // points whose grains are recorded
  std::optional<QuasiStatic> quasi_static;
  std::string resolved;
};

/// Reads a scenario. mesh: from a file; none: [mesh] of the scenario describes a rectangle. Throws DataError with all
/// mistakes.
Scenario read_scenario(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                       std::optional<Mesh> mesh);
/// Reads a scenario from a document.
Scenario read_scenario(Settings& document, std::optional<Mesh> mesh);
/// Returns every key that a scenario may have (core/text/keys.h).
std::vector<Key> scenario_keys();

}  // namespace soilweave::fem
