// Finds the data that come with the tools.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/data.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "core/error.h"

namespace soilweave {
namespace {

namespace fs = std::filesystem;

fs::path data_folder(const std::string& folder) {
  std::error_code failure;
  if (const char* given = std::getenv("SOILWEAVE_DATA")) {
    if (fs::is_directory(fs::path(given) / folder, failure)) return fs::path(given) / folder;
    throw MissingInput(
        fmt::format("SOILWEAVE_DATA: {}: has no folder {}; name the folder data/ of the source", given, folder));
  }
  const fs::path program = fs::read_symlink("/proc/self/exe", failure);
  for (fs::path at = program.parent_path(); at.has_relative_path(); at = at.parent_path())
    for (const char* place : {"share/soilweave", "data"})
      if (fs::is_directory(at / place / folder, failure)) return at / place / folder;
  throw MissingInput(
      fmt::format("{}: not found beside the program; set SOILWEAVE_DATA to the folder data/ of the source", folder));
}

}  // namespace

fs::path data_file(const std::string& folder, const std::string& file) {
  const fs::path path = data_folder(folder) / file;
  std::error_code failure;
  if (!fs::is_regular_file(path, failure)) throw MissingInput(fmt::format("{}: no such file", path.string()));
  return path;
}

std::vector<std::string> data_names(const std::string& folder, const std::string& ending) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(data_folder(folder)))
    if (entry.path().extension() == ending) names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace soilweave
