// Plane meshes: generator, checks, lines along boundaries.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "core/text/text.h"

namespace soilweave::fem {
namespace {

void add_edge(Boundary& boundary, Index first, Index second, std::optional<Index> middle) {
  boundary.ends.push_back({first, second});
  if (middle) boundary.middle.push_back(*middle);
}

void collect_nodes(Boundary& b) {
  b.nodes = b.middle;
  for (const auto& [first, second] : b.ends) b.nodes.insert(b.nodes.end(), {first, second});
  std::sort(b.nodes.begin(), b.nodes.end());
  b.nodes.erase(std::unique(b.nodes.begin(), b.nodes.end()), b.nodes.end());
}

void refuse_ambiguous(const Mesh& mesh, const std::string& name) {
  if (const auto found = mesh.ambiguous.find(name); found != mesh.ambiguous.end()) throw DataError(found->second);
}

}  // namespace

ElementNodes Mesh::corners(Index element, const std::vector<Vec2>& positions) const {
  ElementNodes x(2, static_cast<Eigen::Index>(nodes_of_element()));
  for (Index k = 0; k < nodes_of_element(); ++k) x.col(static_cast<Eigen::Index>(k)) = positions[elements[element][k]];
  return x;
}

void Mesh::check(const std::string& where) const {
  if (elements.empty()) throw DataError(where + ": holds no plane elements; mesh a surface");
  std::vector<bool> used(nodes.size(), false);
  for (Index e = 0; e < elements.size(); ++e) {
    for (Index k = 0; k < nodes_of_element(); ++k) {
      const Index n = elements[e][k];
      if (n >= nodes.size())
        throw DataError(fmt::format("{}: element {} names node {} of {}", where, e, n, nodes.size()));
      used[n] = true;
    }
    for (const IntegrationPoint& point : integration_points(shape, Integration::full)) {
      const double area = gradients(shape, point.at, corners(e, nodes)).area;
      if (!(area > 0))
        throw DataError(
            fmt::format("{}: element {} has the area {:.3g} m2 at a point of integration: its nodes {} are not "
                        "counter-clockwise or "
                        "coincide; mend the mesh",
                        where, e, area, fmt::join(elements[e].begin(), elements[e].begin() + nodes_of_element(), " ")));
    }
  }
  const auto lone = std::find(used.begin(), used.end(), false);
  if (lone != used.end())
    throw DataError(fmt::format("{}: node {} belongs to no element; leave it out", where, lone - used.begin()));
}

const Boundary& Mesh::boundary(const std::string& name) const {
  const auto found = boundaries.find(name);
  if (found != boundaries.end()) return found->second;
  refuse_ambiguous(*this, name);
  std::vector<std::string> names;
  for (const auto& [known, ignored] : boundaries) names.push_back(known);
  if (names.empty())
    throw DataError(
        fmt::format("the mesh has no boundary \"{}\", nor any other: name one in Gmsh, as Physical "
                    "Curve(\"{}\") = {{1}};",
                    name, name));
  throw DataError(fmt::format("the mesh has no boundary \"{}\"{}", name, suggestion(name, names)));
}

const Boundary& Mesh::boundary_with_edges(const std::string& name) const {
  const auto found = boundaries.find(name);
  if (found != boundaries.end() && !found->second.ends.empty()) return found->second;
  refuse_ambiguous(*this, name);
  std::vector<std::string> names;
  for (const auto& [known, b] : boundaries)
    if (!b.ends.empty()) names.push_back(known);
  if (names.empty())
    throw DataError(
        fmt::format("the mesh has no boundary with edges: name one in Gmsh, as Physical Curve(\"{}\") = {{1}};", name));
  if (found == boundaries.end())
    throw DataError(fmt::format("the mesh has no boundary \"{}\"{}", name, suggestion(name, names)));
  throw DataError(fmt::format("boundary \"{}\" has points alone and no length: name one with edges: {}", name,
                              fmt::join(names, ", ")));
}

std::vector<Index> Mesh::nodes_on(const std::string& name) const {
  if (name != "all") return boundary(name).nodes;
  if (boundaries.contains(name) || ambiguous.contains(name))
    throw DataError(
        "\"all\" means every node, and a boundary of the mesh has that name too; give it another in Gmsh, as "
        "Physical Curve(\"everywhere\") = {1};");
  std::vector<Index> every(nodes.size());
  std::iota(every.begin(), every.end(), Index{0});
  return every;
}

std::vector<Index> Mesh::line(const std::vector<std::string>& names) const {
  std::vector<std::array<Index, 2>> edges;
  for (const std::string& name : names) {
    const Boundary& b = boundary_with_edges(name);
    edges.insert(edges.end(), b.ends.begin(), b.ends.end());
  }
  std::map<Index, Index> next;
  std::map<Index, int> balance;
  for (const auto& [first, second] : edges) next[first] = second, ++balance[first], --balance[second];
  const auto start = std::find_if(balance.begin(), balance.end(), [](const auto& node) { return node.second > 0; });
  if (start == balance.end())
    throw DataError(fmt::format("the boundaries {} make no line with two ends", fmt::join(names, ", ")));
  std::vector<Index> line = {start->first};
  while (next.count(line.back()) && line.size() <= edges.size()) line.push_back(next.at(line.back()));
  if (line.size() != edges.size() + 1)
    throw DataError(fmt::format("the boundaries {} are not connected to one line", fmt::join(names, ", ")));
  return line;
}

double Mesh::coincidence() const {
  Vec2 low = nodes.front(), high = low;
  for (const Vec2& x : nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return 1e-8 * (high - low).norm();
}

std::vector<std::array<Index, 2>> Mesh::coincident() const {
  const double near = coincidence();
  std::vector<Index> order(nodes.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::sort(order.begin(), order.end(), [&](Index a, Index b) { return nodes[a].x() < nodes[b].x(); });
  // Groups of nodes with nearly one x, each sorted by y.
  std::vector<std::array<Index, 2>> pairs;
  for (Index from = 0, to = 0; from < order.size(); from = to) {
    for (to = from + 1; to < order.size() && nodes[order[to]].x() - nodes[order[to - 1]].x() <= near;) ++to;
    const auto first = order.begin() + static_cast<std::ptrdiff_t>(from),
               last = order.begin() + static_cast<std::ptrdiff_t>(to);
    std::sort(first, last, [&](Index a, Index b) { return std::pair(nodes[a].y(), a) < std::pair(nodes[b].y(), b); });
    for (auto at = first; at + 1 < last; ++at)
      if ((nodes[at[1]] - nodes[at[0]]).norm() <= near)
        pairs.push_back({std::min(at[0], at[1]), std::max(at[0], at[1])});
  }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

std::vector<Mesh::Piece> Mesh::pieces() const {
  // Union-find: the links of a node lead to the first node of its piece.
  std::vector<Index> to(nodes.size());
  std::iota(to.begin(), to.end(), Index{0});
  const auto first = [&](Index n) {
    while (to[n] != n) n = to[n] = to[to[n]];
    return n;
  };
  for (const auto& e : elements)
    for (Index k = 1; k < nodes_of_element(); ++k) {
      const Index a = first(e[0]), b = first(e[k]);
      to[std::max(a, b)] = std::min(a, b);
    }
  std::map<Index, Piece> of;
  for (const auto& e : elements) ++of[first(e[0])].elements;
  for (Index n = 0; n < nodes.size(); ++n)
    if (const auto piece = of.find(first(n)); piece != of.end())
      piece->second.middle += nodes[n], piece->second.nodes.push_back(n);
  std::vector<Piece> all;
  for (auto& [n, piece] : of) {
    piece.middle /= static_cast<double>(piece.nodes.size());
    all.push_back(std::move(piece));
  }
  return all;
}

Mesh rectangle(double width, double height, Index columns, Index rows, Shape shape) {
  Mesh mesh;
  mesh.shape = shape;
  const Index step = shape == Shape::triangle3 ? 1 : 2;  // grid points per side
  const Index across = step * columns + 1, up = step * rows + 1;
  std::vector<Index> number(across * up, 0);
  for (Index j = 0; j < up; ++j)
    for (Index i = 0; i < across; ++i) {
      if (step == 2 && i % 2 == 1 && j % 2 == 1) continue;  // no node in the middle
      number[j * across + i] = mesh.nodes.size();
      mesh.nodes.emplace_back(width * static_cast<double>(i) / static_cast<double>(across - 1),
                              height * static_cast<double>(j) / static_cast<double>(up - 1));
    }
  const auto node = [&](Index i, Index j) { return number[j * across + i]; };
  for (Index j = 0; j + 1 < up; j += step)
    for (Index i = 0; i + 1 < across; i += step) {
      const Index a = node(i, j), b = node(i + step, j), c = node(i + step, j + step), d = node(i, j + step);
      if (step == 1) {
        mesh.elements.push_back({a, b, d});
        mesh.elements.push_back({b, c, d});
      } else {
        mesh.elements.push_back({a, b, c, d, node(i + 1, j), node(i + 2, j + 1), node(i + 1, j + 2), node(i, j + 1)});
      }
    }
  const auto side = [&](const std::string& name, Index edges, const auto& at) {
    Boundary& b = mesh.boundaries[name];
    for (Index k = 0; k < edges; ++k)
      add_edge(b, at(k * step), at((k + 1) * step), step == 2 ? std::optional(at(k * step + 1)) : std::nullopt);
    collect_nodes(b);
  };
  side("bottom", columns, [&](Index k) { return node(k, 0); });
  side("right", rows, [&](Index k) { return node(across - 1, k); });
  side("top", columns, [&](Index k) { return node(across - 1 - k, up - 1); });
  side("left", rows, [&](Index k) { return node(0, up - 1 - k); });
  mesh.boundaries["bottom-corners"].nodes = {node(0, 0), node(across - 1, 0)};
  return mesh;
}

}  // namespace soilweave::fem
