// Grains as flat arrays of rows.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/bodies.h"

#include <algorithm>
#include <limits>
#include <numbers>
#include <utility>

namespace soilweave::dem {

Bodies::Bodies(const io::GrainsRecord& record)
    : dimension(record.dimension),
      gyration(dimension == 3 ? 0.4 : 0.5),  // solid sphere; disk about its axis
      force(record.size(), Lane4{}),
      torque(record.size(), Lane4{}),
      material(record.material_id.begin(), record.material_id.end()) {
  for (std::size_t i = 0; i < record.size(); ++i) {
    position.push_back(row(record.position[i], record.radius[i]));
    velocity.push_back(row(record.velocity[i], record.mass[i]));
    spin.push_back(row(record.angular_velocity[i], record.radius[i]));
    const Vec4& q = record.orientation[i];
    orientation.push_back(Lane4{q[0], q[1], q[2], q[3]});
  }
}

void Bodies::set_fabric(std::vector<std::int32_t> fabric_of) {
  fabric = std::move(fabric_of);
  for (std::size_t i = 0; i < size(); ++i)
    if (is_node(i)) spin[i] = row(Vec3::Zero(), radius(i));
}

void Bodies::scale_radii(double factor, const Vec3& stretch) {
  for (std::size_t i = 0; i < size(); ++i) {
    if (is_node(i)) continue;
    position[i] *= row(stretch, factor);
    velocity[i][3] *= dimension == 3 ? factor * factor * factor : factor * factor;
    spin[i][3] = radius(i);
  }
}

double grain_volume(int dimension, double radius) {
  return dimension == 3 ? 4.0 / 3.0 * std::numbers::pi * radius * radius * radius : std::numbers::pi * radius * radius;
}

double Bodies::solid_volume() const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += grain_volume(dimension, radius(i));
  return sum;
}

double Bodies::largest_radius() const {
  double largest = 0;
  for (std::size_t i = 0; i < size(); ++i) largest = std::max(largest, radius(i));
  return largest;
}

double Bodies::smallest_radius() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < size(); ++i) smallest = std::min(smallest, radius(i));
  return smallest;
}

double Bodies::smallest_mass() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < size(); ++i) smallest = std::min(smallest, mass(i));
  return smallest;
}

double Bodies::total_mass() const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += mass(i);
  return sum;
}

void Bodies::store(io::GrainsRecord& record) const {
  for (std::size_t i = 0; i < size(); ++i) {
    record.position[i] = vector_of(position[i]);
    record.velocity[i] = vector_of(velocity[i]);
    record.angular_velocity[i] = vector_of(spin[i]);
    for (int a = 0; a < 4; ++a) record.orientation[i][a] = orientation[i][a];
    record.radius[i] = radius(i);
    record.mass[i] = mass(i);
  }
}

}  // namespace soilweave::dem
