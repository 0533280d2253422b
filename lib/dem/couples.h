// The couples of materials, and a contact law's answers for them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "dem/block_lanes.h"

namespace soilweave::dem {

template <class Law>
class Couples {
 public:
  explicit Couples(const std::vector<typename Law::Material>& materials) : count_(materials.size()) {
    for (const auto& a : materials)
      for (const auto& b : materials) all_.push_back(Law::mix(a, b));
  }

  const typename Law::Couple& of(std::int32_t a, std::int32_t b) const {
    return all_[static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b)];
  }
  const std::vector<typename Law::Couple>& all() const { return all_; }
  /// Those of the first n materials with any.
  std::span<const typename Law::Couple> of_first(std::int32_t n) const {
    return std::span(all_).first(std::min(count_, static_cast<std::size_t>(n)) * count_);
  }

  /// The law's answer in four lanes, whose couples may differ: each couple answers for all, its own lanes are taken.
  Response<Lane4> respond(const Bodies& bodies, const BlockLanes& lanes, const Kinematics<Lane4>& kinematics,
                          const Lane4& dt, Memory<Lane4>& memory, Books<Lane4>& books) const {
    if (all_.size() == 1) return Law::respond(all_[0], kinematics, dt, memory, books);
    const auto couple_of = [&](int lane) {
      const auto a = static_cast<std::size_t>(lanes.block->first[lanes.k + lane]);
      const auto b = static_cast<std::size_t>(lanes.block->second[lanes.k + lane]);
      return static_cast<std::int64_t>(static_cast<std::size_t>(bodies.material[a]) * count_ +
                                       static_cast<std::size_t>(bodies.material[b]));
    };
    const Mask<Lane4> couple{couple_of(0), couple_of(1), couple_of(2), couple_of(3)};
    const Memory<Lane4> before = memory;
    Response<Lane4> response = Law::respond(all_[static_cast<std::size_t>(couple[0])], kinematics, dt, memory, books);
    for (int lane = 1; lane < 4; ++lane) {
      const auto one = couple[lane];
      if (one == couple[0] || (lane > 1 && one == couple[1]) || (lane > 2 && one == couple[2])) continue;
      Memory<Lane4> other = before;
      Books<Lane4> other_books;
      const auto answer = Law::respond(all_[static_cast<std::size_t>(one)], kinematics, dt, other, other_books);
      const Mask<Lane4> mine = couple == one;
      response = select<Lane4>(mine, answer, response);
      memory = select<Lane4>(mine, other, memory);
      books = select<Lane4>(mine, other_books, books);
    }
    return response;
  }

 private:
  std::size_t count_;
  std::vector<typename Law::Couple> all_;
};

}  // namespace soilweave::dem
