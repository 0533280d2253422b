// Grains and contacts copied row by row.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/rows.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <vector>

namespace soilweave::packing {
namespace {

template <class Item>
void take(std::vector<Item>& to, const std::vector<Item>& from, std::size_t i) {
  to.push_back(from[i]);
}

}  // namespace

void take_grain(io::GrainsRecord& to, const io::GrainsRecord& from, std::size_t i) {
  take(to.body_id, from.body_id, i), take(to.position, from.position, i), take(to.orientation, from.orientation, i);
  take(to.velocity, from.velocity, i), take(to.angular_velocity, from.angular_velocity, i);
  take(to.radius, from.radius, i), take(to.mass, from.mass, i), take(to.material_id, from.material_id, i);
  take(to.copy_id, from.copy_id, i);
}

void take_contact(io::ContactsRecord& to, const io::ContactsRecord& from, std::size_t c, std::int32_t first,
                  std::int32_t second, const Vec3i& image) {
  const bool turned = second >= 0 && second < first;
  const double side = turned ? -1 : 1;
  to.bodies.push_back(turned ? std::array{second, first} : std::array{first, second});
  to.image.emplace_back(turned ? Vec3i(-image) : image);
  to.normal.emplace_back(side * from.normal[c]);
  to.branch_vector.emplace_back(side * from.branch_vector[c]);
  take(to.overlap, from.overlap, c), take(to.normal_force, from.normal_force, c);
  to.shear_force.emplace_back(side * from.shear_force[c]);
  to.rolling_moment.emplace_back(side * from.rolling_moment[c]);
  take(to.twisting_moment, from.twisting_moment, c);  // about the normal, which turns too
  take(to.sliding, from.sliding, c);
  to.append_own(from, c, side);
}

void sort_by_bodies(io::ContactsRecord& contacts) {
  std::vector<std::size_t> order(contacts.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return contacts.bodies[a] < contacts.bodies[b]; });
  io::ContactsRecord sorted;
  for (const std::size_t c : order)
    take_contact(sorted, contacts, c, contacts.bodies[c][0], contacts.bodies[c][1], contacts.image[c]);
  contacts = std::move(sorted);
}

}  // namespace soilweave::packing
