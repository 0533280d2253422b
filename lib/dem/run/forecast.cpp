// Forecast of a run from its input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>

#include "core/memory.h"
#include "core/text/text.h"
#include "dem/run/prepare.h"
#include "dem/run/rest.h"
#include "files/files.h"

namespace soilweave::dem {
namespace {

constexpr double tried_seconds = 1;  // longest trial
// Prescribed speed over the mean speed of a loading that slows down with the unbalanced force: 2 to 4.4 for the bags of
// chapter 3.
constexpr double slowed = 3;

using Seconds = std::chrono::duration<double>;

// Goes through the loading paths without grains, as if strains and stresses met their goals exactly.
class Walk {
 public:
  Walk(const Simulation& simulation, const Scenario& scenario, int dimension)
      : simulation_(simulation),
        scenario_(scenario),
        rest_(simulation, scenario),
        rig_(planes_of(scenario)),
        dimension_(dimension),
        dt_(simulation.time_step()),
        stiffness_(simulation.measures().axial_stiffness),
        state_{dimension, simulation.measures().stress, Vec3::Zero()} {}

  void learn(const Simulation& tried) { rest_.learn(tried); }

  Forecast::OfStage stage(const Stage& stage) {
    Forecast::OfStage of;
    of.name = stage.name, of.stations = stage.path->stations(), of.paced = stage.way_unbalanced_force > 0;
    state_.strain = Vec3::Zero();
    const auto most = static_cast<double>(scenario_.largest_station);
    std::vector<DriveGoal> before;
    for (std::size_t station = 0; station < of.stations; ++station) {
      const std::vector<DriveGoal> drives = stage.path->drives(station);
      const AxisGoals goals = stage.path->goals(station, state_);
      const Arrival arrival = arrival_at(goals, drives);
      const double fastest = std::max(way(goals), way(drives, before)) / rest_.step_share(arrival);
      const double moving = of.paced ? slowed * fastest : fastest, waiting = rest_.steps(stage, arrival);
      const double steps = std::min(moving + waiting, most), fewest = rest_.fewest(arrival, fastest, waiting);
      of.longest = std::max(of.longest, moving + waiting), of.least_longest = std::max(of.least_longest, fewest);
      of.steps += steps;
      of.waiting += std::max(0.0, steps - moving);
      of.fewest += std::min(fewest, most);
      of.most += std::min(rest_.most(arrival, of.paced ? 2 * moving : moving, waiting), most);
      before = drives;
      first_ = false;
    }
    return of;
  }

 private:
  // Returns the driven planes. A forecast leaves clamps out, because it does not know their positions.
  static std::vector<RigPart> planes_of(const Scenario& scenario) {
    std::vector<RigPart> parts;
    for (const PartSetting& p : scenario.parts)
      if (!p.part.is_clamp) parts.push_back(p.part);
    return parts;
  }

  // Returns the data of the loading to a station. Goals that are reached already add nothing.
  Arrival arrival_at(const AxisGoals& goals, const std::vector<DriveGoal>& drives) {
    Arrival arrival;
    arrival.first = first_;
    int stresses = 0;
    double sum = 0;
    for (int a = 0; a < dimension_; ++a) {
      const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      const bool stress = goal.kind == AxisGoal::Kind::stress;
      if (stress) sum += goal.value, ++stresses;
      const double gap = goal.value - (stress ? state_.stress(a, a) : state_.strain[a]);
      const bool moves = std::abs(gap) > (stress ? scenario_.tolerances.stress * std::abs(goal.value) : 0);
      if (moves && !stress) arrival.sheared = true;
      if (moves) arrival.gradient(a, a) = goal.max_rate;
    }
    std::vector<DriveGoal> moved;
    for (const DriveGoal& goal : drives) {
      const bool load = goal.kind == DriveGoal::Kind::load;
      double& held = loads_[goal.part];
      if (load && held != goal.value) arrival.new_load = true, held = goal.value;
      if (load) load_pressure_ = rest_.pressure_of(goal.value, goal.direction);
      if (!load) arrival.sheared = true;
      if (!load && is_plane(goal.part)) moved.push_back(goal);
    }
    // If only strains are prescribed, the latest known stress is the best guess.
    const double present = scenario_.parts.empty() ? std::max(0.0, mean(state_.stress, dimension_)) : load_pressure_;
    arrival.pressure = stresses > 0 ? sum / stresses : present;
    arrival.gradient += rig_.gradient_of_way(moved, 1, Mat3::Zero(), simulation_);
    return arrival;
  }

