// Grains that grow until they fill a container.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Soil cut from a block leaves a gap of one grain along the container (thesis section 3.2.3). Each round multiplies all
// radii by a small factor. Then the grains come to equilibrium between the nodes, which stand still. Free grains grow
// with the volume of their Delaunay tetrahedra. In a full bag that volume stands still, and overlaps grow instead. Soil
// that is too loose rearranges under lower friction, which is restored at the end.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/doubts.h"
#include "core/progress.h"
#include "core/text/settings.h"
#include "dem/contact/model.h"
#include "dem/loading/control.h"
#include "dem/run/cost.h"
#include "dem/run/keeper.h"
#include "files/records.h"

namespace soilweave::packing {

/// Settings of the growth; PLAN.md describes them.
struct Growth {
  /// Factor on the radii per round.
  double factor = 1.0002;
  /// Factor on the radii that fills the container.
  double filling = 1;
  /// Share of the full stretch that is applied, in logarithmic strain.
  double stretch_share = 1;
  /// Stretch from the grains as cut to the full container. It multiplies coordinates while radii grow by `filling`, so
  /// that grains need not travel far.
  Vec3 stretch = Vec3::Ones();
  /// Greatest unbalanced force at equilibrium: mean resultant over mean contact force.
  double unbalanced_force = 1e-3;
  /// Overlap over radius. The contact force at this overlap is the least reference of the unbalanced force.
  double negligible = 1e-4;
  /// Cundall's local damping.
  double damping = 0.5;
  /// Greatest number of steps per round; ten times as many before a measurement.
  std::int64_t steps = 100;
  /// Steps between stops of all motion during growth; 0: never. Local damping does not slow free flight.
  std::int64_t stop_every = 50;
  /// Growth of the Delaunay volume over its growth with free grains. Below this ratio the volume counts as standing
  /// still.
  double volume_tolerance = 0.9;
  /// Least mean overlap, over the mean radius, of a full container at rest.
  double overlap = 1e-4;
  /// Least coordination number of a full container at rest.
  double coordination_number = 2.5;
  /// Greatest coordination number: radii shrink at rest until it is met. None: no limit.
  std::optional<double> largest_coordination_number;
  /// Void ratio of the full container. Looser soil gets lower friction. None: no target.
  std::optional<double> void_ratio;
  /// Whether tetrahedra of the centres give the void ratio, instead of power cells.
  bool by_delaunay = false;
  /// Factor on the friction angles each time they are lowered.
  double friction_factor = 0.9;
  /// Rounds between measurements.
  std::int64_t measure_every = 10;
  /// Greatest number of rounds.
  std::int64_t largest_rounds = 2000;
  /// Greatest number of steps until rest.
  std::int64_t largest_round = 100'000;

  /// Reads [growth].
  static Growth read(Settings& table);
};

/// Quantities measured at intervals.
struct Fill {
  /// Growth of the radii so far.
  double growth = 1;
  /// Volume of the Delaunay tetrahedra of the soil's centres, m3.
  double volume = 0;
  /// Void ratio by power cells.
  double void_ratio = 0;
  /// Void ratio by the tetrahedra.
  double delaunay_void_ratio = 0;
  /// Mean overlap of the contacts, over the soil's mean radius.
  double overlap = 0;
  /// 2 Nc/N of the soil; contacts with nodes count once.
  double coordination_number = 0;

  /// Returns the void ratio in the measure of the target of `growth`.
  double void_ratio_of(const Growth& growth) const;
  /// Returns one line for progress.
  std::string text() const;
};

/// Result of the growth.
struct Grown {
  /// State at rest.
  io::Snapshot state;
  /// Last measurement.
  Fill fill;
  /// One row per measurement.
  io::Series history;
  /// Cost of the growth.
  dem::Cost cost;
};

/// Returns "dense" if the full container is denser than the void ratio that `growth` asks for, by more than 0.02.
std::vector<Doubt> filling_doubts(const Growth& growth, const Fill& fill);

/// Grows soil between the nodes of the geotextiles, which stand still. The grains must be nearly at rest. Throws
/// TargetNotReached naming the missed criterion.
Grown grow(const io::Snapshot& start, const dem::Model& model, const dem::Numerics& numerics, const Growth& growth,
           const ProgressReport& report = {}, const dem::Safekeeping& safekeeping = {});

}  // namespace soilweave::packing
