// Files that a document names.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/named_file.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace soilweave {

namespace fs = std::filesystem;

fs::path NamedFiles::path(const std::string& key, const std::string& word) const {
  const bool by_set =
      std::any_of(overrides.begin(), overrides.end(), [&](const std::string& o) { return o.starts_with(key + "="); });
  const fs::path folder = by_set ? fs::path() : fs::path(document).parent_path();
  const fs::path there = folder / word;
  std::error_code failure;
  if (!word.empty() && fs::exists(there, failure)) return there;
  throw MissingInput(fmt::format("{}: no such file; {} names \"{}\", looked for {}", there.string(), key, word,
                                 folder.empty() ? "in the working folder" : "beside " + document));
}

}  // namespace soilweave
