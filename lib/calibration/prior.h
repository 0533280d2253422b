// The prior: each parameter lies anywhere in its range, on a linear or log scale.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Eigen/Core>
#include <string>
#include <string_view>
#include <vector>

#include "core/doubts.h"
#include "core/text/settings.h"

namespace soilweave::calibration {

using Vector = Eigen::VectorXd;
using Matrix = Eigen::MatrixXd;
/// Converts an index of the standard library to one of Eigen.
inline Eigen::Index index(std::size_t i) { return static_cast<Eigen::Index>(i); }

enum class Scale { linear, log };

/// Range of one parameter. Its coordinate u runs from 0 at `low` to 1 at `high`; the prior is uniform in it.
struct Range {
  std::string name, unit, long_name;
  double low = 0, high = 1;
  Scale scale = Scale::linear;

  /// Convert a coordinate to a value, and back.
  double value(double u) const;
  double coordinate(double value) const;
  /// Returns the width of the range on its scale (in decades on a log scale).
  double width() const;
};

/// Independent ranges of all parameters, in the order of an ensemble's columns.
struct Prior {
  std::vector<Range> ranges;

  /// Returns the number of parameters.
  std::size_t size() const { return ranges.size(); }
  /// Returns the names of the parameters in order.
  std::vector<std::string> names() const;
  /// Convert a row of coordinates to values, and back.
  Vector values(const Vector& coordinates) const;
  Vector coordinates(const Vector& values) const;
};

/// Reads [[parameter]] tables: name, low, high; unit ("1"), scale ("linear" or "log"), long_name. Mistakes go to the
/// document's list.
Prior read_prior(Settings& document);
/// Reads a prior's TOML whole. Throws DataError with every mistake, each naming `where`.
Prior parse_prior(std::string_view text, const std::string& where);
/// Returns "prior_unit" if a range of angles in degrees lies within half a turn in radians, or one of stresses beyond
/// every material: its numbers are those of another unit.
std::vector<Doubt> doubts(const Prior& prior);
/// Returns whether both have the same parameters with the same units, scales and ranges, in any order.
bool same_ranges(const Prior& a, const Prior& b);
/// Returns a line for people: each parameter with its range, unit and scale.
std::string ranges_text(const Prior& prior);
/// Returns every key that a prior may have (core/text/keys.h).
std::vector<Key> prior_keys();
/// Returns the prior as TOML, with SI numbers.
std::string prior_text(const Prior& prior);

}  // namespace soilweave::calibration
