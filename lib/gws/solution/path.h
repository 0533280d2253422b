// The soil's path from its first mean stress upwards. It depends on the soil and on Young's modulus alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "gws/solution/model.h"

namespace soilweave::gws {

/// A path that grows step by step and answers for any p within it. Each step and each answer is one step in ln p of
/// Dormand and Prince's fifth-order method. So errors between nodes do not exceed errors at nodes.
class Path {
 public:
  /// E: Young's modulus, Pa. tolerance: relative error of the strains at the end; the error of each step is at most a
  /// hundredth of the tolerance.
  Path(const Soil& soil, double E, double tolerance);

  /// Takes one step. Returns false once the path has ended, within `resolution` of its end.
  bool advance();
  /// Returns why the path has ended; none: not yet.
  End end() const { return end_; }
  /// Returns the number of steps so far.
  std::size_t steps() const { return nodes_.size() - 1; }

  /// Return the ends of the path so far, as ln p like all arguments.
  double first() const { return nodes_.front().x; }
  double last() const { return nodes_.back().x; }
  /// Returns the state at ln p = x, between first() and last().
  SoilState at(double x) const;

  /// Relative error in p of the path's end.
  static constexpr double resolution = 1e-9;

 private:
  /// State at the end of one step.
  struct Node {
    /// Mean stress as ln p.
    double x;
    /// Plastic strain there.
    Plastic plastic;
  };
  /// Returns the plastic strain after one step to x.
  Plastic stepped(const Node& from, double x) const;

  Soil soil_;
  double E_, tolerance_, step_ = 0.05;
  End end_ = End::none;
  std::vector<Node> nodes_;
};

/// Returns the states at axial strains, percent, in the order of passing (below zero: the first state). tolerance:
/// relative error. Fewer states than strains mean that the path ends earlier.
std::vector<SoilState> states_at(const Soil& soil, double E, const std::vector<double>& strains, double tolerance);

}  // namespace soilweave::gws
