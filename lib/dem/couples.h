// The couples of materials, and a contact law's answers for them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
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

  const typename Law::Couple& of(std::int32_t a, std::int32_t b) const { return all_[place(a, b)]; }
  const std::vector<typename Law::Couple>& all() const { return all_; }
  /// The only one, where there is one material.
  std::optional<typename Law::Couple> lone() const {
    return all_.size() == 1 ? std::optional(all_.front()) : std::nullopt;
  }
  /// Those of the first n materials with any.
  std::span<const typename Law::Couple> of_first(std::int32_t n) const {
    return std::span(all_).first(std::min(count_, static_cast<std::size_t>(n)) * count_);
  }

  /// Whether some couple's answer depends on the masses.
  bool use_masses() const {
    return std::any_of(all_.begin(), all_.end(), [](const auto& couple) { return Law::uses_masses(couple); });
  }

  /// Whether some couple resists rolling or twisting; where none does, no moment of the memory has a meaning.
  bool use_moments() const {
    return std::any_of(all_.begin(), all_.end(), [](const auto& couple) { return Law::uses_moments(couple); });
  }

  /// The law's answer in lanes whose couples may differ: each couple answers for all, its own lanes are taken.
  template <class T, class Space>
  Response<T> respond(const Bodies& bodies, const BlockLanes<T>& lanes, const Kinematics<T, Space>& kinematics,
                      const T& dt, Memory<T, Space>& memory, Books<T>& books) const {
    if (all_.size() == 1) return Law::respond(all_[0], kinematics, dt, memory, books);
    // By copies: what is looked at through references would have to lie in memory above, too.
    Answer<T, Space> answer{{}, memory, {}};
    answer_differing(bodies, lanes, Kinematics<T, Space>(kinematics), T(dt), answer);
    memory = answer.memory, books = answer.books;
    return answer.response;
  }

 private:
  template <class T, class Space>
  struct Answer {
    Response<T> response;
    Memory<T, Space> memory;
    Books<T> books;
  };

  template <class T, class Space>
  [[gnu::noinline]] void answer_differing(const Bodies& bodies, const BlockLanes<T>& lanes,
                                          const Kinematics<T, Space>& k, const T& dt, Answer<T, Space>& answer) const {
    Mask<T> couple{};
    for (std::size_t lane = 0; lane < width<T>; ++lane)
      couple[lane] = static_cast<std::int64_t>(place(bodies.material[lanes.first(lane) / sizeof(Grain)],
                                                     bodies.material[lanes.second(lane) / sizeof(Grain)]));
    const Memory<T, Space> before = answer.memory;
    Mask<T> answered{};
    for (int lane = 0; lane < width<T>; ++lane) {
      if (answered[lane]) continue;
      Answer<T, Space> one{{}, before, {}};
      one.response = Law::respond(all_[static_cast<std::size_t>(couple[lane])], k, dt, one.memory, one.books);
      const Mask<T> mine = couple == couple[lane];
      answer.response = select<T>(mine, one.response, answer.response);
      answer.memory = select(mine, one.memory, answer.memory);
      answer.books = select<T>(mine, one.books, answer.books);
      answered |= mine;
    }
  }

  std::size_t place(std::int32_t a, std::int32_t b) const {
    return static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b);
  }

  std::size_t count_;
  std::vector<typename Law::Couple> all_;
};

}  // namespace soilweave::dem
