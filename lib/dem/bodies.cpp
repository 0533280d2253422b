// Grains as flat arrays.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/bodies.h"

#include <algorithm>
#include <numbers>

namespace soilweave::dem {
namespace {

V3<double> to_v3(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
Vec3 to_vec3(const V3<double>& v) { return {v.x, v.y, v.z}; }

// Solid sphere 2/5 m r^2; disk about its axis 1/2 m r^2.
double moment_of_inertia(int dimension, double mass, double radius) {
  return (dimension == 3 ? 0.4 : 0.5) * mass * radius * radius;
}

}  // namespace

Bodies::Bodies(const io::GrainsRecord& record)
    : dimension(record.dimension),
      force(record.size(), V3<double>{0, 0, 0}),
      torque(record.size(), V3<double>{0, 0, 0}),
      radius(record.radius),
      mass(record.mass),
      material(record.material_id.begin(), record.material_id.end()),
      orientation(record.orientation) {
  for (std::size_t i = 0; i < record.size(); ++i) {
    position.push_back(to_v3(record.position[i]));
    velocity.push_back(to_v3(record.velocity[i]));
    angular_velocity.push_back(to_v3(record.angular_velocity[i]));
    inertia.push_back(moment_of_inertia(dimension, mass[i], radius[i]));
  }
}

void Bodies::scale_radii(double factor) {
  for (std::size_t i = 0; i < size(); ++i) {
    radius[i] *= factor;
    mass[i] *= dimension == 3 ? factor * factor * factor : factor * factor;
    inertia[i] = moment_of_inertia(dimension, mass[i], radius[i]);
  }
}

double grain_volume(int dimension, double radius) {
  return dimension == 3 ? 4.0 / 3.0 * std::numbers::pi * radius * radius * radius : std::numbers::pi * radius * radius;
}

double Bodies::solid_volume() const {
  double sum = 0;
  for (const double r : radius) sum += grain_volume(dimension, r);
  return sum;
}

double Bodies::largest_radius() const { return *std::max_element(radius.begin(), radius.end()); }
double Bodies::smallest_radius() const { return *std::min_element(radius.begin(), radius.end()); }

void Bodies::store(io::GrainsRecord& record) const {
  for (std::size_t i = 0; i < size(); ++i) {
    record.position[i] = to_vec3(position[i]);
    record.velocity[i] = to_vec3(velocity[i]);
    record.angular_velocity[i] = to_vec3(angular_velocity[i]);
  }
  record.orientation = orientation;
  record.radius = radius;
  record.mass = mass;
}

}  // namespace soilweave::dem
