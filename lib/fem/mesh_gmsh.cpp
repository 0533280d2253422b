// Gmsh's MSH files, ASCII 2.2 and 4.1.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

#include "core/error.h"
#include "core/text.h"
#include "fem/mesh.h"

namespace soilweave::fem {
namespace {

// Gmsh's numbers of element types.
constexpr int line2 = 1, line3 = 8, triangle3 = 2, quadrilateral8 = 16;
constexpr int vertex = 15;

int nodes_of_type(int type) {
  switch (type) {
    case line2:
      return 2;
    case line3:
    case triangle3:
      return 3;
    case quadrilateral8:
      return 8;
    case vertex:
      return 1;
    default:
      return 0;
  }
}

// Words of the file, one after another; messages name their line.
class Words {
 public:
  Words(std::string_view text, std::string where) : text_(text), where_(std::move(where)) {}

  std::string_view next() {
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') line_ += text_[at_++] == '\n';
    if (at_ == text_.size()) fail("ends too early");
    const std::size_t from = at_;
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ') ++at_;
    return text_.substr(from, at_ - from);
  }
  bool done() {
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') line_ += text_[at_++] == '\n';
    return at_ == text_.size();
  }
  template <class Number>
  Number number() {
    const std::string_view word = next();
    Number value{};
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size())
      fail(fmt::format("has \"{}\" where a number belongs", word));
    return value;
  }
  Index count() {
    const auto n = number<std::int64_t>();
    if (n < 0) fail("has a negative count");
    if (static_cast<std::size_t>(n) > text_.size()) fail("counts more than the file can hold");
    return static_cast<Index>(n);
  }
  // "a name" in quotes, on the rest of the line.
  std::string quoted() {
    const std::size_t from = text_.find('"', at_), to = from == text_.npos ? from : text_.find('"', from + 1);
    if (to == text_.npos) fail("has a name without quotes");
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
  [[noreturn]] void fail(const std::string& what) const {
    throw DataError(fmt::format("{}:{}: the mesh {}; write it with Gmsh as ASCII 2.2 or 4.1", where_, line_, what));
  }

 private:
  std::string_view text_;
  std::string where_;
  std::size_t at_ = 0, line_ = 1;
};

class GmshReader {
 public:
  GmshReader(std::string_view text, const std::string& where) : words_(text, where), where_(where) {}

  Mesh read() {
    while (!words_.done()) section(std::string(words_.next()));
    if (version_ == 0) words_.fail("has no $MeshFormat");
    build();
    mesh_.check(where_);
    return std::move(mesh_);
  }

 private:
  struct Item {
    int type;
    std::vector<int> groups;
    std::vector<std::int64_t> nodes;
  };

  void section(const std::string& name) {
    if (name == "$MeshFormat") return format();
    if (version_ == 0) words_.fail("does not begin with $MeshFormat");
    const bool four = version_ > 4;
    if (name == "$PhysicalNames") return names();
    if (name == "$Entities" && four) return entities();
    if (name == "$Nodes") return four ? nodes_4() : nodes_2();
    if (name == "$Elements") return four ? elements_4() : elements_2();
    if (name.empty() || name[0] != '$') words_.fail(fmt::format("has \"{}\" where a section belongs", name));
    words_.skip_to("$End" + name.substr(1));
  }

  void format() {
    version_ = words_.number<double>();
    if (version_ != 2.2 && version_ != 4.1) words_.fail(fmt::format("has the format {}", version_));
    if (words_.number<int>() != 0) words_.fail("is binary");
    words_.next();
    words_.expect("$EndMeshFormat");
  }

  void names() {
    const Index n = words_.count();
    for (Index k = 0; k < n; ++k) {
      const int dimension = words_.number<int>(), tag = words_.number<int>();
      const std::string name = words_.quoted();
      name_of_group_[{dimension, tag}] = name;
    }
    words_.expect("$EndPhysicalNames");
  }

  void entities() {
    std::array<Index, 4> counts{};
    for (Index& n : counts) n = words_.count();
    for (int dimension = 0; dimension < 4; ++dimension)
      for (Index k = 0; k < counts[static_cast<Index>(dimension)]; ++k) {
        const int tag = words_.number<int>();
        for (int c = 0; c < (dimension == 0 ? 3 : 6); ++c) words_.number<double>();
        std::vector<int>& groups = groups_of_entity_[{dimension, tag}];
        for (Index n = words_.count(); n > 0; --n) groups.push_back(words_.number<int>());
        if (dimension > 0)
          for (Index n = words_.count(); n > 0; --n) words_.number<int>();
      }
    words_.expect("$EndEntities");
  }

  void node(std::int64_t tag) {
    const double x = words_.number<double>(), y = words_.number<double>(), z = words_.number<double>();
    if (std::abs(z) > 1e-9 * (std::abs(x) + std::abs(y) + 1)) words_.fail("is not in the plane z = 0");
    position_[tag] = Vec2(x, y);
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
    for (int k = 0; k < 3; ++k) words_.next();
    for (Index b = 0; b < blocks; ++b) {
      words_.next(), words_.next();
      if (words_.number<int>() != 0) words_.fail("has parametric nodes");
      std::vector<std::int64_t> tags(words_.count());
      for (std::int64_t& tag : tags) tag = words_.number<std::int64_t>();
      for (const std::int64_t tag : tags) node(tag);
    }
    words_.expect("$EndNodes");
  }

