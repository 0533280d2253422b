// Compaction of a cloud to a void ratio at a pressure, by lower friction.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cloud compressed at full friction comes to rest as loose as friction allows. Lower friction lets grains slide into
// denser places at the same pressure. Restored friction holds them there. So friction alone chooses the void ratio
// (thesis section 3.2.2).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "dem/contact/model.h"
#include "dem/loading/control.h"
#include "dem/run/cost.h"
#include "dem/run/keeper.h"
#include "files/records.h"
#include "packing/generate/standard.h"

namespace soilweave::packing {

/// Remedies in messages, named as in the tool that compacts.
struct Remedies {
  std::string max_rate = "--max-rate", tolerance = "--tolerance", material = "--material";
  std::string density = "--density, or grains.density in --material";
};

/// Settings of a compaction.
struct Recipe {
  /// Isotropic pressure, Pa.
  double pressure = 1e3;
  /// Target. None: whatever full friction gives.
  std::optional<double> void_ratio;
  /// Greatest difference from the target.
  double void_ratio_tolerance = 5e-4;
  dem::Tolerances tolerances;
  /// Greatest strain rate during compression, 1/s.
  double max_rate = 1.0;
  /// Cundall's local damping, throughout.
  double damping = 0.2;
  /// Factor on the friction angle at each equilibrium.
  double friction_factor = 0.8;
  /// Steps after which an equilibrium counts as unreachable.
  std::int64_t largest_stage = 2'000'000;
  /// Greatest number of attempts at a void ratio that is not held at rest. Each attempt restores friction earlier.
  int most_attempts = 8;
  /// Cell of the grading, for remedies in errors.
  std::optional<Room> room = {};
  /// Shares of max_rate by axis.
  Vec3 rate_shares = Vec3::Ones();
  /// Grains that do not follow the cell's strain: only contacts and yarns move them.
  std::vector<std::int32_t> apart = {};
  /// Friction angle while the cloud is compressed, rad; 0: the materials' own.
  double first_friction = 0;
  /// Materials whose friction is lowered; empty: all.
  std::vector<std::int32_t> materials = {};
  Remedies remedies = {};
};

/// Result of a compaction.
struct Result {
  /// State at rest, at full friction, with strains and clock zero.
  io::Snapshot state;
  double void_ratio = 0;
  /// Lowest friction angle used, rad.
  double friction_angle = 0;
  dem::Cost cost;
  /// The void ratio that the state holds, in words, if no attempt held the target.
  std::optional<std::string> unheld;
};

/// Compresses the assembly isotropically to the pressure at full friction. Then lowers friction step by step (thesis
/// §3.2.2). Restores it as the void ratio passes the target, until an equilibrium at full friction holds the target. If
/// grains settle below the target, the work begins anew and restores friction earlier, by as much as they fell. If no
/// attempt holds it, Result::unheld says so.
///
/// Throws TargetNotReached for a target out of reach, with the void ratios at full friction and without. Throws
/// DataError if the cell is aperiodic or narrower than two largest grains, if the pressure is clearly too high, or if
/// the cloud will not close. A safekeeping folder lets the work go on later, to the same bytes; Stopped after a signal.
///
/// Recipe::first_friction lets grains slide from the first step on. At full friction, a loose cell forms a few columns
/// of grains that bear the pressure before the cell is full. If the cell becomes too dense, the work begins anew with
/// more friction.
Result compact(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
               const ProgressReport& report = {}, const dem::Safekeeping& safekeeping = {});

}  // namespace soilweave::packing
