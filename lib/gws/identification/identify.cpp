// The lines of the wrapped soil identified from series.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/identification/identify.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/text/text.h"
#include "gws/identification/path_lines.h"
#include "gws/identification/thesis_lines.h"
#include "gws/solution/doubts.h"
#include "gws/solution/model.h"

namespace soilweave::gws {
namespace {

/// Throws DataError if the line's constants leave their ranges, or if it explains its points worse than their mean
/// does.
void judge(const Line& line) {
  for (std::size_t k = 0; k < line.constants.size(); ++k) {
    const Parameter& range = constant(line.constants[k]).parameter;
    if (!range.contains(line.fit.estimates[k]))
      throw DataError(
          fmt::format("{}: {} = {:.4g} is out of range: must be {} ({}); check signs and units of the points",
                      line.name, range.name, line.fit.estimates[k], range_text(range), range.why));
  }
  if (!(line.fit.determination > 0))
    throw DataError(
        fmt::format("{}: the points do not follow the line (R2 {:.3g}, less than their mean explains); check signs and "
                    "units of the columns: contraction, compression and q = sigma_a - sigma_r are positive",
                    line.name, line.fit.determination));
}

/// Collects lines, and the reasons for missing lines.
struct Collected {
  std::vector<Line>& lines;
  std::vector<std::string>& left_out;

