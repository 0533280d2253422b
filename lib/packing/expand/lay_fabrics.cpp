// The geotextiles of a plan, laid one after another.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/lay_fabrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/error.h"
#include "packing/container/geotextile.h"

namespace soilweave::packing {
namespace {

// The nodes of one fabric: grains first to end - 1.
struct FabricNodes {
  std::string key;  // table of the plan, as "sheet.1"
  bool flat = false;
  std::size_t first = 0, end = 0;
};

// Cubes of space as wide as the largest node, with the nodes of one fabric in each.
class NodeCubes {
 public:
  NodeCubes(const io::GrainsRecord& grains, const FabricNodes& fabric, double width) : width_(width) {
    for (std::size_t i = fabric.first; i < fabric.end; ++i) in_[cube_of(grains.position[i])].push_back(i);
  }
  template <class Visit>
  void visit_near(const Vec3& x, const Visit& visit) const {
    const auto [a, b, c] = cube_of(x);
    for (const int i : {-1, 0, 1})
      for (const int j : {-1, 0, 1})
        for (const int k : {-1, 0, 1})
          if (const auto found = in_.find({a + i, b + j, c + k}); found != in_.end())
            for (const std::size_t n : found->second) visit(n);
  }

 private:
  std::array<std::int64_t, 3> cube_of(const Vec3& x) const {
    return {std::llround(x.x() / width_), std::llround(x.y() / width_), std::llround(x.z() / width_)};
  }
  double width_;
  std::map<std::array<std::int64_t, 3>, std::vector<std::size_t>> in_;
};

struct DeepestNode {
  std::size_t node = 0;
  double relative = 0, clear = 0;  // overlap over the smaller radius; distance at which nodes touch, m
};

// Returns the node of `inner` that lies deepest in one of `outer`.
DeepestNode deepest_node(const io::GrainsRecord& grains, const FabricNodes& outer, const FabricNodes& inner) {
  const double big = std::max(grains.radius[outer.first], grains.radius[inner.first]);
  const double small = std::min(grains.radius[outer.first], grains.radius[inner.first]);
  DeepestNode deepest{inner.first, 0, big + small};
  const NodeCubes cubes(grains, outer, 2 * big);
  for (std::size_t i = inner.first; i < inner.end; ++i)
    cubes.visit_near(grains.position[i], [&](std::size_t k) {
      const double relative = (deepest.clear - (grains.position[i] - grains.position[k]).norm()) / small;
      if (relative > deepest.relative) deepest.node = i, deepest.relative = relative;
    });
  return deepest;
}

bool boxes_meet(const io::GrainsRecord& grains, const FabricNodes& a, const FabricNodes& b) {
  const double reach = grains.radius[a.first] + grains.radius[b.first];
  std::array<Vec3, 2> low, high;
  for (const auto& [fabric, k] : {std::pair(&a, 0U), std::pair(&b, 1U)}) {
    low.at(k) = high.at(k) = grains.position[fabric->first];
    for (std::size_t i = fabric->first; i < fabric->end; ++i)
      low.at(k) = low.at(k).cwiseMin(grains.position[i]), high.at(k) = high.at(k).cwiseMax(grains.position[i]);
  }
  return ((low[1] - high[0]).array() < reach).all() && ((low[0] - high[1]).array() < reach).all();
}

// Throws DataError with the keys of two fabrics whose nodes overlap by more than `overlap` of the smaller radius. Nodes
// of one fabric are not compared.
void demand_apart(const io::GrainsRecord& grains, const std::vector<FabricNodes>& fabrics, double overlap) {
  for (std::size_t b = 1; b < fabrics.size(); ++b)
    for (std::size_t a = 0; a < b; ++a) {
      const FabricNodes &one = fabrics[a], &other = fabrics[b];
      if (!boxes_meet(grains, one, other)) continue;
      const DeepestNode deepest = deepest_node(grains, one, other);
      if (deepest.relative <= overlap) continue;
      const Vec3& x = grains.position[deepest.node];
      const std::string remedy =
          one.flat && other.flat
              ? fmt::format("give {}.height and {}.height that are {:.4g} m apart", one.key, other.key, deepest.clear)
              : fmt::format("change {0}.height or {0}.cells so that its nodes are {1:.4g} m from those of {2}",
                            other.key, deepest.clear, one.key);
      throw DataError(
          fmt::format("{}: a node at ({:.4g}, {:.4g}, {:.4g}) m lies in one of {} by {:.3g} % of its radius, "
                      "and a run begins with {:.3g} % at most (guards.overlap); {}",
                      other.key, x.x(), x.y(), x.z(), one.key, 100 * deepest.relative, 100 * overlap, remedy));
    }
}

}  // namespace

void lay_fabrics(const Plan& plan, const std::function<void(double)>& laid, io::Snapshot& state) {
  std::vector<FabricNodes> fabrics;
  const auto lay = [&](const std::string& key, bool flat, const Fabric& fabric, const NodeRecipe& nodes) {
    const std::size_t first = state.grains.size();
    add(fabric, nodes, state);
    fabrics.push_back({key, flat, first, state.grains.size()});
  };
  if (plan.wrapping)
    lay("geotextile_mesh", false,
        wrap(*plan.container, *plan.wrapping, plan.outside, plan.even, plan.numerics.threads, laid), plan.nodes);
  for (std::size_t k = 0; k < plan.sheets.size(); ++k) {
    const Plan::Sheet& s = plan.sheets[k];
    lay(fmt::format("sheet.{}", k), true, sheet(s.cells, s.spacing, s.height), s.nodes);
  }
  demand_apart(state.grains, fabrics, plan.numerics.limits.overlap);
}

}  // namespace soilweave::packing
