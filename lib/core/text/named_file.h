// Files that a document names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soilweave {

/// Rule by which the file names in a document are resolved.
struct NamedFiles {
  /// Path of the document; - for standard input.
  std::string document;
  /// KEY=VALUE of each --set.
  std::vector<std::string> overrides;

  /// Returns the path that `word`, the text of the full key `key`, points to. Throws MissingInput.
  /// Relative paths count from the document's folder, or from the working folder for --set and standard input.
  std::filesystem::path path(const std::string& key, const std::string& word) const;
};

}  // namespace soilweave
