// The soil's path from its first mean stress upwards: adaptive Runge-Kutta steps in ln p with a controlled error. The
// path depends on the soil and on E alone. Surcharge, lateral stress and bag enter only the balance of forces at each
// state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "gws/solution/model.h"

namespace soilweave::gws {

/// A path that grows step by step and can be asked for any p within it. Every step and every answer is one step of the
/// fifth-order method of Dormand and Prince, so the error between nodes is no greater than at them.
class Path {
 public:
  /// E: Young's modulus, Pa. tolerance: relative error of the strains at the end of the path. Each step is held to a
  /// hundredth of it.
  Path(const Soil& soil, double E, double tolerance);

  /// Takes one more step. Returns false if the path has ended: end() then tells why, and the last node lies within
  /// `resolution` of the end.
  bool advance();
  /// Return why the path has ended (none: not yet), and the number of steps so far.
  End end() const { return end_; }
  std::size_t steps() const { return nodes_.size() - 1; }

  double first() const { return nodes_.front().x; }  // ln p, like all arguments below
  double last() const { return nodes_.back().x; }
  /// Returns the state at ln p = x, between first() and last().
  SoilState at(double x) const;

  /// Relative width in p within which the end of a path is found.
  static constexpr double resolution = 1e-9;

 private:
  /// State at the end of one step.
  struct Node {
    double x;
    Plastic plastic;
  };
  Plastic stepped(const Node& from, double x) const;

  Soil soil_;
  double E_, tolerance_, step_ = 0.05;
  End end_ = End::none;
  std::vector<Node> nodes_;
};

/// Returns the states of a path at axial strains, percent, that the bag passes one after another (below zero: the first
/// state). Steps are controlled to `tolerance`. Fewer states than strains: the path ends before the next one.
std::vector<SoilState> states_at(const Soil& soil, double E, const std::vector<double>& strains, double tolerance);

}  // namespace soilweave::gws
