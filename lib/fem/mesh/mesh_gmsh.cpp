// Gmsh's MSH files, ASCII 2.2 and 4.1, as text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <set>

#include "core/error.h"
#include "fem/mesh/gmsh_file.h"

namespace soilweave::fem {
namespace {

// Words of the file, one after another. Messages name their line.
class Words {
 public:
  Words(std::string_view text, std::string where) : text_(text), where_(std::move(where)) {}

  std::string_view next() {
    skip_blanks();
    if (at_ == text_.size()) fail("ends too early");
    const std::size_t from = at_;
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ') ++at_;
    return text_.substr(from, at_ - from);
  }
  bool done() {
    skip_blanks();
    return at_ == text_.size();
  }
  template <class Number>
  Number number() {
    const std::string_view word = next();
    Number value{};
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size()) fail_at(word);
    return value;
  }
  Index count() {
    const auto n = number<std::int64_t>();
    if (n < 0) fail("has a negative count");
    // Each counted item takes a character and a blank at least.
    if (static_cast<std::size_t>(n) > (text_.size() - at_) / 2 + 1) fail("counts more than the file can hold");
    return static_cast<Index>(n);
  }
  // Returns "a name" in quotes, from the rest of the line.
  std::string quoted() {
    const std::size_t from = text_.find('"', at_), to = from == text_.npos ? from : text_.find('"', from + 1);
    if (to == text_.npos || to > text_.find('\n', at_)) fail("has a name without quotes");
    at_ = to + 1;
    return std::string(text_.substr(from + 1, to - from - 1));
  }
  void expect(std::string_view word) {
    if (next() != word) fail(fmt::format("lacks {}", word));
  }
  void skip_to(std::string_view word) {
    while (next() != word) {
    }
  }
  std::size_t line() const { return line_; }
  [[noreturn]] void fail(const std::string& what,
                         const std::string& remedy = "write it with Gmsh as ASCII 2.2 or 4.1") {
    throw DataError(fmt::format("{}:{}: the mesh {}; {}", where_, line_, what, remedy));
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') line_ += text_[at_++] == '\n';
  }
  [[noreturn]] void fail_at(std::string_view word) {
    // A "$" in place of a number means that the section ends early.
    if (word.starts_with("$"))
      fail(fmt::format("has {} where a number belongs: its section holds less than it counts", word));
    fail(fmt::format("has \"{}\" where a number belongs", word.substr(0, 40)));
  }

