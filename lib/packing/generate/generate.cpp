// From a cloud to a packing with a given void ratio at a given pressure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/generate.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"
#include "core/text/units.h"
#include "dem/engine/described.h"
#include "dem/run/checkpoint.h"
#include "dem/run/prepare.h"
#include "dem/run/scenario.h"
#include "packing/generate/ahead.h"
#include "packing/generate/apart.h"
#include "packing/generate/compaction_progress.h"

namespace soilweave::packing {
namespace {

// Greatest diameter of a grain over the width of the cell. A guard stops the run at one half.
constexpr double widest_grain = 0.495;
constexpr std::int64_t room_interval = 8;  // steps
// Factor on the tolerance while friction is lowered: these equilibria need not be as good as the last one.
constexpr double coarse_equilibrium = 10;

// Lead: difference in void ratio at which friction is restored before the target. First and largest lead after a
// compression at low friction (slippery()).
constexpr double first_lead = 0.02, largest_lead = 0.05;
// Share of full friction above which the next attempt takes full friction.
constexpr double nearly_full = 0.8;

// Number of tolerances within which a void ratio counts as held at rest.
constexpr double tolerances_held = 4;
// A new attempt begins at a common multiple of all intervals at which a simulation checks itself.
constexpr std::int64_t first_step_multiple = 512;

class Compaction {
 public:
  Compaction(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
             const ProgressReport& report, const dem::Safekeeping& safekeeping, std::optional<io::Checkpoint> last)
      : cloud_(cloud),
        model_(model),
        numerics_(numerics),
        recipe_(recipe),
        report_(report),
        dimension_(cloud.grains.dimension),
        largest_(2 * *std::max_element(cloud.grains.radius.begin(), cloud.grains.radius.end())),
        keeper_(safekeeping, cloud.grains.size()),
        kept_(last ? Archive(std::move(last->numbers), keeper_.part().last().string()) : Archive()),
        simulation_(last ? dem::Simulation(last->state, model, numerics, kept_)
                         : dem::Simulation(cloud, model, numerics)),
        angle_(dem::friction(model, recipe.materials)) {
    for (int a = 0; a < dimension_; ++a)
      if (!cloud.cell.periodic[static_cast<std::size_t>(a)])
        throw DataError(
            "the packing's cell is not periodic: to compress it, give a text its --cell; else give --as-is");
    if (last) {
      servo_.archive(kept_), at_.archive(kept_), clock_.archive(simulation_, 0, kept_);
      dem::demand_kept(at_.phase >= Phase::compressing && at_.phase <= Phase::done, keeper_.part().last(), "phase");
      dem::demand_kept(at_.first >= 0 && at_.first <= simulation_.steps(), keeper_.part().last(), "first step");
      if (at_.friction > 0) set_friction(at_.friction);
    } else {
      dem::demand_footing(cloud, numerics.gravity);
      dem::demand_stable(simulation_, numerics);
      if (recipe.void_ratio) demand_room(*recipe.void_ratio);
      demand_feasible(simulation_, model, recipe, mean_radius(cloud), dimension_, numerics.limits.overlap);
      simulation_.set_damping(recipe.damping);
      at_.cloud_angle = recipe.first_friction;
      if (at_.cloud_angle > 0) set_friction(at_.cloud_angle);
    }
    for (std::size_t a = 0; a < goals_.size(); ++a)
      goals_[a] = {dem::AxisGoal::Kind::stress, recipe.pressure,
                   recipe.max_rate * recipe.rate_shares[static_cast<Eigen::Index>(a)]};
  }

  Result run() {
    while (at_.phase != Phase::done) go_on();
    demand_room(simulation_.void_ratio());
    simulation_.set_reference();
    simulation_.set_velocity_gradient(Mat3::Zero());
    io::Snapshot state = simulation_.snapshot();
    state.step = 0;
    state.time = 0;
    dem::Cost cost = clock_.cost(simulation_, keeper_.seconds());
    cost.steps -= at_.skipped, cost.contact_steps += at_.contact_steps;
    return {std::move(state), simulation_.void_ratio(), at_.lowest, cost, unheld()};
  }

  io::Snapshot left() const { return simulation_.snapshot(); }

 private:
  void enter(Phase phase) {
    at_.phase = phase;
    at_.first = simulation_.steps();
  }

