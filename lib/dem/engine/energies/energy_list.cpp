// The energy terms. The build makes the list from the headers of this folder (Makefile).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <tuple>

#include "dem/engine/energy_term.h"
#include "lists/energies.h"

namespace soilweave::dem {
namespace energies {
namespace {

template <class T>
constexpr EnergyTerm declared() {
  EnergyTerm term{T::name, T::name, T::sentence, T::role};
  if constexpr (requires { T::column; }) term.column = T::column;
  if constexpr (requires { T::share; }) term.share = T::share;
  if constexpr (requires { T::place; }) term.place = T::place;
  if constexpr (requires { T::in_step; }) term.in_step = T::in_step;
  if constexpr (requires { T::between_steps; }) term.between_steps = T::between_steps;
  if constexpr (requires { T::at_start; }) term.at_start = T::at_start;
  if constexpr (requires { T::now; }) term.now = T::now;
  if constexpr (requires { T::occurs; }) term.occurs = T::occurs;
  static_assert((requires { T::now; }) != (
                                              requires { T::in_step; } || requires { T::between_steps; }),
                "an energy term declares either now(), or what is added up: in_step(), between_steps()");
  static_assert(!(
                    requires { T::now; } && requires { T::at_start; }),
                "now() leaves no use for at_start()");
  return term;
}

template <class... T>
constexpr std::array all_declared = {declared<T>()...};

// Returns whether all words differ, apart from empty ones.
constexpr bool differ(std::string_view EnergyTerm::*word) {
  const auto& terms = all_declared<SOILWEAVE_ENERGIES>;
  for (std::size_t k = 0; k < terms.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (!(terms[k].*word).empty() && terms[k].*word == terms[j].*word) return false;
  return true;
}
static_assert(differ(&EnergyTerm::name), "two energy terms have one name");
static_assert(differ(&EnergyTerm::column), "two energy terms have one column");

std::vector<EnergyTerm> in_order() {
  const auto& terms = all_declared<SOILWEAVE_ENERGIES>;
  std::vector<EnergyTerm> sorted(terms.begin(), terms.end());
  std::sort(sorted.begin(), sorted.end(), [](const EnergyTerm& one, const EnergyTerm& other) {
    return std::tie(one.place, one.name) < std::tie(other.place, other.name);
  });
  return sorted;
}

}  // namespace
}  // namespace energies

const std::vector<EnergyTerm>& energy_terms() {
  static const std::vector<EnergyTerm> terms = energies::in_order();
  return terms;
}

}  // namespace soilweave::dem
