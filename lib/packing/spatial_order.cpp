// Neighbours in space as neighbours in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/spatial_order.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>

#include <Eigen/LU>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>
#include <vector>

#include "dem/contacts.h"

namespace soilweave::packing {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;

// In the cell that they are wrapped into.
std::vector<Vec3> wrapped(const io::Snapshot& state) {
  const Mat3 inverse = state.cell.matrix.inverse();
  std::vector<Vec3> positions;
  for (const Vec3& x : state.grains.position) {
    Vec3 reduced = inverse * x;
    for (int a = 0; a < 3; ++a)
      if (state.cell.periodic[static_cast<std::size_t>(a)]) reduced[a] -= std::floor(reduced[a]);
    positions.push_back(state.cell.matrix * reduced);
  }
  return positions;
}

template <class Traits, class Point>
std::vector<std::size_t> curve(const std::vector<Point>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  CGAL::hilbert_sort(order.begin(), order.end(), Traits(CGAL::make_property_map(points)));
  return order;
}

std::vector<std::size_t> curve(const std::vector<Vec3>& positions, int dimension) {
  if (dimension == 2) {
    std::vector<Kernel::Point_2> points;
    for (const Vec3& x : positions) points.emplace_back(x[0], x[1]);
    return curve<CGAL::Spatial_sort_traits_adapter_2<Kernel, CGAL::Pointer_property_map<Kernel::Point_2>::const_type>>(
        points);
  }
  std::vector<Kernel::Point_3> points;
  for (const Vec3& x : positions) points.emplace_back(x[0], x[1], x[2]);
  return curve<CGAL::Spatial_sort_traits_adapter_3<Kernel, CGAL::Pointer_property_map<Kernel::Point_3>::const_type>>(
      points);
}

template <class T>
void put_in(const std::vector<std::size_t>& order, std::vector<T>& values) {
  std::vector<T> ordered;
  ordered.reserve(values.size());
  for (const std::size_t i : order) ordered.push_back(values[i]);
  values = std::move(ordered);
}

}  // namespace

io::Snapshot in_spatial_order(io::Snapshot state) {
  io::GrainsRecord& g = state.grains;
  if (g.size() <= dem::grains_per_chunk || state.contacts.size() > 0 || state.yarns.size() > 0) return state;
  const std::vector<std::size_t> order = curve(wrapped(state), g.dimension);
  put_in(order, g.body_id), put_in(order, g.position), put_in(order, g.orientation);
  put_in(order, g.velocity), put_in(order, g.angular_velocity), put_in(order, g.radius);
  put_in(order, g.mass), put_in(order, g.material_id), put_in(order, g.copy_id);
  return state;
}

}  // namespace soilweave::packing