  // Completes one phase.
  void go_on() {
    switch (at_.phase) {
      case Phase::compressing:
        if (slippery()) return slip();
        if (!settle("compression", end_of_compression())) demand_room(simulation_.void_ratio());
        return compressed();
      case Phase::choosing:
        return choose();
      case Phase::lowering:
        if (!settle("friction lowered", at_.aim, coarse_equilibrium)) return enter(Phase::choosing);
        return restore();
      case Phase::restoring:
        if (settle("friction restored", too_dense())) return restore_earlier();
        at_.lead = std::max(0.0, at_.at_restoring - simulation_.void_ratio());
        return enter(Phase::choosing);
      case Phase::ending:
        if (settle("friction restored", too_dense())) return restore_earlier();
        return conclude();
      case Phase::bare:
        settle("friction restored", 0);
        if (is_held()) return enter(Phase::done);
        return refuse_denser();
      case Phase::done:
        return;
    }
  }

  // Chooses whether to lower friction once more, and the void ratio at which to restore it.
  void choose() {
    if (!recipe_.void_ratio) {
      if (at_.lowered == angle_) return enter(Phase::done);
      set_friction(angle_);
      return enter(Phase::ending);
    }
    const double target = *recipe_.void_ratio, now = simulation_.void_ratio();
    // Later attempts accept a void ratio well within the tolerance held at rest. Lowering friction again could cause
    // another fall.
    const double close = at_.attempt == 0 ? 1 : 0.75 * tolerances_held;
    if (now <= target + close * recipe_.void_ratio_tolerance) {
      if (at_.lowered == angle_ && !slippery()) return enter(Phase::done);
      set_friction(angle_);
      return enter(Phase::ending);
    }
    at_.lowered *= recipe_.friction_factor;
    if (at_.lowered < dem::lowest_friction) {
      at_.frictionless = now;
      set_friction(angle_);
      return enter(Phase::bare);
    }
    at_.lowest = at_.lowered;
    set_friction(at_.lowered);
    at_.aim = target + std::min(at_.lead, 0.5 * (now - target));
    enter(Phase::lowering);
  }

  // The nearest image of a touching pair is unique only if grains are smaller than half the cell.
  void demand_room(double void_ratio) const {
    const Vec3 widths = simulation_.cell_matrix().inverse().rowwise().norm().cwiseInverse();
    const double shrunk = std::pow((1 + void_ratio) / (1 + simulation_.void_ratio()), 1.0 / dimension_);
    const double narrowest = shrunk * widths.head(dimension_).minCoeff();
    if (largest_ < widest_grain * narrowest) return;
    const std::size_t grains = simulation_.grains();
    if (recipe_.room) recipe_.room->at(void_ratio).refuse(grains, narrowest / largest_);
    throw DataError(fmt::format(
        "at a void ratio of {:.4g} the cell is {:.3g} diameters of the largest grain wide, not less than half the "
        "cell: at least {} are needed; take at least {:.0f} such grains, or a more even cell",
        void_ratio, narrowest / largest_, least_diameters,
        1.1 * static_cast<double>(grains) * std::pow(least_diameters * largest_ / narrowest, dimension_)));
  }

  bool is_held() const {
    return std::abs(simulation_.void_ratio() - *recipe_.void_ratio) <= tolerances_held * recipe_.void_ratio_tolerance;
  }

  // Restores friction a little before the target is reached.
  void restore() {
    at_.at_restoring = simulation_.void_ratio();
    set_friction(angle_);
    enter(Phase::restoring);
  }

  // Returns whether the cloud is first compressed at low friction. Later attempts raise that friction if the cloud
  // became too dense.
  bool slippery() const { return recipe_.first_friction > 0; }

  // Returns whether the grains of Recipe::apart are held still, so that loose grains do not carry them along. They are
  // held until the mean stress of a compression at low friction first reaches the pressure.
  bool holding() const {
    return slippery() && at_.phase == Phase::compressing && !at_.let_go && !recipe_.apart.empty();
  }

  void slip() {
    at_.lowest = at_.cloud_angle, at_.lowered = angle_;
    if (settle("compression", end_of_compression(), recipe_.void_ratio ? coarse_equilibrium : 1)) return restore();
    compressed();
  }

  // Returns the void ratio at which a compression ends before it reaches the pressure; 0: none. A compression at low
  // friction ends above the target, where friction is restored. Any other ends below the target as too dense, except in
  // the first and last attempt.
  double end_of_compression() const {
    if (!recipe_.void_ratio) return 0;
    if (slippery()) return at_.cloud_angle == angle_ ? 0 : *recipe_.void_ratio + std::max(first_lead, at_.least_lead);
    if (at_.attempt == 0 || at_.attempt + 1 == recipe_.most_attempts) return 0;
    return *recipe_.void_ratio - tolerances_held * recipe_.void_ratio_tolerance;
  }

  // Returns the void ratio at which a compression at low friction has failed, so that it need not come to rest; 0:
  // none.
  double too_dense() const {
    if (!slippery() || !recipe_.void_ratio || at_.attempt + 1 == recipe_.most_attempts) return 0;
    return *recipe_.void_ratio - tolerances_held * recipe_.void_ratio_tolerance;
  }

