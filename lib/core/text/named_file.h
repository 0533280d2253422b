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
  std::vector<std::string> overrides;  // KEY=VALUE of each --set

  /// Returns the path that `word`, the text of the full key `key`, points to. Relative paths count from the document's
  /// folder. They count from the working folder if --set gave the text or the document came from standard input. Throws
  /// MissingInput that names the places searched.
  std::filesystem::path path(const std::string& key, const std::string& word) const;
};

}  // namespace soilweave