  bool is_plane(const std::string& name) const {
    return std::any_of(scenario_.parts.begin(), scenario_.parts.end(),
                       [&](const PartSetting& p) { return p.part.name == name && !p.part.is_clamp; });
  }

  // Returns the steps that the slowest axis takes to a station, and sets the state to the goals.
  double way(const AxisGoals& goals) {
    double slowest = 0;
    for (int a = 0; a < dimension_; ++a) {
      const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      const bool stress = goal.kind == AxisGoal::Kind::stress;
      double& now = stress ? state_.stress(a, a) : state_.strain[a];
      const double strain =
          stress ? (goal.value - now) / std::max(stiffness_[a], std::abs(goal.value)) : goal.value - now;
      if (goal.max_rate > 0) slowest = std::max(slowest, std::abs(strain) / (goal.max_rate * dt_));
      now = goal.value;
    }
    return slowest;
  }

  // Returns the steps of the slowest part between two displacements. Motion under a load is not foreseen.
  double way(const std::vector<DriveGoal>& drives, const std::vector<DriveGoal>& before) const {
    double slowest = 0;
    for (std::size_t k = 0; k < drives.size(); ++k) {
      if (drives[k].kind != DriveGoal::Kind::displacement) continue;
      const double from = k < before.size() ? before[k].value : 0;
      slowest = std::max(slowest, std::abs(drives[k].value - from) / (drives[k].speed * dt_));
    }
    return slowest;
  }

