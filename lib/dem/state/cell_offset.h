// Number of cells between a grain and a neighbour's image, packed into one integer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstdint>

#include "core/tensor.h"

namespace soilweave::dem {

/// Packed offset, x in the highest bits. Offsets add, subtract and compare (x first) like vectors of integers.
using CellOffset = std::int64_t;

/// Bits per axis, sign included.
constexpr int cell_offset_bits = 21;

/// Packs three integers. Each is limited to a million cells, farther than any pair reaches.
inline CellOffset cell_offset(const Vec3i& cells) {
  constexpr std::int64_t most = (std::int64_t{1} << (cell_offset_bits - 1)) - 1;
  const auto along = [&](int axis) { return std::clamp(std::int64_t{cells[axis]}, -most, most); };
  return (along(0) * (1 << cell_offset_bits) + along(1)) * (1 << cell_offset_bits) + along(2);
}

/// Unpacks an offset.
inline Vec3i cells_of(CellOffset offset) {
  constexpr std::int64_t range = std::int64_t{1} << cell_offset_bits, half = range / 2;
  Vec3i cells;
  for (const int axis : {2, 1}) {
    cells[axis] = static_cast<int>(((offset + half) & (range - 1)) - half);
    offset = (offset - cells[axis]) / range;
  }
  cells[0] = static_cast<int>(offset);
  return cells;
}

/// Returns the vector to add to the second grain's position, m. `matrix`: Cell::matrix.
inline Vec3 shift_of(CellOffset offset, const Mat3& matrix) {
  return offset == 0 ? Vec3::Zero() : Vec3(matrix * cells_of(offset).cast<double>());
}

}  // namespace soilweave::dem
