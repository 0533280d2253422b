// A scenario of two scales: mesh, material of the points, supports, geosynthetic, duration, read from TOML and checked
// whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fem/model.h"

namespace soilweave::fem {

/// At every output the loading stands still until the kinetic energy is this small.
struct QuasiStatic {
  Relaxation damping;
  double kinetic_energy = 0;      // J per metre, of the soil
  std::int64_t largest_rest = 0;  // steps after which it counts as unreachable
};

struct Scenario {
  ModelSetup model;  // without packings
  double duration = 0;
  std::vector<Index> recorded;  // points whose grains are recorded whole
  std::optional<QuasiStatic> quasi_static;
  std::string resolved;
};

/// mesh: read from a file; nothing: the scenario's [mesh] makes a rectangle. Throws DataError with all mistakes.
Scenario read_scenario(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                       std::optional<Mesh> mesh);

}  // namespace soilweave::fem
