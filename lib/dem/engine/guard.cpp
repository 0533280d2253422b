// Notices when physics breaks.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/guard.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace soilweave::dem {
namespace {

// Largest diameter over the width of the cell. It is below a half, so that the file of a stopped run can be read.
constexpr double widest_grain = 0.4999;
// Unbalanced force below which a deep overlap comes from load, not from motion.
constexpr double quiet = 0.1;
// Mean stress over the stiffness of the contacts, for Hertzian spheres that overlap by a tenth of their radius. The
// ratio is far smaller where stiff grains overlap because of their speed.
constexpr double soft = 0.03;

bool finite(const Lane4& r) { return std::isfinite(r[0]) && std::isfinite(r[1]) && std::isfinite(r[2]); }

const char* wrong_part(const Bodies& bodies, std::size_t i) {
  if (!finite(bodies.grains[i].position)) return "position";
  if (!finite(bodies.velocity(i))) return "velocity";
  if (!finite(bodies.spin(i))) return "spin";
  if (!finite(bodies.loads[i].force)) return "force";
  return finite(bodies.loads[i].torque) ? nullptr : "torque";
}

}  // namespace

Guard::Guard(const Numerics& numerics, const Bodies& bodies, const Cell& cell, const Planes& planes, double range)
    : limits_(numerics.limits),
      fixed_step_(numerics.time_step.has_value()),
      largest_(2 * bodies.largest_radius()),
      range_(range),
      planes_(!planes.all.empty()),
      dimension_(bodies.dimension) {
  // Without a range, reading the packing has checked the grains already.
  for (int a = 0; a < dimension_ && range_ > 0; ++a) {
    const double width = cell.widths()[a];
    if (!cell.periodic(a) || largest_ + range_ < widest_grain * width) continue;
    throw DataError(
        fmt::format("contacts act across gaps of {:.4g} m: with the largest grain, {:.4g} m across, that is half of "
                    "the cell, {:.4g} m wide along axis {}, or more: give a smaller range, or take more grains",
                    range_, largest_, width, "xyz"[a]));
  }
  if (planes.all.empty() || bodies.size() == 0) return;
  low_ = high_ = vector_of(bodies.grains[0].position);
  const auto hold = [this](const Vec3& x) { low_ = low_.cwiseMin(x), high_ = high_.cwiseMax(x); };
  for (std::size_t i = 0; i < bodies.size(); ++i) hold(vector_of(bodies.grains[i].position));
  const Vec3 centre = 0.5 * (low_ + high_);
  for (const Plane& plane : planes.all) hold(centre - (centre - plane.point).dot(plane.normal) * plane.normal);
  const Vec3 room = Vec3::Constant(limits_.escape * ((high_ - low_).norm() + largest_));
  low_ -= room;
  high_ += room;
  for (int a = 0; a < dimension_; ++a) open_[static_cast<std::size_t>(a)] = !cell.periodic(a);
}

std::string Guard::lower_step() const {
  // The step is also fixed for a material point, which derives it from the safety factor.
  return fixed_step_ ? "lower numerics.time_step where it is given, else numerics.time_step_safety"
                     : "lower numerics.time_step_safety";
}

void Guard::finite(std::int64_t step, const Bodies& bodies, double force, double spent) const {
  if (std::isfinite(force) && std::isfinite(spent)) return;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (const char* part = wrong_part(bodies, i))
      throw PhysicsError(fmt::format(
          "step {}: grain {} has a {} that is not a number: the time step is too large for the stiffness, or "
          "the input overlaps: {}",
          step, i, part, lower_step()));
  throw PhysicsError(fmt::format(
      "step {}: the forces add up to {} N and damping takes {} J: the time step is too large for the stiffness: {}",
      step, force, spent, lower_step()));
}

void Guard::too_deep(std::int64_t step, const std::string& deepest, double unbalanced_force,
                     const Measures& measures) const {
  const double stiffness = measures.axial_stiffness.head(dimension_).mean();
  const bool squeezed = mean(measures.stress, dimension_) > soft * stiffness;
  const bool loaded = squeezed || (unbalanced_force < quiet && !fixed_step_);
  throw PhysicsError(fmt::format(
      "step {}: {}, more than the {:.3g} % of guards.overlap: {}", step, deepest, 100 * limits_.overlap,
      !loaded
          ? fmt::format("grains move too far in a step; {}, lower the loading rate, or check the packing", lower_step())
          : fmt::format("{}the load is too high for grains of this stiffness{}; {}lower {}, or raise "
                        "contact.young_modulus",
                        planes_ ? "a plane is moved too far into the grains, or " : "",
                        dimension_ == 2 ? ", for disks young_modulus times radius per metre of thickness" : "",
                        planes_ ? "shorten the way of the plane, " : "", planes_ ? "the load" : "it")));
}

void Guard::room(std::int64_t step, const Cell& cell) const {
  const Vec3 widths = cell.widths();
  for (int a = 0; a < dimension_; ++a) {
    if (!cell.periodic(a) || largest_ + range_ < widest_grain * widths[a]) continue;
    throw PhysicsError(fmt::format(
        "step {}: the cell is {:.4g} m wide along axis {}, and the largest grain is {:.4g} m across{}, half of "
        "it or more: it would touch itself; strain it less, or take more grains",
        step, widths[a], "xyz"[a], largest_,
        range_ > 0 ? fmt::format(" and acts across gaps of {:.4g} m", range_) : std::string()));
  }
}

void Guard::balance(std::int64_t step, const Energies& e) const {
  const double turned_over = e.turned_over() + std::abs(e.initial()) + e.kinetic() + std::abs(e.stored());
  if (!(std::abs(e.error()) > limits_.energy_error * turned_over)) return;
  throw PhysicsError(
      fmt::format("step {}: {:.3g} J of energy {}, {:.3g} % of the {:.3g} J converted, more than the {:.3g} % of "
                  "guards.energy_error: the time step is too large, or grains move too fast: {} or the loading rate",
                  step, std::abs(e.error()), e.error() < 0 ? "came from nowhere" : "went nowhere",
                  100 * std::abs(e.error()) / turned_over, turned_over, 100 * limits_.energy_error, lower_step()));
}

void Guard::escape(std::int64_t step, const Bodies& bodies) const {
  if (!open_[0] && !open_[1] && !open_[2]) return;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    for (int a = 0; a < dimension_; ++a) {
      const double x = bodies.grains[i].position[a];
      if (!open_[static_cast<std::size_t>(a)] || (x >= low_[a] && x <= high_[a])) continue;
      throw PhysicsError(fmt::format(
          "step {}: grain {} has gone to {} = {:.4g} m, beyond {:.4g} m: it escaped through an open side or "
          "between planes; close it with a [[plane]], or raise guards.escape",
          step, i, "xyz"[a], x, x < low_[a] ? low_[a] : high_[a]));
    }
}

}  // namespace soilweave::dem
