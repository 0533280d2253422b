// A scenario carried out.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "core/error.h"
#include "dem/bodies.h"
#include "dem/record.h"

namespace soilweave::dem {
namespace {

// Steps between two looks at whether a station has settled, and between two reports.
constexpr std::int64_t report_interval = 256;

// Uniform in [-1, 1) from the engine's bits alone: standard distributions differ between libraries.
double symmetric_uniform(std::mt19937_64& engine) {
  return 2.0 * static_cast<double>(engine() >> 11) * 0x1.0p-53 - 1.0;
}

bool wants_snapshot(const SnapshotRule& rule, const Simulation& simulation, int axis) {
  if (rule.which == SnapshotRule::Which::stations) return true;
  if (rule.which == SnapshotRule::Which::ends) return false;
  const double strain = simulation.strain()[axis];
  return std::any_of(rule.strains.begin(), rule.strains.end(), [&](double s) { return std::abs(s - strain) < 1e-7; });
}

void demand_periodic(const io::Snapshot& packing, const Scenario& scenario) {
  const PathState unloaded{packing.grains.dimension, Mat3::Zero(), Vec3::Zero()};
  for (const Stage& stage : scenario.stages)
    for (std::size_t station = 0; station < stage.path->stations(); ++station) {
      const AxisGoals goals = stage.path->goals(station, unloaded);
      for (std::size_t a = 0; a < static_cast<std::size_t>(unloaded.dimension); ++a) {
        const bool held = goals[a].kind == AxisGoal::Kind::strain && goals[a].value == 0;
        if (!packing.cell.periodic[a] && !held)
          throw DataError(
              fmt::format("stage \"{}\" loads axis {}, along which the packing's cell is not periodic: give the "
                          "packing a periodic cell, or hold the axis by a stage of path \"free\"",
                          stage.name, "xyz"[a]));
      }
    }
}

class Runner {
 public:
  Runner(const io::Snapshot& start, const Scenario& scenario, const Report& report)
      : scenario_(scenario),
        report_(report),
        dimension_(start.grains.dimension),
        model_(scenario.model),
        simulation_(start, scenario.model, scenario.numerics),
        servo_(scenario.servo) {
    result_.series = empty_series();
    result_.scenario = scenario.resolved;
    for (const Stage& stage : scenario.stages) total_ += stage.path->stations();
  }

  io::RunFile run() {
    keep(0, true);
    for (std::size_t n = 0; n < scenario_.stages.size(); ++n) {
      const Stage& stage = scenario_.stages[n];
      begin(stage, n);
      for (std::size_t station = 0; station < stage.path->stations(); ++station, ++done_) {
        travel(stage, station);
        const bool last_of_stage = station + 1 == stage.path->stations();
        keep(static_cast<int>(n), last_of_stage || wants_snapshot(scenario_.snapshots, simulation_, dimension_ - 1));
      }
    }
    return std::move(result_);
  }

 private:
  void begin(const Stage& stage, std::size_t n) {
    if (stage.friction) {
      model_ = with_friction(model_, *stage.friction);
      simulation_.set_model(model_);
    }
    simulation_.set_damping(stage.damping.value_or(scenario_.numerics.damping));
    if (stage.reset_strain) {
      simulation_.set_reference();
      if (n > 0) keep(static_cast<int>(n), false);  // strains start at zero in the table, too
    }
    start_of_stage_ = simulation_.strain();
  }

  // A path counts strains from the start of its stage, the simulation from its reference.
  AxisGoals goals_of(const Stage& stage, std::size_t station) const {
    AxisGoals goals =
        stage.path->goals(station, {dimension_, simulation_.measures().stress, simulation_.strain() - start_of_stage_});
    for (int a = 0; a < 3; ++a) {
      AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      if (goal.kind == AxisGoal::Kind::strain) goal.value += start_of_stage_[a];
    }
    return goals;
  }

