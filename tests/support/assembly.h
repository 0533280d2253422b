// Assemblies of grains with known contacts and forces, for the tests of the analysis.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <random>
#include <vector>

#include "files/records.h"

namespace soilweave::analysis::test {

inline void add_grain(io::Snapshot& s, const Vec3& position, double radius) {
  io::GrainsRecord& g = s.grains;
  g.body_id.push_back(static_cast<std::int64_t>(g.position.size()));
  g.position.push_back(position);
  g.orientation.emplace_back(1, 0, 0, 0);
  g.velocity.emplace_back(Vec3::Zero());
  g.angular_velocity.emplace_back(Vec3::Zero());
  g.radius.push_back(radius);
  g.mass.push_back(1);
  g.material_id.push_back(0);
  g.copy_id.push_back(0);
}

/// Adds a contact of two grains, the second shifted by `image` cells. The force on the second is normal * n + shear.
inline void add_contact(io::Snapshot& s, std::int32_t first, std::int32_t second, const Vec3i& image, double normal,
                        const Vec3& shear = Vec3::Zero()) {
  io::ContactsRecord& c = s.contacts;
  const auto i = static_cast<std::size_t>(first), j = static_cast<std::size_t>(second);
  const Vec3 branch = s.grains.position[j] + s.cell.matrix * image.cast<double>() - s.grains.position[i];
  const Vec3 n = branch.normalized();
  c.bodies.push_back({first, second});
  c.image.push_back(image);
  c.normal.push_back(n);
  c.branch_vector.push_back(branch);
  c.overlap.push_back(s.grains.radius[i] + s.grains.radius[j] - branch.norm());
  c.normal_force.push_back(normal);
  c.shear_force.emplace_back(shear - shear.dot(n) * n);
  c.rolling_moment.emplace_back(Vec3::Zero());
  c.twisting_moment.push_back(0);
  c.sliding.push_back(0);
}

/// Adds a contact of a grain with its own image in the next cell, for any normal direction, with a branch of 2 r.
inline void add_direction(io::Snapshot& s, const Vec3& n, double normal, const Vec3& shear) {
  io::ContactsRecord& c = s.contacts;
  c.bodies.push_back({0, 1});
  c.image.emplace_back(Vec3i::Zero());
  c.normal.push_back(n);
  c.branch_vector.emplace_back(2 * n);
  c.overlap.push_back(0);
  c.normal_force.push_back(normal);
  c.shear_force.push_back(shear);
  c.rolling_moment.emplace_back(Vec3::Zero());
  c.twisting_moment.push_back(0);
  c.sliding.push_back(0);
}

/// Returns n x n x n touching spheres of diameter 1 (2D: n x n disks) with one normal force per axis in their contacts.
inline io::Snapshot simple_cubic(int n, const Vec3& force, int dimension = 3) {
  io::Snapshot s;
  s.grains.dimension = dimension;
  s.cell.matrix = Vec3(n, n, dimension == 3 ? n : 1).asDiagonal();
  s.cell.periodic[2] = dimension == 3;
  const int layers = dimension == 3 ? n : 1;
  const auto at = [n](int x, int y, int z) { return static_cast<std::int32_t>(x + n * (y + n * z)); };
  for (int z = 0; z < layers; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) add_grain(s, Vec3(x, y, z), 0.5);
  for (int z = 0; z < layers; ++z)
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x)
        for (int a = 0; a < dimension; ++a) {
          Vec3i to(x, y, z), image = Vec3i::Zero();
          to[a] += 1;
          if (to[a] == n) {
            to[a] = 0;
            image[a] = 1;
          }
          add_contact(s, at(x, y, z), at(to[0], to[1], to[2]), image, force[a]);
        }
  return s;
}

/// Returns grains at random in a sheared periodic cell of volume n, without overlap, some of them across its faces.
inline io::Snapshot random_cell(int n, int dimension = 3, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> any(0, 1);
  io::Snapshot s;
  s.grains.dimension = dimension;
  const double side = std::pow(n, 1.0 / dimension);
  s.cell.matrix << side, 0.3 * side, 0.1 * side, 0, side, -0.2 * side, 0, 0, side;
  if (dimension == 2) s.cell.matrix << side, 0.3 * side, 0, 0, side, 0, 0, 0, 1;
  s.cell.periodic[2] = dimension == 3;
  const Mat3 inverse = s.cell.matrix.inverse();
  for (int tries = 0; static_cast<int>(s.grains.size()) < n && tries < 200000; ++tries) {
    Vec3 reduced(any(random), any(random), dimension == 3 ? any(random) : 0);
    const double radius = 0.25 + 0.2 * any(random);
    bool free = true;
    for (std::size_t i = 0; free && i < s.grains.size(); ++i) {
      Vec3 apart = inverse * s.grains.position[i] - reduced;
      for (int a = 0; a < dimension; ++a) apart[a] -= std::round(apart[a]);
      free = (s.cell.matrix * apart).norm() > radius + s.grains.radius[i];
    }
    if (free) add_grain(s, s.cell.matrix * reduced, radius);
  }
  for (std::size_t i = 0; i < s.grains.size(); i += 3) s.grains.position[i] -= s.cell.matrix.col(0) * 2.0;
  return s;
}

}  // namespace soilweave::analysis::test
