// The bag that a run loads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/loaded_bag.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/error.h"
#include "core/text/settings.h"
#include "dem/loading/path.h"
#include "packing/expand/plan.h"

namespace soilweave::packing {
namespace {

using analysis::LoadedBag;

/// Returns the corners of the box around the nodes of the fabric, m.
std::array<Vec3, 2> box_around(const io::Snapshot& state, std::int32_t fabric) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t k = 0; k < state.yarns.size(); ++k)
    if (state.yarns.fabric[k] == fabric)
      for (const std::int32_t n : state.yarns.nodes[k]) {
        const Vec3& x = state.grains.position[static_cast<std::size_t>(n)];
        low = low.cwiseMin(x), high = high.cwiseMax(x);
      }
  return {low, high};
}

/// Returns the plan by which filter-expand made the bag. Throws DataError if the history has none.
Settings plan_of(const io::RunFile& run, const std::string& where) {
  for (auto record = run.source.history.rbegin(); record != run.source.history.rend(); ++record)
    if (record->tool == "filter-expand" && !record->scenario.empty())
      return Settings::parse(record->scenario, where + ": plan of filter-expand");
  throw DataError(where +
                  ": its history has no plan of filter-expand, which tells the size of the bag; make the bag by "
                  "filter-expand, and load it by run-dem");
}

/// Sets area, height and the volume of the node layer from the plan.
void measure(Settings& plan, const io::Snapshot& start, std::int32_t fabric, const std::string& where, LoadedBag& bag) {
  Settings container = plan.table("container"), mesh = plan.table("geotextile_mesh");
  const std::string shape = container.text("shape", "none");
  if (shape == "none" || !plan.has("geotextile_mesh"))
    throw DataError(where + ": its geotextile lies flat and wraps no soil; the table loading is for bags");
  const Laid laid = read_laid(mesh);
  const double r = laid.nodes.radius;
  if (const auto body = read_container(shape, container)) {
    const auto* filled = dynamic_cast<const FilledBag*>(body.get());
    const Vec3 size = body->high() - body->low();
    bag.area = filled ? filled->width * filled->width : size.x() * size.y();
    bag.height = size.z();
    bag.fabric_volume = body->volume(-(laid.outside + r)) - body->volume(r - laid.outside);
    return;
  }
  const auto [low, high] = box_around(start, fabric);
  const Vec3 size = high - low - Vec3::Constant(2 * laid.outside);
  bag.area = size.x() * size.y();
  bag.height = size.z();
  // Volume between the parallel surfaces at -r and r of a convex surface (Steiner): area times 2 r, plus 8/3 pi r^3.
  bag.fabric_volume = 2 * r * analysis::fabric_area(start, fabric) + 8 * std::numbers::pi / 3 * r * r * r;
}

/// Reads the names of the plates, whether the first stage precedes the loading, and how fast each stage closes the
/// plates.
void read_stages(Settings& scenario, LoadedBag& bag) {
  std::vector<Settings> stages = scenario.tables("stage");
  for (Settings& stage : stages) {
    if (stage.text("path", "") != "uniaxial") continue;
    bag.upper = stage.text("upper", "top"), bag.lower = stage.text("lower", "bottom");
    break;
  }
  bag.preloaded = stages.size() > 1 && stages.front().text("path", "") != "uniaxial";
  for (Settings& stage : stages) {
    const auto path = dem::read_path(stage.text("path", ""), stage);
    std::optional<double> closing = 0;
    if (path && path->stations() > 0)
      for (const dem::DriveGoal& goal : path->drives(0)) {
        const bool of_plates = goal.part == bag.upper || goal.part == bag.lower;
        if (!of_plates || std::abs(goal.direction.z()) == 0) continue;
        // A plate under a load has no prescribed speed.
        if (goal.kind == dem::DriveGoal::Kind::load) closing.reset();
        if (closing) *closing += goal.speed * std::abs(goal.direction.z());
      }
    bag.closing_speed.push_back(closing);
  }
}

