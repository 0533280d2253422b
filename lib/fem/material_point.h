// What a point of integration is made of: a displacement gradient goes in, a stress comes out.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>

#include "core/archive.h"
#include "core/tensor.h"
#include "io/records.h"

namespace soilweave::fem {

/// What a point tells besides its stress; NaN where it has no such thing.
struct Local {
  double void_ratio = std::numeric_limits<double>::quiet_NaN();
  double anisotropy = std::numeric_limits<double>::quiet_NaN();  // F_a; -1 without contacts
  double rotation = std::numeric_limits<double>::quiet_NaN();    // rad, mean of the disks since the start
  double contacts = std::numeric_limits<double>::quiet_NaN();
};

/// Energies of a point since its start, J per m2 of its own cross-section at the start and metre of thickness.
struct PointEnergy {
  double stored = 0, kinetic = 0, dissipated = 0;
};

class MaterialPoint {
 public:
  MaterialPoint() = default;
  MaterialPoint(const MaterialPoint&) = delete;
  MaterialPoint& operator=(const MaterialPoint&) = delete;
  virtual ~MaterialPoint() = default;

  /// One step. gradient: of the displacement increment on the geometry before the step, row i, column j: du_i/dx_j; its
  /// skew part rotates the material. Throws PhysicsError.
  virtual void advance(const Mat2& gradient) = 0;
  /// Pa, symmetric, tension positive.
  virtual Mat2 stress() const = 0;
  /// Pa, stiffness for stability: rows and columns xx, yy, xy (engineering shear).
  virtual Mat3 tangent() const = 0;
  virtual Local local() const { return {}; }
  virtual PointEnergy energy() const { return {}; }
  /// Of its own motion, where it has one; nothing: as the scenario says.
  virtual void set_damping(std::optional<double>) {}
  /// Whether its own time step is still stable: the step over its limit, 0 where it has none.
  virtual double step_over_limit() { return 0; }
  /// Its grains, where it has some.
  virtual std::optional<io::Snapshot> packing() const { return std::nullopt; }
  /// Grain steps and contacts of them so far.
  virtual std::int64_t steps() const { return 0; }
  virtual std::int64_t contact_steps() const { return 0; }
  virtual std::size_t grains() const { return 0; }
  /// Keeps the state under names that begin with the prefix, or takes it back, bit for bit.
  virtual void archive(Archive& archive, const std::string& prefix) = 0;
};

}  // namespace soilweave::fem
