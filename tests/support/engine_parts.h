// Parts of the engine that Simulation assembles, for tests and benchmarks that drive them one by one.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstring>
#include <memory>

#include "dem/engine/step_passes.h"
#include "dem/sweep/neighbours.h"

namespace soilweave::support {

struct EngineParts {
  EngineParts(const io::Snapshot& state, std::unique_ptr<dem::ContactSweep> sweep_with, int threads = 1,
              const dem::GrainMotion& how = dem::grain_motion())
      : bodies(state.grains),
        cell(state.cell, state.grains.dimension),
        neighbours(bodies.largest_radius()),
        motion(bodies.size(), threads, how),
        sweep(std::move(sweep_with)) {
    contacts.threads = threads;
    neighbours.rebuild(bodies, cell, planes, contacts);
  }

  dem::Scene scene() { return {bodies, cell, planes}; }
  /// Computes forces after a step dt. Grains move within the sweep if they have not moved before.
  void act(double dt, bool moving = false, Vec3* affine_stiffness = nullptr) {
    dem::StepPasses passes(moving, contacts, motion, bodies);
    sums = sweep->run(scene(), dt, contacts, passes, affine_stiffness);
    sums.force_branch += motion.collected();
  }

  dem::Bodies bodies;
  dem::Cell cell;
  dem::Planes planes;
  dem::Contacts contacts;
  dem::Neighbours neighbours;
  dem::Motion motion;
  std::unique_ptr<dem::ContactSweep> sweep;
  dem::SweepSums sums;
};

template <class Rows>
bool same_bits(const Rows& a, const Rows& b) {
  if (a.size() != b.size()) return false;
  return a.size() == 0 ||
         std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;  // an empty vector has no address
}

}  // namespace soilweave::support