  template <class Make>
  void add(const Make& make) {
    try {
      Line line = make();
      judge(line);
      lines.push_back(std::move(line));
    } catch (const DataError& error) {
      left_out.emplace_back(error.what());
    }
  }
};

void set_constants(Soil& soil, const std::vector<Line>& lines) {
  for (const Line& line : lines)
    for (std::size_t k = 0; k < line.constants.size(); ++k)
      soil.*constant(line.constants[k]).field = line.fit.estimates[k];
}

/// Returns the series. From series that do not begin at rest it removes the first rows, where q/p is still below the
/// beginning of the near-failure line.
std::vector<BagSeries> near_failure_rows(const std::vector<BagSeries>& series, const Soil& soil) {
  std::vector<BagSeries> kept;
  for (const BagSeries& one : series) {
    std::size_t first = 0;
    const auto distance = [&](std::size_t i) {
      return failure_obliquity(soil, one.mean_stress[i]) - one.deviatoric_stress[i] / one.mean_stress[i];
    };
    while (!one.from_rest && first < one.size() && distance(first) > soil.kappa / soil.lambda - soil.xi) ++first;
    kept.push_back(one.from_row(first));
  }
  return kept;
}

void by_thesis(Collected& all, const std::vector<BagSeries>& series, const Soil& soil, Difference difference,
               bool compression_given) {
  const bool rest = std::ranges::any_of(series, [](const BagSeries& s) { return s.from_rest; });
  if (rest && !compression_given) all.add([&] { return compression_line(series, soil, {}); });
  all.add([&] { return near_failure_line(series, soil); });
  if (!rest) return;
  all.add([&] { return dilatancy_line(series, soil, difference); });
  all.add([&] { return stiffness_line(series, soil, difference); });
}

/// Fits along the paths. The search starts from the constants that by_thesis() finds. If it fails there, it starts from
/// the given constants.
void by_path(Collected& all, const std::vector<BagSeries>& series, const Soil& soil, Difference difference,
             bool compression_given) {
  std::vector<Line> lines;
  std::vector<std::string> ignored;
  Collected first{lines, ignored};
  by_thesis(first, series, soil, difference, compression_given);
  Soil start = soil;
  set_constants(start, lines);
  std::vector<Line> found;
  std::vector<std::string> left_out;
  const auto search = [&](const Soil& from) {
    left_out.clear();
    found = path_lines(series, from, compression_given, difference, left_out);
    // Constants of one path fit depend on each other: if one line is out of range, none is kept. The stiffness is
    // judged on its own.
    for (const Line& line : found)
      if (line.name != "stiffness") judge(line);
  };
  try {
    search(start);
  } catch (const DataError&) {
    search(soil);
  }
  for (Line& line : found) all.add([&] { return std::move(line); });
  all.left_out.insert(all.left_out.end(), left_out.begin(), left_out.end());
}

/// Returns the doubt "not-identified" if lines keep the constants of the soil that identification began with.
std::vector<Doubt> not_identified(const Identification& found, const std::vector<std::string>& assignments) {
  std::vector<std::string> kept;
  for (const Constant& c : constants()) {
    const std::string start = std::string(c.line) + ".";
    const bool assigned =
        std::ranges::any_of(assignments, [&](const std::string& one) { return one.starts_with(start); });
    const bool identified = std::ranges::any_of(found.lines, [&](const Line& line) { return line.name == c.line; });
    if (!assigned && !identified && (kept.empty() || kept.back() != c.line)) kept.emplace_back(c.line);
  }
  if (kept.empty()) return {};
  std::string why = fmt::format("{}", fmt::join(found.left_out, "; "));
  if (why.empty()) why = "give what determines them, as --failure for the failure line";
  return {{"not-identified", fmt::format("{}: not identified, so the answer keeps the constants of soil {}: {}",
                                         fmt::join(kept, ", "), found.soil.name, why)}};
}

/// Returns why the points hardly determine a line: a 95 % interval beyond the range of a constant, or a low R2. A line
/// through as many points as constants has no such findings.
std::vector<std::string> weaknesses(const Line& line) {
  constexpr double least_determination = 0.5;
  std::vector<std::string> found;
  if (line.x.size() <= line.constants.size()) return found;
  for (std::size_t k = 0; k < line.constants.size(); ++k) {
    const Parameter& range = constant(line.constants[k]).parameter;
    const double value = line.fit.estimates[k], low = value - line.fit.half_width(k),
                 high = value + line.fit.half_width(k);
    if (low < range.low || high > range.high)
      found.push_back(fmt::format("{} {:.4g} (95 %: {:.3g} to {:.3g}; must be {})", range.name, value, low, high,
                                  range_text(range)));
  }
  if (line.fit.determination < least_determination) found.push_back(fmt::format("R2 {:.3g}", line.fit.determination));
  return found;
}

/// Returns the doubt "hardly-determined" about lines that have weaknesses.
std::vector<Doubt> hardly_determined(const std::vector<Line>& lines) {
  std::string all;
  bool stiffness = false;
  for (const Line& line : lines) {
    const std::vector<std::string> found = weaknesses(line);
    if (found.empty()) continue;
    all += fmt::format("{}{}: {}", all.empty() ? "" : "; ", line.name, fmt::join(found, ", "));
    stiffness = stiffness || line.name == "stiffness";
  }
  if (all.empty()) return {};
  return {{"hardly-determined",
           fmt::format("the points hardly determine these constants: {}; {}give more points, over a wider range", all,
                       stiffness ? "check that the geotextiles are in the order of the series, or " : "")}};
}

/// Returns the doubt "compression-range" if most points of compression lie beyond a range of the mean stress.
std::vector<Doubt> beyond_series(const Points& compression, const Span& range) {
  const auto beyond = std::ranges::count_if(compression.x, [&](double p) { return p < range.low || p > range.high; });
  if (!range.known() || 2 * static_cast<std::size_t>(beyond) <= compression.x.size()) return {};
  const auto [low, high] = std::ranges::minmax(compression.x);
  return {{"compression-range",
           fmt::format("{} of {} points of --compression, from {:.4g} to {:.4g} kPa, lie beyond the mean stress of the "
                       "series, {:.4g} to {:.4g} kPa: check the units in the heads of both, or give points from there",
                       beyond, compression.x.size(), low / 1e3, high / 1e3, range.low / 1e3, range.high / 1e3)}};
}

/// Returns the doubt "out-of-proportion" about constants of a size that a slip of units gives, not a soil.
std::vector<Doubt> out_of_proportion(const Identification& found) {
  constexpr double greatest_factor = 10, farthest_pressure = 1e3;
  std::vector<std::string> all;
  for (const Line& line : found.lines) {
    if (line.name == "compression_line") {
      const double factor = line.fit.estimates[0] / line.given[0];
      if (factor > greatest_factor || factor < 1 / greatest_factor)
        all.push_back(
            fmt::format("C_t = {:.4g} is {:.3g} times that of soil {}: check the units of strain_volumetric "
                        "and mean_stress in the heads",
                        line.fit.estimates[0], factor, found.soil.name));
    } else if (line.name == "failure_line") {
      const double p_c = line.fit.estimates[1];
      const auto [low, high] = std::ranges::minmax(line.x);
      if (p_c > farthest_pressure * high || p_c < low / farthest_pressure)
        all.push_back(
            fmt::format("p_c = {:.4g} kPa is far beyond the tests, {:.4g} to {:.4g} kPa: check "
                        "obliquity_at_failure, and give strengths over a wider range of pressures",
                        p_c / 1e3, low / 1e3, high / 1e3));
    }
  }
  if (all.empty()) return {};
  return {{"out-of-proportion", fmt::format("{}", fmt::join(all, "; "))}};
}

}  // namespace

std::string_view explained(Method method) {
  return method == Method::path ? "All constants together along the bags' paths; the plastic strain is subtracted from "
                                  "the compression line."
                                : "Line by line, as the thesis; the compression line is fitted to all of the strain, "
                                  "plastic strain included, and tests at failure count at their confining pressure.";
}

Identification identify(const std::vector<BagSeries>& given, const SoilFile& soil, const Points& compression,
                        const Points& failure, Difference difference, Method method) {
  Identification found;
  found.soil = soil;
  found.soil.scatter.clear();
  found.soil.exact.clear();
  const std::vector<BagSeries> series = near_failure_rows(given, soil.soil);
  if (!series.empty()) found.soil.identified = range_of(series);
  found.of_points = beyond_series(compression, found.soil.identified.mean_stress);
  for (const Points* points : {&compression, &failure})
    found.of_points.insert(found.of_points.end(), points->doubts.begin(), points->doubts.end());
  Collected all{found.lines, found.left_out};
  if (!compression.x.empty()) all.add([&] { return compression_line(series, soil.soil, compression); });
  if (!failure.x.empty()) all.add([&] { return failure_line(series, soil.soil, failure); });
  const bool rest = std::ranges::any_of(series, [](const BagSeries& s) { return s.from_rest; });
  if (!series.empty() && !rest)
    found.left_out.emplace_back(
        "compression_line, dilatancy_line, stiffness: no series begins at rest, as a bag between plates does; give "
        "one");
  if (!series.empty() && rest && method == Method::path) {
    Soil known = soil.soil;
    set_constants(known, found.lines);
    try {
      by_path(all, series, known, difference, !compression.x.empty());
    } catch (const DataError& error) {
      found.left_out.push_back(fmt::format("all constants at once: {}", error.what()));
      all.add([&] { return near_failure_line(series, known); });  // it needs no other line
    }
  } else if (!series.empty()) {
    by_thesis(all, series, soil.soil, difference, !compression.x.empty());
  }
  std::ranges::stable_sort(found.lines, {}, [](const Line& line) {
    return std::ranges::find(constants(), line.constants.front(), &Constant::key) - constants().begin();
  });
  set_constants(found.soil.soil, found.lines);
  const Soil& elastic = method == Method::path ? found.soil.soil : soil.soil;
  for (const BagSeries& one : series) {
    auto& list = found.increments.emplace_back();
    for (std::size_t i = 0; one.from_rest && i + 1 < one.size(); ++i)
      list.push_back(increment(one, i, elastic, difference));
  }
  for (Line& line : found.lines) {
    line.given.clear();
    for (const std::string& key : line.constants) line.given.push_back(soil.soil.*constant(key).field);
    if (line.fit.freedom > 0)
      found.soil.scatter.push_back({line.constants, line.fit.standard_errors, line.fit.correlation, line.fit.freedom});
    if (line.x.size() <= line.constants.size()) found.soil.exact.push_back(line.name);
  }
  return found;
}

std::vector<Doubt> doubts(const Identification& found, const std::vector<std::string>& assignments) {
  std::vector<Doubt> all = not_identified(found, assignments), exact = unscattered(found.soil),
                     weak = hardly_determined(found.lines), large = out_of_proportion(found);
  for (const std::vector<Doubt>& more : {exact, weak, large, found.of_points, found.soil.doubts})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace soilweave::gws
