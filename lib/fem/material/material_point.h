// Material of an integration point: it takes a displacement gradient and returns a stress.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "core/archive.h"
#include "core/tensor.h"
#include "files/records.h"

namespace soilweave::fem {

/// Local state of a point besides its stress; NaN for what it does not have.
struct Local {
  double void_ratio = std::numeric_limits<double>::quiet_NaN();
  double anisotropy = std::numeric_limits<double>::quiet_NaN();  // F_a; -1 without contacts
  double rotation = std::numeric_limits<double>::quiet_NaN();    // mean of the disks since the start, rad
  double contacts = std::numeric_limits<double>::quiet_NaN();
};

/// Energies of a point since its start, J per m2 of its initial cross-section and metre of thickness.
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

  /// Takes one step. gradient: of the displacement increment on the geometry before the step, element (i, j) =
  /// du_i/dx_j. Its skew part rotates the material. Throws PhysicsError.
  virtual void advance(const Mat2& gradient) = 0;
  /// Returns the stress, Pa, symmetric, tension positive.
  virtual Mat2 stress() const = 0;
  /// Returns the stiffness for stability, Pa: rows and columns xx, yy, xy (engineering shear).
  virtual Mat3 tangent() const = 0;
  /// Return local state and energies since the start.
  virtual Local local() const { return {}; }
  virtual PointEnergy energy() const { return {}; }
  /// Sets the damping of the point's own motion, if it has any; none: as the scenario says.
  virtual void set_damping(std::optional<double>) {}
  /// Returns the point's own time step over its stability limit; 0 if it has none.
  virtual double step_over_limit() { return 0; }
  /// Returns the point's grains, if it has any.
  virtual std::optional<io::Snapshot> packing() const { return std::nullopt; }
  /// Returns the number of grain steps and of contacts so far.
  virtual std::int64_t steps() const { return 0; }
  /// Return sums over the grains of the point; 0 without grains.
  virtual std::int64_t contact_steps() const { return 0; }
  virtual std::size_t grains() const { return 0; }
  /// Keeps the state under names with the prefix, or restores it, bit for bit.
  virtual void archive(Archive& archive, const std::string& prefix) = 0;
};

}  // namespace soilweave::fem
