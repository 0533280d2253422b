// The table [mesh] of a two-scale scenario, and the checks of a mesh from a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/scenario_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <utility>

namespace soilweave::fem {
namespace {

constexpr Word element{"element", "kind of the elements"};

std::string text_of(Shape shape) { return shape == Shape::triangle3 ? "3-node triangles" : "8-node quadrilaterals"; }

Mesh read_rectangle(Settings& table) {
  static constexpr Parameter width{"width", "m", 0, 1e6, true, "width of the rectangle"},
      height{"height", "m", 0, 1e6, true, "height of the rectangle"};
  static constexpr Parameter columns{"columns", "1", 1, 1e4, false, "squares along x"},
      rows{"rows", "1", 1, 1e4, false, "squares along y"};
  for (const char* key : {"pieces", "coincident_nodes"})
    if (table.has(key)) table.mistake(key, "is of a mesh from a file: name one with --mesh, or leave it out");
  const double w = table.number(width), h = table.number(height);
  const auto nx = static_cast<Index>(table.integer(columns)), ny = static_cast<Index>(table.integer(rows));
  const bool quadrilaterals = table.choice(element, {"triangle3", "quadrilateral8"}, "triangle3") == "quadrilateral8";
  constexpr Index most = 100'000;  // each one is computed, and most hold grains
  const bool too_many = nx > most || ny > most / std::max<Index>(nx, 1);
  if (too_many) table.mistake("rows", fmt::format("makes, times columns, more than {} squares", most));
  if (!(w > 0 && h > 0) || nx < 1 || ny < 1 || too_many) return rectangle(1, 1, 1, 1, Shape::triangle3);
  return rectangle(w, h, nx, ny, quadrilaterals ? Shape::quadrilateral8 : Shape::triangle3);
}

std::int64_t tag_of(const Mesh& mesh, Index node) {
  return mesh.node_tags.empty() ? static_cast<std::int64_t>(node) : mesh.node_tags[node];
}

// Refuses nodes on sides of elements that do not have them: the mesh would gape there.
void check_hanging(Settings& table, const Mesh& mesh) {
  const std::vector<Mesh::Hanging> hanging = mesh.hanging();
  if (hanging.empty()) return;
  const Mesh::Hanging& h = hanging.front();
  const auto element = mesh.element_tags.empty() ? static_cast<std::int64_t>(h.element) : mesh.element_tags[h.element];
  table.mistake(
      "coincident_nodes",
      fmt::format("node {} lies on the side {}-{} of element {}, which does not have it{}: the mesh would gape "
                  "there; divide that side at the node (in Gmsh: SetFactory(\"OpenCASCADE\"); and Coherence; "
                  "before meshing), or where a slit is meant give mesh.coincident_nodes = \"keep\"",
                  tag_of(mesh, h.node), tag_of(mesh, h.ends[0]), tag_of(mesh, h.ends[1]), element,
                  hanging.size() == 1 ? "" : fmt::format(", nor {} others like it", hanging.size() - 1)));
}

// Refuses coincident nodes and pieces that share no node, unless they are intended.
void check_joints(Settings& table, const Mesh& mesh) {
  static constexpr Parameter meant{"pieces", "1", 1, 1e6, false, "pieces of the mesh that share no node"};
  const bool kept =
      table.choice({"coincident_nodes", "whether nodes of a mesh file may lie on one another or on sides of others"},
                   {"refuse", "keep"}, "refuse") == "keep";
  const auto wanted = static_cast<Index>(table.integer(meant, 1));
  const auto pairs = kept ? std::vector<std::array<Index, 2>>() : mesh.coincident();
  const std::vector<Mesh::Piece> pieces = mesh.pieces();
  std::string text;
  if (pieces.size() != wanted || !pairs.empty())
    text = pieces.size() == 1 ? "is one piece" : fmt::format("falls into {} pieces that share no node", pieces.size());
  for (Index k = 0; pieces.size() > 1 && !text.empty() && k < std::min<Index>(pieces.size(), 3); ++k)
    text += fmt::format("{}{} elements around ({:.4g}, {:.4g})", k == 0 ? ": " : ", ", pieces[k].elements,
                        pieces[k].middle.x(), pieces[k].middle.y());
  if (pieces.size() > 3 && !text.empty()) text += ", ...";
  const std::string pieces_remedy = pieces.size() == wanted ? "" : fmt::format("mesh.pieces = {}", pieces.size());
  if (!pairs.empty()) {
    const auto [a, b] = pairs.front();
    const Vec2 at = mesh.nodes[a];
    table.mistake(
        "coincident_nodes",
        fmt::format("{} of its nodes lie on another one, as node {} on {} at ({:.4g}, {:.4g}), and the mesh {}; "
                    "join them (in Gmsh: Coherence; before meshing, or Coherence Mesh; after it), or where "
                    "a slit is meant give mesh.coincident_nodes = \"keep\"{}{}",
                    pairs.size(), tag_of(mesh, b), tag_of(mesh, a), at.x(), at.y(), text,
                    pieces_remedy.empty() ? "" : " and ", pieces_remedy));
    return;
  }
  if (!kept) check_hanging(table, mesh);
  if (!pieces_remedy.empty())
    table.mistake("pieces",
                  pieces.size() == 1
                      ? fmt::format("the mesh is one piece, not {}: give {}", wanted, pieces_remedy)
                      : fmt::format("the mesh {}; join them, or where that is meant give {}", text, pieces_remedy));
}

// Completes a mesh from a file with the scenario's keys.
Mesh take_mesh(Settings& table, Mesh mesh) {
  for (const char* key : {"width", "height", "columns", "rows"})
    if (table.has(key)) table.mistake(key, "is of a rectangle, but --mesh names a file: leave one of the two out");
  if (table.has("element") && table.choice(element, {"triangle3", "quadrilateral8"}) != name_of(mesh.shape))
    table.mistake("element",
                  fmt::format("the file of the mesh decides: it has {}; leave the key out", text_of(mesh.shape)));
  check_joints(table, mesh);
  return mesh;
}

}  // namespace

Integration read_integration(Settings& table, Shape shape) {
  if (shape == Shape::triangle3) {
    if (table.has("integration"))
      table.mistake("integration",
                    "is of quadrilaterals; the 3-node triangles of this mesh have one point: leave it out");
    return Integration::reduced;
  }
  return table.choice({"integration", "points of integration of a quadrilateral: 4 or 9"}, {"reduced", "full"},
                      "reduced") == "full"
             ? Integration::full
             : Integration::reduced;
}

Mesh read_mesh(Settings& table, std::optional<Mesh> given) {
  return given ? take_mesh(table, std::move(*given)) : read_rectangle(table);
}

}  // namespace soilweave::fem
