// From a cloud to a packing with a given void ratio at a given pressure: compression, then friction lowered step by
// step.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A cloud that is compressed at full friction comes to rest as loose as friction allows. Lower friction lets grains
// slide into denser places at the same pressure, and restored friction holds them there. So friction alone chooses the
// void ratio, between that of full friction and that of none (thesis section 3.2.2).
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

/// Remedies in messages, by the names of the tool that compacts.
struct Remedies {
  std::string max_rate = "--max-rate", tolerance = "--tolerance", material = "--material";
  std::string density = "--density, or grains.density in --material";
};

/// Settings of a compaction.
struct Recipe {
  double pressure = 1e3;             // Pa
  std::optional<double> void_ratio;  // none: whatever full friction gives
  double void_ratio_tolerance = 5e-4;
  dem::Tolerances tolerances;
  double max_rate = 1.0;                   // 1/s, during compression
  double damping = 0.2;                    // Cundall's local damping, throughout
  double friction_factor = 0.8;            // factor on the friction angle at each equilibrium
  std::int64_t largest_stage = 2'000'000;  // steps after which an equilibrium counts as unreachable
  int most_attempts = 8;            // attempts at a void ratio that is not held at rest; each restores friction earlier
  std::optional<Room> room = {};    // cell of the grading; if known, errors tell how many grains are enough
  Vec3 rate_shares = Vec3::Ones();  // shares of max_rate by axis
  std::vector<std::int32_t> apart = {};      // grains that the cell's strain moves only through contacts and yarns
  double first_friction = 0;                 // friction angle while the cloud is compressed, rad; 0: the materials' own
  std::vector<std::int32_t> materials = {};  // materials whose friction is lowered; empty: all
  Remedies remedies = {};
};

/// Result of a compaction.
struct Result {
  io::Snapshot state;  // state at rest, at full friction, strains and clock zero
  double void_ratio = 0;
  double friction_angle = 0;  // the lowest one used, rad
  dem::Cost cost;
  /// If no attempt held the void ratio: the message that says which one the state holds.
  std::optional<std::string> unheld;
};

/// Compresses the assembly isotropically to the pressure at full friction. Then lowers the friction of the recipe's
/// materials step by step (thesis §3.2.2), and restores it as the void ratio passes the target, until an equilibrium at
/// the pressure and full friction holds the target. If grains settle below the target as friction is restored, the work
/// begins anew from the cloud and restores friction earlier, by as much as they fell. If no attempt holds the target,
/// Result::unheld says so. Throws TargetNotReached if the target is out of reach, with the void ratios measured at full
/// friction and without. Throws DataError if the cell is aperiodic or narrower than two of the largest grains, or if it
/// is clear before the first step that the pressure is too high or that the cloud will not close. With a folder to keep
/// it in, the work goes on from what is there and ends in the same bytes; Stopped after a signal.
///
/// With a first friction the materials slide from the first step on. Otherwise the grains of a loose cell form a few
/// columns that bear the pressure before they fill it. If that makes the cell denser than the target, the work begins
/// anew with more friction.
Result compact(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
               const ProgressReport& report = {}, const dem::Safekeeping& safekeeping = {});

}  // namespace soilweave::packing
