// The reinforced part of an assembly.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/reinforced.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

#include "analysis/tables/bag.h"
#include "core/linear_algebra.h"
#include "packing/expand/tile.h"

namespace soilweave::packing {
namespace {

// Radii of one growth differ only by rounding.
constexpr double same_growth = 1e-9;

// Returns the geotextile's normal at node i, fitted to the nodes `around` it, pointing away from the middle.
Vec3 outwards(std::size_t i, const std::vector<std::size_t>& around, const std::vector<Vec3>& x, const Vec3& middle) {
  Vec3 mean = x[i];
  for (const std::size_t j : around) mean += x[j];
  mean /= static_cast<double>(around.size() + 1);
  Mat3 spread = (x[i] - mean) * (x[i] - mean).transpose();
  for (const std::size_t j : around) spread += (x[j] - mean) * (x[j] - mean).transpose();
  const Vec3 normal = eigensystem(spread).vectors.col(0);
  return normal.dot(x[i] - middle) < 0 ? Vec3(-normal) : normal;
}

std::size_t root(std::vector<std::size_t>& parent, std::size_t i) {
  while (parent[i] != i) i = parent[i] = parent[parent[i]];
  return i;
}

}  // namespace

bool is_cut_from(const io::Snapshot& reinforced, const io::Snapshot& block) {
  const std::vector<bool> node = io::nodes(reinforced);
  double growth = 0;
  for (std::size_t i = 0; i < node.size(); ++i) {
    if (node[i]) continue;
    const std::int64_t id = reinforced.grains.body_id[i];
    if (id < 0 || static_cast<std::size_t>(id) >= block.grains.size()) return false;
    const auto k = static_cast<std::size_t>(id);
    if (reinforced.grains.copy_id[i] != block.grains.copy_id[k]) return false;
    const double grown = reinforced.grains.radius[i] / block.grains.radius[k];
    if (growth == 0) growth = grown;
    if (std::abs(grown / growth - 1) > same_growth) return false;
  }
  return growth > 0;
}

Origin origin(const io::Snapshot& reinforced, const io::Snapshot& block) {
  const std::vector<bool> node = io::nodes(reinforced);
  Origin from;
  from.taken.assign(block.grains.size(), false);
  from.cut = is_cut_from(reinforced, block);
  if (from.cut) {
    for (std::size_t i = 0; i < node.size(); ++i)
      if (!node[i]) from.taken[static_cast<std::size_t>(reinforced.grains.body_id[i])] = true;
    return from;
  }
  const Inside inside(reinforced);
  for (std::size_t k = 0; k < from.taken.size(); ++k) from.taken[k] = inside(block.grains.position[k]);
  return from;
}

io::Snapshot between_faces(const io::Snapshot& bag, const std::vector<bool>& keep) {
  const std::size_t n = bag.grains.size();
  const std::vector<bool> node = io::nodes(bag);
  std::vector<std::size_t> parent(n);
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  std::vector<bool> on_face(n, false);
  for (std::size_t y = 0; y < bag.yarns.size(); ++y) {
    if (bag.yarns.family[y] != 0) continue;
    const auto a = static_cast<std::size_t>(bag.yarns.nodes[y][0]), b = static_cast<std::size_t>(bag.yarns.nodes[y][1]);
    on_face[a] = on_face[b] = true;
    parent[std::max(root(parent, a), root(parent, b))] = std::min(root(parent, a), root(parent, b));
  }
  const auto kept = [&](std::size_t i) { return node[i] ? on_face[i] : static_cast<bool>(keep[i]); };
  io::Snapshot state = filter(bag, kept);
  std::vector<std::int32_t> place(n, -1), fabric(n, -1);
  std::int32_t next = 0, fabrics = 0;
  for (std::size_t i = 0; i < n; ++i)
    if (kept(i)) place[i] = next++;
  io::YarnsRecord& to = state.yarns;
  const io::YarnsRecord& from = bag.yarns;
  for (std::size_t y = 0; y < from.size(); ++y) {
    if (from.family[y] != 0) continue;
    std::int32_t& number = fabric[root(parent, static_cast<std::size_t>(from.nodes[y][0]))];
    if (number < 0) number = fabrics++;
    to.nodes.push_back(
        {place[static_cast<std::size_t>(from.nodes[y][0])], place[static_cast<std::size_t>(from.nodes[y][1])]});
    to.fabric.push_back(number), to.geotextile_id.push_back(from.geotextile_id[y]), to.family.push_back(0);
    to.rest_length.push_back(from.rest_length[y]), to.largest_strain.push_back(from.largest_strain[y]);
    to.tension.push_back(from.tension[y]), to.broken.push_back(from.broken[y]);
    to.break_time.push_back(from.break_time[y]), to.break_position.push_back(from.break_position[y]);
  }
  return state;
}

Vec3 extent(const io::Snapshot& state) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const Vec3 r = Vec3::Constant(state.grains.radius[i]);
    low = low.cwiseMin(state.grains.position[i] - r), high = high.cwiseMax(state.grains.position[i] + r);
  }
  return high - low;
}

Inside::Inside(const io::Snapshot& reinforced) {
  const std::vector<bool> node = io::nodes(reinforced);
  const io::YarnsRecord& yarns = reinforced.yarns;
  const std::vector<Vec3>& x = reinforced.grains.position;
  for (std::size_t i = 0; i < node.size(); ++i) {
    if (node[i]) continue;
    low_ = any_soil_ ? Vec3(low_.cwiseMin(x[i])) : x[i], high_ = any_soil_ ? Vec3(high_.cwiseMax(x[i])) : x[i];
    any_soil_ = true;
  }
  // Sides (families other than 0) distinguish a closed geotextile from a sheet.
  std::map<std::int32_t, std::pair<Vec3, double>> middles;
  for (std::size_t y = 0; y < yarns.size(); ++y)
    if (yarns.family[y] != 0) middles[yarns.fabric[y]] = {Vec3::Zero(), 0};
  std::vector<std::int32_t> fabric(node.size(), -1);
  std::vector<std::vector<std::size_t>> around(node.size());
  for (std::size_t y = 0; y < yarns.size(); ++y) {
    if (!middles.contains(yarns.fabric[y])) continue;
    const auto a = static_cast<std::size_t>(yarns.nodes[y][0]), b = static_cast<std::size_t>(yarns.nodes[y][1]);
    around[a].push_back(b), around[b].push_back(a);
    fabric[a] = fabric[b] = yarns.fabric[y];
  }
  for (std::size_t i = 0; i < node.size(); ++i)
    if (fabric[i] >= 0) middles[fabric[i]].first += x[i], middles[fabric[i]].second += 1;
  for (std::size_t i = 0; i < node.size(); ++i) {
    if (fabric[i] < 0) continue;
    const auto& [sum, number] = middles[fabric[i]];
    nodes_.push_back({x[i], outwards(i, around[i], x, sum / number)});
  }
}

bool Inside::operator()(const Vec3& at) const {
  if (nodes_.empty()) return any_soil_ && (at.array() >= low_.array()).all() && (at.array() <= high_.array()).all();
  double nearest = std::numeric_limits<double>::infinity();
  bool inside = false;
  for (const Node& n : nodes_) {
    const double d = (at - n.position).squaredNorm();
    if (d < nearest) nearest = d, inside = (at - n.position).dot(n.outwards) < 0;
  }
  return inside;
}

}  // namespace soilweave::packing
