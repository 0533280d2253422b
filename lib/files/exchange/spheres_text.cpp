// Sphere packings as plain text: one grain per line, with or without a header.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/spheres_text.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <unordered_map>
#include <utility>

#include "core/error.h"
#include "core/text/number_word.h"
#include "core/text/units.h"
#include "files/exchange/spheres_columns.h"
#include "files/exchange/spheres_comments.h"
#include "files/exchange/spheres_foreign.h"
#include "files/exchange/table.h"
#include "store/bytes.h"

namespace soilweave::io {
namespace {

constexpr std::string_view periodic_mark = "##PERIODIC::";

/// Returns the separator of a first line of numbers. A comma separates only if no blank stands between two commas; "1,5
/// 2,5" has decimal commas.
char separator_of_numbers(std::string_view line) {
  const char separator = separator_of(line);
  if (separator != ',') return separator == ';' ? ';' : ' ';
  for (const std::string& cell : cells(line, ','))
    if (cell.find_first_of(" \t") != std::string::npos) return ' ';
  return ',';
}

/// Returns where a comment begins in a line: at the first # that stands behind a blank or a separator, or first in the
/// line.
std::size_t comment_in(std::string_view line) {
  std::size_t at = line.find('#');
  while (at != line.npos && at > 0 && std::string_view(" \t,;").find(line[at - 1]) == std::string_view::npos)
    at = line.find('#', at + 1);
  return at;
}

class SpheresReader {
 public:
  SpheresReader(const std::string& where, const SpheresOptions& options)
      : where_(where), options_(options), dimension_(options.dimension), comments_(where) {}

  void line(std::string_view text) {
    ++line_;
    const std::string plain = plain_spaces(text);
    const std::string_view all = trimmed(plain);
    if (all.starts_with(periodic_mark)) return periodic_cell(all.substr(periodic_mark.size()));
    if (all.starts_with('#')) return comment(all);
    const std::string_view kept = trimmed(all.substr(0, comment_in(all)));
    if (kept.empty()) return;
    if (!columns_) {
      const char separator = separator_of(kept);
      const std::vector<std::string> names = header_names(kept, separator);
      if (std::none_of(names.begin(), names.end(), is_number)) return header(names, separator);
    }
    // Tabs at the end of the line stay, because they separate empty cells.
    grain(std::string_view(plain).substr(0, comment_in(plain)));
  }

  ImportedSpheres finish() {
    GrainsRecord& g = state_.grains;
    if (g.size() == 0) throw DataError(where_ + ": holds no spheres; write x y z r a line");
    g.dimension = dimension_.value_or(3);
    if (g.dimension == 2) flatten();
    if (has_cell_ && options_.cell)
      throw DataError(where_ + ": has a ##PERIODIC:: line, so that no other cell can be given (--cell)");
    if (options_.cell && options_.cell->periodic[2] != (g.dimension == 3))
      throw DataError(fmt::format("{}: holds {}, whose cell has {} lengths (--cell)", where_,
                                  g.dimension == 2 ? "disks" : "spheres", g.dimension));
    // The lengths of the cell have the unit of the columns.
    if (has_cell_) state_.cell.matrix.topLeftCorner(g.dimension, g.dimension) *= columns_->length_factor;
    if (!has_cell_ && options_.cell) state_.cell = *options_.cell;
    if (!has_cell_ && !options_.cell) aperiodic_cell();
    ImportedSpheres read{std::move(state_), {}, {}};
    if (!columns_->unused.empty())
      read.notes.push_back(fmt::format("{}: columns left out: {}; density and radius give the mass", where_,
                                       fmt::join(columns_->unused, ", ")));
    if (g.dimension == 2)
      read.notes.push_back(fmt::format("{}: read as disks{}", where_, columns_->z ? ", their common z left out" : ""));
    return read;
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw DataError(fmt::format("{}: line {}, column {}: {}", where_, line_, column + 1, what));
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw DataError(fmt::format("{}: line {}: {}", where_, line_, what));
  }
  /// Returns true for a word that is a number, or was meant to be one.
  static bool is_number(const std::string& word) { return number_of(word) || !number_remedy(word).empty(); }

