// From a cloud to a packing with a given void ratio at a given pressure: compression, then friction lowered step by
// step.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "dem/control.h"
#include "dem/keeper.h"
#include "dem/model.h"
#include "dem/price.h"
#include "io/records.h"
#include "packing/standard.h"

namespace soilweave::packing {

/// Names by which the tool that a compaction is done for knows the remedies in its messages.
struct Remedies {
  std::string max_rate = "--max-rate", tolerance = "--tolerance", material = "--material";
  std::string density = "--density, or grains.density in --material";
};

struct Recipe {
  double pressure = 1e3;             // Pa
  std::optional<double> void_ratio;  // none: whatever full friction gives
  double void_ratio_tolerance = 5e-4;
  dem::Tolerances tolerances;
  double max_rate = 1.0;                   // 1/s, while compressing
  double damping = 0.2;                    // Cundall's, throughout
  double friction_factor = 0.8;            // of the friction angle, each time equilibrium is reached
  std::int64_t largest_stage = 2'000'000;  // steps after which an equilibrium counts as unreachable
  int most_attempts = 8;                   // at a void ratio that is not held at rest, each restoring friction earlier
  std::optional<Room> room = {};           // of the grading; where it is known, errors say how many grains are enough
  Vec3 rate_shares = Vec3::Ones();         // of max_rate, by axis
  std::vector<std::int32_t> apart = {};    // grains that the cell's strain moves through contacts and yarns alone
  double first_friction = 0;               // rad, of the materials while the cloud is compressed; 0: their own
  std::vector<std::int32_t> materials = {};  // whose friction is lowered; empty: of all
  Remedies remedies = {};
};

struct Result {
  io::Snapshot state;  // at rest, full friction, strains and clock zero
  double void_ratio = 0;
  double friction_angle = 0;  // rad, the lowest used
  dem::Price price;
  /// Where no attempt held the void ratio asked for: the message that says which one the state holds.
  std::optional<std::string> unheld;
};

using Report = std::function<void(double fraction, const std::string& detail)>;

/// Compresses the assembly isotropically to the pressure at full friction, then lowers the friction of the recipe's
/// materials step by step (thesis §3.2.2) and restores it as the void ratio passes the target, until equilibrium at the
/// pressure and full friction holds the target. Where grains settle below the target as friction is restored, the work
/// begins anew from the cloud and restores friction earlier, by as much as they fell; if no attempt holds the target,
/// Result::unheld says so. Throws TargetNotReached where the target is out of reach, with the void ratios measured at
/// full friction and without; DataError where the cell is not periodic or not two of the largest grains wide, or where
/// before the first step it is clear that the pressure is too high for the grains or that the cloud will not close.
/// With a folder to keep it in, the work goes on from what is there and ends in the same packing, bit by bit; Stopped
/// after a signal.
///
/// With a first friction the materials slide from the first step on: grains of a loose cell would else lean on each
/// other in a few columns and bear the pressure before they fill it. Where that makes the cell denser than the target,
/// the work begins anew at more friction.
Result compact(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
               const Report& report = {}, const dem::Safekeeping& safekeeping = {});

}  // namespace soilweave::packing
