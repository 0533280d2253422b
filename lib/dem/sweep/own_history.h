// Reads and writes the fields of history that only one law keeps.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A block has an array of eight for each number. A vector takes three arrays.
// For disks a vector is one number along the contact, in the third array (space.h).
#pragma once

#include <cstddef>
#include <tuple>
#include <utility>

#include "dem/contact/contact_block.h"
#include "dem/contact/laws.h"

namespace soilweave::dem {

/// The fields of law L. Without such fields all members do nothing.
template <class L>
class OwnFields {
 public:
  /// Number of arrays per block.
  static constexpr std::size_t arrays = numbers_of(history_fields<L>());

  /// Fills the law's own part of `history` for pairs that touch.
  /// `from`: place of the lane in the block's first array. `carried`: rotates vectors to the present contact.
  template <class T, class Space, class Histories, class Carry>
  static void read(const double* from, const Mask<T>& touching, const Carry& carried, Histories& history) {
    each<T, Space>(history, [&]<class Field>(Field& field, std::size_t array, HistoryField::Kind kind) {
      const double* const at = from + array * ContactBlock::size;
      if constexpr (std::is_same_v<Field, V3<T>>)
        field = carried(masked(
            touching, V3<T>{load<T>(at), load<T>(at + ContactBlock::size), load<T>(at + 2 * ContactBlock::size)}));
      else
        field = masked(touching, load<T>(at + number_in(kind) * ContactBlock::size));
    });
  }
  /// Stores the law's own part of `history`.
  template <class T, class Space, class Histories>
  static void write(Histories& history, double* to) {
    each<T, Space>(history, [&]<class Field>(const Field& field, std::size_t array, HistoryField::Kind kind) {
      double* const at = to + array * ContactBlock::size;
      if constexpr (std::is_same_v<Field, V3<T>>)
        store(at, field.x), store(at + ContactBlock::size, field.y), store(at + 2 * ContactBlock::size, field.z);
      else
        store(at + number_in(kind) * ContactBlock::size, field);
    });
  }

 private:
  /// Returns the array that holds a number: the third one for a disk's vector.
  static constexpr std::size_t number_in(HistoryField::Kind kind) { return kind == HistoryField::Kind::scalar ? 0 : 2; }

  /// Calls use(field, first array, kind) for each field.
  template <class T, class Space, class Histories, class Use>
  static void each(Histories& history, const Use& use) {
    if constexpr (KeepsHistory<L>) {
      auto fields = history.own.fields();
      static_assert(std::tuple_size_v<decltype(fields)> == L::history.size(), "fields() ties what `history` declares");
      std::size_t array = 0;
      [&]<std::size_t... I>(std::index_sequence<I...>) {
        ((use(std::get<I>(fields), array, L::history[I].kind), array += L::history[I].numbers()), ...);
      }
      (std::make_index_sequence<L::history.size()>());
    }
  }
};

}  // namespace soilweave::dem