  // Begins a new attempt with twice the lead, since the void ratio at rest of this attempt is unknown.
  void restore_earlier() {
    at_.least_lead = 2 * std::max(first_lead, at_.least_lead);
    at_.dense_angle = at_.cloud_angle;
    begin_again();
  }

  // Goes on after compression of the cloud, which in the first attempt was at full friction.
  void compressed() {
    const double now = simulation_.void_ratio();
    if (slippery() ? at_.cloud_angle == angle_ : at_.attempt == 0) {
      at_.loosest = now;
      if (recipe_.void_ratio) demand_looser(*recipe_.void_ratio);
    }
    at_.lead = std::max(recipe_.void_ratio_tolerance, at_.least_lead);
    at_.lowered = at_.cloud_angle > 0 ? at_.cloud_angle : angle_;
    if (!slippery() && now <= end_of_compression()) {
      at_.dense_angle = at_.lowered;
      return begin_again();
    }
    enter(Phase::choosing);
  }

  // Decides at rest with full friction: done, still looser than the target, or once more from the cloud.
  void conclude() {
    if (!recipe_.void_ratio) return enter(Phase::done);
    const double fallen = *recipe_.void_ratio - simulation_.void_ratio();
    if (is_held()) return enter(Phase::done);
    if (fallen < 0) return enter(Phase::choosing);
    if (at_.attempt + 1 == recipe_.most_attempts) return enter(Phase::done);
    at_.least_lead += fallen;
    at_.loose_angle = at_.cloud_angle > 0 ? at_.cloud_angle : angle_;
    begin_again();
  }

  // Compresses the cloud anew and restores friction earlier, by as much as the grains fell. The new friction lies
  // between the angles that left the cloud looser and denser than the target. Grains that barely support each other
  // come to rest only at few void ratios, which depend on the friction.
  void begin_again() {
    CompactionProgress next;
    next.attempt = at_.attempt + 1;
    next.least_lead = at_.least_lead, next.loosest = at_.loosest;
    next.loose_angle = at_.loose_angle, next.dense_angle = at_.dense_angle;
    next.contact_steps = at_.contact_steps + simulation_.contact_steps();
    if (at_.attempt > 0 || at_.loosest > *recipe_.void_ratio + tolerances_held * recipe_.void_ratio_tolerance)
      next.cloud_angle = 0.5 * (next.loose_angle + next.dense_angle);
    if (slippery()) next.cloud_angle = next_slippery_angle(next.least_lead);
    io::Snapshot start = cloud_;
    start.step = (simulation_.steps() / first_step_multiple + 1) * first_step_multiple;
    next.skipped = at_.skipped + start.step - simulation_.steps();
    simulation_ = dem::Simulation(start, model_, numerics_);
    simulation_.set_damping(recipe_.damping);
    servo_ = dem::Servo();
    at_ = next;
    if (at_.cloud_angle > 0) set_friction(at_.cloud_angle);
    enter(Phase::compressing);
  }

  void demand_looser(double target) const {
    if (at_.loosest >= target - recipe_.void_ratio_tolerance) return;
    throw TargetNotReached(
        fmt::format("void ratio {:.4f} is not reached at {:.4g} Pa: at the full friction angle of {:.4g} deg the "
                    "packing is already at {:.4f}; ask for at most {:.4f}",
                    target, recipe_.pressure, angle_ / degree, at_.loosest, downwards(at_.loosest)));
  }

  // Returns the friction angle of the next attempt. Up to the largest lead it stays the same, and friction is only
  // restored earlier. Beyond that lead, friction would be restored before grains press. Then the lead is reset, and the
  // angle is the geometric mean with full friction, or full friction if near it. Full friction shows whether the target
  // can be reached.
  double next_slippery_angle(double& lead) const {
    if (lead <= largest_lead) return at_.dense_angle;
    lead = 0;
    const double more = std::sqrt(angle_ * at_.dense_angle);
    return more > nearly_full * angle_ ? angle_ : more;
  }

  [[noreturn]] void refuse_denser() const {
    const double densest = simulation_.void_ratio();
    if (slippery())
      throw TargetNotReached(fmt::format(
          "void ratio {:.4f} is not reached at {:.4g} Pa: without friction the cell stays at {:.4f}, and is at {:.4f} "
          "with all friction restored; ask for at least {:.4f}",
          *recipe_.void_ratio, recipe_.pressure, at_.frictionless, densest, upwards(densest)));
    throw TargetNotReached(fmt::format(
        "void ratio {:.4f} is not reached at {:.4g} Pa: without friction the packing stays at {:.4f}, and is at {:.4f} "
        "with all friction restored; ask for one from {:.4f} to {:.4f}",
        *recipe_.void_ratio, recipe_.pressure, at_.frictionless, densest, upwards(densest), downwards(at_.loosest)));
  }

