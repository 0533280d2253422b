// Words of comments that name columns, units and cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/spheres_comments.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "core/error.h"
#include "core/text/number_word.h"
#include "core/text/text.h"
#include "core/text/units.h"
#include "files/exchange/table.h"

namespace soilweave::io {
namespace {

using Words = std::vector<std::string>;
using Names = std::span<const std::string_view>;

// Words, in lower case, that may surround the unit of all lengths in a comment.
constexpr std::array<std::string_view, 21> unit_words{
    "in",    "unit",   "units",    "all",       "length",      "lengths",   "dimensions",
    "of",    "are",    "is",       "the",       "coordinates", "positions", "and",
    "radii", "radius", "diameter", "diameters", "sizes",       "values",    "position"};
// Words before a unit. In prose the second one may mean something else.
constexpr std::array<std::string_view, 2> unit_leads{"units", "unit"};
// Units of length that are never converted.
constexpr std::array<std::string_view, 6> foreign_lengths{"inch", "inches", "foot", "feet", "ft", "mil"};
constexpr std::array<std::string_view, 9> position_words{"position", "positions", "coordinate", "coordinates", "centre",
                                                         "center",   "centres",   "centers",    "xyz"};
constexpr std::array<std::string_view, 4> diameter_words{"diameter", "diameters", "diam", "dia"};
constexpr std::array<std::string_view, 6> cell_words{"periodic", "cell", "box", "boxsize", "cellsize", "domain"};
// Words that may stand beside these.
constexpr std::array<std::string_view, 7> cell_fillers{"length", "lengths", "size", "sizes", "dimensions", "of", "is"};

bool is_among(Names words, std::string_view word) {
  return std::find(words.begin(), words.end(), lower_case(word)) != words.end();
}
bool has_one_of(Names words, const Words& all) {
  return std::any_of(all.begin(), all.end(), [&](const std::string& word) { return is_among(words, word); });
}

/// Returns a comment without its marks #.
std::string_view content_of(std::string_view comment) {
  return trimmed(comment.substr(std::min(comment.find_first_not_of('#'), comment.size())));
}

/// Returns the words of a comment, without the marks between them.
Words words_of(std::string_view line) {
  constexpr std::string_view marks = " \t,;=()[]";
  Words words;
  for (std::size_t at = 0; at < line.size();) {
    const std::size_t end = std::min(line.find_first_of(marks, at), line.size());
    std::string_view word = line.substr(at, end - at);
    while (word.ends_with(':') || word.ends_with('.')) word.remove_suffix(1);
    if (!word.empty()) words.emplace_back(word);
    at = end + 1;
  }
  return words;
}

/// Returns a comment without its label, such as "Columns: ". A label that names a column stays.
std::string_view without_label(std::string_view line) {
  const std::size_t colon = line.find(": ");
  if (colon == line.npos) return line;
  const Words label = words_of(line.substr(0, colon));
  const bool has_name = std::any_of(label.begin(), label.end(),
                                    [](const std::string& word) { return column_role(word) != SphereRole::other; });
  return has_name ? line : trimmed(line.substr(colon + 1));
}

/// Returns whether a word is a unit of length, perhaps misspelt.
bool is_like_length(const std::string& word) {
  return is_length(word) || is_among(foreign_lengths, word) || is_length(unit_meant(word));
}

/// Returns the unit of length in a comment; empty if there is none. A unit behind a number belongs to this number.
std::string unit_in(const Words& words) {
  for (std::size_t k = 0; k < words.size(); ++k)
    if ((k == 0 || !number_of(words[k - 1])) && is_like_length(words[k])) return words[k];
  // "units: cgs" states a unit that is none of length.
  for (std::size_t k = 0; k < words.size(); ++k) {
    if (!is_among(unit_leads, words[k])) continue;
    while (++k < words.size() && is_among(unit_words, words[k]))
      ;
    return k == words.size() ? "" : words[k];
  }
  return "";
}

std::string why_unknown(const std::string& unit) {
  try {
    unit_factor(unit, "m");
    return "";
  } catch (const DataError& error) {
    return error.what();
  }
}

}  // namespace

bool is_like_a_cell(std::string_view comment) {
  const std::string_view content = content_of(comment);
  if (lower_case(content).starts_with("periodic:")) return true;
  const Words all = words_of(content);
  const auto number = [](const std::string& word) { return number_of(word).has_value(); };
  const auto numbers = std::find_if(all.begin(), all.end(), number);
  const Words names(all.begin(), numbers);
  const auto lengths = all.end() - numbers;
  return (lengths == 2 || lengths == 3 || lengths == 6) && std::all_of(numbers, all.end(), number) &&
         has_one_of(cell_words, names) && std::all_of(names.begin(), names.end(), [](const std::string& word) {
           return is_among(cell_words, word) || is_among(cell_fillers, word);
         });
}

SpheresComments::Comment SpheresComments::read(std::size_t line, std::string_view text) {
  Comment comment;
  comment.line = line;
  const std::string_view content = content_of(text);
  const Words all = words_of(content);
  const auto named = [&](auto... roles) {
    return std::count_if(all.begin(), all.end(), [&](const std::string& word) {
      const SphereRole role = column_role(word);
      return ((role == roles) || ...);
    });
  };
  using enum SphereRole;
  const std::string_view list = without_label(content);
  if (named(x) && named(y) && named(radius, diameter)) {
    try {
      comment.columns = named_columns(header_names(list, separator_of(list)));
    } catch (const DataError& error) {
      comment.unclear = error.what();
      const auto unit = std::find_if(all.begin(), all.end(), [](const std::string& word) { return is_length(word); });
      if (unit != all.end()) comment.unit = *unit, comment.unit_is_vague = true;
    }
    return comment;
  }
  if (named(x, y, z, radius, diameter) > 1) comment.seems_to_name = header_names(list, separator_of(list)).size();
  comment.of_diameters = has_one_of(position_words, all) && has_one_of(diameter_words, all);
  const std::string unit = unit_in(all);
  if (unit.empty()) return comment;
  // Lengths in "metres" need no conversion, so that this spelling does no harm.
  comment.unit = lower_case(unit) == "si" || unit_meant(unit) == "m" ? "m" : unit;
  comment.unknown_unit = why_unknown(comment.unit);
  comment.unit_is_vague = std::any_of(
      all.begin(), all.end(), [&](const std::string& word) { return word != unit && !is_among(unit_words, word); });
  // Prose such as "packing of a unit test" states no unit.
  if (comment.unit_is_vague && !is_like_length(unit) && !has_one_of(Names(unit_leads).first(1), all))
    comment.unit.clear();
  return comment;
}

void SpheresComments::fail(const Comment& comment, const std::string& what) const {
  throw DataError(
      fmt::format("{}: line {}: {}; write a line of names without #, one for each column, such as "
                  "x [mm] y [mm] z [mm] r [mm], or leave the comment out",
                  where_, comment.line, what));
}

void SpheresComments::add(std::size_t line, std::string_view text, bool cell_is_given) {
  if (!cell_is_given && is_like_a_cell(text))
    throw DataError(
        fmt::format("{}: line {}: write ##PERIODIC:: Lx Ly Lz (disks: Lx Ly), as it stands here, for a "
                    "periodic cell; leave the comment out if there is none",
                    where_, line));
  comments_.push_back(read(line, text));
}

void SpheresComments::below(std::size_t line, std::string_view text, const SphereColumns& columns) const {
  const Comment comment = read(line, text);
  if (comment.names_columns() || content_of(text).starts_with("format") || is_like_a_cell(text))
    throw DataError(
        fmt::format("{}: line {}: a comment below the first grain names columns or a cell: are there two "
                    "packings in the file? keep one of them, with its comments above it",
                    where_, line));
  SphereColumns same = columns;
  same.has_unit = true;
  heed_unit(comment, same);
}

std::optional<SphereColumns> SpheresComments::columns(std::size_t width, std::optional<int> dimension) const {
  const Comment* unfit = nullptr;
  for (auto comment = comments_.rbegin(); comment != comments_.rend(); ++comment) {
    if (!comment->names_columns()) continue;
    const std::optional<SphereColumns>& named = comment->columns;
    if (named && named->width == width && (named->z || dimension != 3)) return named;
    if (!unfit) unfit = &*comment;
  }
  if (unfit && !unfit->columns) fail(*unfit, "columns in a comment that is not understood: " + unfit->unclear);
  if (unfit && unfit->columns->width == width) fail(*unfit, "a comment that names no column z, which spheres need");
  if (unfit) fail(*unfit, fmt::format("the comment names {} columns, and lines have {}", unfit->columns->width, width));
  for (const Comment& comment : comments_) {
    if (comment.seems_to_name == width) fail(comment, "the comment seems to name the columns, and is not understood");
    if (comment.of_diameters)
      fail(comment, "the comment speaks of diameters, and columns without names end with the radius");
  }
  return std::nullopt;
}

void SpheresComments::heed_unit(const Comment& comment, SphereColumns& columns) const {
  if (comment.unit.empty() || (comment.unit_is_vague && columns.has_unit)) return;
  if (!comment.unknown_unit.empty()) fail(comment, "the comment gives a unit of length: " + comment.unknown_unit);
  const double factor = unit_factor(comment.unit, "m");
  if (comment.unit_is_vague && factor == 1) return;
  if (comment.unit_is_vague) fail(comment, fmt::format("whether lengths are in {} is not clear here", comment.unit));
  if (columns.has_unit && factor != columns.length_factor)
    fail(comment, fmt::format("the comment gives lengths in {}, the columns another unit", comment.unit));
  columns.length_factor = factor, columns.has_unit = true;
}

void SpheresComments::heed(SphereColumns& columns) const {
  for (const Comment& comment : comments_) {
    const std::optional<SphereColumns>& named = comment.columns;
    if (named && (named->size_factor != columns.size_factor ||
                  (named->has_unit && named->length_factor != columns.length_factor)))
      fail(comment, "the comment names other columns or units than the line of names");
    heed_unit(comment, columns);
  }
}

}  // namespace soilweave::io
