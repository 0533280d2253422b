// Progress of the compaction of a packing.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "core/archive.h"

namespace soilweave::packing {

// Phases of the work; each ends at an equilibrium. bare: friction was lowered to zero and is restored again.
enum class Phase { compressing, choosing, lowering, restoring, ending, bare, done };

// Progress of the work.
struct CompactionProgress {
  Phase phase = Phase::compressing;
  /// First step of the present phase.
  std::int64_t first = 0;
  /// Present friction angle of the materials, rad; 0 before its first change.
  double friction = 0;
  double lowered = 0, lowest = 0;    // rad
  double aim = 0, at_restoring = 0;  // void ratios
  /// Expected fall of the void ratio after friction is restored.
  double lead = 0;
  // Results of earlier attempts. least_lead: least value of `lead`, from their falls below the target. loose_angle,
  // dense_angle: friction angles at which clouds came to rest too loose or too dense, rad. cloud_angle: angle while
  // this cloud is compressed, rad; 0: full friction.
  double least_lead = 0, loose_angle = 0, dense_angle = 0, cloud_angle = 0;
  /// Void ratios at rest, at full friction and without.
  double loosest = 0, frictionless = 0;
  /// Whether the grains of Recipe::apart are released.
  bool let_go = false;
  std::int64_t attempt = 0;
  /// Step numbers skipped between attempts.
  std::int64_t skipped = 0;
  /// Contact steps of earlier attempts.
  std::int64_t contact_steps = 0;

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
