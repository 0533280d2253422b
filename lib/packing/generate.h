// From a cloud to a packing with a given void ratio at a given pressure: compression, then friction lowered step by
// step. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "dem/control.h"
#include "dem/keeper.h"
#include "dem/model.h"
#include "dem/price.h"
#include "io/records.h"

namespace soilweave::packing {

struct Recipe {
  double pressure = 1e3;             // Pa
  std::optional<double> void_ratio;  // none: whatever full friction gives
  double void_ratio_tolerance = 5e-4;
  dem::Tolerances tolerances;
  double max_rate = 1.0;                   // 1/s, while compressing
  double damping = 0.2;                    // Cundall's, throughout
  double friction_factor = 0.8;            // of the friction angle, each time equilibrium is reached
  std::int64_t largest_stage = 2'000'000;  // steps after which an equilibrium counts as unreachable
};

struct Result {
  io::Snapshot state;  // at rest, full friction, strains and clock zero
  double void_ratio = 0;
  double friction_angle = 0;  // rad, the lowest used
  dem::Price price;
};

using Report = std::function<void(double fraction, const std::string& detail)>;

/// Compresses the assembly isotropically to the pressure at full friction, then lowers the friction step by step
/// (thesis §3.2.2) and restores it as the void ratio passes the target, until equilibrium at the pressure and full
/// friction holds the target. Throws TargetNotReached with the void ratio reached and the reason; DataError where the
/// cell is not periodic, or is or will be less than two of the largest grains wide. With a folder to keep it in, the
/// work goes on from what is there and ends in the same packing, bit by bit; Stopped after a signal.
Result compact(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
               const Report& report = {}, const dem::Safekeeping& safekeeping = {});

}  // namespace soilweave::packing
