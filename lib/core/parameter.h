// One described quantity: name, symbol, unit, range, sentence. Options, scenario keys, help, man pages and
// range errors are all made from it, so that nothing is described twice.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace soilweave {

struct Parameter {
  std::string_view name;  // snake_case: the scenario key; as an option it is written --with-hyphens
  std::string_view unit;  // SI, "1" for pure numbers, "deg" for angles in what users write
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool open = false;               // true: the bounds themselves are not allowed
  std::string_view sentence = "";  // what it is, in one sentence without a full stop
  std::string_view why = "";       // why the range is what it is; printed with a range error

  bool contains(double value) const { return open ? (value > low && value < high) : (value >= low && value <= high); }
};

}  // namespace soilweave
