// Removes grains and contacts with numbers that are not finite from a state.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/finite_part.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

namespace soilweave::io {
namespace {

bool finite(const GrainsRecord& g, std::size_t i) {
  return g.position[i].allFinite() && g.velocity[i].allFinite() && g.angular_velocity[i].allFinite() &&
         g.orientation[i].allFinite();
}

bool finite(const ContactsRecord& c, std::size_t k) {
  for (const OwnHistory& field : c.own)
    for (std::size_t j = 0; j < field.width; ++j)
      if (!std::isfinite(field.values[field.width * k + j])) return false;
  return c.normal[k].allFinite() && c.branch_vector[k].allFinite() && c.shear_force[k].allFinite() &&
         c.rolling_moment[k].allFinite() && std::isfinite(c.normal_force[k]) && std::isfinite(c.twisting_moment[k]) &&
         std::isfinite(c.overlap[k]);
}

// Too large steps leave quaternions that are no rotations.
Vec4 rotation(const Vec4& q) { return q.norm() > 0 ? Vec4(q.normalized()) : Vec4(1, 0, 0, 0); }

// A collapsed cell is opened, because nothing can be folded back along its axes.
void open_where_collapsed(Snapshot& state) {
  CellRecord& cell = state.cell;
  const GrainsRecord& g = state.grains;
  for (Mat3* m : {&cell.velocity_gradient, &cell.deformation_gradient})
    if (!m->allFinite()) *m = Mat3::Identity();
  double largest = 0;
  for (const double r : g.radius) largest = std::max(largest, r);
  if (cell.matrix.allFinite() && cell.matrix.determinant() > 0) {
    const Vec3 widths = cell.matrix.inverse().rowwise().norm().cwiseInverse();
    for (int a = 0; a < g.dimension; ++a)
      if (4 * largest >= widths[a]) cell.periodic[static_cast<std::size_t>(a)] = false;
    return;
  }
  cell.periodic = {false, false, false};
  cell.matrix = 4 * largest * Mat3::Identity();
}

template <class Item>
void take(std::vector<Item>& to, const std::vector<Item>& from, std::size_t i) {
  to.push_back(from[i]);
}

}  // namespace

Snapshot finite_part(const Snapshot& state) {
  Snapshot left;
  left.step = state.step, left.time = state.time;
  left.cell = state.cell, left.planes = state.planes;
  const GrainsRecord& from = state.grains;
  GrainsRecord& g = left.grains;
  g.dimension = from.dimension;
  std::vector<std::int32_t> place(from.size(), -1);
  for (std::size_t i = 0; i < from.size(); ++i) {
    if (!finite(from, i)) continue;
    place[i] = static_cast<std::int32_t>(g.size());
    take(g.body_id, from.body_id, i), take(g.position, from.position, i),
        g.orientation.push_back(rotation(from.orientation[i]));
    take(g.velocity, from.velocity, i), take(g.angular_velocity, from.angular_velocity, i);
    take(g.radius, from.radius, i), take(g.mass, from.mass, i);
    take(g.material_id, from.material_id, i), take(g.copy_id, from.copy_id, i);
  }
  open_where_collapsed(left);
  ContactsRecord& c = left.contacts;
  const ContactsRecord& all = state.contacts;
  for (std::size_t k = 0; k < all.size(); ++k) {
    auto [first, second] = all.bodies[k];
    first = place[static_cast<std::size_t>(first)];
    if (second >= 0) second = place[static_cast<std::size_t>(second)];
    const bool plane = all.bodies[k][1] < 0;
    if (first < 0 || (second < 0 && !plane) || !finite(all, k)) continue;
    c.append(all, k);
    c.bodies.back() = {first, second};
  }
  YarnsRecord& y = left.yarns;
  for (std::size_t k = 0; k < state.yarns.size(); ++k) {
    const YarnsRecord& whole = state.yarns;
    const std::int32_t first = place[static_cast<std::size_t>(whole.nodes[k][0])];
    const std::int32_t second = place[static_cast<std::size_t>(whole.nodes[k][1])];
    if (first < 0 || second < 0 || !std::isfinite(whole.tension[k]) || !std::isfinite(whole.largest_strain[k]))
      continue;
    y.nodes.push_back({first, second});
    take(y.fabric, whole.fabric, k), take(y.geotextile_id, whole.geotextile_id, k), take(y.family, whole.family, k);
    take(y.rest_length, whole.rest_length, k), take(y.largest_strain, whole.largest_strain, k);
    take(y.tension, whole.tension, k), take(y.broken, whole.broken, k), take(y.break_time, whole.break_time, k);
    take(y.break_position, whole.break_position, k);
  }
  return left;
}

}  // namespace soilweave::io
