// Sphere packings as plain text: x y z r a line, as YADE and spreadsheets write them.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/LU>
#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "io/files.h"

namespace soilweave::io {
namespace {

constexpr std::string_view periodic_mark = "##PERIODIC::";

bool separates(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r'; }

std::vector<std::string_view> words(std::string_view line) {
  std::vector<std::string_view> found;
  for (std::size_t at = 0; at < line.size();) {
    while (at < line.size() && separates(line[at])) ++at;
    const std::size_t start = at;
    while (at < line.size() && !separates(line[at])) ++at;
    if (at > start) found.push_back(line.substr(start, at - start));
  }
  return found;
}

std::optional<double> number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

class SpheresReader {
 public:
  SpheresReader(const std::string& where, double density) : where_(where), density_(density) {}

  void line(std::string_view text) {
    ++line_;
    if (text.starts_with(periodic_mark)) return periodic_cell(words(text.substr(periodic_mark.size())));
    const std::vector<std::string_view> found = words(text.substr(0, text.find('#')));
    // A first line of words is a header.
    if (found.empty() || (state_.grains.size() == 0 && !number(found[0]))) return;
    if (found.size() < 4) fail(found.size(), "x y z r are needed");
    sphere({value(found, 0), value(found, 1), value(found, 2)}, value(found, 3));
  }

  Snapshot finish(const CellRecord* given) {
    if (state_.grains.size() == 0) throw DataError(where_ + ": holds no spheres; write x y z r a line");
    if (!has_cell_ && given) state_.cell = *given;
    if (!has_cell_ && !given) aperiodic_cell();
    return std::move(state_);
  }

 private:
  [[noreturn]] void fail(std::size_t column, const std::string& what) const {
    throw DataError(fmt::format("{}: line {}, column {}: {}", where_, line_, column + 1, what));
  }
  double value(const std::vector<std::string_view>& found, std::size_t column) const {
    const std::optional<double> v = number(found[column]);
    if (!v) fail(column, fmt::format("\"{}\" is no finite number", found[column]));
    return *v;
  }

  void periodic_cell(const std::vector<std::string_view>& lengths) {
    if (lengths.size() != 3) fail(0, "three cell lengths belong behind ##PERIODIC::");
    for (std::size_t a = 0; a < 3; ++a) {
      const double length = value(lengths, a);
      if (!(length > 0)) fail(a, "a cell length that is not positive");
      state_.cell.matrix(static_cast<int>(a), static_cast<int>(a)) = length;
    }
    state_.cell.periodic = {true, true, true};
    has_cell_ = true;
  }

  void sphere(const Vec3& position, double radius) {
    if (!(radius > 0)) fail(3, "a radius that is not positive");
    GrainsRecord& g = state_.grains;
    g.body_id.push_back(static_cast<std::int64_t>(g.size()));
    g.position.push_back(position);
    g.orientation.emplace_back(1, 0, 0, 0);
    g.velocity.emplace_back(0, 0, 0);
    g.angular_velocity.emplace_back(0, 0, 0);
    g.radius.push_back(radius);
    g.mass.push_back(density_ * 4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
    g.material_id.push_back(0);
    g.copy_id.push_back(0);
  }

  /// A box that would hold the spheres and the origin: axes that are not periodic carry a length only.
  void aperiodic_cell() {
    const GrainsRecord& g = state_.grains;
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    for (std::size_t i = 0; i < g.size(); ++i) {
      low = low.cwiseMin((g.position[i].array() - g.radius[i]).matrix());
      high = high.cwiseMax((g.position[i].array() + g.radius[i]).matrix());
    }
    state_.cell.matrix = (high - low).asDiagonal();
    state_.cell.periodic = {false, false, false};
  }

  const std::string& where_;
  double density_;
  std::size_t line_ = 0;
  bool has_cell_ = false;
  Snapshot state_;
};

bool upright(const CellRecord& cell) {
  return cell.periodic == std::array<bool, 3>{true, true, true} && cell.matrix.isDiagonal(0.0);
}

}  // namespace

PackingFile import_spheres(const std::filesystem::path& path, double density, const CellRecord* cell) {
  TextFile file = read_text(path, "spheres");
  const std::string where = path == "-" ? "standard input" : path.string();
  if (!(density > 0 && std::isfinite(density))) throw DataError(where + ": a density that is not positive");
  SpheresReader reader(where, density);
  for (std::string_view rest = file.text; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    reader.line(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  Snapshot state = reader.finish(cell);
  check(state, where);
  return {std::move(state), std::move(file.source)};
}

std::string export_spheres(const Snapshot& state) {
  std::string text;
  const Mat3& m = state.cell.matrix;
  if (upright(state.cell)) text = fmt::format("{} {} {} {}\n", periodic_mark, m(0, 0), m(1, 1), m(2, 2));
  for (std::size_t i = 0; i < state.grains.size(); ++i) {
    const Vec3& x = state.grains.position[i];
    text += fmt::format("{} {} {} {}\n", x.x(), x.y(), x.z(), state.grains.radius[i]);
  }
  return text;
}

}  // namespace soilweave::io
