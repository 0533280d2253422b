// Progress of the compaction of a packing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/archive.h"

namespace soilweave::packing {

// Present work, each until an equilibrium. `bare`: friction was lowered to nothing and is restored once more.
enum class Phase { compressing, choosing, lowering, restoring, ending, bare, done };

// Progress of the work.
struct CompactionProgress {
  Phase phase = Phase::compressing;
  std::int64_t first = 0;            // step at which the way to the equilibrium began
  double friction = 0;               // present angle of all materials, rad; 0 before it was first changed
  double lowered = 0, lowest = 0;    // rad
  double aim = 0, at_restoring = 0;  // void ratios
  double lead = 0;                   // fall of the void ratio expected after friction is restored
  // Results of earlier attempts: their fall below the target; friction angles (rad) at which clouds came to rest looser
  // and denser than it; the angle at which this cloud is compressed, 0 for full friction.
  double least_lead = 0, loose_angle = 0, dense_angle = 0, cloud_angle = 0;
  double loosest = 0, frictionless = 0;  // void ratios at rest, at full friction and without friction
  bool let_go = false;                   // whether grains that are apart from the cell's strain are no longer held
  std::int64_t attempt = 0;
  std::int64_t skipped = 0;        // numbers of steps that no attempt took
  std::int64_t contact_steps = 0;  // contact steps of earlier attempts

  void archive(Archive& a) {
    a.whole("phase", phase), a.item("phase_first_step", first);
    a.item("friction", friction), a.item("lowered", lowered), a.item("lowest", lowest);
    a.item("aim", aim), a.item("at_restoring", at_restoring), a.item("lead", lead);
    a.item("least_lead", least_lead), a.item("loose_angle", loose_angle), a.item("dense_angle", dense_angle);
    a.item("cloud_angle", cloud_angle), a.item("loosest", loosest), a.item("frictionless", frictionless);
    a.whole("let_go", let_go), a.item("attempt", attempt), a.item("skipped_steps", skipped),
        a.item("contact_steps_before", contact_steps);
  }
};

}  // namespace soilweave::packing
