// Units as products of powers of kilogram, metre, second and radian.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/units.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "core/error.h"

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

constexpr double degree = std::numbers::pi / 180;

constexpr std::array units{
    NamedUnit{"1", {1, {}}, false},
    NamedUnit{"-", {1, {}}, false},
    NamedUnit{"%", {0.01, {}}, false},
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

/// One factor: a symbol with an optional power, as in "m3", "m^3", "s-1".
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
  if (!base) throw DataError(fmt::format("'{}' is not a known unit", text));
  Unit result{std::pow(base->factor, power), {}};
  for (std::size_t i = 0; i < result.powers.size(); ++i) result.powers[i] = power * base->powers[i];
  return result;
}

/// A product such as "N m/rad", "kg/m3", "N·m/rad": a slash divides by the one factor after it.
Unit parsed(std::string_view text) {
  constexpr std::string_view dot = "\u00b7";
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

double quantity(std::string_view text, std::string_view unit) {
  const std::size_t first = text.find_first_not_of(" +");
  const std::string_view trimmed = first == std::string_view::npos ? "" : text.substr(first);
  double value = 0;
  const auto [end, status] = std::from_chars(trimmed.data(), trimmed.data() + trimmed.size(), value);
  if (status != std::errc()) throw DataError(fmt::format("'{}' is not a number", text));
  std::string_view rest = trimmed.substr(static_cast<std::size_t>(end - trimmed.data()));
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  if (rest.empty()) return value;
  // Powers of ten are kept exact (100 kPa is 100000 Pa to the last bit) by dividing where the factor is below one.
  const double factor = unit_factor(rest, unit);
  const double inverse = std::round(1 / factor);
  return factor < 1 && std::abs(inverse * factor - 1) < 1e-15 ? value / inverse : value * factor;
}

}  // namespace soilweave