/// Returns a point of the plane `name` in the first state. Throws DataError if there is no such plane, or if its normal
/// is not along z with the sign of `facing`.
Vec3 point_of(Settings& scenario, const io::Snapshot& start, const std::string& name, double facing,
              const std::string& where) {
  std::vector<Settings> planes = scenario.tables("plane");
  std::vector<std::string> names;
  for (std::size_t k = 0; k < planes.size() && k < start.planes.point.size(); ++k) {
    if (planes[k].has("name")) names.push_back(planes[k].text("name"));
    if (!planes[k].has("name") || names.back() != name) continue;
    if (start.planes.normal[k].normalized().z() * facing < 1 - 1e-6)
      throw DataError(fmt::format(
          "{}: plane \"{}\" does not face the bag along z; the table loading needs level plates", where, name));
    return start.planes.point[k];
  }
  throw DataError(
      fmt::format("{}: no plane named \"{}\" (its named ones: {}); load the bag between planes named \"top\" "
                  "and \"bottom\"",
                  where, name, names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

/// Returns the distance by which the plates have moved apart in the series at the time of the first state, m.
double moved_apart(const io::RunFile& run, const LoadedBag& bag, const std::string& where) {
  const io::Snapshot& start = run.snapshots.front();
  const std::vector<double>& step = run.series.at("step").values;
  const auto row = std::ranges::find(step, static_cast<double>(start.step)) - step.begin();
  if (row == std::ssize(step))
    throw DataError(fmt::format("{}: its series has no row of step {}, that of its first state", where, start.step));
  const auto moved = [&](const std::string& name) {
    return run.series.at("displacement_" + name + "_z").values[static_cast<std::size_t>(row)];
  };
  return moved(bag.upper) - moved(bag.lower);
}

/// Returns for each family the mean `multiple` (in the scenario) of its yarns' geotextiles.
std::array<double, 3> multiples(Settings& scenario, const io::YarnsRecord& yarns) {
  static constexpr Parameter multiple{"multiple", "1", 0, 1e3, true, "factor on the tensions"};
  std::vector<double> of_geotextile;
  for (Settings& table : scenario.tables("geotextile")) of_geotextile.push_back(table.number(multiple, 1.0));
  std::array<double, 3> sum = {0, 0, 0}, count = {0, 0, 0};
  for (std::size_t k = 0; k < yarns.size(); ++k) {
    const auto family = static_cast<std::size_t>(std::clamp(yarns.family[k], 0, 2));
    const auto geotextile = static_cast<std::size_t>(yarns.geotextile_id[k]);
    sum[family] += geotextile < of_geotextile.size() ? of_geotextile[geotextile] : 1, ++count[family];
  }
  for (std::size_t f = 0; f < 3; ++f) sum[f] = count[f] > 0 ? sum[f] / count[f] : 1;
  return sum;
}

/// Makes the table of the loading once, so that an error about a missing column names the file.
void demand_columns(const io::RunFile& run, const LoadedBag& bag, const std::string& where) {
  try {
    analysis::loading(run.series, bag);
  } catch (const DataError& error) {
    throw DataError(fmt::format("{}: its series has {}", where, error.what()));
  }
}

std::optional<double> first_break(const io::YarnsRecord& yarns) {
  std::optional<double> first;
  for (std::size_t k = 0; k < yarns.size(); ++k)
    if (yarns.broken[k]) first = std::min(first.value_or(yarns.break_time[k]), yarns.break_time[k]);
  return first;
}

}  // namespace

LoadedBag loaded_bag(const io::RunFile& run, const std::string& where) {
  if (run.series.rows() == 0)
    throw DataError(where + ": has no series: it is a packing, not a run; load it by run-dem");
  const io::Snapshot& start = run.snapshots.front();
  if (start.yarns.size() == 0) throw DataError(where + ": has no geotextile; the table loading is for bags");
  LoadedBag bag;
  Settings plan = plan_of(run, where), scenario = Settings::parse(run.scenario, where + ": scenario");
  // filter-expand adds the geotextile around the container first.
  const std::int32_t fabric = *std::ranges::min_element(start.yarns.fabric);
  measure(plan, start, fabric, where, bag);
  read_stages(scenario, bag);
  const double apart =
      point_of(scenario, start, bag.upper, -1, where).z() - point_of(scenario, start, bag.lower, 1, where).z();
  demand_columns(run, bag, where);
  bag.gap = apart - moved_apart(run, bag, where);
  bag.multiple = multiples(scenario, start.yarns);
  const auto [face, side] = analysis::yarns_in_cut(start, fabric);
  bag.face_yarns = face, bag.side_yarns = side;
  bag.first_break = first_break(run.snapshots.back().yarns);
  return bag;
}

}  // namespace soilweave::packing
