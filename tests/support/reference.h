// Comma-separated tables of the reference data, in the folder SOILWEAVE_REFERENCE.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace soilweave::test {

using Columns = std::map<std::string, std::vector<double>>;

/// Returns a file of the reference folder; empty without SOILWEAVE_REFERENCE, or if the file does not exist.
inline std::filesystem::path reference_file(const std::string& name) {
  const char* folder = std::getenv("SOILWEAVE_REFERENCE");
  if (folder == nullptr || *folder == 0) return {};
  const std::filesystem::path file = std::filesystem::path(folder) / name;
  return std::filesystem::exists(file) ? file : std::filesystem::path();
}

/// Returns a comma-separated table of the reference folder; empty if there is none.
inline Columns reference_table(const std::string& name) {
  Columns table;
  std::ifstream file(reference_file(name));
  std::string line;
  std::vector<std::string> names;
  while (std::getline(file, line)) {
    std::istringstream cells(line);
    std::string cell;
    for (std::size_t i = 0; std::getline(cells, cell, ','); ++i) {
      if (table.size() < names.size() || names.size() <= i) {
        names.push_back(cell);
      } else {
        table[names[i]].push_back(std::strtod(cell.c_str(), nullptr));
      }
    }
    for (const std::string& one : names) table[one];
  }
  return table;
}

}  // namespace soilweave::test
