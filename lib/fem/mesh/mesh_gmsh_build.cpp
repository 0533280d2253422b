// The plane mesh of a Gmsh file: each element once and counter-clockwise, boundaries along its sides.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/error.h"
#include "fem/mesh/gmsh_file.h"

namespace soilweave::fem {
namespace {

bool is_plane(int type) { return type == gmsh::triangle3 || type == gmsh::quadrilateral8; }
bool is_edge(int type) { return type == gmsh::line2 || type == gmsh::line3; }

// Returns the corners from the smallest number towards its smaller neighbour. Reversed and rotated copies of an element
// give the same numbers.
std::vector<std::int64_t> round_of(const GmshFile::Item& item) {
  const std::ptrdiff_t corners = item.type == gmsh::triangle3 ? 3 : 4;
  std::vector<std::int64_t> nodes(item.nodes.begin(), item.nodes.begin() + corners);
  std::rotate(nodes.begin(), std::min_element(nodes.begin(), nodes.end()), nodes.end());
  if (nodes.back() < nodes[1]) std::reverse(nodes.begin() + 1, nodes.end());
  return nodes;
}

// Returns twice the area of the triangle (a, b, c), positive if it is counter-clockwise.
double turn(const Vec2& a, const Vec2& b, const Vec2& c) {
  const Vec2 u = b - a, v = c - a;
  return u.x() * v.y() - u.y() * v.x();
}

bool cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;
}

class Builder {
 public:
  Builder(const GmshFile& file, const std::string& where) : file_(file), where_(where) {}

