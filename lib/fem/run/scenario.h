// A scenario of two scales, read from TOML and checked whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/doubts.h"
#include "core/text/settings.h"
#include "fem/model/model.h"

namespace soilweave::fem {

/// Quasi-static loading: stops at every output until kinetic energy is small.
struct QuasiStatic {
  Relaxation damping;
  /// Limit for the soil, J per metre.
  double kinetic_energy = 0;
  /// Steps after which rest counts as unreachable.
  std::int64_t largest_rest = 0;
};

/// A whole two-scale scenario.
struct Scenario {
  /// Model without packings.
  ModelSetup model;
  /// Duration, s.
  double duration = 0;
  /// Points whose grains are recorded.
  std::vector<Index> recorded;
  std::optional<QuasiStatic> quasi_static;
  /// Doubts about the mesh, and about how the soil is held and loaded.
  std::vector<Doubt> doubts;
  /// TOML with all defaults.
  std::string resolved;
  /// Stresses that were given without a unit, Pa: tractions, initial stress, cohesion, seat pressure.
  std::vector<BareNumber> bare_stresses;
};

/// Reads a scenario. mesh: from a file; none: the rectangle of [mesh]. Throws DataError with all mistakes.
Scenario read_scenario(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                       std::optional<Mesh> mesh);
/// Reads a scenario from a document.
Scenario read_scenario(Settings& document, std::optional<Mesh> mesh);
/// Returns every key that a scenario may have (core/text/keys.h).
std::vector<Key> scenario_keys();

}  // namespace soilweave::fem
