// From a cloud to a packing with a given void ratio at a given pressure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/error.h"
#include "dem/moment.h"
#include "dem/scenario.h"

namespace soilweave::packing {
namespace {

constexpr double degree = std::numbers::pi / 180;
// Of the cell: a little less than the half at which a guard stops.
constexpr double widest_grain = 0.495;
constexpr std::int64_t room_interval = 8;  // steps
// While friction is being lowered the equilibria need not be as good as the last one.
constexpr double coarse_equilibrium = 10;

// What is being done, each until an equilibrium.
enum class Phase { compressing, choosing, lowering, restoring, ending, done };

// How far the work is.
struct Position {
  Phase phase = Phase::compressing;
  std::int64_t first = 0;            // step at which the way to the equilibrium began
  double friction = 0;               // rad, of all materials now; 0 before it was first changed
  double lowered = 0, lowest = 0;    // rad
  double aim = 0, at_restoring = 0;  // void ratios
  double lead = 0;  // void ratio that falls a little after friction is restored: that much is left for it

  void archive(Archive& a) {
    a.whole("phase", phase), a.item("phase_first_step", first);
    a.item("friction", friction), a.item("lowered", lowered), a.item("lowest", lowest);
    a.item("aim", aim), a.item("at_restoring", at_restoring), a.item("lead", lead);
  }
};

class Compaction {
 public:
  Compaction(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
             const Report& report, const dem::Safekeeping& safekeeping, std::optional<io::Moment> last)
      : model_(model),
        recipe_(recipe),
        report_(report),
        dimension_(cloud.grains.dimension),
        largest_(2 * *std::max_element(cloud.grains.radius.begin(), cloud.grains.radius.end())),
        keeper_(safekeeping, cloud.grains.size()),
        kept_(last ? Archive(std::move(last->numbers), keeper_.part().last().string()) : Archive()),
        simulation_(last ? dem::Simulation(last->state, model, numerics, kept_)
                         : dem::Simulation(cloud, model, numerics)),
        angle_(dem::friction(model)) {
    for (int a = 0; a < dimension_; ++a)
      if (!cloud.cell.periodic[static_cast<std::size_t>(a)])
        throw DataError("the packing's cell is not periodic and cannot be compressed: give its lengths (--cell)");
    if (last) {
      servo_.archive(kept_), at_.archive(kept_), clock_.archive(simulation_, 0, kept_);
      if (at_.friction > 0) set_friction(at_.friction);
    } else {
      if (recipe.void_ratio) demand_room(*recipe.void_ratio);
      simulation_.set_damping(recipe.damping);
    }
    const dem::AxisGoal goal{dem::AxisGoal::Kind::stress, recipe.pressure, recipe.max_rate};
    goals_ = {goal, goal, goal};
  }

  Result run() {
    while (at_.phase != Phase::done) go_on();
    if (recipe_.void_ratio) demand_held(*recipe_.void_ratio);
    demand_room(simulation_.void_ratio());
    simulation_.set_reference();
    simulation_.set_velocity_gradient(Mat3::Zero());
    io::Snapshot state = simulation_.snapshot();
    state.step = 0;
    state.time = 0;
    return {std::move(state), simulation_.void_ratio(), at_.lowest, clock_.price(simulation_, keeper_.seconds())};
  }

  io::Snapshot snapshot() const { return simulation_.snapshot(); }

 private:
  void enter(Phase phase) {
    at_.phase = phase;
    at_.first = simulation_.steps();
  }

  // One phase, to its end.
  void go_on() {
    switch (at_.phase) {
      case Phase::compressing:
        settle("compression", 0);
        demand_room(simulation_.void_ratio());
        if (recipe_.void_ratio) demand_looser(*recipe_.void_ratio);
        at_.lead = recipe_.void_ratio_tolerance;
        at_.lowered = angle_;
        return enter(Phase::choosing);
      case Phase::choosing:
        return choose();
      case Phase::lowering:
        if (!settle("friction lowered", at_.aim, coarse_equilibrium)) return enter(Phase::choosing);
        at_.at_restoring = simulation_.void_ratio();
        set_friction(angle_);
        return enter(Phase::restoring);
      case Phase::restoring:
        settle("friction restored", 0);
        at_.lead = std::max(0.0, at_.at_restoring - simulation_.void_ratio());
        return enter(Phase::choosing);
      case Phase::ending:
        settle("friction restored", 0);
        return enter(Phase::done);
      case Phase::done:
        return;
    }
  }

  // Whether to lower friction once more, and what void ratio to restore it at.
  void choose() {
    if (!recipe_.void_ratio) return enter(Phase::done);
    const double target = *recipe_.void_ratio, now = simulation_.void_ratio();
    if (now <= target + recipe_.void_ratio_tolerance) {
      if (at_.lowered == angle_) return enter(Phase::done);
      set_friction(angle_);
      return enter(Phase::ending);
    }
    at_.lowered *= recipe_.friction_factor;
    if (at_.lowered < dem::lowest_friction)
      throw TargetNotReached(
          fmt::format("void ratio {:.4f} is not reached at {:.4g} Pa: without friction the packing stays at {:.4f}; "
                      "raise the pressure, lower the rolling stiffness, or widen the grading",
                      target, recipe_.pressure, now));
    at_.lowest = at_.lowered;
    set_friction(at_.lowered);
    at_.aim = target + std::min(at_.lead, 0.5 * (now - target));
    enter(Phase::lowering);
  }