  std::string_view text_;
  std::string where_;
  std::size_t at_ = 0, line_ = 1;
};

std::string remedy_for(int type) {
  constexpr int quadrilateral4 = 3, triangle6 = 9, quadrilateral9 = 10;
  if (type == quadrilateral4 || type == quadrilateral9)
    return "mesh it with \"Mesh.ElementOrder = 2; Mesh.SecondOrderIncomplete = 1;\", or as triangles without Recombine";
  if (type == triangle6) return "mesh it with \"Mesh.ElementOrder = 1;\"";
  return "mesh a surface in the plane z = 0";
}

class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& where) : words_(text, where) {}

  GmshFile read() {
    while (!words_.done()) section(std::string(words_.next()));
    if (version_ == 0) words_.fail("has no $MeshFormat");
    for (std::size_t k = 0; k < entity_of_.size(); ++k) file_.items[k].groups = groups_of(entity_of_[k]);
    return std::move(file_);
  }

 private:
  using Entity = std::pair<int, int>;  // dimension and number
  struct Partition {
    Entity parent;
    std::vector<int> groups;
  };

  void section(const std::string& name) {
    if (name == "$MeshFormat") return format();
    if (name == "$Comments") return words_.skip_to("$EndComments");
    if (version_ == 0) unknown(name);
    const bool four = version_ > 4;
    if (name == "$PhysicalNames") return names();
    if (name == "$Entities" && four) return entities();
    if (name == "$PartitionedEntities" && four) return partitions();
    if (name == "$Nodes") return four ? nodes_4() : nodes_2();
    if (name == "$Elements") return four ? elements_4() : elements_2();
    if (name == "$ParametricNodes") words_.fail("has $ParametricNodes", "mesh it with \"Mesh.SaveParametric = 0;\"");
    if (name.empty() || name[0] != '$')
      words_.fail(fmt::format("has \"{}\" where a section belongs", name.substr(0, 40)));
    words_.skip_to("$End" + name.substr(1));
  }

  [[noreturn]] void unknown(const std::string& first) {
    if (first == "$NOD" || first == "$NOE") words_.fail("is in Gmsh's format 1");
    if (first.find("Point(") != first.npos || first.starts_with("SetFactory") || first.starts_with("//"))
      words_.fail("seems to be a geometry of Gmsh", "mesh it: gmsh -2 -format msh41 FILE.geo");
    words_.fail("does not begin with $MeshFormat");
  }

  void format() {
    if (version_ != 0) words_.fail("has $MeshFormat twice");
    version_ = words_.number<double>();
    if (version_ != 2.2 && version_ != 4.1) words_.fail(fmt::format("has the format {}", version_));
    if (words_.number<int>() != 0)
      words_.fail("is binary", "write it with Gmsh as ASCII 2.2 or 4.1: gmsh FILE.msh -save -bin 0 -o ASCII.msh");
    words_.next();
    words_.expect("$EndMeshFormat");
  }

  void names() {
    const Index n = words_.count();
    for (Index k = 0; k < n; ++k) {
      const int dimension = words_.number<int>(), tag = words_.number<int>();
      const std::string name = words_.quoted();
      file_.names[{dimension, std::abs(tag)}] = name;
    }
    words_.expect("$EndPhysicalNames");
  }

  void skip_numbers(int n) {
    for (int k = 0; k < n; ++k) words_.number<double>();
  }
  // The sign of a physical number is the orientation of its curve or surface.
  std::vector<int> physical_tags() {
    std::vector<int> tags(words_.count());
    for (int& tag : tags) tag = std::abs(words_.number<int>());
    return tags;
  }

  void entities() {
    std::array<Index, 4> counts{};
    for (Index& n : counts) n = words_.count();
    for (int dimension = 0; dimension < 4; ++dimension)
      for (Index k = 0; k < counts[static_cast<Index>(dimension)]; ++k) {
        const int tag = words_.number<int>();
        skip_numbers(dimension == 0 ? 3 : 6);
        groups_of_entity_[{dimension, tag}] = physical_tags();
        if (dimension > 0)
          for (Index n = words_.count(); n > 0; --n) words_.number<int>();
      }
    words_.expect("$EndEntities");
  }

  void partitions() {
    words_.count();
    for (Index ghosts = words_.count(); ghosts > 0; --ghosts) words_.number<int>(), words_.number<int>();
    std::array<Index, 4> counts{};
    for (Index& n : counts) n = words_.count();
    for (int dimension = 0; dimension < 4; ++dimension)
      for (Index k = 0; k < counts[static_cast<Index>(dimension)]; ++k) {
        const int tag = words_.number<int>(), parent_dimension = words_.number<int>(), parent = words_.number<int>();
        for (Index n = words_.count(); n > 0; --n) words_.number<int>();
        skip_numbers(dimension == 0 ? 3 : 6);
        partition_[{dimension, tag}] = {{parent_dimension, parent}, physical_tags()};
        if (dimension > 0)
          for (Index n = words_.count(); n > 0; --n) words_.number<int>();
      }
    words_.expect("$EndPartitionedEntities");
  }

  // A part of a curve or surface also belongs to the groups of the whole. Entities between parts belong to none of
  // them.
  std::vector<int> groups_of(const Entity& entity) const {
    std::set<int> groups;
    const auto add = [&](const Entity& of) {
      if (const auto known = groups_of_entity_.find(of); known != groups_of_entity_.end())
        groups.insert(known->second.begin(), known->second.end());
    };
    if (const auto part = partition_.find(entity); part != partition_.end()) {
      groups.insert(part->second.groups.begin(), part->second.groups.end());
      if (part->second.parent.first == entity.first) add(part->second.parent);
    } else {
      add(entity);
    }
    return {groups.begin(), groups.end()};
  }

  void node(std::int64_t tag) {
    const std::size_t line = words_.line();
    Vec3 at;
    for (double& x : at) {
      x = words_.number<double>();
      if (!(std::abs(x) <= farthest))
        words_.fail(fmt::format("has node {} at {}, farther than {} m", tag, x, farthest), "mend it; lengths are in m");
    }
    const auto [known, fresh] = file_.nodes.try_emplace(tag, GmshFile::Node{at, line});
    if (!fresh && known->second.at != at)
      words_.fail(fmt::format("has node {} in two places, here and in line {}", tag, known->second.line),
                  "give every node a number of its own");
  }

  void nodes_2() {
    for (Index n = words_.count(); n > 0; --n) {
      const auto tag = words_.number<std::int64_t>();
      node(tag);
    }
    words_.expect("$EndNodes");
  }

  void nodes_4() {
    const Index blocks = words_.count();
    for (int k = 0; k < 3; ++k) words_.number<std::int64_t>();
    for (Index b = 0; b < blocks; ++b) {
      const int dimension = words_.number<int>();
      words_.number<int>();
      const bool parametric = words_.number<int>() != 0;
      std::vector<std::int64_t> tags(words_.count());
      for (std::int64_t& tag : tags) tag = words_.number<std::int64_t>();
      for (const std::int64_t tag : tags) {
        node(tag);
        if (parametric) skip_numbers(dimension);
      }
    }
    words_.expect("$EndNodes");
  }

  void item(std::int64_t tag, std::size_t line, int type, std::vector<int> groups) {
    const GmshType known = gmsh_type(type);
    const bool taken = type == gmsh::line2 || type == gmsh::line3 || type == gmsh::triangle3 ||
                       type == gmsh::quadrilateral8 || type == gmsh::vertex;
    if (!taken)
      words_.fail(fmt::format("has, as element {}, {}; taken are 3-node triangles and 8-node quadrilaterals", tag,
                              known.nodes > 0 ? fmt::format("a {}", known.name)
                                              : fmt::format("one of a type unknown here, number {}", type)),
                  remedy_for(type));
    GmshFile::Item item{tag, line, type, std::move(groups), {}};
    for (int k = 0; k < known.nodes; ++k) item.nodes.push_back(words_.number<std::int64_t>());
    file_.items.push_back(std::move(item));
  }

  void elements_2() {
    for (Index n = words_.count(); n > 0; --n) {
      const auto tag = words_.number<std::int64_t>();
      const std::size_t line = words_.line();
      const int type = words_.number<int>();
      // Tags: physical group, geometrical entity, and, in a partitioned mesh, the partitions.
      std::vector<int> tags(words_.count());
      for (int& t : tags) t = words_.number<int>();
      const bool grouped = !tags.empty() && tags[0] != 0;
      item(tag, line, type, grouped ? std::vector{std::abs(tags[0])} : std::vector<int>{});
    }
    words_.expect("$EndElements");
  }

  void elements_4() {
    const Index blocks = words_.count();
    for (int k = 0; k < 3; ++k) words_.number<std::int64_t>();
    for (Index b = 0; b < blocks; ++b) {
      const int dimension = words_.number<int>(), tag = words_.number<int>(), type = words_.number<int>();
      for (Index n = words_.count(); n > 0; --n) {
        const auto number = words_.number<std::int64_t>();
        item(number, words_.line(), type, {});
        entity_of_.push_back({dimension, tag});
      }
    }
    words_.expect("$EndElements");
  }

  static constexpr double farthest = 1e9;  // coordinate of a node, m

  Words words_;
  double version_ = 0;
  GmshFile file_;
  std::vector<Entity> entity_of_;  // entity of each item, 4.1 only
  std::map<Entity, std::vector<int>> groups_of_entity_;
  std::map<Entity, Partition> partition_;
};

}  // namespace

