// One pass over the brackets and dots of a TOML text, outside strings and comments.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/toml_depth.h"

#include <fmt/format.h>

#include <algorithm>

namespace soilweave {
namespace {

constexpr int most_parts = 32, most_levels = 32;
constexpr std::size_t most_bytes = std::size_t{16} << 20;

/// Returns the position behind the string that begins with a quote at `at`: basic or literal, of one line or several.
std::size_t behind_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string three(3, quote);
  const bool lines = text.substr(at, 3) == three;
  for (at += lines ? 3 : 1; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\')
      ++at;
    else if (lines ? text.substr(at, 3) == three : text[at] == quote || text[at] == '\n')
      return at + (lines ? 3 : 1);
  }
  return text.size();
}

std::string place(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const std::size_t start = before.rfind('\n') == before.npos ? 0 : before.rfind('\n') + 1;
  return fmt::format("{}:{}", 1 + std::count(before.begin(), before.end(), '\n'), at - start + 1);
}

}  // namespace

std::string toml_excess(std::string_view text) {
  if (text.size() > most_bytes)
    return fmt::format("1:1: a document of {} MiB; at most {} are read", text.size() >> 20, most_bytes >> 20);
  int parts = 1, levels = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    if (c == '"' || c == '\'') {
      at = behind_string(text, at);
      continue;
    }
    if (c == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (c == '.' && ++parts > most_parts)
      return fmt::format("{}: a key of more than {} parts", place(text, at), most_parts);
    if (std::string_view("=,[]{}\n").find(c) != std::string_view::npos) parts = 1;
    if (c == '[' || c == '{') ++levels;
    if (c == ']' || c == '}') levels = std::max(0, levels - 1);
    if (levels > most_levels)
      return fmt::format("{}: lists or tables more than {} within one another", place(text, at), most_levels);
    ++at;
  }
  return "";
}

}  // namespace soilweave