  // The nearest image of a touching pair is unique only while grains are smaller than half the cell.
  void demand_room(double void_ratio) const {
    const Vec3 widths = simulation_.cell_matrix().inverse().rowwise().norm().cwiseInverse();
    const double shrunk = std::pow((1 + void_ratio) / (1 + simulation_.void_ratio()), 1.0 / dimension_);
    const double narrowest = shrunk * widths.head(dimension_).minCoeff();
    if (largest_ >= widest_grain * narrowest)
      throw DataError(
          fmt::format("at a void ratio of {:.4g} the cell is {:.4g} m wide, and the largest grain is {:.4g} m across: "
                      "not less than half the cell; take more grains or a more even cell",
                      void_ratio, narrowest, largest_));
  }

  void demand_looser(double target) const {
    const double loosest = simulation_.void_ratio();
    if (loosest >= target - recipe_.void_ratio_tolerance) return;
    throw TargetNotReached(fmt::format(
        "void ratio {:.4f} is not reached at {:.4g} Pa: at the full friction angle of {:.4g} deg the packing is "
        "already at "
        "{:.4f}; raise the friction angle or the rolling stiffness, lower the pressure, or ask for a denser packing",
        target, recipe_.pressure, angle_ / degree, loosest));
  }

  void demand_held(double target) const {
    if (std::abs(simulation_.void_ratio() - target) <= 4 * recipe_.void_ratio_tolerance) return;
    throw TargetNotReached(fmt::format(
        "void ratio {:.4f} is not held at {:.4g} Pa: the packing settled at {:.4f} as friction was restored; "
        "lower the rate (--max-rate) or raise the damping",
        target, recipe_.pressure, simulation_.void_ratio()));
  }

  void set_friction(double angle) {
    at_.friction = angle;
    simulation_.set_model(dem::with_friction(model_, angle));
  }

  // Runs to equilibrium at the pressure; true as soon as the void ratio falls to `aim` on the way (0: never).
  bool settle(const char* stage, double aim, double coarseness = 1) {
    dem::Tolerances tolerances = recipe_.tolerances;
    tolerances.unbalanced_force *= coarseness;
    tolerances.stress *= coarseness;
    for (;;) {
      servo_.drive(goals_, dimension_, simulation_);
      simulation_.step();
      if (simulation_.steps() % room_interval == 0) demand_room(simulation_.void_ratio());
      if (aim > 0 && simulation_.void_ratio() <= aim) return true;
      if (dem::Servo::settled(goals_, dimension_, tolerances, simulation_)) return false;
      const std::int64_t steps = simulation_.steps() - at_.first;
      if (report_ && steps % dem::report_interval == 0) tell(stage);
      if (steps > recipe_.largest_stage)
        throw TargetNotReached(
            fmt::format("{}: no equilibrium at {:.4g} Pa after {} steps (unbalanced force {:.2e} of {:.2e}, void ratio "
                        "{:.4f}): raise the "
                        "damping or loosen the tolerance",
                        stage, recipe_.pressure, steps, simulation_.unbalanced_force(),
                        recipe_.tolerances.unbalanced_force, simulation_.void_ratio()));
      keeper_.after_step([this] { return moment(); });
    }
  }

  io::Moment moment() { return dem::moment_of(simulation_, clock_, keeper_.seconds(), {}, servo_, at_); }

  void tell(const char* stage) const {
    const dem::Measures& m = simulation_.measures();
    const double e = simulation_.void_ratio();
    report_(recipe_.void_ratio ? std::min(1.0, *recipe_.void_ratio / e) : 0.5,
            fmt::format("{}: step {}, p {:.4g} Pa, e {:.4f}, unbalanced {:.1e}", stage, simulation_.steps(),
                        mean(m.stress, dimension_), e, simulation_.unbalanced_force()));
  }

  dem::Model model_;
  const Recipe& recipe_;
  const Report& report_;
  int dimension_;
  double largest_;  // m, diameter
  dem::Keeper keeper_;
  Archive kept_;
  dem::Simulation simulation_;
  dem::Servo servo_;
  dem::AxisGoals goals_;
  double angle_;  // rad, full friction
  Position at_;
  dem::PriceClock clock_;
};

}  // namespace

Result compact(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
               const Report& report, const dem::Safekeeping& safekeeping) {
  io::Snapshot start = cloud;
  start.step = 0;
  start.time = 0;
  io::Part* part = safekeeping.part;
  Compaction compaction(start, model, numerics, recipe, report, safekeeping, part ? part->take_last() : std::nullopt);
  return dem::carry_out<false>(compaction, part);
}

}  // namespace soilweave::packing
