// Copies of a representative volume side by side.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/tile.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>

#include "core/error.h"
#include "packing/generate/rows.h"

namespace soilweave::packing {
namespace {

class Tiling {
 public:
  Tiling(const io::Snapshot& packing, const std::array<int, 3>& copies, const std::array<bool, 3>& closed)
      : of_(packing), copies_(copies[0], copies[1], copies[2]), closed_(closed), grains_(packing.grains.size()) {
    const Mat3 inverse = packing.cell.matrix.inverse();
    for (const Vec3& x : packing.grains.position) wraps_.push_back((inverse * x).array().floor().cast<int>());
  }

  io::Snapshot make() const {
    io::Snapshot block;
    block.grains.dimension = of_.grains.dimension;
    block.cell.periodic = closed_;
    for (int a = 0; a < 3; ++a) block.cell.matrix.col(a) = copies_[a] * of_.cell.matrix.col(a);
    const Vec3 centre = 0.5 * block.cell.matrix.rowwise().sum();
    for (int z = 0; z < copies_[2]; ++z)
      for (int y = 0; y < copies_[1]; ++y)
        for (int x = 0; x < copies_[0]; ++x) add_grains({x, y, z}, centre, block.grains);
    for (int z = 0; z < copies_[2]; ++z)
      for (int y = 0; y < copies_[1]; ++y)
        for (int x = 0; x < copies_[0]; ++x) add_contacts({x, y, z}, block.contacts);
    sort_by_bodies(block.contacts);
    return block;
  }

 private:
  std::int32_t number(const Vec3i& copy) const { return (copy.z() * copies_.y() + copy.y()) * copies_.x() + copy.x(); }

  void add_grains(const Vec3i& copy, const Vec3& centre, io::GrainsRecord& to) const {
    for (std::size_t i = 0; i < grains_; ++i) {
      take_grain(to, of_.grains, i);
      to.body_id.back() = static_cast<std::int64_t>(to.size()) - 1;
      to.position.back() += of_.cell.matrix * (copy - wraps_[i]).cast<double>() - centre;
      to.copy_id.back() = number(copy);
    }
  }

  // Adds the contacts of a copy's grains whose second grain exists, in this or another copy.
  void add_contacts(const Vec3i& copy, io::ContactsRecord& to) const {
    for (std::size_t c = 0; c < of_.contacts.size(); ++c) {
      const auto [first, second] = of_.contacts.bodies[c];
      if (second < 0) continue;
      Vec3i other = copy + of_.contacts.image[c] + wraps_[static_cast<std::size_t>(second)] -
                    wraps_[static_cast<std::size_t>(first)];
      Vec3i image = Vec3i::Zero();
      bool there = true;
      for (int a = 0; a < 3; ++a) {
        if (closed_[static_cast<std::size_t>(a)]) {
          image[a] = static_cast<int>(std::floor(static_cast<double>(other[a]) / copies_[a]));
          other[a] -= image[a] * copies_[a];
        }
        there = there && other[a] >= 0 && other[a] < copies_[a];
      }
      const auto n = static_cast<std::int32_t>(grains_);
      if (there) take_contact(to, of_.contacts, c, first + n * number(copy), second + n * number(other), image);
    }
  }

  const io::Snapshot& of_;
  Vec3i copies_;
  std::array<bool, 3> closed_;
  std::size_t grains_;
  std::vector<Vec3i> wraps_;  // offset of every grain's recorded position
};

}  // namespace

io::Snapshot tile(const io::Snapshot& packing, const std::array<int, 3>& copies, const std::array<bool, 3>& closed) {
  for (int a = 0; a < 3; ++a)
    if (!packing.cell.periodic[static_cast<std::size_t>(a)])
      throw DataError(
          fmt::format("the representative volume is not periodic along {}: its copies would not fit each "
                      "other; make it with pack-generate",
                      "xyz"[a]));
  return Tiling(packing, copies, closed).make();
}

io::Snapshot filter(const io::Snapshot& state, const std::function<bool(std::size_t)>& keep) {
  io::Snapshot left;
  left.cell = state.cell;
  left.grains.dimension = state.grains.dimension;
  std::vector<std::int32_t> place(state.grains.size(), -1);
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    if (!keep(i)) continue;
    place[i] = static_cast<std::int32_t>(left.grains.size());
    take_grain(left.grains, state.grains, i);
  }
  for (std::size_t c = 0; c < state.contacts.size(); ++c) {
    const auto [first, second] = state.contacts.bodies[c];
    const std::int32_t a = place[static_cast<std::size_t>(first)];
    const std::int32_t b = second < 0 ? -1 : place[static_cast<std::size_t>(second)];
    if (a >= 0 && b >= 0) take_contact(left.contacts, state.contacts, c, a, b, state.contacts.image[c]);
  }
  return left;
}

}  // namespace soilweave::packing
