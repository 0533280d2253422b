// Changes of the grains' motion at the start and end of the loading to a station.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/way.h"

#include <cmath>

#include "dem/engine/homogeneous.h"
#include "dem/run/keeper.h"

namespace soilweave::dem {
namespace {

void lay(const Mat3& gradient, Simulation& simulation) {
  const HomogeneousField field(simulation);
  simulation.change_velocities([&](Bodies& bodies) { field.add(gradient, bodies); });
}

}  // namespace

void Way::begin_stage() {
  waiting_ = laid_ = false;
  gradient_ = Mat3::Zero();
}

void Way::before_step(const Stage& stage, bool waiting, const std::vector<DriveGoal>& goals, double pace,
                      const Rig& rig, Simulation& simulation) {
  if (waiting && !waiting_) {
    if (laid_) {
      gradient_ = HomogeneousField(simulation).gradient(simulation.bodies());
      lay(-gradient_, simulation);
      laid_ = false;
    }
    drag_ = stage.rest_drag;
    critical_ = stage.critical_drag;
    if (critical_) swing_.begin(simulation);
  }
  waiting_ = waiting;
  if (waiting || laid_ || !stage.homogeneous_start) return;
  lay(rig.gradient_of_way(goals, pace, gradient_, simulation), simulation);
  laid_ = true;
}

void Way::after_step(Simulation& simulation) {
  if (!waiting_) return;
  ++waited_;
  // Local damping weakens as forces balance, so a slow swing needs a drag to come to rest.
  if (critical_) swing_.look(simulation);
  const double drag = critical_ ? swing_.critical_drag() : drag_;
  if (drag > 0 && simulation.steps() % look_interval == 0)
    simulation.slow_motion(std::exp(-drag * look_interval * simulation.time_step()));
}

void Way::archive(Archive& a) {
  a.whole("waiting", waiting_), a.whole("homogeneous_field_laid", laid_);
  a.item("mean_velocity_gradient", gradient_);
  a.item("rest_drag", drag_), a.whole("critical_drag", critical_), a.whole("steps_waited", waited_);
  a.whole("steps_waited_for_energy", waited_for_energy_);
  swing_.archive(a);
}

}  // namespace soilweave::dem
