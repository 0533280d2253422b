// Candidate pairs and the contacts among them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contacts.h"

namespace soilweave::dem {

void Contacts::clear(std::size_t k) {
  const V3<double> zero{0, 0, 0};
  touching[k] = sliding[k] = 0;
  memory[k] = {zero, zero, 0.0};
  overlap[k] = normal_force[k] = 0;
  normal[k] = branch[k] = force[k] = torque_first[k] = torque_second[k] = zero;
  normal_stiffness[k] = shear_stiffness[k] = rolling_stiffness[k] = twisting_stiffness[k] = 0;
}

void Contacts::index(std::size_t n) {
  body_start.assign(n + 1, 0);
  const auto count = [&](std::int32_t body) {
    if (body >= 0) ++body_start[static_cast<std::size_t>(body) + 1];
  };
  for (std::size_t k = 0; k < size(); ++k) count(first[k]), count(second[k]);
  for (std::size_t b = 0; b < n; ++b) body_start[b + 1] += body_start[b];
  body_pairs.resize(static_cast<std::size_t>(body_start[n]));
  std::vector<std::int32_t> next(body_start.begin(), body_start.end() - 1);
  for (std::size_t k = 0; k < size(); ++k)
    for (const std::int32_t body : {first[k], second[k]})
      if (body >= 0)
        body_pairs[static_cast<std::size_t>(next[static_cast<std::size_t>(body)]++)] = static_cast<std::int32_t>(k);
}

}  // namespace soilweave::dem
