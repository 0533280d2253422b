// Woven geotextiles as meshes of nodes and yarns.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/geotextile.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/in_parallel.h"
#include "dem/state/bodies.h"

namespace soilweave::packing {

NodeRecipe NodeRecipe::read(Settings& table) {
  static constexpr Parameter radius{"node_radius", "m", 0, 1e3, true, "radius of the nodes"};
  static constexpr Parameter density{"node_density", "kg/m3", 0, 1e12, true, "density of the nodes, scaling included"};
  static constexpr Parameter material{"material", "1", 0, 1e3, false, "material_id of the nodes"};
  static constexpr Parameter geotextile{
      "geotextile_id", "1", 0, 1e3, false, "number of the [[geotextile]] in a scenario"};
  NodeRecipe r;
  r.radius = table.number(radius, r.radius);
  r.density = table.number(density, r.density);
  r.material = static_cast<std::int32_t>(table.integer(material, r.material));
  r.geotextile = static_cast<std::int32_t>(table.integer(geotextile, r.geotextile));
  return r;
}

namespace {

// Nodes of a mesh on a box, with the nodes before and after along each axis; -1 for none.
using Neighbours = std::vector<std::array<std::array<std::int32_t, 2>, 3>>;

constexpr int evening_sweeps = 500;
constexpr double evening_share = 0.25;  // share of the differences in length that a sweep removes

// Slides nodes on the bag until their yarns are equally long, as woven yarns are. The pulls of opposite neighbours are
// summed first, so that mirrored nodes stay mirrored to the last bit.
void even_out(const Container& bag, double outside, const Neighbours& neighbours, int threads, Fabric& fabric,
              const std::function<void(double)>& done) {
  double length = 0;
  for (const Fabric::Yarn& y : fabric.yarns)
    length +=
        (fabric.nodes[static_cast<std::size_t>(y.second)] - fabric.nodes[static_cast<std::size_t>(y.first)]).norm();
  length /= static_cast<double>(fabric.yarns.size());
  std::vector<Vec3> moved(fabric.nodes.size());
  for (int sweep = 0; sweep < evening_sweeps; ++sweep) {
    in_parallel(moved.size(), threads, [&](std::size_t n) {
      const Vec3& x = fabric.nodes[n];
      const auto pull = [&](std::int32_t other) -> Vec3 {
        if (other < 0) return Vec3::Zero();
        const Vec3 along = fabric.nodes[static_cast<std::size_t>(other)] - x;
        return along * (1 - length / along.norm());
      };
      std::array<Vec3, 3> pulls;
      for (std::size_t axis = 0; axis < 3; ++axis)
        pulls[axis] = pull(neighbours[n][axis][0]) + pull(neighbours[n][axis][1]);
      moved[n] = bag.nearest(x + evening_share * (pulls[0] + pulls[1] + pulls[2]), outside);
    });
    fabric.nodes.swap(moved);
    if (done) done((sweep + 1.0) / evening_sweeps);
  }
}

}  // namespace

Fabric wrap(const Container& bag, const std::array<int, 3>& cells, double outside, bool even, int threads,
            const std::function<void(double)>& done) {
  Fabric fabric;
  std::vector<Vec3> box;
  const auto [nx, ny, nz] = cells;
  std::map<std::array<int, 3>, std::int32_t> number;
  for (int k = 0; k <= nz; ++k)
    for (int j = 0; j <= ny; ++j)
      for (int i = 0; i <= nx; ++i) {
        const bool face = k == 0 || k == nz, side = i == 0 || i == nx || j == 0 || j == ny;
        if (!face && !side) continue;
        number[{i, j, k}] = static_cast<std::int32_t>(box.size());
        // Integers until the last division keep mirrored nodes mirrored to the last bit.
        box.emplace_back(static_cast<double>(2 * i - nx) / nx, static_cast<double>(2 * j - ny) / ny,
                         static_cast<double>(2 * k - nz) / nz);
      }
  fabric.nodes = bag.spread(box, cells, outside, even);
  Neighbours neighbours(fabric.nodes.size(), {{{-1, -1}, {-1, -1}, {-1, -1}}});
  for (const auto& [at, one] : number)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<int, 3> next = at;
      ++next[axis];
      const auto other = number.find(next);
      if (other == number.end()) continue;
      const bool face = at[2] == next[2] && (at[2] == 0 || at[2] == nz);
      // In a bag one cell wide, nodes of opposite sides may follow each other; they share no quadrilateral.
      fabric.yarns.push_back({one, other->second, face ? 0 : (axis == 2 ? 2 : 1)});
      neighbours[static_cast<std::size_t>(one)][axis][1] = other->second;
      neighbours[static_cast<std::size_t>(other->second)][axis][0] = one;
    }
  if (even) even_out(bag, outside, neighbours, threads, fabric, done);
  return fabric;
}

