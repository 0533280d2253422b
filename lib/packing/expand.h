// Grains that grow until they fill a container: radii by small factors, with equilibrium between.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "core/settings.h"
#include "dem/control.h"
#include "dem/keeper.h"
#include "dem/model.h"
#include "dem/price.h"
#include "io/records.h"

namespace soilweave::packing {

struct Growth {
  double factor = 1.0002;    // of the radii, a round
  double filling = 1;        // growth of the radii that fills the container
  double stretch_share = 1;  // of the way to the container that the soil is stretched, in strain
  /// Between the grains as they are cut and the container that they fill: as far as they are stretched to it,
  /// coordinates are by this while the radii grow by `filling`, so that nothing need travel far.
  Vec3 stretch = Vec3::Ones();
  double unbalanced_force = 1e-3;    // of an equilibrium: mean resultant over mean contact force
  double negligible = 1e-4;          // overlap over radius whose force counts instead, while contacts carry less
  double damping = 0.5;              // Cundall's
  std::int64_t steps = 100;          // of a round at most; ten times that before a measurement
  std::int64_t stop_every = 50;      // steps of growth after which motion is stopped, 0: never; flight is not damped
  double volume_tolerance = 0.9;     // growth of the Delaunay volume over that of free grains: less is standing still
  double overlap = 1e-4;             // mean overlap over the mean radius at which the grains are full, at rest
  double coordination_number = 2.5;  // and their least coordination number
  /// Their largest one: radii give way at rest until they have no more contacts. None: as many as they have.
  std::optional<double> largest_coordination_number;
  /// Of the full container: while grains that press are looser, friction is lowered; it is restored at the end. None:
  /// as dense as they come.
  std::optional<double> void_ratio;
  bool by_delaunay = false;         // told of the tetrahedra of the soil's centres, not of its power cells
  double friction_factor = 0.9;     // of the friction angles, each time
  std::int64_t measure_every = 10;  // rounds
  std::int64_t largest_rounds = 2000;
  std::int64_t largest_round = 100'000;  // steps

  static Growth read(Settings& table);
};

/// What is measured now and then.
struct Fill {
  double growth = 1;               // of the radii, so far
  double volume = 0;               // m3, of the Delaunay tetrahedra of the soil's centres
  double void_ratio = 0;           // of the soil's power cells
  double delaunay_void_ratio = 0;  // of those tetrahedra
  double overlap = 0;              // mean over the contacts, over the soil's mean radius
  double coordination_number = 0;  // 2 Nc/N of the soil, contacts with nodes counting once

  std::string text() const;
};

struct Grown {
  io::Snapshot state;  // at rest
  Fill fill;
  io::Series history;  // a row a measurement
  dem::Price price;
};

using Report = std::function<void(double fraction, const std::string& detail)>;

/// Soil grows in the container that the nodes of the state's geotextiles make, which stand still. The grains of the
/// state are at rest or nearly so. Throws TargetNotReached naming the criterion that was missed.
Grown grow(const io::Snapshot& start, const dem::Model& model, const dem::Numerics& numerics, const Growth& growth,
           const Report& report = {}, const dem::Safekeeping& safekeeping = {});

}  // namespace soilweave::packing
