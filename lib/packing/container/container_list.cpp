// The shapes of [container], from the list that the build makes of the files in shapes/.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "lists/containers.h"
#include "packing/container/container.h"

namespace soilweave::packing {
namespace {

struct ListedShape {
  std::string_view name;
  std::unique_ptr<Container> (*read)(Settings&, PlanFiles*);
};

template <class... C>
std::vector<ListedShape> listed_shapes() {
  return {ListedShape{C::name, &C::read}...};
}
const std::vector<ListedShape>& known() {
  static const std::vector<ListedShape> all = listed_shapes<SOILWEAVE_CONTAINERS>();
  return all;
}

}  // namespace

const std::vector<std::string>& shapes() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const ListedShape& s : known()) found.emplace_back(s.name);
    return found;
  }();
  return names;
}

std::unique_ptr<Container> read_container(std::string_view shape, Settings& table, PlanFiles* files) {
  for (const ListedShape& s : known())
    if (s.name == shape) return s.read(table, files);
  return nullptr;
}

}  // namespace soilweave::packing
