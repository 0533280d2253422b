// Words to numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_word.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace soilweave {
namespace {

constexpr std::array<std::string_view, 8> blanks{" ", "\t", "\r", "\n", "\u00a0", "\u2007", "\u202f", "\u2009"};

constexpr std::string_view digits = "0123456789";

std::string with(std::string_view text, std::string_view old, std::string_view put) {
  std::string changed(text);
  for (std::size_t at = changed.find(old); at != std::string::npos; at = changed.find(old, at + put.size()))
    changed.replace(at, old.size(), put);
  return changed;
}

bool is_number(std::string_view word) { return !word.empty() && number_of(word).has_value(); }

/// Returns the word with a point for its only comma, or nothing.
std::string with_point(std::string_view word) {
  const std::string_view mantissa = word.substr(0, word.find_first_of("eE"));
  const std::size_t comma = mantissa.find(',');
  const bool digit_behind = comma + 1 < mantissa.size() && digits.find(mantissa[comma + 1]) != digits.npos;
  return std::count(mantissa.begin(), mantissa.end(), ',') == 1 && digit_behind ? with(word, ",", ".") : "";
}

bool is_digit(char c) { return digits.find(c) != digits.npos; }

/// Returns whether digits stand in groups of three behind the mark, as in 1 000 000 or 100,000, and no zero leads.
bool is_grouped(std::string_view word, char mark) {
  if (word.starts_with('-') || word.starts_with('+')) word.remove_prefix(1);
  word = word.substr(0, word.find('.'));
  constexpr std::size_t group = 3;
  std::size_t at = word.find(mark);
  if (at == word.npos || at == 0 || at > group || word.front() == '0') return false;
  for (std::size_t k = 0; k < word.size(); ++k)
    if (k < at || (k - at) % (group + 1) != 0 ? !is_digit(word[k]) : word[k] != mark) return false;
  return (word.size() - at) % (group + 1) == 0;
}

/// Returns the word without its blanks, or nothing where a blank separates two numbers.
std::string without_blanks(std::string_view word) {
  const std::string plain = plain_spaces(word);
  for (std::size_t k = 1; k + 1 < plain.size(); ++k)
    if (plain[k] == ' ' && is_digit(plain[k - 1]) && is_digit(plain[k + 1]) && !is_grouped(plain, ' ')) return "";
  std::string joint = with(plain, " ", "");
  return joint != word ? joint : "";
}

}  // namespace

std::string_view trimmed(std::string_view text) {
  for (bool again = true; again;) {
    again = false;
    for (const std::string_view blank : blanks) {
      for (; text.starts_with(blank); again = true) text.remove_prefix(blank.size());
      for (; text.ends_with(blank); again = true) text.remove_suffix(blank.size());
    }
  }
  return text;
}

std::string plain_spaces(std::string_view text) {
  std::string plain(text);
  for (const std::string_view blank : blanks)
    if (blank.size() > 1) plain = with(plain, blank, " ");
  return plain;
}

std::optional<double> number_of(std::string_view word) {
  const bool plus = word.starts_with('+');
  if (plus) word.remove_prefix(1);
  if (plus && word.starts_with('-')) return std::nullopt;
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::string number_remedy(std::string_view word) {
  const std::string minus = with(word, "\u2212", "-");
  if (minus != word && is_number(minus)) return fmt::format("write {}, with the minus sign of the keyboard", minus);
  if (const std::string point = with_point(word); is_number(point))
    return is_grouped(word, ',') ? fmt::format("write {} if the comma separates thousands, {} if it is a decimal comma",
                                               with(word, ",", ""), point)
                                 : fmt::format("write {}, with a decimal point", point);
  if (word.find_first_not_of("0123456789.,+-eE") == word.npos && !word.ends_with(',') && word.find(',') != word.npos &&
      word.find_first_of(digits) != word.npos)
    return "write its digits without commas, with one decimal point";
  if (const std::string joint = without_blanks(word); is_number(joint))
    return fmt::format("write {}, without blanks", joint);
  if (const std::size_t at = word.find_first_of("dDqQ"); at != word.npos && at > 0) {
    const std::string exponent = fmt::format("{}e{}", word.substr(0, at), word.substr(at + 1));
    if (is_number(exponent)) return fmt::format("write {}", exponent);
  }
  double ignored = 0;
  const std::string_view unsigned_word = word.substr(word.starts_with('+') ? 1 : 0);
  if (std::from_chars(unsigned_word.data(), unsigned_word.data() + unsigned_word.size(), ignored).ec ==
      std::errc::result_out_of_range)
    return "it is beyond the range of double precision, 1e-308 to 1.8e308";
  if (word.ends_with('%') && is_number(trimmed(word.substr(0, word.size() - 1))))
    return "write the number, and [%] behind the name of its column";
  return "";
}

std::string no_number(std::string_view word, std::string_view what) {
  const std::string remedy = number_remedy(word);
  return fmt::format("\"{}\" is no {}{}{}", word, what, remedy.empty() ? "" : ": ", remedy);
}

std::vector<std::string> parts_of_list(std::string_view list) {
  std::vector<std::string> parts;
  for (std::size_t at = 0; at <= list.size();) {
    const std::size_t end = std::min(list.find(',', at), list.size());
    parts.emplace_back(trimmed(list.substr(at, end - at)));
    at = end + 1;
  }
  return parts;
}

std::vector<double> numbers_of_list(std::string_view list) {
  std::vector<double> numbers;
  for (const std::string& part : parts_of_list(list)) {
    const std::optional<double> number = number_of(part);
    if (!number || !std::isfinite(*number)) return {};
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace soilweave