  double value(const std::vector<std::string>& words, std::size_t column) const {
    const std::optional<double> v = number_of(words[column]);
    if (!v || !std::isfinite(*v))
      fail(column,
           no_number(words[column], "finite number") +
               (separator_ == ' ' && words[column].ends_with(',') ? ": columns are separated by blanks here" : ""));
    return *v;
  }

  void periodic_cell(std::string_view text) {
    if (has_cell_) fail("a second ##PERIODIC:: line; keep the one of the packing");
    if (state_.grains.size() > 0) fail("##PERIODIC:: belongs before the first grain");
    text = trimmed(text.substr(0, comment_in(text)));
    const std::vector<std::string> lengths = cells(text, separator_of_numbers(text));
    if (lengths.size() != 3 && lengths.size() != 2)
      fail(0, "three cell lengths, of disks two, belong behind ##PERIODIC::");
    take_dimension(static_cast<int>(lengths.size()), "the ##PERIODIC:: line has");
    for (std::size_t a = 0; a < lengths.size(); ++a) {
      const double length = value(lengths, a);
      if (!(length > 0)) fail(a, "a cell length that is not positive");
      state_.cell.matrix(static_cast<int>(a), static_cast<int>(a)) = length;
    }
    state_.cell.periodic = {true, true, lengths.size() == 3};
    has_cell_ = true;
  }

  /// Sets the dimension (spheres or disks). Throws DataError if another one was set before.
  void take_dimension(int dimension, const std::string& said) {
    if (dimension_ && *dimension_ != dimension)
      fail(fmt::format("{} {} lengths where {} are read: give --dimension {}, or change the line", said, dimension,
                       *dimension_ == 2 ? "disks" : "spheres", dimension));
    dimension_ = dimension;
  }

  void comment(std::string_view text) {
    if (state_.grains.size() > 0) return comments_.below(line_, text, *columns_);
    try {
      if (auto columns = columns_ ? std::nullopt : yade_columns(text)) return take(std::move(*columns), ' ');
    } catch (const DataError& error) {
      fail(error.what());
    }
    comments_.add(line_, text, options_.cell.has_value());
  }

  void header(const std::vector<std::string>& names, char separator) {
    try {
      take(named_columns(names), separator);
    } catch (const DataError& error) {
      fail(fmt::format("neither numbers nor a header of x y z r: {}", error.what()));
    }
  }

  void take(SphereColumns columns, char separator) {
    if (!columns.z && !dimension_) dimension_ = 2;
    if (!columns.z && *dimension_ == 3) throw DataError("no column z, which spheres need");
    columns_ = std::move(columns);
    separator_ = separator;
  }

  /// Determines the columns of a text that begins with numbers.
  void begin(std::string_view text) {
    separator_ = separator_of_numbers(trimmed(text));
    const std::vector<std::string> words = cells(text, separator_);
    if (const auto columns = comments_.columns(words.size(), dimension_)) return take(*columns, separator_);
    take(plain_columns(dimension_.value_or(3)), separator_);
    // Decimal commas would look like too many columns, so words that are no numbers are reported first.
    for (std::size_t k = 0; k < words.size(); ++k)
      if (!number_of(words[k])) value(words, k);
    if (words.size() != columns_->width)
      fail(
          fmt::format("{} numbers; without a header a line is {}: name the columns in a first line, such as id x y z r",
                      words.size(), columns_->z ? "x y z r (disks: x y r, with --dimension 2)" : "x y r"));
  }

