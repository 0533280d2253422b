// Carries out a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "dem/loading/pace.h"
#include "dem/loading/plate_ways.h"
#include "dem/run/checkpoint.h"
#include "dem/run/prepare.h"
#include "dem/run/record.h"
#include "dem/run/way.h"

namespace soilweave::dem {
namespace {

Numerics with_clamps(const Scenario& scenario, const io::Snapshot& start) {
  Numerics numerics = scenario.numerics;
  for (const PartSetting& p : scenario.parts)
    if (p.part.is_clamp) numerics.clamps.push_back(nodes_within(start, p.low, p.high));
  return numerics;
}

// Progress of a run.
struct RunProgress {
  std::size_t stage = 0, station = 0;  // station: the next one to reach
  bool begun = false;                  // whether the stage has begun
  std::int64_t first = 0;              // step at which the loading to the station began
  std::size_t done = 0;                // number of stations done, in all stages
  Vec3 start_of_stage = Vec3::Zero();  // strain at the start of the stage

  void archive(Archive& a) {
    a.whole("stage", stage), a.whole("station", station), a.whole("stage_begun", begun);
    a.item("station_first_step", first), a.whole("stations_done", done);
    a.item("start_of_stage", start_of_stage);
  }
};

class Runner {
 public:
  Runner(const io::Snapshot& start, const Scenario& scenario, const ProgressReport& report,
         const Safekeeping& safekeeping, const Observe& observe, std::optional<io::Checkpoint> last)
      : scenario_(scenario),
        report_(report),
        observe_(observe),
        dimension_(start.grains.dimension),
        model_(scenario.model),
        planes_material_(start.planes.material_id),
        keeper_(safekeeping, start.grains.size()),
        kept_(last ? Archive(std::move(last->numbers), keeper_.part().last().string()) : Archive()),
        simulation_(last ? Simulation(last->state, scenario.model, with_clamps(scenario, start), kept_)
                         : Simulation(start, scenario.model, with_clamps(scenario, start))),
        servo_(scenario.servo),
        rig_(parts_of(scenario)),
        pace_(start.grains.size(), dimension_) {
    result_.series = last ? std::move(last->series) : empty_series();
    result_.scenario = scenario.resolved;
    for (const Stage& stage : scenario.stages) total_ += stage.path->stations();
    if (last)
      go_on();
    else
      demand_stable(simulation_, scenario.numerics);
  }

  Outcome run() {
    if (result_.series.rows() == 0) {
      row(0);
      keep_state();
    }
    for (; at_.stage < scenario_.stages.size(); ++at_.stage, at_.station = 0, at_.begun = false) {
      const Stage& stage = scenario_.stages[at_.stage];
      if (!at_.begun) begin(stage);
      while (at_.station < stage.path->stations()) {
        travel(stage, at_.station);
        row(at_.stage);
        ++at_.done;
        const bool last_of_stage = ++at_.station == stage.path->stations();
        at_.first = simulation_.steps();
        if (last_of_stage || wants_snapshot(stage, at_.station - 1)) keep_state();
      }
    }
    Cost cost = clock_.cost(simulation_, keeper_.seconds());
    cost.waiting = way_.waited(), cost.waiting_for_energy = way_.waited_for_energy();
    result_.work = {cost.steps, cost.contact_steps};
    if (keeper_.keeps()) result_.snapshots = keeper_.part().recorded();
    return {std::move(result_), cost};
  }

  io::Snapshot left() const { return simulation_.snapshot(); }

 private:
  void go_on() {
    servo_.archive(kept_), rig_.archive(kept_), pace_.archive(kept_), way_.archive(kept_);
    at_.archive(kept_);
    clock_.archive(simulation_, keeper_.seconds(), kept_);
    demand_place();
    for (std::size_t n = 0; n < at_.stage + (at_.begun ? 1 : 0); ++n) apply(scenario_.stages[n]);
  }

