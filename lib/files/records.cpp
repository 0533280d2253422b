// Copies single contacts between records, and finds the nodes among the grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/records.h"

namespace soilweave::io {

void ContactsRecord::append_own(const ContactsRecord& from, std::size_t c, double side) {
  if (own.empty())
    for (const OwnHistory& field : from.own) own.push_back({field.name, field.unit, field.long_name, field.width, {}});
  for (std::size_t f = 0; f < from.own.size(); ++f) {
    const OwnHistory& field = from.own[f];
    for (std::size_t k = 0; k < field.width; ++k)
      own[f].values.push_back((field.width == 1 ? 1 : side) * field.values[field.width * c + k]);
  }
}

void ContactsRecord::append(const ContactsRecord& from, std::size_t c) {
  bodies.push_back(from.bodies[c]), image.push_back(from.image[c]), normal.push_back(from.normal[c]);
  branch_vector.push_back(from.branch_vector[c]), overlap.push_back(from.overlap[c]);
  normal_force.push_back(from.normal_force[c]), shear_force.push_back(from.shear_force[c]);
  rolling_moment.push_back(from.rolling_moment[c]), twisting_moment.push_back(from.twisting_moment[c]);
  sliding.push_back(from.sliding[c]);
  append_own(from, c);
}

std::vector<bool> nodes(const Snapshot& state) {
  std::vector<bool> node(state.grains.size(), false);
  for (const auto& ends : state.yarns.nodes)
    for (const std::int32_t n : ends) node[static_cast<std::size_t>(n)] = true;
  return node;
}

}  // namespace soilweave::io