GmshType gmsh_type(int number) {
  static const std::map<int, GmshType> types = {
      {1, {"2-node line", 2}},
      {2, {"3-node triangle", 3}},
      {3, {"4-node quadrilateral", 4}},
      {4, {"4-node tetrahedron", 4}},
      {5, {"8-node hexahedron", 8}},
      {6, {"6-node prism", 6}},
      {7, {"5-node pyramid", 5}},
      {8, {"3-node line", 3}},
      {9, {"6-node triangle", 6}},
      {10, {"9-node quadrilateral", 9}},
      {11, {"10-node tetrahedron", 10}},
      {12, {"27-node hexahedron", 27}},
      {13, {"18-node prism", 18}},
      {14, {"14-node pyramid", 14}},
      {15, {"point", 1}},
      {16, {"8-node quadrilateral", 8}},
      {17, {"20-node hexahedron", 20}},
      {18, {"15-node prism", 15}},
      {19, {"13-node pyramid", 13}},
      {20, {"9-node triangle", 9}},
      {21, {"10-node triangle", 10}},
      {22, {"12-node triangle", 12}},
      {23, {"15-node triangle", 15}},
      {26, {"4-node line", 4}},
      {27, {"5-node line", 5}},
      {36, {"16-node quadrilateral", 16}},
      {39, {"12-node quadrilateral", 12}},
  };
  const auto known = types.find(number);
  return known == types.end() ? GmshType{"", 0} : known->second;
}

GmshFile parse_gmsh(std::string_view text, const std::string& where) { return GmshReader(text, where).read(); }

Mesh read_gmsh(std::string_view text, const std::string& where) { return build_mesh(parse_gmsh(text, where), where); }

}  // namespace soilweave::fem
