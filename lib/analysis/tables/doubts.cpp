// Doubts about packings, bags and runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "analysis/doubts/idle_doubts.h"
#include "analysis/doubts/input_doubts.h"
#include "analysis/doubts/loading_doubts.h"
#include "analysis/doubts/material_doubts.h"
#include "analysis/measure/fabric.h"
#include "analysis/measure/soundness.h"
#include "analysis/measure/stress.h"
#include "analysis/measure/tessellation.h"
#include "analysis/tables/bag.h"
#include "dem/state/bodies.h"
#include "dem/sweep/contact_sweep.h"

namespace soilweave::analysis {
namespace {

// Least mean number of contacts per grain in a bag. Soil grown into a bag has 2.5 (packing::Growth).
constexpr double loosest_bag = 2;
// Largest inertial number. At 3e-3 (10 %/s, linear springs) the response is up to 6 % off the quasi-static one.
constexpr double largest_inertia = 1e-4;

// Loading of one stage: its largest strain rate, and its mean stress.
struct Loading {
  std::size_t stage;
  double rate, pressure;  // 1/s, Pa
};

dem::AxisGoals goals_at(const dem::Stage& stage, std::size_t station, int dimension, double pressure) {
  return stage.path->goals(station, {dimension, pressure * Mat3::Identity(), Vec3::Zero()});
}

// Returns the mean of the stresses that a stage demands at a station; none if it demands strains alone.
std::optional<double> asked_pressure(const dem::AxisGoals& goals, int dimension) {
  double sum = 0, count = 0;
  for (int a = 0; a < dimension; ++a)
    if (const dem::AxisGoal& goal = goals[static_cast<std::size_t>(a)]; goal.kind == dem::AxisGoal::Kind::stress)
      sum += goal.value, count += 1;
  return count > 0 ? std::optional(sum / count) : std::nullopt;
}

// Returns the largest prescribed strain rate of a stage, 1/s; 0 if stresses control it, or if the rate follows the
// unbalanced force.
double given_rate(const dem::Stage& stage, int dimension) {
  if (stage.way_unbalanced_force > 0) return 0;
  double rate = 0;
  if (const std::optional<dem::Between> between = stage.path->between())
    for (const dem::DriveGoal& goal : stage.path->drives(0)) rate += goal.speed / between->height;
  std::array<double, 3> before = {0, 0, 0};
  for (std::size_t station = 0; station < stage.path->stations(); ++station) {
    const dem::AxisGoals goals = goals_at(stage, station, dimension, 1);
    for (std::size_t a = 0; a < static_cast<std::size_t>(dimension); ++a) {
      if (goals[a].kind != dem::AxisGoal::Kind::strain || goals[a].value == before[a]) continue;
      rate = std::max(rate, goals[a].max_rate), before[a] = goals[a].value;
    }
  }
  return rate;
}

bool is_isotropic(const dem::Stage& stage, int dimension) {
  const dem::AxisGoals goals = goals_at(stage, stage.path->stations() - 1, dimension, 1);
  return std::all_of(goals.begin(), goals.begin() + dimension, [&](const dem::AxisGoal& goal) {
    return goal.kind == dem::AxisGoal::Kind::stress && goal.value == goals[0].value;
  });
}

// Returns the rate that would suffice, rounded down to one digit.
double slower(double rate, double inertia) {
  const double exact = rate * largest_inertia / inertia, digit = std::pow(10, std::floor(std::log10(exact)));
  return std::floor(exact / digit) * digit;
}

std::vector<Doubt> inertia_doubts(const io::Snapshot& start, const dem::Scenario& scenario,
                                  const std::vector<Loading>& loadings) {
  double diameter = 0, mass = 0, solid = 0;
  const std::vector<bool> node = nodes(start);
  double grains = 0;
  for (std::size_t i = 0; i < start.grains.size(); ++i) {
    if (node[i]) continue;
    diameter += 2 * start.grains.radius[i], grains += 1;
    mass += start.grains.mass[i];
    solid += dem::grain_volume(start.grains.dimension, start.grains.radius[i]);
  }
  if (grains == 0) return {};
  diameter /= grains;
  const double density = mass / solid;
  const Loading* worst = nullptr;
  double largest = largest_inertia;
  for (const Loading& l : loadings)
    if (const double i = inertial_number(l.rate, diameter, density, l.pressure); i > largest) largest = i, worst = &l;
  if (!worst) return {};
  return {
      {"inertia",
       fmt::format("stage \"{}\" at {:.3g} 1/s: inertial number {:.1e} (grains of {:.3g} m and {:.3g} kg/m3, scaling "
                   "included, at {:.3g} Pa): above {:.0e} the response depends on the rate; a rate of {:.1g} 1/s "
                   "is slow enough",
                   scenario.stages[worst->stage].name, worst->rate, largest, diameter, density, worst->pressure,
                   largest_inertia, slower(worst->rate, largest))}};
}

std::vector<Loading> planned(const io::Snapshot& start, const dem::Scenario& scenario) {
  const int dimension = start.grains.dimension;
  double pressure = mean(cell_stress(start), dimension);
  std::vector<Loading> loadings;
  for (std::size_t s = 0; s < scenario.stages.size(); ++s) {
    const dem::Stage& stage = scenario.stages[s];
    pressure = asked_pressure(goals_at(stage, 0, dimension, pressure), dimension).value_or(pressure);
    if (const double rate = given_rate(stage, dimension); rate > 0 && pressure > 0)
      loadings.push_back({s, rate, pressure});
    pressure =
        asked_pressure(goals_at(stage, stage.path->stations() - 1, dimension, pressure), dimension).value_or(pressure);
  }
  return loadings;
}

// Returns the area that bodies cover in plan, m2.
double area_in_plan(const io::Snapshot& state) {
  Vec3 low = Vec3::Constant(INFINITY), high = -low;
  for (const Vec3& x : state.grains.position) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return (high.x() - low.x()) * (high.y() - low.y());
}

// Returns the mean stress at each row; in a stage between plates their force over the area in plan.
std::vector<double> pressures_in(const io::Snapshot& start, const dem::Stage& stage, const io::Series& series) {
  const std::optional<dem::Between> between = stage.path->between();
  if (!between) return series.at("mean_stress").values;
  std::vector<double> pressures = series.at("force_" + between->upper + "_z").values;
  const double area = area_in_plan(start);
  for (double& p : pressures) p = std::abs(p) / area;
  return pressures;
}

std::vector<Loading> carried_out(const io::Snapshot& start, const dem::Scenario& scenario, const io::Series& series) {
  const std::vector<double>& stages = series.at("stage").values;
  const std::vector<Loading> plan = planned(start, scenario);
  std::vector<Loading> loadings;
  for (std::size_t s = 0; s < scenario.stages.size(); ++s) {
    const double rate = given_rate(scenario.stages[s], start.grains.dimension);
    if (rate == 0) continue;
    const std::vector<double> pressures = pressures_in(start, scenario.stages[s], series);
    double least = INFINITY;
    // Row 0 is the packing before its first stage.
    for (std::size_t row = 1; row < stages.size(); ++row)
      if (stages[row] == static_cast<double>(s) && pressures[row] > 0) least = std::min(least, pressures[row]);
    if (std::isfinite(least)) {
      loadings.push_back({s, rate, least});
      continue;
    }
    // Grains that the loading threw apart have no stress, so the one before counts.
    const auto before = std::ranges::find(plan, s, &Loading::stage);
    if (before != plan.end()) loadings.push_back(*before);
  }
  return loadings;
}

// Returns the recorded state at the end of the last isotropic stage, or nullptr.
const io::Snapshot* last_compacted(const dem::Scenario& scenario, const io::RunFile& run, int dimension) {
  const std::vector<double>&stages = run.series.at("stage").values, &steps = run.series.at("step").values;
  for (std::size_t s = scenario.stages.size(); s-- > 0;) {
    if (!is_isotropic(scenario.stages[s], dimension)) continue;
    const auto end = std::find(stages.rbegin(), stages.rend(), static_cast<double>(s));
    if (end == stages.rend()) return nullptr;
    const auto row = static_cast<std::size_t>(stages.rend() - end) - 1;
    for (const io::Snapshot& state : run.snapshots)
      if (static_cast<double>(state.step) == steps[row]) return &state;
  }
  return nullptr;
}

void append(std::vector<Doubt>& to, std::vector<Doubt> more) {
  std::move(more.begin(), more.end(), std::back_inserter(to));
}

// Returns directions spread evenly over the sphere (Fibonacci's spiral).
std::vector<Vec3> directions() {
  constexpr int count = 300;
  std::vector<Vec3> all;
  for (int k = 0; k < count; ++k) {
    const double z = 1 - (2 * k + 1.0) / count, r = std::sqrt(1 - z * z), turn = k * 2.39996322972865332;
    all.emplace_back(r * std::cos(turn), r * std::sin(turn), z);
  }
  return all;
}

// Returns the number of soil grains whose centres are beyond the nodes of the geotextile in some direction.
std::size_t beyond(const io::Snapshot& state, const std::vector<Part>& part) {
  std::vector<bool> out(state.grains.size(), false);
  for (const Vec3& u : directions()) {
    double reach = -INFINITY;
    for (std::size_t i = 0; i < part.size(); ++i)
      if (part[i] == Part::node) reach = std::max(reach, u.dot(state.grains.position[i]));
    for (std::size_t i = 0; i < part.size(); ++i)
      if (part[i] == Part::soil && u.dot(state.grains.position[i]) > reach) out[i] = true;
  }
  return static_cast<std::size_t>(std::count(out.begin(), out.end(), true));
}

// Returns doubts about contact history that is lost or begins at zero, because the contact law changes.
std::vector<Doubt> history_doubts(const io::Snapshot& start, const dem::Scenario& scenario) {
  if (start.contacts.size() == 0) return {};
  const auto sweep = dem::make_contact_sweep(scenario.model);
  const auto fields = sweep->own_history();
  const std::vector<io::OwnHistory>& given = start.contacts.own;
  std::vector<Doubt> doubts;
  for (const io::OwnHistory& g : given)
    if (std::none_of(fields.begin(), fields.end(), [&](const auto& f) { return f.name == g.name; }))
      doubts.push_back(
          {"left-" + g.name, fmt::format("the input's contacts keep {}, which the law \"{}\" does not know: "
                                         "it is left out; give the law that made them to go on with it",
                                         g.name, scenario.model.materials.law())});
  for (const dem::HistoryField& f : fields)
    if (std::none_of(given.begin(), given.end(), [&](const auto& g) { return g.name == f.name; }))
      doubts.push_back({"new-" + std::string(f.name),
                        fmt::format("the input's contacts have no {}, which the law \"{}\" keeps: it begins at zero; "
                                    "start from a run of this law if its value matters",
                                    f.name, scenario.model.materials.law())});
  return doubts;
}

// Returns doubts that depend only on input and scenario, so that they are equal before and after a run.
std::vector<Doubt> of_scenario(const io::Snapshot& start, const dem::Scenario& scenario, const io::Snapshot& begun) {
  std::vector<Doubt> doubts = material_doubts(start, scenario.model, scenario.numerics.gravity);
  append(doubts, input_doubts(begun, scenario));
  append(doubts, stage_friction_doubts(scenario));
  append(doubts, clamp_doubts(scenario, begun));
  std::vector<Doubt> jumps = start_doubts(start, begun, scenario);
  // A jump at the start may cause later ones, so they are not reported.
  append(doubts, jumps.empty() ? jump_doubts(begun, scenario) : std::move(jumps));
  append(doubts, unit_doubts(begun, scenario));
  append(doubts, history_doubts(start, scenario));
  return doubts;
}

}  // namespace

std::vector<Doubt> cell_doubts(const io::Snapshot& state) {
  const int dimension = state.grains.dimension;
  const double narrowest = loaded_packing(dimension).cell;
  const Vec3 widths = cell_over_grain(state);
  for (int a = 0; a < dimension; ++a) {
    if (!state.cell.periodic[static_cast<std::size_t>(a)] || widths[a] >= narrowest) continue;
    return {
        {"cell-over-grain",
         fmt::format("the cell is {:.2g} diameters of the largest grain ({:.3g} m) wide along {}, below {:.0f}: its "
                     "periodicity affects the result; take {:.0f} times the grains, or leave out the largest",
                     widths[a], 2 * *std::max_element(state.grains.radius.begin(), state.grains.radius.end()), "xyz"[a],
                     narrowest, std::ceil(std::pow(narrowest / widths[a], dimension)))}};
  }
  return {};
}

std::vector<Doubt> open_cell_doubts(const io::Snapshot& state, std::string_view table) {
  if (is_periodic(state)) return {};
  std::vector<std::string> instead;
  if (is_reinforced(state)) instead.emplace_back("--table bag, or loading for a bag between plates");
  const std::array<bool, 3>& periodic = state.cell.periodic;
  // Power cells of an open assembly exist in 3D only.
  if (state.grains.dimension == 3 && std::none_of(periodic.begin(), periodic.end(), [](bool axis) { return axis; }))
    instead.emplace_back("--table volumes with a --box among the grains");
  const std::string planes = "displacement and force of named planes ";
  instead.push_back(planes + (table == "series" ? "alone (--columns)" : "from --table series"));
  return {{"open-cell",
           fmt::format("the cell is not periodic along all axes, so that it does not follow its grains: it has no "
                       "stress, strain or void ratio (nan); take {}",
                       fmt::join(instead, "; or "))}};
}

std::vector<Doubt> volume_doubts(const io::Snapshot& state, const std::vector<Volume>& volumes) {
  const std::size_t least = state.grains.dimension == 3 ? 64 : 16;
  const auto smallest =
      std::ranges::min_element(volumes, {}, [](const Volume& volume) { return volume.grains.size(); });
  if (smallest == volumes.end() || smallest->grains.size() >= least) return {};
  return {{"few-grains",
           fmt::format("grains in {}: {}, fewer than {}: its stress and void ratio are those of single grains; take "
                       "a larger volume",
                       smallest->name, smallest->grains.size(), least)}};
}

std::vector<Doubt> compaction_doubts(const io::Snapshot& state) {
  std::vector<Doubt> doubts;
  if (state.contacts.size() == 0) return doubts;
  const SoundLimits limits = loaded_packing(state.grains.dimension);
  const Coordination z = coordination(state);
  const double rattlers = rattler_share(state, z.rattlers);
  if (rattlers > limits.rattlers)
    doubts.push_back(
        {"rattlers", fmt::format("{:.0f} % of the grains bear nothing, more than {:.0f} %: void ratio and fabric count "
                                 "them all the same; take a denser packing, or leave out the finest grains",
                                 100 * rattlers, 100 * limits.rattlers)});
  if (z.all < limits.coordination)
    doubts.push_back(
        {"coordination", fmt::format("2 Nc/N is {:.2f} after an isotropic compression, below {}: the packing is hardly "
                                     "stable; take a denser one",
                                     z.all, limits.coordination)});
  if (const double obliquity = stress_obliquity(state); !(obliquity <= limits.obliquity))
    doubts.push_back(
        {"isotropy",
         fmt::format("q/p is {:.2g} in a state that should be isotropic, more than {:.2g}: a cell with right "
                     "angles keeps its shear stress; take more grains, or another seed",
                     obliquity, limits.obliquity)});
  return doubts;
}

std::vector<Doubt> bag_doubts(const io::Snapshot& state) {
  const std::vector<Part> part = parts(state);
  const auto soil = static_cast<std::size_t>(std::count(part.begin(), part.end(), Part::soil));
  if (state.yarns.size() == 0 || soil == 0) return {};
  std::vector<Doubt> doubts;
  // If most grains are beyond the geotextile, it is a sheet within soil, not a bag.
  if (const std::size_t out = beyond(state, part); out > 0 && 2 * out < soil)
    doubts.push_back(
        {"outside", fmt::format("{} of {} grains are beyond the geotextile: it does not confine them, but soil "
                                "stresses and void ratio count them; a finer mesh holds them",
                                out, soil)});
  if (const double z = coordination(state, those(part, Part::soil)).all; z < loosest_bag)
    doubts.push_back(
        {"preload",
         fmt::format("2 Nc/N of the soil in the bag is {:.2g}, below {:.0f}: it bears no load yet, and plates "
                     "close its gaps first; let filter-expand grow it ([growth]), or load it first",
                     z, loosest_bag)});
  return doubts;
}

std::vector<Doubt> mesh_doubts(const io::Snapshot& state) {
  if (state.yarns.size() == 0) return {};
  const std::vector<Part> part = parts(state);
  double node = INFINITY;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (part[i] == Part::node) node = std::min(node, state.grains.radius[i]);
  const std::vector<double>& yarns = state.yarns.rest_length;
  const double apart = std::reduce(yarns.begin(), yarns.end()) / static_cast<double>(yarns.size());
  // Diameter of the sphere that passes between four nodes at the corners of a square.
  const double opening = std::sqrt(2.0) * apart - 2 * node;
  std::size_t soil = 0, narrow = 0;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (part[i] == Part::soil) ++soil, narrow += 2 * state.grains.radius[i] < opening;
  if (narrow == 0) return {};
  return {{"mesh", fmt::format("openings between the nodes of the geotextile are some {:.3g} mm across, and {} of {} "
                               "grains are narrower: they may slip out as they grow; a finer mesh holds them "
                               "(geotextile_mesh.cells or spacing)",
                               1e3 * opening, narrow, soil)}};
}

double inertial_number(double rate, double diameter, double density, double pressure) {
  return rate * diameter * std::sqrt(density / pressure);
}

std::vector<Doubt> doubts_before(const io::Snapshot& start, const dem::Scenario& scenario, const io::Snapshot& begun) {
  std::vector<Doubt> doubts = cell_doubts(start);
  append(doubts, bag_doubts(start));
  append(doubts, inertia_doubts(start, scenario, planned(start, scenario)));
  append(doubts, of_scenario(start, scenario, begun));
  return doubts;
}

std::vector<Doubt> doubts_after(const io::Snapshot& start, const dem::Scenario& scenario, const io::RunFile& run) {
  std::vector<Doubt> doubts = cell_doubts(run.snapshots.back());
  // The preload is judged at the start, because a loose bag may bear much at the end.
  for (const Doubt& d : bag_doubts(start))
    if (d.key == "preload") doubts.push_back(d);
  for (const Doubt& d : bag_doubts(run.snapshots.back()))
    if (d.key == "outside") doubts.push_back(d);
  if (const io::Snapshot* compacted = last_compacted(scenario, run, start.grains.dimension))
    append(doubts, compaction_doubts(*compacted));
  append(doubts, overlap_doubts(run.snapshots.back()));
  append(doubts, inertia_doubts(start, scenario, carried_out(start, scenario, run.series)));
  append(doubts, idle_plate_doubts(scenario, run.series));
  append(doubts, no_contact_doubts(scenario, run.series));
  append(doubts, of_scenario(start, scenario, run.snapshots.front()));
  return doubts;
}

}  // namespace soilweave::analysis
