// The soil's path from its first mean stress upwards: adaptive Runge-Kutta steps in ln p with a controlled error. It
// depends on the soil and on E alone; surcharge, lateral stress and bag enter only the balance of forces at each of its
// states. SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "gws/model.h"

namespace soilweave::gws {

/// The path grows step by step; any p within it can be asked for. Each step and each answer is one step of the
/// fifth-order method of Dormand and Prince, so that the error between nodes is no greater than at them.
class Path {
 public:
  /// E: Young's modulus, Pa. tolerance: relative error of the strains at the end of the path; a step is held to a
  /// hundredth.
  Path(const Soil& soil, double E, double tolerance);

  /// One more step. False where the path has ended; end() then says why, and the last node lies within `resolution` of
  /// there.
  bool advance();
  End end() const { return end_; }
  std::size_t steps() const { return nodes_.size() - 1; }

  double first() const { return nodes_.front().x; }  // ln p, as all arguments below
  double last() const { return nodes_.back().x; }
  double before_last() const { return nodes_.size() > 1 ? nodes_[nodes_.size() - 2].x : first(); }
  /// The state at ln p = x, between first() and last().
  SoilState at(double x) const;

  /// Relative width of p within which a path's end is found.
  static constexpr double resolution = 1e-9;

 private:
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

}  // namespace soilweave::gws
