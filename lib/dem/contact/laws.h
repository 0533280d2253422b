// Requirements on a contact law, and the list of all laws. A new law is registered by its name in that list.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"

namespace soilweave::dem {

/// A stateless law: materials are mixed once per pair of materials. Pure functions then turn kinematics and history
/// into forces, for one contact or several at once.
template <class L>
concept ContactLaw = requires(const typename L::Material& material, const typename L::MaterialPair& mixed,
                              const Kinematics<double>& kinematics, double dt, ContactHistory<double>& history,
                              ContactEnergies<double>& energies, const Kinematics<Lane4>& four,
                              ContactHistory<Lane4>& histories_of_four, ContactEnergies<Lane4>& energies_of_four,
                              Settings& table) {
  { L::read(table) } -> std::same_as<typename L::Material>;
  { L::name } -> std::convertible_to<std::string_view>;
  { L::mix(material, material) } -> std::same_as<typename L::MaterialPair>;
  { L::uses_masses(mixed) } -> std::same_as<bool>;
  { L::uses_moments(mixed) } -> std::same_as<bool>;
  { L::respond(mixed, kinematics, dt, history, energies) } -> std::same_as<Response<double>>;
  { L::respond(mixed, four, Lane4{}, histories_of_four, energies_of_four) } -> std::same_as<Response<Lane4>>;
  requires std::same_as<typename L::Material::Law, L>;
};

/// A list of laws: the variant of their materials, and their names for scenarios.
template <ContactLaw... Law>
struct LawList {
  using Materials = std::variant<std::vector<typename Law::Material>...>;

  static std::vector<std::string> names() { return {std::string(Law::name)...}; }
  /// Reads each table as a material of the law `name`, which must be one of names().
  static Materials read(std::string_view name, std::vector<Settings>& tables) {
    Materials all;
    const auto take = [&]<class L>() {
      if (L::name != name) return;
      std::vector<typename L::Material> materials;
      for (Settings& table : tables) materials.push_back(L::read(table));
      all = std::move(materials);
    };
    (take.template operator()<Law>(), ...);
    return all;
  }
};

using Laws = LawList<HertzMindlin, Linear>;
using AnyMaterials = Laws::Materials;

}  // namespace soilweave::dem