  void grain(std::string_view text) {
    if (!columns_) begin(text);
    if (state_.grains.size() == 0) comments_.heed(*columns_);
    const std::vector<std::string> words = cells(text, separator_);
    const SphereColumns& c = *columns_;
    if (words.size() != c.width)
      fail(std::min(words.size(), c.width),
           fmt::format(
               "{} values where {} belong, separated by {}{}", words.size(), c.width, separator_name(separator_),
               separator_ == ',' && words.size() > c.width ? "; with decimal commas among them? write points" : ""));
    for (std::size_t k = 0; k < c.width; ++k)
      if (!c.is_unused(k)) value(words, k);  // throws for the first column that is no number
    demand_one_packing(words);
    const Vec3 position(value(words, c.x), value(words, c.y), c.z ? value(words, *c.z) : 0);
    const double size = value(words, c.size);
    if (!(size > 0)) fail(c.size, fmt::format("a {} that is not positive", c.size_factor == 1 ? "radius" : "diameter"));
    append(position * c.length_factor, size * c.size_factor * c.length_factor);
  }

  /// Throws DataError if a grain's number comes again or the time changes, as where a file holds several time steps.
  void demand_one_packing(const std::vector<std::string>& words) {
    constexpr std::string_view remedy = ": are these two time steps or packings? keep the lines of one";
    if (const auto id = columns_->id) {
      const auto [first, is_new] = first_line_.try_emplace(words[*id], line_);
      if (!is_new && !words[*id].empty())
        fail(*id, fmt::format("the number {} again, which line {} has{}", words[*id], first->second, remedy));
    }
    if (const auto time = columns_->time) {
      if (!time_) time_ = words[*time];
      if (*time_ != words[*time]) fail(*time, fmt::format("{} below {}{}", words[*time], *time_, remedy));
    }
  }

