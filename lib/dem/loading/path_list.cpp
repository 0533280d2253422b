// The loading paths by their names. The build makes the list from the headers in paths/ (Makefile).
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/path.h"
#include "lists/paths.h"

namespace soilweave::dem {
namespace {

struct Entry {
  std::string_view name;
  std::unique_ptr<Path> (*read)(Settings&);
};

template <class... P>
std::vector<Entry> list() {
  return {
      Entry{P::name, [](Settings& table) -> std::unique_ptr<Path> { return std::make_unique<P>(P::read(table)); }}...};
}

const std::vector<Entry>& known() {
  static const std::vector<Entry> all = list<SOILWEAVE_PATHS>();
  return all;
}

}  // namespace

std::vector<std::string> path_names() {
  std::vector<std::string> names;
  for (const Entry& e : known()) names.emplace_back(e.name);
  return names;
}

std::unique_ptr<Path> read_path(const std::string& name, Settings& table) {
  for (const Entry& e : known())
    if (e.name == name) return e.read(table);
  return nullptr;
}

}  // namespace soilweave::dem
