// Requirements on a contact law.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A law is one header in laws/. It declares its name, its materials with their keys, and its response to a contact.
// It may also declare:
//
//   history   fields that only this law keeps for each contact, such as the largest overlap so far.
//             They are stored in files and checkpoints, and passed to respond() in the next step.
//   range     the gap across which two bodies still act on each other. Pairs are then searched that far.
//
// The build lists the headers (Makefile): no other file names a law.
#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "dem/contact/laws/contact.h"
#include "dem/contact/materials.h"

namespace soilweave {
class Settings;
}

namespace soilweave::dem {

/// A law with history of its own: `history` is an array of HistoryField.
/// `Own<T, Space>` holds the values of these fields. Its fields() returns a tie of them in the order of `history`.
template <class L>
concept KeepsHistory = requires {
  L::history.size();
};

/// A law that acts across gaps up to range(mixed), m.
/// Farther pairs come to respond() with an overlap of -range. They must get neither force nor energy.
template <class L>
concept ActsAcrossGaps = requires(const typename L::MaterialPair& mixed) {
  { L::range(mixed) } -> std::same_as<double>;
};

/// History of a contact, by law.
template <class L, class T, class Space>
struct HistoryOfLaw {
  using type = ContactHistory<T, Space>;
};
template <KeepsHistory L, class T, class Space>
struct HistoryOfLaw<L, T, Space> {
  using type = HistoryWithOwn<T, Space, typename L::template Own<T, Space>>;
};
/// History of a contact as law L has it.
template <class L, class T, class Space = Spatial>
using HistoryOf = typename HistoryOfLaw<L, T, Space>::type;

/// Returns the fields of history that only law L keeps.
template <class L>
constexpr std::span<const HistoryField> history_fields() {
  if constexpr (KeepsHistory<L>)
    return L::history;
  else
    return {};
}
/// Returns how many numbers a contact keeps for these fields.
constexpr std::size_t numbers_of(std::span<const HistoryField> fields) {
  std::size_t n = 0;
  for (const HistoryField& f : fields) n += f.numbers();
  return n;
}

/// A stateless law. Materials are mixed once per pair.
/// Pure functions then turn kinematics and history into forces, one contact per lane.
template <class L>
concept ContactLaw = requires(const typename L::Material& material, const typename L::MaterialPair& mixed,
                              const Kinematics<double>& kinematics, double dt, HistoryOf<L, double>& history,
                              ContactEnergies<double>& energies, const Kinematics<Lane4>& four,
                              HistoryOf<L, Lane4>& histories_of_four, ContactEnergies<Lane4>& energies_of_four,
                              Settings& table) {
  { L::read(table) } -> std::same_as<typename L::Material>;
  { L::name } -> std::convertible_to<std::string_view>;
  { L::examples[1] } -> std::convertible_to<std::string_view>;
  { L::modulus(material) } -> std::same_as<double>;
  { L::mix(material, material) } -> std::same_as<typename L::MaterialPair>;
  { L::uses_masses(mixed) } -> std::same_as<bool>;
  { L::uses_moments(mixed) } -> std::same_as<bool>;
  { L::respond(mixed, kinematics, dt, history, energies) } -> std::same_as<Response<double>>;
  { L::respond(mixed, four, Lane4{}, histories_of_four, energies_of_four) } -> std::same_as<Response<Lane4>>;
  requires std::same_as<typename L::Material::Law, L>;
};

/// A list of laws.
template <ContactLaw... Law>
struct LawList {};

/// Returns the names of all laws, for scenarios.
const std::vector<std::string>& law_names();
/// Reads each table as a material of the law `name`, one of law_names().
Materials read_materials(std::string_view name, std::vector<Settings>& tables);

}  // namespace soilweave::dem
