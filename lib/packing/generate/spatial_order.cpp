// Sorts grains so that neighbours in space are neighbours in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/spatial_order.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "dem/contact/contacts.h"

namespace soilweave::packing {
namespace {

// Returns the grains' positions wrapped into the cell.
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

// Sorts the grains of a box by recursive bisection across its longest side. Each half gets a whole number of chunks.
// Chunks become about as long as wide, so that few contact pairs join different chunks.
void bisect(const std::vector<Vec3>& positions, std::span<std::size_t> box) {
  if (box.size() < 2) return;
  Vec3 low = positions[box[0]], high = low;
  for (const std::size_t i : box) low = low.cwiseMin(positions[i]), high = high.cwiseMax(positions[i]);
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t chunks = dem::chunks_of(box.size());
  const std::size_t half = chunks > 1 ? (chunks + 1) / 2 * dem::grains_per_chunk : box.size() / 2;
  const auto cut = box.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(box.begin(), cut, box.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(positions[a][axis], a) < std::pair(positions[b][axis], b);
  });
  bisect(positions, box.first(half)), bisect(positions, box.subspan(half));
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
  std::vector<std::size_t> order(g.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  bisect(wrapped(state), order);
  put_in(order, g.body_id), put_in(order, g.position), put_in(order, g.orientation);
  put_in(order, g.velocity), put_in(order, g.angular_velocity), put_in(order, g.radius);
  put_in(order, g.mass), put_in(order, g.material_id), put_in(order, g.copy_id);
  return state;
}

}  // namespace soilweave::packing