  void item(int type, const std::vector<int>& groups) {
    const int n = nodes_of_type(type);
    if (n == 0)
      words_.fail(fmt::format("has elements of type {}; triangles of 3 and quadrilaterals of 8 nodes are read", type));
    Item item{type, groups, {}};
    for (int k = 0; k < n; ++k) item.nodes.push_back(words_.number<std::int64_t>());
    items_.push_back(std::move(item));
  }

  void elements_2() {
    for (Index n = words_.count(); n > 0; --n) {
      words_.next();
      const int type = words_.number<int>();
      std::vector<int> tags(words_.count());
      for (int& tag : tags) tag = words_.number<int>();
      if (!tags.empty()) tags.resize(1);
      item(type, tags);
    }
    words_.expect("$EndElements");
  }

  void elements_4() {
    const Index blocks = words_.count();
    for (int k = 0; k < 3; ++k) words_.next();
    for (Index b = 0; b < blocks; ++b) {
      const int dimension = words_.number<int>(), tag = words_.number<int>(), type = words_.number<int>();
      for (Index n = words_.count(); n > 0; --n) {
        words_.next();
        item(type, groups_of_entity_[{dimension, tag}]);
      }
    }
    words_.expect("$EndElements");
  }

  Index number_of(std::int64_t tag) {
    const auto known = number_.find(tag);
    if (known != number_.end()) return known->second;
    const auto place = position_.find(tag);
    if (place == position_.end())
      throw DataError(fmt::format("{}: an element names the node {}, which is none", where_, tag));
    mesh_.nodes.push_back(place->second);
    return number_[tag] = mesh_.nodes.size() - 1;
  }

  void build() {
    std::optional<int> type;
    for (const Item& item : items_) {
      if (item.type != triangle3 && item.type != quadrilateral8) continue;
      if (type && *type != item.type)
        throw DataError(where_ + ": mixes triangles and quadrilaterals; mesh it with one of them");
      type = item.type;
      std::array<Index, most_nodes> nodes{};
      for (Index k = 0; k < item.nodes.size(); ++k) nodes[k] = number_of(item.nodes[k]);
      mesh_.elements.push_back(nodes);
    }
    mesh_.shape = type && *type == quadrilateral8 ? Shape::quadrilateral8 : Shape::triangle3;
    boundaries();
  }

  void boundaries() {
    // The sense of an edge is that of the element it belongs to.
    std::set<std::pair<Index, Index>> sides;
    const Index corners = corners_of(mesh_.shape);
    for (const auto& e : mesh_.elements)
      for (Index k = 0; k < corners; ++k) sides.emplace(e[k], e[(k + 1) % corners]);
    for (const Item& item : items_) {
      if (item.type != line2 && item.type != line3 && item.type != vertex) continue;
      for (const int group : item.groups) {
        const auto named = name_of_group_.find({item.type == vertex ? 0 : 1, group});
        const std::string name = named != name_of_group_.end() ? named->second : std::to_string(group);
        if (item.type == vertex) {
          mesh_.boundaries[name].nodes.push_back(number_of(item.nodes[0]));
          continue;
        }
        Index first = number_of(item.nodes[0]), second = number_of(item.nodes[1]);
        if (!sides.count({first, second})) std::swap(first, second);
        if (!sides.count({first, second}))
          throw DataError(fmt::format("{}: boundary \"{}\" has an edge that is no side of an element", where_, name));
        Boundary& b = mesh_.boundaries[name];
        b.ends.push_back({first, second});
        if (item.type == line3) b.middle.push_back(number_of(item.nodes[2]));
      }
    }
    for (auto& [name, b] : mesh_.boundaries) {
      if (b.ends.empty()) continue;
      if (!b.middle.empty() != (mesh_.shape == Shape::quadrilateral8))
        throw DataError(fmt::format("{}: the edges of \"{}\" are of another order than the elements", where_, name));
      std::set<Index> all(b.nodes.begin(), b.nodes.end());
      all.insert(b.middle.begin(), b.middle.end());
      for (const auto& [first, second] : b.ends) all.insert({first, second});
      b.nodes.assign(all.begin(), all.end());
    }
  }

  Words words_;
  std::string where_;
  double version_ = 0;
  Mesh mesh_;
  std::map<std::pair<int, int>, std::string> name_of_group_;
  std::map<std::pair<int, int>, std::vector<int>> groups_of_entity_;
  std::map<std::int64_t, Vec2> position_;
  std::map<std::int64_t, Index> number_;
  std::vector<Item> items_;
};

}  // namespace

Mesh read_gmsh(std::string_view text, const std::string& where) { return GmshReader(text, where).read(); }

}  // namespace soilweave::fem