std::array<int, 3> cells_of(const Container& bag, double spacing, double outside) {
  constexpr int pieces = 100;
  // Returns the length of the hoop over the middles of four sides of the box, m.
  const auto hoop = [&](Eigen::Index across) {
    std::vector<Vec3> box;
    Vec3 at = Vec3::UnitZ();
    at[across] = -1;
    for (const auto& [axis, way] : {std::pair(across, 1.0), {2, -1.0}, {across, -1.0}, {2, 1.0}})
      for (int i = 1; i <= pieces; ++i) {
        at[axis] = way * (2.0 * i / pieces - 1);
        box.push_back(at);
      }
    const std::vector<Vec3> line = bag.spread(box, {pieces, pieces, pieces}, outside, true);
    double length = (line.front() - line.back()).norm();
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    return length;
  };
  constexpr double most = 1e8;  // no memory holds so many nodes, and more would not be counted
  const auto cells = [&](double length) {
    return static_cast<int>(std::lround(std::clamp(length / spacing, 1.0, most)));
  };
  const int down = cells(bag.high().z() - bag.low().z() + 2 * outside);
  const auto across = [&](Eigen::Index axis) { return cells(0.5 * hoop(axis) - down * spacing); };
  return {across(0), across(1), down};
}

Fabric sheet(const std::array<int, 2>& cells, double spacing, double height) {
  Fabric fabric;
  const int nx = cells[0];
  const int ny = cells[1];
  const auto number = [&](int i, int j) { return static_cast<std::int32_t>(j * (nx + 1) + i); };
  for (int j = 0; j <= ny; ++j)
    for (int i = 0; i <= nx; ++i) {
      fabric.nodes.emplace_back((i - 0.5 * nx) * spacing, (j - 0.5 * ny) * spacing, height);
      if (i > 0) fabric.yarns.push_back({number(i - 1, j), number(i, j), 0});
      if (j > 0) fabric.yarns.push_back({number(i, j - 1), number(i, j), 0});
    }
  return fabric;
}

std::size_t geotextiles_of(const io::Snapshot& state) {
  const std::vector<std::int32_t>& ids = state.yarns.geotextile_id;
  return ids.empty() ? 0 : static_cast<std::size_t>(*std::max_element(ids.begin(), ids.end())) + 1;
}

std::vector<dem::WireCurve> resting_geotextiles(std::size_t count) {
  return std::vector<dem::WireCurve>(count, {"resting", {1}, {1}, 1});
}

void add(const Fabric& fabric, const NodeRecipe& recipe, io::Snapshot& state) {
  io::GrainsRecord& g = state.grains;
  io::YarnsRecord& y = state.yarns;
  const auto first = static_cast<std::int32_t>(g.size());
  std::int64_t id = 0;
  for (const std::int64_t known : g.body_id) id = std::max(id, known + 1);
  const std::int32_t number = y.fabric.empty() ? 0 : 1 + *std::max_element(y.fabric.begin(), y.fabric.end());
  for (const Vec3& x : fabric.nodes) {
    g.body_id.push_back(id++);
    g.position.push_back(x);
    g.orientation.emplace_back(1, 0, 0, 0);
    g.velocity.emplace_back(Vec3::Zero());
    g.angular_velocity.emplace_back(Vec3::Zero());
    g.radius.push_back(recipe.radius);
    g.mass.push_back(recipe.density * dem::grain_volume(3, recipe.radius));
    g.material_id.push_back(recipe.material);
    g.copy_id.push_back(-1);
  }
  for (const Fabric::Yarn& yarn : fabric.yarns) {
    const Vec3 reach =
        fabric.nodes[static_cast<std::size_t>(yarn.second)] - fabric.nodes[static_cast<std::size_t>(yarn.first)];
    y.nodes.push_back({first + yarn.first, first + yarn.second});
    y.fabric.push_back(number), y.geotextile_id.push_back(recipe.geotextile), y.family.push_back(yarn.family);
    y.rest_length.push_back(reach.norm()), y.largest_strain.push_back(0), y.tension.push_back(0);
    y.broken.push_back(0), y.break_time.push_back(0), y.break_position.emplace_back(Vec3::Zero());
  }
}

}  // namespace soilweave::packing