  void demand_place() const {
    const std::vector<Stage>& stages = scenario_.stages;
    const bool among = at_.stage < stages.size();
    demand_kept(among || (at_.stage == stages.size() && !at_.begun), keeper_.part().last(), "stage");
    demand_kept(at_.station <= (among ? stages[at_.stage].path->stations() : 0), keeper_.part().last(), "station");
    demand_kept(at_.done <= total_, keeper_.part().last(), "number of stations done");
    demand_kept(at_.first >= 0 && at_.first <= simulation_.steps(), keeper_.part().last(), "first step");
    const std::vector<io::Column>&found = result_.series.columns, wanted = empty_series().columns;
    bool same_table = found.size() >= wanted.size() && std::equal(wanted.begin(), wanted.end(), found.begin(),
                                                                  [](auto& a, auto& b) { return a.name == b.name; });
    for (const EnergyColumn& further : simulation_.energies().further_columns())
      same_table = same_table && result_.series.find(further.name);
    demand_kept(same_table && result_.series.rows() > 0, keeper_.part().last(), "table");
  }

  io::Checkpoint checkpoint() {
    return checkpoint_of(simulation_, clock_, keeper_.seconds(), result_.series, servo_, rig_, pace_, way_, at_);
  }

  // Applies the friction angles of a stage. Planes keep their own angle, once given, under a later one of all
  // materials.
  void apply(const Stage& stage) {
    if (!stage.friction && !stage.plate_friction) return;
    if (stage.friction) model_ = with_friction(model_, *stage.friction);
    if (stage.plate_friction) plate_friction_ = stage.plate_friction;
    if (plate_friction_) model_ = with_friction_against(model_, *plate_friction_, planes_material_);
    simulation_.set_model(model_);
  }

  // Returns whether the reached station gets a snapshot.
  bool wants_snapshot(const Stage& stage, std::size_t station) const {
    const SnapshotRule& rule = scenario_.snapshots;
    if (rule.which != SnapshotRule::Which::list) return rule.which == SnapshotRule::Which::stations;
    const double nominal = stage.path->nominal_strain(station);
    if (!std::isnan(nominal)) return is_at(rule.strains, nominal);
    const int axis = dimension_ - 1;
    const AxisGoal goal = goals_of(stage, station)[static_cast<std::size_t>(axis)];
    const double strain = simulation_.strain()[axis];
    return is_at(rule.strains, strain) ||
           (goal.kind == AxisGoal::Kind::strain && is_at(rule.strains, strain - at_.start_of_stage[axis]));
  }

  void begin(const Stage& stage) {
    apply(stage);
    if (stage.reset_strain) {
      simulation_.set_reference();
      if (at_.stage > 0) row(at_.stage);  // strains start at zero in the table too
    }
    at_.start_of_stage = simulation_.strain();
    rig_.begin_stage();
    pace_.begin_stage();
    way_.begin_stage();
    at_.first = simulation_.steps();
    at_.begun = true;
  }

  // Returns the goals with strains since the simulation's reference; a path counts them from the start of its stage.
  AxisGoals goals_of(const Stage& stage, std::size_t station) const {
    AxisGoals goals = stage.path->goals(
        station, {dimension_, simulation_.measures().stress, simulation_.strain() - at_.start_of_stage});
    for (int a = 0; a < 3; ++a) {
      AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      if (goal.kind == AxisGoal::Kind::strain) goal.value += at_.start_of_stage[a];
    }
    return goals;
  }

  void travel(const Stage& stage, std::size_t station) {
    const std::vector<DriveGoal> drives = stage.path->drives(station);
    const double on_the_way = stage.damping.value_or(scenario_.numerics.damping);
    for (;;) {
      const AxisGoals goals = goals_of(stage, station);
      const bool waiting = waits(goals, drives);
      const double damping = stage.rest_damping && waiting ? *stage.rest_damping : on_the_way;
      simulation_.set_damping(damping);
      const double pace = waiting ? 1 : pace_on_the_way(stage);
      servo_.drive(goals, dimension_, simulation_, pace);
      rig_.drive(drives, damping, simulation_, pace);
      way_.before_step(stage, waiting, drives, pace, rig_, simulation_);
      simulation_.step();
      way_.after_step(simulation_);
      if (settled(goals, drives)) break;
      const std::int64_t steps = simulation_.steps() - at_.first;
      if (steps % report_interval == 0) tell(stage, station);
      if (steps >= scenario_.largest_station) unreachable(stage, station, goals, drives);
      keeper_.after_step([this] { return checkpoint(); });
    }
    tell(stage, station);
  }

  // Returns the present loading speed as a share of the prescribed speeds and rates.
  double pace_on_the_way(const Stage& stage) {
    if (stage.way_unbalanced_force == 0) return 1;
    if (simulation_.steps() % look_interval == 0)
      pace_.follow(simulation_.unbalanced_force(), stage.way_unbalanced_force, look_interval);
    return pace_.share();
  }

