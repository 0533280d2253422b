// Forecast of a run from its input.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/forecast.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "core/memory.h"
#include "core/text/text.h"
#include "dem/engine/homogeneous.h"
#include "dem/run/prepare.h"
#include "files/files.h"

namespace soilweave::dem {
namespace {

constexpr double tried_seconds = 1;  // longest trial
// Steps until grains are at rest after a station, per e-fold of the unbalanced force and over the damping: measured on
// 60 to 1000 grains. Across more than 20 grains a wave takes longer.
constexpr double settling = 20;
// Steps until rest for each grain across a bag between plates, where waves reflect from soft ends. The thesis's bag of
// 69,000 grains in PP took 319,000 steps for 21 stations; the forecast is 245,000.
constexpr double swaying = 8;
// Frequency of a bag's swing over the affine one, as found from the drags that brought the bags of chapter 3 to rest.
constexpr double swing_share = 0.5;

using Seconds = std::chrono::duration<double>;

// A loading path without grains: strains and stresses are exactly at their goals.
class Walk {
 public:
  Walk(const Simulation& simulation, const Scenario& scenario, int dimension, std::size_t grains)
      : scenario_(scenario),
        dimension_(dimension),
        dt_(simulation.time_step()),
        stiffness_(simulation.measures().axial_stiffness),
        state_{dimension, simulation.measures().stress, Vec3::Zero()} {
    const double across = std::pow(static_cast<double>(grains), 1.0 / dimension);
    folds_ = -std::log(std::min(0.5, scenario.tolerances.unbalanced_force));
    waves_ = std::max(settling, (scenario.parts.empty() ? 1 : swaying) * across);
    swing_ = swing_share * slowest_swing(simulation);
  }

  Forecast::OfStage stage(const Stage& stage) {
    Forecast::OfStage of{stage.name, stage.path->stations(), 0, 0, stage.way_unbalanced_force > 0};
    state_.strain = Vec3::Zero();
    const double rest = steps_to_rest(stage);
    std::vector<DriveGoal> before;
    for (std::size_t station = 0; station < of.stations; ++station) {
      const std::vector<DriveGoal> drives = stage.path->drives(station);
      const double moving = std::max(way(stage.path->goals(station, state_)), way(drives, before));
      const double steps = std::min(moving + rest, static_cast<double>(scenario_.largest_station));
      of.steps += steps;
      of.waiting += std::max(0.0, steps - moving);
      before = drives;
    }
    return of;
  }

 private:
  // A swing of frequency w under a drag c decays as exp(-c t/2), or if it creeps as exp(-(c/2 - sqrt(c^2/4 - w^2)) t).
  double steps_to_rest(const Stage& stage) const {
    const double half = stage.critical_drag ? swing_ : 0.5 * stage.rest_drag;
    if (half > 0 && swing_ > 0)
      return folds_ / ((half - std::sqrt(std::max(0.0, half * half - swing_ * swing_))) * dt_);
    const double damping = stage.rest_damping.value_or(stage.damping.value_or(scenario_.numerics.damping));
    return waves_ * folds_ / std::max(0.05, damping);
  }

  // Returns the steps to a station, for the slowest axis.
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

  const Scenario& scenario_;
  int dimension_;
  double dt_;
  Vec3 stiffness_;
  PathState state_;
  double folds_ = 0, waves_ = 0, swing_ = 0;  // swing_: 1/s
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
  Walk walk(simulation, scenario, dimension, start.grains.size());
  std::size_t stations = 0;
  double steps = 0, waiting = 0;
  for (const Stage& stage : scenario.stages) {
    f.stages.push_back(walk.stage(stage));
    stations += f.stages.back().stations;
    steps += f.stages.back().steps;
    waiting += f.stages.back().waiting;
  }
  f.states = states_of(scenario, stations);
  f.cost = tried(simulation, scenario, dimension);
  f.cost.waiting = std::llround(waiting);
  const double scale = steps / static_cast<double>(f.cost.steps);
  f.cost.grains = start.grains.size();
  f.cost.stepping *= scale;
  f.cost.contact_steps = std::llround(static_cast<double>(f.cost.contact_steps) * scale);
  f.cost.steps = std::llround(steps);
  const auto writing = std::chrono::steady_clock::now();
  const io::Snapshot state = simulation.snapshot();
  const auto state_bytes = static_cast<double>(io::packing_bytes(state));
  const double write = Seconds(std::chrono::steady_clock::now() - writing).count();
  const auto states = static_cast<double>(f.states);
  // Every state is written when recorded, read back at the end, and written once more.
  f.cost.output = 3 * states * write;
  f.file_bytes = states * state_bytes + 300.0 * static_cast<double>(stations);
  f.memory_bytes = peak_memory() + (states + 1) * bytes_of(state) + f.file_bytes;
  return f;
}

std::string Forecast::text() const {
  std::string text = fmt::format(
      "{} grains, {:.0f} contacts, largest overlap {:.2g} of the radius, unbalanced force {:.2g}\n"
      "time step {:.4g} s, stability limit {:.4g} s\n",
      cost.grains, cost.contacts(), largest_overlap, unbalanced_force, time_step, stability_limit);
  for (const OfStage& stage : stages)
    text += fmt::format("stage \"{}\": {} station{}, about {:.2g} steps{}, {:.2g} of them waiting for rest\n",
                        stage.name, stage.stations, stage.stations == 1 ? "" : "s", stage.steps,
                        stage.paced ? " if as fast as given" : "", stage.waiting);
  text += fmt::format("{} states recorded, file about {}, memory about {}\n", states, bytes_text(file_bytes),
                      bytes_text(memory_bytes));
  return text + fmt::format("about {}: {}\n", time_text(cost.stepping + cost.output), cost.line());
}

}  // namespace soilweave::dem
