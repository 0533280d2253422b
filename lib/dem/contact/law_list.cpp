// Reads the materials of any law by its name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact/law_list.h"

#include "core/text/settings.h"

namespace soilweave::dem {
namespace {

template <class... Law>
std::vector<std::string> names_in(LawList<Law...>) {
  return {std::string(Law::name)...};
}

template <class... Law>
Materials read_in(LawList<Law...>, std::string_view name, std::vector<Settings>& tables) {
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

}  // namespace

const std::vector<std::string>& law_names() {
  static const std::vector<std::string> names = names_in(Laws());
  return names;
}

Materials read_materials(std::string_view name, std::vector<Settings>& tables) { return read_in(Laws(), name, tables); }

}  // namespace soilweave::dem