  // Returns whether all prescribed motion is complete, so that the station only waits for rest.
  bool waits(const AxisGoals& goals, const std::vector<DriveGoal>& drives) const {
    return rig_.moved(drives) && Servo::strained(goals, dimension_, simulation_);
  }

  bool settled(const AxisGoals& goals, const std::vector<DriveGoal>& drives) {
    if (rig_.any()) {
      if (simulation_.steps() % look_interval != 0) return false;
      if (!rig_.arrived(drives, scenario_.tolerances.stress, simulation_)) return false;
    }
    // The kinetic energy is checked last, so that steps which wait for it alone can be counted.
    if (!servo_settled(goals)) return false;
    if (still()) return true;
    way_.wait_for_energy(rig_.any() ? look_interval : 1);
    return false;
  }

  bool servo_settled(const AxisGoals& goals) const {
    return Servo::settled(goals, dimension_, scenario_.tolerances, simulation_);
  }

  bool still() const {
    return std::isinf(scenario_.tolerances.kinetic_energy) ||
           simulation_.kinetic_energy_of_acted_on() <= scenario_.tolerances.kinetic_energy;
  }

  void tell(const Stage& stage, std::size_t station) const {
    if (!report_) return;
    report_(static_cast<double>(at_.done) / static_cast<double>(total_),
            fmt::format("{} {}/{}, step {}, {}{}, unbalanced {:.1e}{}", stage.name, station + 1, stage.path->stations(),
                        simulation_.steps(), state(), pace(stage), simulation_.unbalanced_force(), motion()));
  }

  std::string motion() const {
    if (std::isinf(scenario_.tolerances.kinetic_energy)) return {};
    return fmt::format(", kinetic energy {:.1e} J", simulation_.kinetic_energy_of_acted_on());
  }

  std::string energy_and_limit() const {
    if (std::isinf(scenario_.tolerances.kinetic_energy)) return {};
    return fmt::format(", kinetic energy {:.2e} of {:.2e} J", simulation_.kinetic_energy_of_acted_on(),
                       scenario_.tolerances.kinetic_energy);
  }

  std::string pace(const Stage& stage) const {
    if (stage.way_unbalanced_force == 0) return {};
    return fmt::format(", at {:.2g} % of its speed", 100 * pace_.share());
  }

  // Between plates, stress and void ratio of the cell say nothing about the grains.
  std::string state() const {
    if (rig_.any()) return rig_.text(simulation_);
    return fmt::format("p {:.4g} Pa, e {:.4f}", mean(simulation_.measures().stress, dimension_),
                       simulation_.void_ratio());
  }

  [[noreturn]] void unreachable(const Stage& stage, std::size_t station, const AxisGoals& goals,
                                const std::vector<DriveGoal>& drives) const {
    std::string where;
    for (int a = 0; a < dimension_; ++a) {
      const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      const bool stress = goal.kind == AxisGoal::Kind::stress;
      where += fmt::format("{}{} {:.6g} of {:.6g}{}", a ? ", " : "", "xyz"[a],
                           stress ? simulation_.measures().stress(a, a) : simulation_.strain()[a], goal.value,
                           stress ? " Pa" : "");
    }
    throw TargetNotReached(fmt::format(
        "stage \"{}\", station {}: not settled after {} steps, at step {} ({}; unbalanced force {:.2e} of "
        "{:.2e}{}): {}",
        stage.name, station + 1, scenario_.largest_station, simulation_.steps(), where, simulation_.unbalanced_force(),
        scenario_.tolerances.unbalanced_force, energy_and_limit(), likely_cause(stage, goals, drives)));
  }

  // Names the axis that is farthest from its strain goal, with a remedy; empty if all strains are reached.
  std::string late_strain(const Stage& stage, const AxisGoals& goals) const {
    if (Servo::strained(goals, dimension_, simulation_)) return {};
    const Vec3 strain = simulation_.strain();
    int late = 0;
    double most = 0;
    for (int a = 0; a < dimension_; ++a) {
      const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      const double left = goal.kind == AxisGoal::Kind::strain ? std::abs(goal.value - strain[a]) : 0;
      if (left > most) most = left, late = a;
    }
    return fmt::format("axis {} is still {:.3g} away from its strain: raise equilibrium.steps{} or the rate",
                       "xyz"[late], most, stage.way_unbalanced_force > 0 ? ", way_unbalanced_force" : "");
  }

