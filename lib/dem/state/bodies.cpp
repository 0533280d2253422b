// Grains as rows.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/state/bodies.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <utility>

namespace soilweave::dem {

Bodies::Bodies(const io::GrainsRecord& record)
    : dimension(record.dimension),
      gyration(dimension == 3 ? 0.4 : 0.5),  // solid sphere; disk about its axis
      loads(record.size()),
      material(record.material_id.begin(), record.material_id.end()),
      of_one_material(std::adjacent_find(material.begin(), material.end(), std::not_equal_to<>()) == material.end()) {
  for (std::size_t i = 0; i < record.size(); ++i) {
    const Vec4& q = record.orientation[i];
    grains.push_back({row(record.position[i], record.radius[i]), row(record.velocity[i], record.mass[i]),
                      row(Vec3::Zero(), record.radius[i]), Lane4{q[0], q[1], q[2], q[3]}});
    set_spin(i, record.angular_velocity[i]);
    if (dimension == 2) angle.push_back(2 * std::atan2(q[3], q[0]));
  }
}

void Bodies::set_velocity(std::size_t i, const Vec3& v) {
  Lane4& to = grains[i].velocity;
  to = dimension == 2 ? Lane4{v[0], v[1], to[2], to[3]} : row(v, to[3]);
}

void Bodies::set_spin(std::size_t i, const Vec3& spin) {
  if (dimension == 2)
    grains[i].velocity[2] = spin[2];
  else
    grains[i].spin = row(spin, radius(i));
}

void Bodies::set_fabric(std::vector<std::int32_t> fabric_of) {
  fabric = std::move(fabric_of);
  for (std::size_t i = 0; i < size(); ++i)
    if (is_node(i)) set_spin(i, Vec3::Zero());
}

void Bodies::scale_radii(double factor, const Vec3& stretch) {
  for (std::size_t i = 0; i < size(); ++i) {
    if (is_node(i)) continue;
    grains[i].position *= row(stretch, factor);
    grains[i].velocity[3] *= dimension == 3 ? factor * factor * factor : factor * factor;
    grains[i].spin[3] = radius(i);
  }
}

double grain_volume(int dimension, double radius) {
  return dimension == 3 ? 4.0 / 3.0 * std::numbers::pi * radius * radius * radius : std::numbers::pi * radius * radius;
}

void set_density(io::Snapshot& state, double density) {
  const std::vector<bool> node = io::nodes(state);
  for (std::size_t i = 0; i < state.grains.size(); ++i)
    if (!node[i]) state.grains.mass[i] = density * grain_volume(state.grains.dimension, state.grains.radius[i]);
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

double Bodies::smallest_inertia() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < size(); ++i) smallest = std::min(smallest, inertia(i));
  return smallest;
}

double Bodies::total_mass() const {
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) sum += mass(i);
  return sum;
}

io::GrainsRecord Bodies::identities(io::GrainsRecord record) {
  io::GrainsRecord kept;
  kept.dimension = record.dimension;
  kept.body_id = std::move(record.body_id);
  kept.material_id = std::move(record.material_id);
  kept.copy_id = std::move(record.copy_id);
  return kept;
}

void Bodies::store(io::GrainsRecord& record) const {
  record.position.resize(size()), record.velocity.resize(size()), record.angular_velocity.resize(size());
  record.orientation.resize(size()), record.radius.resize(size()), record.mass.resize(size());
  for (std::size_t i = 0; i < size(); ++i) {
    const Grain& grain = grains[i];
    record.position[i] = vector_of(grain.position);
    record.velocity[i] = vector_of(velocity(i));
    record.angular_velocity[i] = vector_of(spin(i));
    const Lane4& q = grain.orientation;
    record.orientation[i] =
        dimension == 2 ? Vec4(std::cos(0.5 * angle[i]), 0, 0, std::sin(0.5 * angle[i])) : Vec4(q[0], q[1], q[2], q[3]);
    record.radius[i] = radius(i);
    record.mass[i] = mass(i);
  }
}

}  // namespace soilweave::dem
