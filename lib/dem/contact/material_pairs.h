// Pairs of materials, mixed once as a contact law sees them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <vector>

#include "dem/contact/contacts.h"
#include "dem/contact/laws.h"

namespace soilweave::dem {

/// Table of all pairs of n materials, with (a, b) and (b, a) as separate entries.
template <class Law>
class MaterialPairs {
 public:
  explicit MaterialPairs(const std::vector<typename Law::Material>& materials) : count_(materials.size()) {
    for (const auto& a : materials)
      for (const auto& b : materials) all_.push_back(Law::mix(a, b));
  }

  /// Returns the pair of two materials.
  const typename Law::MaterialPair& of(std::int32_t a, std::int32_t b) const { return all_[place(a, b)]; }
  /// Returns the pair of materials of a block.
  const typename Law::MaterialPair& of(const ContactBlock& block, const Bodies& bodies) const {
    const auto material = [&](std::uint32_t grain) {
      return bodies.material[static_cast<std::size_t>(ContactBlock::index(grain))];
    };
    return of(material(block.first[0]), material(block.second[0]));
  }
  /// Returns the pairs of all materials, row by row.
  const std::vector<typename Law::MaterialPair>& all() const { return all_; }
  /// Returns the only pair, if there is one material.
  std::optional<typename Law::MaterialPair> lone() const {
    return all_.size() == 1 ? std::optional(all_.front()) : std::nullopt;
  }
  /// Returns the pairs of the first n materials with any material.
  std::span<const typename Law::MaterialPair> of_first(std::int32_t n) const {
    return std::span(all_).first(std::min(count_, static_cast<std::size_t>(n)) * count_);
  }

  /// Returns whether the force of some pair of materials depends on the masses.
  bool use_masses() const {
    return std::any_of(all_.begin(), all_.end(), [](const auto& mixed) { return Law::uses_masses(mixed); });
  }

  /// Returns the largest gap across which some pair of materials acts, m.
  double range() const {
    double largest = 0;
    if constexpr (ActsAcrossGaps<Law>)
      for (const auto& mixed : all_) largest = std::max(largest, Law::range(mixed));
    return largest;
  }

  /// Returns whether some pair of materials resists rolling or twisting.
  bool use_moments() const {
    return std::any_of(all_.begin(), all_.end(), [](const auto& mixed) { return Law::uses_moments(mixed); });
  }

 private:
  /// Returns the index of a pair in all_.
  std::size_t place(std::int32_t a, std::int32_t b) const {
    return static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b);
  }

  /// Number of materials.
  std::size_t count_;
  /// All pairs of materials, mixed.
  std::vector<typename Law::MaterialPair> all_;
};

}  // namespace soilweave::dem
