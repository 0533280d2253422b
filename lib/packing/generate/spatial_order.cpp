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
#include "packing/generate/rows.h"

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

// Sorts the grains of a box by recursive bisection across its longest side. `row`: number of the first row of the box.
// Cuts lie where chunks of rows begin. Chunks become about as long as wide, so that few contact pairs join different
// chunks.
void bisect(const std::vector<Vec3>& positions, std::size_t row, std::span<std::size_t> box) {
  if (box.size() < 2) return;
  Vec3 low = positions[box[0]], high = low;
  for (const std::size_t i : box) low = low.cwiseMin(positions[i]), high = high.cwiseMax(positions[i]);
  int axis = 0;
  (high - low).maxCoeff(&axis);
  const std::size_t first = row / dem::grains_per_chunk, chunks = dem::chunks_of(row + box.size()) - first;
  const std::size_t half = chunks > 1 ? (first + (chunks + 1) / 2) * dem::grains_per_chunk - row : box.size() / 2;
  const auto cut = box.begin() + static_cast<std::ptrdiff_t>(half);
  std::nth_element(box.begin(), cut, box.end(), [&](std::size_t a, std::size_t b) {
    return std::pair(positions[a][axis], a) < std::pair(positions[b][axis], b);
  });
  bisect(positions, row, box.first(half)), bisect(positions, row + half, box.subspan(half));
}

// Returns the contacts with the new rows of their grains, sorted.
io::ContactsRecord moved(const io::ContactsRecord& contacts, const std::vector<std::int32_t>& row) {
  const auto now = [&](std::int32_t body) { return body < 0 ? body : row[static_cast<std::size_t>(body)]; };
  io::ContactsRecord to;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    take_contact(to, contacts, c, now(contacts.bodies[c][0]), now(contacts.bodies[c][1]), contacts.image[c]);
  sort_by_bodies(to);
  return to;
}

}  // namespace

io::Snapshot in_spatial_order(io::Snapshot state, std::size_t first) {
  const io::GrainsRecord& g = state.grains;
  const auto names_a_row = [first](const auto& yarn) {
    return std::any_of(yarn.begin(), yarn.end(), [&](std::int32_t n) { return static_cast<std::size_t>(n) >= first; });
  };
  if (g.size() <= first + 1 || g.size() <= dem::grains_per_chunk ||
      std::any_of(state.yarns.nodes.begin(), state.yarns.nodes.end(), names_a_row))
    return state;
  std::vector<std::size_t> order(g.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  bisect(wrapped(state), first, std::span(order).subspan(first));
  io::GrainsRecord sorted;
  sorted.dimension = g.dimension;
  std::vector<std::int32_t> row(g.size());
  for (const std::size_t i : order) {
    row[i] = static_cast<std::int32_t>(sorted.size());
    take_grain(sorted, g, i);
  }
  state.contacts = moved(state.contacts, row);
  state.grains = std::move(sorted);
  return state;
}

}  // namespace soilweave::packing