  std::optional<std::string> unheld() const {
    if (!recipe_.void_ratio || is_held()) return std::nullopt;
    return fmt::format(
        "void ratio {:.4f} is not held at {:.4g} Pa: in {} attempts the packing came to another one as friction was "
        "restored, at last to {:.4f}, which is written; ask for that, or for one within {:.3g} of it",
        *recipe_.void_ratio, recipe_.pressure, at_.attempt + 1, simulation_.void_ratio(),
        tolerances_held * recipe_.void_ratio_tolerance);
  }

  // Round to the four digits of a message, towards void ratios that can be reached.
  static double upwards(double void_ratio) { return std::ceil(1e4 * void_ratio) / 1e4; }
  static double downwards(double void_ratio) { return std::floor(1e4 * void_ratio) / 1e4; }

  void set_friction(double angle) {
    at_.friction = angle;
    simulation_.set_model(dem::with_friction(model_, angle, recipe_.materials));
  }

  // Runs to equilibrium at the pressure. Returns true as soon as the void ratio falls to `aim` on the way (0: never).
  bool settle(const char* stage, double aim, double coarseness = 1) {
    dem::Tolerances tolerances = recipe_.tolerances;
    tolerances.unbalanced_force *= coarseness;
    tolerances.stress *= coarseness;
    for (;;) {
      const Mat3 before = simulation_.cell().velocity_gradient();
      servo_.drive(goals_, dimension_, simulation_);
      keep_apart(recipe_.apart, simulation_.cell().velocity_gradient() - before, simulation_);
      if (holding()) hold(recipe_.apart, simulation_);
      simulation_.step();
      at_.let_go = at_.let_go || mean(simulation_.measures().stress, dimension_) >= recipe_.pressure;
      if (simulation_.steps() % room_interval == 0) demand_room(simulation_.void_ratio());
      if (aim > 0 && simulation_.void_ratio() <= aim) return true;
      if (dem::Servo::settled(goals_, dimension_, tolerances, simulation_)) return false;
      const std::int64_t steps = simulation_.steps() - at_.first;
      if (report_ && steps % dem::report_interval == 0) tell(stage);
      if (steps > recipe_.largest_stage) throw TargetNotReached(unsettled(stage, steps));
      keeper_.after_step([this] { return checkpoint(); });
    }
  }

  std::string unsettled(const char* stage, std::int64_t steps) const {
    if (simulation_.measures().contacts == 0)
      return fmt::format(
          "{}: grains have not come together after {} steps (void ratio {:.4f}): raise the rate ({}) or scale the "
          "density ({})",
          stage, steps, simulation_.void_ratio(), recipe_.remedies.max_rate, recipe_.remedies.density);
    return fmt::format(
        "{}: no equilibrium at {:.4g} Pa after {} steps (unbalanced force {:.2e} of {:.2e}, void ratio {:.4f}): loosen "
        "the "
        "tolerance ({}) or raise numerics.damping ({})",
        stage, recipe_.pressure, steps, simulation_.unbalanced_force(), recipe_.tolerances.unbalanced_force,
        simulation_.void_ratio(), recipe_.remedies.tolerance, recipe_.remedies.material);
  }

  io::Checkpoint checkpoint() { return dem::checkpoint_of(simulation_, clock_, keeper_.seconds(), {}, servo_, at_); }

  void tell(const char* stage) const {
    const dem::Measures& m = simulation_.measures();
    const double e = simulation_.void_ratio();
    report_(recipe_.void_ratio ? std::min(1.0, *recipe_.void_ratio / e) : 0.5,
            fmt::format("{}: step {}, p {:.4g} Pa, e {:.4f}, unbalanced {:.1e}", stage, simulation_.steps(),
                        mean(m.stress, dimension_), e, simulation_.unbalanced_force()));
  }

  const io::Snapshot& cloud_;
  dem::Model model_;
  dem::Numerics numerics_;
  const Recipe& recipe_;
  const ProgressReport& report_;
  int dimension_;
  double largest_;  // largest diameter, m
  dem::Keeper keeper_;
  Archive kept_;
  dem::Simulation simulation_;
  dem::Servo servo_;
  dem::AxisGoals goals_;
  double angle_;  // full friction, rad
  CompactionProgress at_;
  dem::CostClock clock_;
};

}  // namespace

Result compact(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
               const ProgressReport& report, const dem::Safekeeping& safekeeping) {
  io::Snapshot start = cloud;
  start.step = 0;
  start.time = 0;
  io::Part* part = safekeeping.part;
  Compaction compaction(start, model, numerics, recipe, report, safekeeping, part ? part->take_last() : std::nullopt);
  return dem::carry_out<false>(compaction, part);
}

}  // namespace soilweave::packing
