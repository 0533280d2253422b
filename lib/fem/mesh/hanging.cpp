// Nodes that lie on sides of elements which do not have them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "fem/mesh/mesh.h"

namespace soilweave::fem {
namespace {

// A side that one element has alone.
struct FreeSide {
  Index element = 0;
  std::array<Index, 2> ends{};
  std::optional<Index> middle;
};

std::vector<FreeSide> free_sides(const Mesh& mesh) {
  const Index corners = corners_of(mesh.shape);
  std::map<std::array<Index, 2>, FreeSide> alone;
  for (Index e = 0; e < mesh.elements.size(); ++e)
    for (Index k = 0; k < corners; ++k) {
      const auto& nodes = mesh.elements[e];
      const std::array<Index, 2> ends = {nodes[k], nodes[(k + 1) % corners]};
      // The neighbour has the side in the other sense.
      if (alone.erase({ends[1], ends[0]}) > 0) continue;
      alone[ends] = {e, ends, corners == 4 ? std::optional(nodes[4 + k]) : std::nullopt};
    }
  std::vector<FreeSide> sides;
  for (const auto& [ends, side] : alone) sides.push_back(side);
  return sides;
}

// The curve of a side: a line, or a parabola through the middle node.
class SideCurve {
 public:
  SideCurve(const FreeSide& side, const Mesh& mesh)
      : a_(mesh.nodes[side.ends[0]]),
        b_(mesh.nodes[side.ends[1]]),
        bulge_(side.middle ? Vec2(4 * mesh.nodes[*side.middle] - 2 * (a_ + b_)) : Vec2(Vec2::Zero())) {}

  double length() const { return (b_ - a_).norm(); }
  Vec2 at(double s) const { return a_ + s * (b_ - a_) + s * (1 - s) * bulge_; }
  // Returns the place along the side, from 0 to 1, that is nearest to a point close to it.
  double nearest(const Vec2& x) const {
    double s = (x - a_).dot(b_ - a_) / (b_ - a_).squaredNorm();
    for (int k = 0; k < 5 && !bulge_.isZero(0); ++k) {
      const Vec2 along = b_ - a_ + (1 - 2 * s) * bulge_;
      s += (x - at(s)).dot(along) / along.squaredNorm();
    }
    return s;
  }

 private:
  Vec2 a_, b_, bulge_;
};

// Squares of the plane, about as wide as a side is long, with the nodes of the free sides in each.
class Squares {
 public:
  Squares(const std::vector<FreeSide>& sides, const Mesh& mesh) {
    for (const FreeSide& side : sides) width_ += SideCurve(side, mesh).length() / static_cast<double>(sides.size());
    std::set<Index> nodes;
    for (const FreeSide& side : sides) {
      nodes.insert(side.ends.begin(), side.ends.end());
      if (side.middle) nodes.insert(*side.middle);
    }
    for (const Index n : nodes) in_[square_of(mesh.nodes[n])].push_back(n);
  }
  // Returns the nodes in the squares that a side passes, and in those around them.
  std::set<Index> nodes_near(const SideCurve& side) const {
    std::set<Index> nodes;
    const double steps = std::ceil(2 * side.length() / width_);
    for (double k = 0; k <= steps; ++k) {
      const auto [i, j] = square_of(side.at(k / steps));
      for (const int right : {-1, 0, 1})
        for (const int up : {-1, 0, 1})
          if (const auto found = in_.find({i + right, j + up}); found != in_.end())
            nodes.insert(found->second.begin(), found->second.end());
    }
    return nodes;
  }

 private:
  std::array<std::int64_t, 2> square_of(const Vec2& x) const {
    return {std::llround(x.x() / width_), std::llround(x.y() / width_)};
  }
  double width_ = 0;
  std::map<std::array<std::int64_t, 2>, std::vector<Index>> in_;
};

}  // namespace

std::vector<Mesh::Hanging> Mesh::hanging() const {
  // Largest angle between a side and the line from its nearer end to a node on it: coordinates may have few digits.
  constexpr double flat = 1e-4;
  const std::vector<FreeSide> sides = free_sides(*this);
  const Squares squares(sides, *this);
  const double near = coincidence();
  std::map<Index, Hanging> found;
  for (const FreeSide& side : sides) {
    const auto& own = elements[side.element];
    const SideCurve curve(side, *this);
    for (const Index n : squares.nodes_near(curve)) {
      if (std::find(own.begin(), own.begin() + nodes_of_element(), n) != own.begin() + nodes_of_element()) continue;
      const double s = curve.nearest(nodes[n]), from_end = std::min(s, 1 - s) * curve.length();
      if (from_end > near && (curve.at(s) - nodes[n]).norm() <= flat * from_end)
        found.try_emplace(n, Hanging{n, side.element, side.ends});
    }
  }
  std::vector<Hanging> all;
  for (const auto& [node, hanging] : found) all.push_back(hanging);
  return all;
}

}  // namespace soilweave::fem
