// The deepest overlap of an assembly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/state/overlap.h"

#include <fmt/format.h>

#include <algorithm>

#include "dem/state/plane.h"

namespace soilweave::dem {

DeepestContact deepest_of(const io::ContactsRecord& contacts, const Bodies& bodies) {
  DeepestContact deepest;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto [first, second] = contacts.bodies[k];
    double radius = bodies.radius(static_cast<std::size_t>(first));
    if (second >= 0) radius = std::min(radius, bodies.radius(static_cast<std::size_t>(second)));
    const double relative = contacts.overlap[k] / radius;
    if (relative > deepest.relative) deepest = {first, second, contacts.overlap[k], relative};
  }
  return deepest;
}

std::string description(const DeepestContact& c) {
  const std::string other =
      c.second < 0 ? fmt::format("plane {}", plane_number(c.second)) : fmt::format("{}", c.second);
  return fmt::format("grains {} and {} overlap by {:.3g} m, {:.0f} % of the radius", c.first, other, c.overlap,
                     100 * c.relative);
}

}  // namespace soilweave::dem
