// Material of an integration point: from displacement gradient to stress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "core/archive.h"
#include "core/tensor.h"
#include "files/records.h"

namespace soilweave::fem {

/// Local state of a point besides stress; NaN: absent.
struct Local {
  double void_ratio = std::numeric_limits<double>::quiet_NaN();
  /// F_a; -1 without contacts.
  double anisotropy = std::numeric_limits<double>::quiet_NaN();
  /// Mean rotation of the disks since the start, rad.
  double rotation = std::numeric_limits<double>::quiet_NaN();
  double contacts = std::numeric_limits<double>::quiet_NaN();
};

/// Energies since the start, J per m2 of initial cross-section and metre of thickness.
struct PointEnergy {
  double stored = 0, kinetic = 0, dissipated = 0;
};

/// A material point. Implementations: ContinuumPoint, Rve.
class MaterialPoint {
 public:
  MaterialPoint() = default;
  MaterialPoint(const MaterialPoint&) = delete;
  MaterialPoint& operator=(const MaterialPoint&) = delete;
  virtual ~MaterialPoint() = default;

  /// Takes one step. gradient: displacement increment on the geometry before the step, (i, j) = du_i/dx_j. Its skew
  /// part rotates the material. Throws PhysicsError.
  virtual void advance(const Mat2& gradient) = 0;
  /// Returns the stress, Pa, symmetric, tension positive.
  virtual Mat2 stress() const = 0;
  /// Returns the stiffness for stability, Pa, for xx, yy, xy (engineering shear).
  virtual Mat3 tangent() const = 0;
  /// Returns the local state.
  virtual Local local() const { return {}; }
  /// Returns energies since the start.
  virtual PointEnergy energy() const { return {}; }
  /// Sets the damping of the point's own motion; none: the scenario's.
  virtual void set_damping(std::optional<double>) {}
  /// Returns the point's time step over its limit; 0 without one.
  virtual double step_over_limit() { return 0; }
  /// Returns the grains, if any.
  virtual std::optional<io::Snapshot> packing() const { return std::nullopt; }
  /// Returns the number of grain steps so far.
  virtual std::int64_t steps() const { return 0; }
  /// Returns the contacts, summed over the steps.
  virtual std::int64_t contact_steps() const { return 0; }
  /// Returns the number of grains.
  virtual std::size_t grains() const { return 0; }
  /// Keeps or restores the state bit for bit, under names with the prefix.
  virtual void archive(Archive& archive, const std::string& prefix) = 0;
};

}  // namespace soilweave::fem
