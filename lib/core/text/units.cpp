// Units as products of powers of kilogram, metre, second and radian.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/text/number_word.h"
#include "core/text/text.h"

namespace soilweave {
namespace {

struct Unit {
  double factor = 1;
  std::array<int, 4> powers{};  // kg, m, s, rad
};

struct NamedUnit {
  std::string_view symbol;
  Unit unit;
  bool prefixed;  // takes k, M, m, …
};

constexpr std::array units{
    NamedUnit{"1", {1, {}}, false},
    NamedUnit{"-", {1, {}}, false},
    NamedUnit{"%", {0.01, {}}, false},
    NamedUnit{"\u2030", {0.001, {}}, false},
    NamedUnit{"m", {1, {0, 1, 0, 0}}, true},
    NamedUnit{"g", {1e-3, {1, 0, 0, 0}}, true},
    NamedUnit{"t", {1e3, {1, 0, 0, 0}}, false},
    NamedUnit{"s", {1, {0, 0, 1, 0}}, true},
    NamedUnit{"min", {60, {0, 0, 1, 0}}, false},
    NamedUnit{"h", {3600, {0, 0, 1, 0}}, false},
    NamedUnit{"N", {1, {1, 1, -2, 0}}, true},
    NamedUnit{"Pa", {1, {1, -1, -2, 0}}, true},
    NamedUnit{"bar", {1e5, {1, -1, -2, 0}}, false},
    NamedUnit{"J", {1, {1, 2, -2, 0}}, true},
    NamedUnit{"W", {1, {1, 2, -3, 0}}, true},
    NamedUnit{"Hz", {1, {0, 0, -1, 0}}, true},
    NamedUnit{"rad", {1, {0, 0, 0, 1}}, true},
    NamedUnit{"deg", {degree, {0, 0, 0, 1}}, false},
    NamedUnit{"\u00b0", {degree, {0, 0, 0, 1}}, false},
};

struct Prefix {
  std::string_view symbol;
  double factor;
};

constexpr std::array prefixes{Prefix{"n", 1e-9}, Prefix{"u", 1e-6}, Prefix{"\u00b5", 1e-6}, Prefix{"\u03bc", 1e-6},
                              Prefix{"m", 1e-3}, Prefix{"c", 1e-2}, Prefix{"d", 1e-1},      Prefix{"k", 1e3},
                              Prefix{"M", 1e6},  Prefix{"G", 1e9}};

/// Units that messages offer. Of units that differ only in case, the commonest comes first.
constexpr std::array common{"m",  "mm", "um", "cm", "km", "N",   "kN", "MN",  "Pa",  "kPa", "MPa", "GPa", "bar",
                            "kg", "g",  "t",  "s",  "ms", "min", "h",  "rad", "deg", "J",   "Hz",  "%",   "1"};

struct Spelling {
  std::string_view written, symbol;
};

/// Words for units, in lower case and without a plural s.
constexpr std::array spellings{
    Spelling{"metre", "m"},        Spelling{"meter", "m"},       Spelling{"millimetre", "mm"},
    Spelling{"millimeter", "mm"},  Spelling{"micron", "um"},     Spelling{"micrometre", "um"},
    Spelling{"micrometer", "um"},  Spelling{"percent", "%"},     Spelling{"pct", "%"},
    Spelling{"degree", "deg"},     Spelling{"sec", "s"},         Spelling{"second", "s"},
    Spelling{"kilopascal", "kPa"}, Spelling{"pascal", "Pa"},     Spelling{"gram", "g"},
    Spelling{"kilogram", "kg"},    Spelling{"hour", "h"},        Spelling{"minute", "min"},
    Spelling{"hr", "h"},           Spelling{"ton", "t"},         Spelling{"tonne", "t"},
    Spelling{"centimetre", "cm"},  Spelling{"centimeter", "cm"}, Spelling{"kilometre", "km"},
    Spelling{"kilometer", "km"},   Spelling{"newton", "N"},      Spelling{"mu m", "um"},
    Spelling{"mum", "um"}};

/// Returns "; did you mean 'kPa'?" for a misspelt unit, or lists the units of the field.
std::string unit_suggestion(std::string_view symbol) {
  if (const std::string_view meant = unit_meant(symbol); !meant.empty())
    return fmt::format("; did you mean '{}'?", meant);
  return fmt::format("; known: {}, and products such as kg/m3", fmt::join(common, ", "));
}

std::optional<Unit> named(std::string_view symbol) {
  for (const NamedUnit& n : units)
    if (n.symbol == symbol) return n.unit;
  for (const Prefix& p : prefixes) {
    if (!symbol.starts_with(p.symbol)) continue;
    for (const NamedUnit& n : units)
      if (n.prefixed && n.symbol == symbol.substr(p.symbol.size()))
        return Unit{p.factor * n.unit.factor, n.unit.powers};
  }
  return std::nullopt;
}

/// Parses one factor: a symbol with an optional power, as in "m3", "m^3", "s-1".
Unit power_of(std::string_view text) {
  if (const auto whole = named(text)) return *whole;
  std::size_t end = text.size();
  while (end > 0 && (std::isdigit(static_cast<unsigned char>(text[end - 1])) != 0)) --end;
  std::size_t symbol_end = end;
  if (symbol_end > 0 && text[symbol_end - 1] == '-') --symbol_end;
  int power = 0;
  std::from_chars(text.data() + symbol_end, text.data() + text.size(), power);
  if (symbol_end > 0 && text[symbol_end - 1] == '^') --symbol_end;
  const auto base = end < text.size() ? named(text.substr(0, symbol_end)) : std::nullopt;
  if (!base) {
    const std::string_view symbol = end < text.size() ? text.substr(0, symbol_end) : text;
    throw DataError(fmt::format("'{}' is not a known unit{}", text, unit_suggestion(symbol)));
  }
  Unit result{std::pow(base->factor, power), {}};
  for (std::size_t i = 0; i < result.powers.size(); ++i) result.powers[i] = power * base->powers[i];
  return result;
}

/// Returns the text with digits for raised digits (m², s⁻¹), ordinary spaces, and one kind of dot.
std::string plain_powers(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 6> marks{
      {{"\u00b9", "1"}, {"\u00b2", "2"}, {"\u00b3", "3"}, {"\u2074", "4"}, {"\u207b", "-"}, {"\u22c5", "\u00b7"}}};
  std::string plain = plain_spaces(text);
  for (const auto& [mark, digit] : marks)
    for (std::size_t at = plain.find(mark); at != std::string::npos; at = plain.find(mark, at + digit.size()))
      plain.replace(at, mark.size(), digit);
  return plain;
}

/// Parses a product such as "N m/rad", "kg/m3", "N·m/rad". A slash divides by the one factor after it.
Unit parsed(std::string_view written) {
  constexpr std::string_view dot = "\u00b7";
  const std::string plain = plain_powers(written);
  const std::string_view text = plain;
  Unit result;
  bool divide = false;
  std::string factor;
  const auto take = [&] {
    if (factor.empty()) return;
    const Unit unit = power_of(factor);
    const int sign = divide ? -1 : 1;
    result.factor *= divide ? 1 / unit.factor : unit.factor;
    for (std::size_t i = 0; i < result.powers.size(); ++i) result.powers[i] += sign * unit.powers[i];
    factor.clear();
    divide = false;
  };
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text.substr(i).starts_with(dot)) {
      take();
      i += dot.size() - 1;
    } else if (text[i] == ' ' || text[i] == '*') {
      take();
    } else if (text[i] == '/') {
      take();
      divide = true;
    } else {
      factor += text[i];
    }
  }
  take();
  return result;
}

}  // namespace