  const Simulation& simulation_;
  const Scenario& scenario_;
  RestEstimate rest_;
  Rig rig_;  // at rest
  int dimension_;
  double dt_;
  Vec3 stiffness_;
  PathState state_;
  std::map<std::string, double> loads_;  // N, by part
  double load_pressure_ = 0;             // Pa, of the latest load
  bool first_ = true;                    // true: no station has been reached
};

std::size_t states_of(const Scenario& scenario, std::size_t stations) {
  if (scenario.snapshots.which == SnapshotRule::Which::stations) return 1 + stations;
  return 1 + scenario.stages.size() + scenario.snapshots.strains.size();
}

// Returns the memory of a state while it is written or read.
double bytes_of(const io::Snapshot& s) {
  constexpr double of_grain = 5 * sizeof(Vec3) + sizeof(Vec4) + 4 * sizeof(double);
  constexpr double of_contact = 5 * sizeof(Vec3) + 4 * sizeof(double);
  return of_grain * static_cast<double>(s.grains.size()) + of_contact * static_cast<double>(s.contacts.size());
}

// Times the first steps of the run.
Cost tried(Simulation& simulation, const Scenario& scenario, int dimension) {
  Servo servo(scenario.servo);
  const Stage& first = scenario.stages.front();
  simulation.set_damping(first.damping.value_or(scenario.numerics.damping));
  if (first.friction) simulation.set_model(with_friction(scenario.model, *first.friction));
  if (first.reset_strain) simulation.set_reference();
  const Trial trial = try_steps(tried_seconds, [&] {
    servo.drive(first.path->goals(0, {dimension, simulation.measures().stress, simulation.strain()}), dimension,
                simulation);
    simulation.step();
  });
  Cost cost;
  cost.steps = trial.steps, cost.stepping = trial.seconds;
  cost.contact_steps = simulation.contact_steps();
  cost.times = simulation.step_times();
  return cost;
}

}  // namespace

Forecast forecast(const io::Snapshot& start, const Scenario& scenario) {
  const int dimension = start.grains.dimension;
  Simulation simulation(start, scenario.model, scenario.numerics);
  demand_stable(simulation, scenario.numerics);
  Forecast f;
  f.time_step = simulation.time_step();
  f.stability_limit = simulation.stability_limit();
  f.unbalanced_force = simulation.unbalanced_force();
  f.largest_overlap = simulation.largest_overlap();
  f.largest_station = scenario.largest_station;
  const auto writing = std::chrono::steady_clock::now();
  f.begun = simulation.snapshot();
  const auto state_bytes = static_cast<double>(io::packing_bytes(f.begun));
  const double write = Seconds(std::chrono::steady_clock::now() - writing).count();
  Walk walk(simulation, scenario, dimension);
  f.cost = tried(simulation, scenario, dimension);
  walk.learn(simulation);
  std::size_t stations = 0;
  double steps = 0, waiting = 0, fewest = 0, most = 0;
  for (const Stage& stage : scenario.stages) {
    f.stages.push_back(walk.stage(stage));
    stations += f.stages.back().stations;
    steps += f.stages.back().steps;
    waiting += f.stages.back().waiting;
    fewest += f.stages.back().fewest, most += f.stages.back().most;
  }
  f.states = states_of(scenario, stations);
  f.cost.waiting = std::llround(waiting);
  const double scale = steps / static_cast<double>(f.cost.steps);
  f.cost.grains = start.grains.size();
  f.cost.stepping *= scale;
  f.cost.contact_steps = std::llround(static_cast<double>(f.cost.contact_steps) * scale);
  f.cost.steps = std::llround(steps);
  const auto states = static_cast<double>(f.states);
  // Every state is written when recorded, read back at the end, and written once more.
  f.cost.output = 3 * states * write;
  f.least_time = f.cost.stepping * fewest / steps + f.cost.output;
  f.greatest_time = f.cost.stepping * most / steps + f.cost.output;
  f.file_bytes = states * state_bytes + 300.0 * static_cast<double>(stations);
  f.memory_bytes = peak_memory() + (states + 1) * bytes_of(f.begun) + f.file_bytes;
  return f;
}

std::string Forecast::text() const {
  std::string text = fmt::format(
      "{} grains, {:.0f} contacts, largest overlap {:.2g} of the radius, unbalanced force {:.2g}\n"
      "time step {:.4g} s, stability limit {:.4g} s\n",
      cost.grains, cost.contacts(), largest_overlap, unbalanced_force, time_step, stability_limit);
  for (const OfStage& stage : stages) {
    text += fmt::format(
        "stage \"{}\": {} station{}, about {:.2g} steps ({:.2g} to {:.2g}{}), {:.2g} of them waiting "
        "for rest\n",
        stage.name, stage.stations, stage.stations == 1 ? "" : "s", stage.steps, stage.fewest, stage.most,
        stage.paced ? ", slowed down on the way" : "", stage.waiting);
    const auto limit = static_cast<double>(largest_station);
    if (stage.longest > limit)
      text += fmt::format(
          "stage \"{}\": equilibrium.steps = {} {} end the run: a station takes about {:.2g} steps; raise it, or load "
          "faster\n",
          stage.name, largest_station, stage.least_longest > limit ? "would" : "may", stage.longest);
  }
  text += fmt::format("{} states recorded, file about {}, memory about {}\n", states, bytes_text(file_bytes),
                      bytes_text(memory_bytes));
  return text + fmt::format("about {} ({} to {}): {}\n", time_text(cost.stepping + cost.output), time_text(least_time),
                            time_text(greatest_time), cost.line());
}

}  // namespace soilweave::dem