  void travel(const Stage& stage, std::size_t station) {
    const std::int64_t first = simulation_.steps();
    for (;;) {
      const AxisGoals goals = goals_of(stage, station);
      servo_.drive(goals, dimension_, simulation_);
      simulation_.step();
      if (Servo::settled(goals, dimension_, scenario_.tolerances, simulation_)) break;
      const std::int64_t steps = simulation_.steps() - first;
      if (steps % report_interval == 0) tell(stage, station);
      if (steps >= scenario_.largest_station) unreachable(stage, station, goals);
    }
    tell(stage, station);
  }

  void tell(const Stage& stage, std::size_t station) const {
    if (!report_) return;
    const Measures& m = simulation_.measures();
    report_(static_cast<double>(done_) / static_cast<double>(total_),
            fmt::format("{} {}/{}, step {}, p {:.4g} Pa, e {:.4f}, unbalanced {:.1e}", stage.name, station + 1,
                        stage.path->stations(), simulation_.steps(), mean(m.stress, dimension_),
                        simulation_.void_ratio(), m.unbalanced_force));
  }

  [[noreturn]] void unreachable(const Stage& stage, std::size_t station, const AxisGoals& goals) const {
    std::string where;
    for (int a = 0; a < dimension_; ++a) {
      const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      const bool stress = goal.kind == AxisGoal::Kind::stress;
      where += fmt::format("{}{} {:.6g} of {:.6g}{}", a ? ", " : "", "xyz"[a],
                           stress ? simulation_.measures().stress(a, a) : simulation_.strain()[a], goal.value,
                           stress ? " Pa" : "");
    }
    throw TargetNotReached(fmt::format(
        "stage \"{}\", station {}: not settled after {} steps ({}; unbalanced force {:.2e} of {:.2e}): raise "
        "equilibrium.steps, loosen the tolerances or lower the rate",
        stage.name, station + 1, scenario_.largest_station, where, simulation_.measures().unbalanced_force,
        scenario_.tolerances.unbalanced_force));
  }

  void keep(int stage, bool snapshot) {
    record(simulation_, dimension_, stage, result_.series);
    if (snapshot) result_.snapshots.push_back(simulation_.snapshot());
  }

  const Scenario& scenario_;
  const Report& report_;
  int dimension_;
  Model model_;
  Simulation simulation_;
  Servo servo_;
  Vec3 start_of_stage_ = Vec3::Zero();  // strain
  io::RunFile result_;
  std::size_t done_ = 0, total_ = 0;
};

}  // namespace

io::Snapshot prepare(const io::Snapshot& packing, const Scenario& scenario) {
  demand_periodic(packing, scenario);
  io::Snapshot state = packing;
  const auto materials = std::visit([](const auto& m) { return m.size(); }, scenario.model.materials);
  for (const std::int32_t id : state.grains.material_id)
    if (id < 0 || static_cast<std::size_t>(id) >= materials)
      throw DataError(fmt::format(
          "the packing has grains of material {}, the scenario describes {}: add [[material]] tables", id, materials));
  if (scenario.density > 0) {
    for (std::size_t i = 0; i < state.grains.size(); ++i) {
      state.grains.mass[i] = scenario.density * grain_volume(state.grains.dimension, state.grains.radius[i]);
    }
  }
  if (!scenario.planes.point.empty()) state.planes = scenario.planes;
  state.step = 0;
  state.time = 0;
  return state;
}

io::Snapshot perturbed(const io::Snapshot& packing, double fraction, std::uint64_t seed) {
  io::Snapshot twin = packing;
  std::mt19937_64 engine(seed);
  for (std::size_t i = 0; i < twin.grains.size(); ++i)
    for (int a = 0; a < twin.grains.dimension; ++a)
      twin.grains.position[i][a] += fraction * twin.grains.radius[i] * symmetric_uniform(engine);
  return twin;
}

io::RunFile run(const io::Snapshot& start, const Scenario& scenario, const Report& report) {
  return Runner(start, scenario, report).run();
}

}  // namespace soilweave::dem