double unit_factor(std::string_view from, std::string_view to) {
  if (from == to) return 1;
  const Unit given = parsed(from), wanted = parsed(to);
  if (given.powers != wanted.powers) throw DataError(fmt::format("'{}' does not measure what '{}' measures", from, to));
  return given.factor / wanted.factor;
}

std::string_view unit_meant(std::string_view word) {
  std::string small = lower_case(word);
  for (const std::string_view known : common)
    if (lower_case(known) == small) return known;
  if (small.size() > 3 && small.ends_with('s')) small.pop_back();
  for (const Spelling& spelling : spellings)
    if (spelling.written == small) return spelling.symbol;
  return "";
}

void demand_unit(std::string_view unit) { (void)parsed(unit); }

double quantity(std::string_view given, std::string_view unit) {
  const std::string plain = plain_spaces(given);
  const std::string_view whole = trimmed(plain);
  const std::string_view text = whole.substr(whole.starts_with('+') ? 1 : 0);
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  const std::string_view rest = status == std::errc() ? text.substr(static_cast<std::size_t>(end - text.data())) : "";
  // The number ends with its last digit before the first character that no number has. So the tail of a foreign
  // spelling such as 1d3 is not taken for a unit.
  const std::size_t last = text.find_last_of("0123456789");
  // A unit may begin with a digit, as in "0.5 1/s".
  const std::size_t stop =
      std::min({text.find_first_not_of("0123456789.,+-eEdDqQ \u2212"), text.find(" 1/"), text.size()});
  const std::string_view number = trimmed(text.substr(0, std::min(stop, last == text.npos ? 0 : last + 1)));
  if (status != std::errc() || rest.starts_with(',') ||
      (!number.empty() && number.size() > text.size() - rest.size())) {
    const std::string remedy = number_remedy(number);
    if (status != std::errc() || rest.starts_with(',') || !remedy.empty())
      throw DataError(fmt::format("'{}' is not a number{}{}", given, remedy.empty() ? "" : ": ", remedy));
  }
  const std::string_view symbol = trimmed(rest);
  if (symbol.empty()) return value;
  // Dividing by factors below one keeps powers of ten exact: 100 kPa is 100000 Pa to the last bit.
  const double factor = unit_factor(symbol, unit);
  const double inverse = std::round(1 / factor);
  return factor < 1 && std::abs(inverse * factor - 1) < 1e-15 ? value / inverse : value * factor;
}

}  // namespace soilweave
