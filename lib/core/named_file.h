// Files that a document names.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace soilweave {

/// Where the documents of one reading look for the files they name.
struct NamedFiles {
  std::string document;                // path of the document, - for standard input
  std::vector<std::string> overrides;  // --set, KEY=VALUE

  /// The path that `word`, the text of this full key, points to: a relative one from the document's folder; from the
  /// working folder where --set gave the text, or the document came from standard input. Throws MissingInput that says
  /// where no file was found.
  std::filesystem::path path(const std::string& key, const std::string& word) const;
};

}  // namespace soilweave