  Mesh build() {
    for (const GmshFile::Item& item : file_.items)
      if (is_plane(item.type)) element(item);
    if (mesh_.elements.empty()) nothing();
    for (Index e = 0; e < mesh_.elements.size(); ++e) set_upright(e);
    for (Index e = 0; e < mesh_.elements.size(); ++e) sides_of(e);
    for (const GmshFile::Item& item : file_.items)
      if (!is_plane(item.type)) boundaries_of(item);
    name_boundaries();
    note();
    mesh_.check(where_);
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(std::size_t line, const std::string& what) const {
    throw DataError(fmt::format("{}:{}: {}", where_, line, what));
  }
  [[noreturn]] void fail_element(Index e, const std::string& what) const {
    fail(from_[e]->line, fmt::format("element {} {}", from_[e]->tag, what));
  }

  [[noreturn]] void nothing() const {
    throw DataError(
        fmt::format("{}: holds no plane elements{}; mesh a surface (gmsh -2), and where there are physical "
                    "groups put it into one: Physical Surface(\"soil\") = {{1}};",
                    where_, file_.items.empty() ? "" : fmt::format(" among its {}", file_.items.size())));
  }

  void element(const GmshFile::Item& item) {
    if (from_.empty()) mesh_.shape = item.type == gmsh::triangle3 ? Shape::triangle3 : Shape::quadrilateral8;
    if (!from_.empty() && from_[0]->type != item.type)
      fail(item.line, fmt::format("element {} is a {}, element {} before it a {}; mesh all with one of them", item.tag,
                                  gmsh_type(item.type).name, from_[0]->tag, gmsh_type(from_[0]->type).name));
    // Format 2.2 writes an element of several groups once per group.
    const auto [known, fresh] = known_.try_emplace(round_of(item), Known{item.groups, mesh_.elements.size()});
    for (const int group : item.groups) surfaces_[group].insert(known->second.element);
    if (!fresh) {
      again_ += known->second.groups == item.groups;
      return;
    }
    std::array<Index, most_nodes> nodes{};
    for (Index k = 0; k < item.nodes.size(); ++k) nodes[k] = plane_node(item, item.nodes[k]);
    if (std::set(item.nodes.begin(), item.nodes.end()).size() < item.nodes.size())
      fail(item.line,
           fmt::format("element {} names a node twice: {}; mend the mesh", item.tag, fmt::join(item.nodes, " ")));
    mesh_.elements.push_back(nodes);
    mesh_.element_tags.push_back(item.tag);
    from_.push_back(&item);
  }

  const GmshFile::Node& node_of(const GmshFile::Item& item, std::int64_t tag) const {
    const auto place = file_.nodes.find(tag);
    if (place == file_.nodes.end())
      fail(item.line, fmt::format("element {} names the node {}, which is none; mend the mesh", item.tag, tag));
    return place->second;
  }

  Index plane_node(const GmshFile::Item& item, std::int64_t tag) {
    const GmshFile::Node& node = node_of(item, tag);
    const Vec3& x = node.at;
    if (std::abs(x.z()) > 1e-9 * (std::abs(x.x()) + std::abs(x.y()) + 1))
      fail(node.line, fmt::format("the mesh is not in the plane z = 0: node {} is at z = {:.6g}; mesh a surface in x "
                                  "and y",
                                  tag, x.z()));
    const auto [known, fresh] = number_.try_emplace(tag, mesh_.nodes.size());
    if (fresh) mesh_.nodes.emplace_back(x.x(), x.y()), mesh_.node_tags.push_back(tag);
    return known->second;
  }

  // Makes an element counter-clockwise. Throws for one without area.
  void set_upright(Index e) {
    auto& nodes = mesh_.elements[e];
    const Index n = corners_of(mesh_.shape);
    double area = 0, longest = 0;
    for (Index k = 0; k < n; ++k) {
      const Vec2 &a = mesh_.nodes[nodes[k]], &b = mesh_.nodes[nodes[(k + 1) % n]];
      area += 0.5 * turn(mesh_.nodes[nodes[0]], a, b), longest = std::max(longest, (b - a).norm());
    }
    if (n == 4 && crossed(nodes))
      fail_element(e, fmt::format("crosses itself: its corners {} do not follow each other around it; mend the mesh",
                                  corners(e)));
    if (!(std::abs(area) > 1e-10 * longest * longest))
      fail_element(
          e, fmt::format("has no area: its corners {} lie on a line or on one another; mend the mesh", corners(e)));
    if (area < 0) {
      // Reverses the order after the first corner, and with it the sides and their middle nodes.
      std::reverse(nodes.begin() + 1, nodes.begin() + static_cast<std::ptrdiff_t>(n));
      if (mesh_.shape == Shape::quadrilateral8) std::reverse(nodes.begin() + 4, nodes.end());
      if (turned_++ == 0) first_turned_ = from_[e]->tag;
    }
    for (const IntegrationPoint& point : integration_points(mesh_.shape, Integration::full))
      if (!(gradients(mesh_.shape, point.at, mesh_.corners(e, mesh_.nodes)).area > 0))
        fail_element(
            e,
            fmt::format("is folded: its corners {} have a hollow, or a node of a side is far from the side's middle; "
                        "mend the mesh",
                        corners(e)));
  }

  bool crossed(const std::array<Index, most_nodes>& e) const {
    const auto at = [&](Index k) { return mesh_.nodes[e[k]]; };
    return cross(at(0), at(1), at(2), at(3)) || cross(at(1), at(2), at(3), at(0));
  }

  std::string corners(Index e) const {
    const auto& nodes = from_[e]->nodes;
    return fmt::format(
        "{}", fmt::join(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(corners_of(mesh_.shape)), " "));
  }

  // An edge has the orientation of its element; two elements on one side of it overlap.
  void sides_of(Index e) {
    const auto& nodes = mesh_.elements[e];
    const Index n = corners_of(mesh_.shape);
    for (Index k = 0; k < n; ++k) {
      const auto [side, fresh] = sides_.try_emplace({nodes[k], nodes[(k + 1) % n]}, Side{e, n == 4 ? nodes[4 + k] : 0});
      if (!fresh)
        fail_element(
            e, fmt::format(
                   "and element {} lie on the same side of the edge from node {} to node {}: they overlap; mend "
                   "the mesh",
                   from_[side->second.element]->tag, mesh_.node_tags[nodes[k]], mesh_.node_tags[nodes[(k + 1) % n]]));
    }
  }

  // A physical group by its dimension and number. Gmsh numbers each dimension by itself.
  using Group = std::pair<int, int>;

  std::string name_of_group(const Group& group) const {
    const auto named = file_.names.find(group);
    return named != file_.names.end() ? named->second : std::to_string(group.second);
  }

  Index mesh_node(const GmshFile::Item& item, const std::string& name, std::int64_t tag) const {
    node_of(item, tag);
    const auto known = number_.find(tag);
    if (known == number_.end())
      fail(item.line, fmt::format("boundary \"{}\" has node {}, which belongs to no plane element; take it out of the "
                                  "group, or mesh the surface at it",
                                  name, tag));
    return known->second;
  }

  void boundaries_of(const GmshFile::Item& item) {
    for (const int group : item.groups) {
      const Group key(item.type == gmsh::vertex ? 0 : 1, group);
      Boundary& b = groups_[key];
      if (item.type == gmsh::vertex)
        b.nodes.push_back(mesh_node(item, name_of_group(key), item.nodes[0]));
      else if (is_edge(item.type))
        edge(item, key, b);
    }
  }

  // A name that several groups have names none of them.
  void name_boundaries() {
    std::map<std::string, std::vector<Group>> named;
    for (const auto& [group, ignored] : groups_) named[name_of_group(group)].push_back(group);
    for (const auto& [name, groups] : named) {
      if (groups.size() > 1) {
        mesh_.ambiguous[name] = ambiguity(name, groups);
        continue;
      }
      Boundary& b = mesh_.boundaries[name] = std::move(groups_[groups[0]]);
      collect_nodes(b);
    }
  }

  static std::string ambiguity(const std::string& name, const std::vector<Group>& groups) {
    const auto kind = [](const Group& group) { return group.first == 0 ? "point" : "curve"; };
    std::vector<std::string> all;
    for (const Group& group : groups) all.push_back(fmt::format("physical {} {}", kind(group), group.second));
    const auto [ignored, number] = groups[0];
    const std::string word = kind(groups[0]), kind_of_gmsh = word == "point" ? "Point" : "Curve";
    return fmt::format(
        "the name \"{}\" means {} of the mesh alike; give each a name of its own in Gmsh, as Physical "
        "{}(\"{}-{}\", {}) = {{1}};",
        name, fmt::join(all, " and "), kind_of_gmsh, word, number, number);
  }

  void edge(const GmshFile::Item& item, const Group& group, Boundary& b) {
    const std::string name = name_of_group(group);
    if ((item.type == gmsh::line3) != (mesh_.shape == Shape::quadrilateral8))
      fail(item.line,
           fmt::format("boundary \"{}\" has a {}, but the elements are each a {}: of another order; mesh both "
                       "with one Mesh.ElementOrder",
                       name, gmsh_type(item.type).name, gmsh_type(from_[0]->type).name));
    std::array<Index, 2> ends = {mesh_node(item, name, item.nodes[0]), mesh_node(item, name, item.nodes[1])};
    auto side = sides_.find(ends);
    if (side == sides_.end()) {
      std::swap(ends[0], ends[1]);
      side = sides_.find(ends);
    }
    if (side == sides_.end())
      fail(item.line, fmt::format("boundary \"{}\" has an edge that is no side of an element, from node {} to node {}; "
                                  "mend the mesh",
                                  name, item.nodes[0], item.nodes[1]));
    const bool curved = item.type == gmsh::line3;
    if (curved && mesh_node(item, name, item.nodes[2]) != side->second.middle)
      fail(item.line,
           fmt::format("boundary \"{}\" has node {} in the middle of an edge, element {} another; mend the mesh", name,
                       item.nodes[2], from_[side->second.element]->tag));
    if (!edges_[group].insert(ends).second) return;
    b.ends.push_back(ends);
    if (curved) b.middle.push_back(side->second.middle);
  }

  static void collect_nodes(Boundary& b) {
    std::set<Index> all(b.nodes.begin(), b.nodes.end());
    all.insert(b.middle.begin(), b.middle.end());
    for (const auto& [first, second] : b.ends) all.insert({first, second});
    b.nodes.assign(all.begin(), all.end());
  }

  void note() {
    if (turned_ > 0)
      mesh_.doubts.push_back({"mesh_turned", fmt::format("{}: {} of {} elements, element {} the first, are clockwise: "
                                                         "turned round",
                                                         where_, turned_, mesh_.elements.size(), first_turned_)});
    if (again_ > 0)
      mesh_.doubts.push_back({"mesh_repeated", fmt::format("{}: {} element{} more than once in the file: counted once",
                                                           where_, again_, again_ == 1 ? " is" : "s are")});
    note_surfaces();
    std::vector<std::int64_t> lone;
    for (const auto& [tag, node] : file_.nodes)
      if (!number_.count(tag)) lone.push_back(tag);
    if (lone.empty()) return;
    const auto shown = static_cast<std::ptrdiff_t>(std::min<std::size_t>(lone.size(), 5));
    mesh_.doubts.push_back(
        {"mesh_left_out",
         fmt::format("{}: {} of no element left out: {}{}", where_,
                     lone.size() == 1 ? "a node" : fmt::format("{} nodes", lone.size()),
                     fmt::join(lone.begin(), lone.begin() + shown, ", "), lone.size() > 5 ? ", ..." : "")});
  }

  // Adds a doubt if physical surfaces hold only a part of the elements, since all elements become one soil.
  void note_surfaces() {
    const Index all = mesh_.elements.size();
    std::vector<std::string> parts;
    for (const auto& [group, elements] : surfaces_)
      if (elements.size() < all)
        parts.push_back(fmt::format("\"{}\" ({} of {})", name_of_group({2, group}), elements.size(), all));
    if (!parts.empty())
      mesh_.doubts.push_back(
          {"mesh_surfaces", fmt::format("{}: all elements become one soil, which [soil] describes, although physical "
                                        "surfaces part them: {}; mesh only what is that soil",
                                        where_, fmt::join(parts, ", "))});
  }

  // A known element: its number, and its groups at its first occurrence.
  struct Known {
    std::vector<int> groups;
    Index element;
  };
  struct Side {
    Index element, middle;
  };

  const GmshFile& file_;
  const std::string& where_;
  Mesh mesh_;
  std::vector<const GmshFile::Item*> from_;  // Gmsh's item of each element
  std::map<std::vector<std::int64_t>, Known> known_;
  std::map<int, std::set<Index>> surfaces_;     // elements of each physical surface
  std::map<std::int64_t, Index> number_;        // numbers of nodes by Gmsh's numbers
  std::map<std::array<Index, 2>, Side> sides_;  // sides by their end nodes, counter-clockwise
  std::map<Group, Boundary> groups_;
  std::map<Group, std::set<std::array<Index, 2>>> edges_;
  Index turned_ = 0, again_ = 0;
  std::int64_t first_turned_ = 0;
};

}  // namespace

Mesh build_mesh(const GmshFile& file, const std::string& where) { return Builder(file, where).build(); }

}  // namespace soilweave::fem