  void append(const Vec3& position, double radius) {
    GrainsRecord& g = state_.grains;
    g.body_id.push_back(static_cast<std::int64_t>(g.size()));
    g.position.push_back(position);
    g.orientation.emplace_back(1, 0, 0, 0);
    g.velocity.emplace_back(0, 0, 0);
    g.angular_velocity.emplace_back(0, 0, 0);
    g.radius.push_back(radius);
    const double area = std::numbers::pi * radius * radius;
    g.mass.push_back(dimension_.value_or(3) == 2
                         ? options_.density * area
                         : options_.density * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
    g.material_id.push_back(0);
    g.copy_id.push_back(0);
  }

  /// Puts disks into the plane z = 0.
  void flatten() {
    for (Vec3& x : state_.grains.position) {
      if (x.z() != state_.grains.position.front().z() && &x != state_.grains.position.data())
        throw DataError(
            fmt::format("{}: disks lie in a plane, but z goes from {} to {}: leave out --dimension 2, or the column z",
                        where_, state_.grains.position.front().z(), x.z()));
    }
    for (Vec3& x : state_.grains.position) x.z() = 0;
  }

  /// Sets an aperiodic cell. Its axes have only lengths, so the box encloses the grains and the origin.
  void aperiodic_cell() {
    const GrainsRecord& g = state_.grains;
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    for (std::size_t i = 0; i < g.size(); ++i) {
      low = low.cwiseMin((g.position[i].array() - g.radius[i]).matrix());
      high = high.cwiseMax((g.position[i].array() + g.radius[i]).matrix());
    }
    state_.cell.matrix = (high - low).asDiagonal();
    if (g.dimension == 2) state_.cell.matrix(2, 2) = 1;
    state_.cell.periodic = {false, false, false};
  }

  const std::string& where_;
  const SpheresOptions& options_;
  std::optional<int> dimension_;
  std::size_t line_ = 0;
  bool has_cell_ = false;
  char separator_ = ' ';
  std::optional<SphereColumns> columns_;
  SpheresComments comments_;
  std::unordered_map<std::string, std::size_t> first_line_;  // by the number of a grain
  std::optional<std::string> time_;
  Snapshot state_;
};

/// Returns whether the lengths in a line ##PERIODIC:: describe the cell completely.
bool upright(const Snapshot& state) {
  const bool disks = state.grains.dimension == 2;
  return state.cell.periodic == std::array<bool, 3>{true, true, !disks} && state.cell.matrix.isDiagonal(0.0);
}

/// Returns the content that a text of grains leaves out, for people.
std::string left_out_of_text(const Snapshot& state, std::size_t nodes) {
  std::vector<std::string> all;
  const auto counted = [](std::size_t n, const char* what) {
    return fmt::format("{} {}{}", n, what, n == 1 ? "" : "s");
  };
  if (nodes > 0)
    all.push_back(counted(nodes, "node") + " and " + counted(state.yarns.size(), "yarn") + " of geotextiles");
  if (!state.planes.point.empty()) all.push_back(counted(state.planes.point.size(), "plane"));
  if (state.contacts.size() > 0) all.push_back(counted(state.contacts.size(), "contact"));
  const std::array<bool, 3>& periodic = state.cell.periodic;
  if (!upright(state) && (periodic[0] || periodic[1] || (state.grains.dimension == 3 && periodic[2])))
    all.emplace_back("the cell, which is tilted or not periodic along all axes");
  return fmt::format("{}", fmt::join(all, ", "));
}

}  // namespace

CellRecord periodic_cell(const std::string& lengths, const std::string& what) {
  CellRecord cell;
  const std::vector<std::string> parts = parts_of_list(lengths);
  const std::string remedy = "give three positive lengths, of disks two, in m, as in 0.0462,0.0461,0.0921";
  if (parts.size() != 2 && parts.size() != 3) throw UsageError(fmt::format("{} {}: {}", what, lengths, remedy));
  for (std::size_t a = 0; a < parts.size(); ++a) {
    double length = 0;
    try {
      length = quantity(parts[a], "m");
    } catch (const DataError& error) {
      throw UsageError(fmt::format("{} {}: {}; {}", what, lengths, error.what(), remedy));
    }
    if (!(length > 0 && std::isfinite(length))) throw UsageError(fmt::format("{} {}: {}", what, lengths, remedy));
    cell.matrix(static_cast<int>(a), static_cast<int>(a)) = length;
  }
  cell.periodic = {true, true, parts.size() == 3};
  return cell;
}

ImportedSpheres import_spheres(const std::filesystem::path& path, const SpheresOptions& options) {
  TextFile file = read_text(path, "spheres");
  const std::string where = input_name(path);
  if (!(options.density > 0 && std::isfinite(options.density)))
    throw DataError(where + ": a density that is not positive");
  if (const std::string foreign = foreign_spheres(file.text); !foreign.empty())
    throw DataError(fmt::format("{}: {}", where, foreign));
  SpheresReader reader(where, options);
  for (std::string_view rest = file.text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    reader.line(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  ImportedSpheres read = reader.finish();
  check(read.state, where);
  read.source = std::move(file.source);
  return read;
}

ExportedSpheres export_spheres(const Snapshot& state, const std::string& where) {
  const bool disks = state.grains.dimension == 2;
  const std::vector<bool> node = io::nodes(state);
  const auto nodes = static_cast<std::size_t>(std::count(node.begin(), node.end(), true));
  if (nodes > 0 && nodes == node.size())
    throw DataError(where + ": holds nodes of geotextiles alone, which are no grains: name a file with grains");
  const Mat3& m = state.cell.matrix;
  std::string text;
  if (upright(state)) text = fmt::format("{} {} {}", periodic_mark, m(0, 0), m(1, 1));
  if (upright(state)) text += disks ? "\n" : fmt::format(" {}\n", m(2, 2));
  if (disks) text += "x y r\n";
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    if (node[i]) continue;
    const Vec3& x = state.grains.position[i];
    text += fmt::format("{} {} ", x.x(), x.y());
    text += disks ? fmt::format("{}\n", state.grains.radius[i]) : fmt::format("{} {}\n", x.z(), state.grains.radius[i]);
  }
  return {std::move(text), left_out_of_text(state, nodes)};
}

}  // namespace soilweave::io
