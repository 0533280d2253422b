// Description of one quantity, for options, scenario keys, help, man pages and errors.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace soilweave {

/// One described quantity. Bounds are in its unit and inclusive, unless `open`.
struct Parameter {
  /// Key in a scenario, in snake_case; an option has --with-hyphens.
  std::string_view name;
  /// SI unit; "1" for pure numbers, "deg" for angles that users write.
  std::string_view unit;
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  /// Whether the bounds themselves are excluded.
  bool open = false;
  /// Meaning, as one sentence without a full stop.
  std::string_view sentence = "";
  /// Reason for the range, printed with a range error.
  std::string_view why = "";

  /// Returns whether a value lies in the range. A NaN does not.
  bool contains(double value) const { return open ? (value > low && value < high) : (value >= low && value <= high); }
};

}  // namespace soilweave
