// From a cloud to a packing with a given void ratio at a given pressure.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "dem/scenario.h"

namespace soilweave::packing {
namespace {

constexpr double degree = std::numbers::pi / 180;
// Below this friction angle the packing is as dense as friction can make it.
constexpr double lowest_friction = 0.05 * degree;
// While friction is being lowered the equilibria need not be as good as the last one.
constexpr double coarse_equilibrium = 10;
constexpr std::int64_t report_interval = 512;

class Compaction {
 public:
  Compaction(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
             const Report& report)
      : model_(model),
        recipe_(recipe),
        report_(report),
        dimension_(cloud.grains.dimension),
        largest_(2 * *std::max_element(cloud.grains.radius.begin(), cloud.grains.radius.end())),
        simulation_(cloud, model, numerics),
        angle_(dem::friction(model)) {
    for (int a = 0; a < dimension_; ++a)
      if (!cloud.cell.periodic[static_cast<std::size_t>(a)])
        throw DataError("the packing's cell is not periodic and cannot be compressed: give its lengths (--cell)");
    if (recipe.void_ratio) demand_room(*recipe.void_ratio);
    simulation_.set_damping(recipe.damping);
    const dem::AxisGoal goal{dem::AxisGoal::Kind::stress, recipe.pressure, recipe.max_rate};
    goals_ = {goal, goal, goal};
  }

  Result run() {
    settle("compression", 0);
    demand_room(simulation_.void_ratio());
    if (recipe_.void_ratio) densify(*recipe_.void_ratio);
    demand_room(simulation_.void_ratio());
    simulation_.set_reference();
    simulation_.set_velocity_gradient(Mat3::Zero());
    return {simulation_.snapshot(), simulation_.void_ratio(), lowest_};
  }

 private:
  // The nearest image of a touching pair is unique only while grains are smaller than half the cell.
  void demand_room(double void_ratio) const {
    const Vec3 widths = simulation_.cell_matrix().inverse().rowwise().norm().cwiseInverse();
    const double shrunk = std::pow((1 + void_ratio) / (1 + simulation_.void_ratio()), 1.0 / dimension_);
    const double narrowest = shrunk * widths.head(dimension_).minCoeff();
    if (largest_ >= narrowest / 2)
      throw DataError(
          fmt::format("at a void ratio of {:.4g} the cell is {:.4g} m wide, and the largest grain is {:.4g} m across: "
                      "not less than half the cell; take more grains or a more even cell",
                      void_ratio, narrowest, largest_));
  }

  void densify(double target) {
    const double tolerance = recipe_.void_ratio_tolerance;
    const double loosest = simulation_.void_ratio();
    if (loosest < target - tolerance)
      throw TargetNotReached(fmt::format(
          "void ratio {:.4f} is not reached at {:.4g} Pa: at the full friction angle of {:.4g} deg the packing is "
          "already at "
          "{:.4f}; raise the friction angle or the rolling stiffness, lower the pressure, or ask for a denser packing",
          target, recipe_.pressure, angle_ / degree, loosest));
    // The void ratio goes on falling a little after friction is restored: that much is left for it, learnt on the way.
    double lead = tolerance;
    double lowered = angle_;
    while (simulation_.void_ratio() > target + tolerance) {
      lowered *= recipe_.friction_factor;
      if (lowered < lowest_friction)
        throw TargetNotReached(
            fmt::format("void ratio {:.4f} is not reached at {:.4g} Pa: without friction the packing stays at {:.4f}; "
                        "raise the pressure, "
                        "lower the rolling stiffness, or widen the grading",
                        target, recipe_.pressure, simulation_.void_ratio()));
      lowest_ = lowered;
      set_friction(lowered);
      const double aim = target + std::min(lead, 0.5 * (simulation_.void_ratio() - target));
      const bool passed = settle("friction lowered", aim, coarse_equilibrium);
      if (!passed) continue;
      const double at_restoring = simulation_.void_ratio();
      set_friction(angle_);
      settle("friction restored", 0);
      lead = std::max(0.0, at_restoring - simulation_.void_ratio());
    }
    if (lowered != angle_) {
      set_friction(angle_);
      settle("friction restored", 0);
    }
    if (std::abs(simulation_.void_ratio() - target) > 4 * tolerance)
      throw TargetNotReached(fmt::format(
          "void ratio {:.4f} is not held at {:.4g} Pa: the packing settled at {:.4f} as friction was restored; "
          "lower the rate (--max-rate) or raise the damping",
          target, recipe_.pressure, simulation_.void_ratio()));
  }

  void set_friction(double angle) { simulation_.set_model(dem::with_friction(model_, angle)); }

  // Runs to equilibrium at the pressure; true as soon as the void ratio falls to `aim` on the way (0: never).
  bool settle(const char* stage, double aim, double coarseness = 1) {
    dem::Tolerances tolerances = recipe_.tolerances;
    tolerances.unbalanced_force *= coarseness;
    tolerances.stress *= coarseness;
    const std::int64_t first = simulation_.steps();
    for (;;) {
      servo_.drive(goals_, dimension_, simulation_);
      simulation_.step();
      if (aim > 0 && simulation_.void_ratio() <= aim) return true;
      if (dem::Servo::settled(goals_, dimension_, tolerances, simulation_)) return false;
      const std::int64_t steps = simulation_.steps() - first;
      if (report_ && steps % report_interval == 0) tell(stage);
      if (steps > recipe_.largest_stage)
        throw TargetNotReached(
            fmt::format("{}: no equilibrium at {:.4g} Pa after {} steps (unbalanced force {:.2e} of {:.2e}, void ratio "
                        "{:.4f}): raise the "
                        "damping or loosen the tolerance",
                        stage, recipe_.pressure, steps, simulation_.measures().unbalanced_force,
                        recipe_.tolerances.unbalanced_force, simulation_.void_ratio()));
    }
  }

  void tell(const char* stage) const {
    const dem::Measures& m = simulation_.measures();
    const double e = simulation_.void_ratio();
    report_(recipe_.void_ratio ? std::min(1.0, *recipe_.void_ratio / e) : 0.5,
            fmt::format("{}: step {}, p {:.4g} Pa, e {:.4f}, unbalanced {:.1e}", stage, simulation_.steps(),
                        mean(m.stress, dimension_), e, m.unbalanced_force));
  }

  dem::Model model_;
  const Recipe& recipe_;
  const Report& report_;
  int dimension_;
  double largest_;  // m, diameter
  dem::Simulation simulation_;
  dem::Servo servo_;
  dem::AxisGoals goals_;
  double angle_;  // rad, full friction
  double lowest_ = 0;
};

}  // namespace

Result compact(const io::Snapshot& cloud, const dem::Model& model, const dem::Numerics& numerics, const Recipe& recipe,
               const Report& report) {
  return Compaction(cloud, model, numerics, recipe, report).run();
}

}  // namespace soilweave::packing
