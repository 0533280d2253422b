// Grains that grow until they fill a container: radii grow by small factors, with equilibrium in between.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Soil cut from a block to the shape of a bag leaves a gap of one grain along the surface. Growth closes it (thesis
// section 3.2.3). Each round multiplies all radii by a small factor and lets the grains come to equilibrium between the
// nodes, which stand still. Free grains carry the volume of their Delaunay tetrahedra along as the cube of their radii;
// once the bag is full that volume stands still, and overlaps grow instead. If the soil is then looser than asked for,
// friction is lowered and grains rearrange. At last friction is restored, and the grains come to rest.
#pragma once

#include <optional>
#include <string>

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
  double factor = 1.0002;    // growth of the radii per round
  double filling = 1;        // growth of the radii that fills the container
  double stretch_share = 1;  // share of the way to the container, in strain, by which the soil is stretched
  /// Stretch from the grains as cut to the container that they fill. Coordinates grow by it while radii grow by
  /// `filling`, so that nothing need travel far.
  Vec3 stretch = Vec3::Ones();
  double unbalanced_force = 1e-3;  // limit at an equilibrium: mean resultant over mean contact force
  double negligible = 1e-4;  // overlap over radius; its force replaces the mean contact force while contacts carry less
  double damping = 0.5;      // Cundall's local damping
  std::int64_t steps = 100;  // greatest number per round; ten times as many before a measurement
  std::int64_t stop_every = 50;   // steps of growth after which motion is stopped, since flight is not damped; 0: never
  double volume_tolerance = 0.9;  // growth of the Delaunay volume over that of free grains; below, it stands still
  double overlap = 1e-4;          // mean overlap over mean radius at which the grains are full, at rest
  double coordination_number = 2.5;  // least coordination number of full grains
  /// Greatest coordination number: radii shrink at rest until it is reached. None: no limit.
  std::optional<double> largest_coordination_number;
  /// Void ratio of the full container. Friction is lowered while pressing grains are looser, and restored at the end.
  /// None: as dense as they come.
  std::optional<double> void_ratio;
  bool by_delaunay = false;      // true: void ratio by the tetrahedra of the soil's centres; false: by its power cells
  double friction_factor = 0.9;  // factor on the friction angles, each time
  std::int64_t measure_every = 10;  // rounds
  std::int64_t largest_rounds = 2000;
  std::int64_t largest_round = 100'000;  // steps

  /// Reads [growth].
  static Growth read(Settings& table);
};

/// Quantities measured at intervals.
struct Fill {
  double growth = 1;               // growth of the radii so far
  double volume = 0;               // volume of the Delaunay tetrahedra of the soil's centres, m3
  double void_ratio = 0;           // void ratio by the soil's power cells
  double delaunay_void_ratio = 0;  // void ratio by those tetrahedra
  double overlap = 0;              // mean over the contacts, over the soil's mean radius
  double coordination_number = 0;  // 2 Nc/N of the soil; contacts with nodes count once

  /// Returns the measurements in a line, for progress.
  std::string text() const;
};

/// Result of the growth.
struct Grown {
  io::Snapshot state;  // state at rest
  Fill fill;
  io::Series history;  // one row per measurement
  dem::Cost cost;
};

/// Grows soil in the container that the nodes of the state's geotextiles form; the nodes stand still. The grains of the
/// state must be at rest or nearly so. Throws TargetNotReached naming the criterion that was missed.
Grown grow(const io::Snapshot& start, const dem::Model& model, const dem::Numerics& numerics, const Growth& growth,
           const ProgressReport& report = {}, const dem::Safekeeping& safekeeping = {});

}  // namespace soilweave::packing