  std::string likely_cause(const Stage& stage, const AxisGoals& goals, const std::vector<DriveGoal>& drives) const {
    const Measures& m = simulation_.measures();
    const Mat3 gradient = simulation_.snapshot().cell.velocity_gradient;
    for (int a = 0; a < dimension_; ++a) {
      const AxisGoal& goal = goals[static_cast<std::size_t>(a)];
      if (goal.kind != AxisGoal::Kind::stress) continue;
      if (std::abs(goal.value - m.stress(a, a)) <= scenario_.tolerances.stress * std::abs(goal.value)) continue;
      const char* held = std::abs(gradient(a, a)) > 0.999 * goal.max_rate ? "raise max_rate or equilibrium.steps" : "";
      if (m.axial_stiffness[a] == 0)
        return fmt::format("axis {} meets no resistance, the grains do not touch yet: {}", "xyz"[a],
                           *held ? held : "raise equilibrium.steps, or start from a denser packing");
      if (*held) return fmt::format("axis {} is held back by its largest rate: {}", "xyz"[a], held);
    }
    if (std::string late = late_strain(stage, goals); !late.empty()) return late;
    if (std::string late = rig_.late_part(drives, scenario_.tolerances.stress, simulation_); !late.empty()) return late;
    if (simulation_.unbalanced_force() > scenario_.tolerances.unbalanced_force &&
        stage.damping.value_or(scenario_.numerics.damping) < 0.05)
      return fmt::format("the grains do not come to rest: raise {}",
                         stage.damping ? "the stage's damping" : "numerics.damping");
    if (servo_settled(goals) && !still())
      return "only the kinetic energy is above its limit: raise equilibrium.kinetic_energy or equilibrium.steps, or "
             "give the stage a rest_drag";
    return "raise equilibrium.steps, loosen the tolerances or lower the rate";
  }

  void row(std::size_t stage) {
    keeper_.timed([this, stage] { put_row(stage, simulation_.snapshot()); });
  }
  void put_row(std::size_t stage, const io::Snapshot& now) {
    const Energies energies = simulation_.energies();
    record(simulation_, now, energies, static_cast<int>(stage), result_.series);
    rig_.record(simulation_, result_.series);
    append(result_.series, "steps_waiting", "1", "time steps in which stations waited for rest, since the start",
           static_cast<double>(way_.waited()));
    for (const EnergyColumn& c : energies.further_columns())
      append(result_.series, std::string(c.name), "J", std::string(c.sentence), c.value);
    if (observe_) observe_(now, result_.series);
    if (result_.series.rows() == 1) demand_distinct_columns(result_.series);
  }

  void keep_state() {
    if (keeper_.keeps())
      keeper_.keep([this] { return checkpoint(); }, true);
    else
      result_.snapshots.push_back(simulation_.snapshot());
  }

  const Scenario& scenario_;
  const ProgressReport& report_;
  const Observe& observe_;
  int dimension_;
  Model model_;
  std::vector<std::int32_t> planes_material_;
  std::optional<double> plate_friction_;  // latest friction angle of planes given by a stage, rad
  Keeper keeper_;
  Archive kept_;
  Simulation simulation_;
  Servo servo_;
  Rig rig_;
  Pace pace_;
  Way way_;
  RunProgress at_;
  io::RunFile result_;
  std::size_t total_ = 0;
  CostClock clock_;
};

}  // namespace

void demand_apart(const io::Snapshot& state, const Scenario& scenario) {
  PlateWays ways(state, parts_of(scenario), scenario.numerics.limits.overlap);
  for (const Stage& stage : scenario.stages)
    if (const std::string why = ways.follow(*stage.path); !why.empty())
      throw DataError(fmt::format("stage \"{}\" {}", stage.name, why));
}

Outcome run(const io::Snapshot& start, const Scenario& scenario, const ProgressReport& report,
            const Safekeeping& safekeeping, const Observe& observe) {
  io::Part* part = safekeeping.part;
  Runner runner(start, scenario, report, safekeeping, observe, part ? part->take_last() : std::nullopt);
  return carry_out<true>(runner, part);
}

}  // namespace soilweave::dem
