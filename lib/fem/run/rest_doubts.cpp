// Doubts about the rest of the soil at the end of a two-scale run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/rest_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "fem/run/boundary_conditions.h"

namespace soilweave::fem {
namespace {

// Largest amplitude about the rest, over the change that the loads cause.
constexpr double largest_amplitude = 0.05;
// Forces out of balance at the start, over the internal forces, below which the loads change nothing. Packings are made
// to a hundredth of their stress.
constexpr double least_change = 0.01;
// Forces out of balance in a soil that is driven, over its internal forces, beyond which it is not loaded slowly.
constexpr double largest_inertia = 0.2;
// Damping over the critical one, at which motion about the rest decays fastest, and the time that this takes, in
// periods over two pi.
constexpr double best_damping = 0.7, dying = 10;

// Motion of the soil about its rest, from the forces out of balance at the start and now.
struct Swing {
  double amplitude = 0;  // over the change that the loads cause
  double frequency = 0;  // 1/s, in radians; 0: unknown
  double work = 0;       // of the forces at the start, J/m
};

Swing swing_of(const Soil& soil, const OutOfBalance& start, const OutOfBalance& now) {
  double first = 0, last = 0, work = 0, restored = 0, inertia = 0;
  for (Index n = 0; n < start.forces.size(); ++n) {
    const Vec2& u = soil.displacements()[n];
    first += start.forces[n].norm(), last += now.forces[n].norm();
    work += start.forces[n].dot(u);
    restored += (start.forces[n] - now.forces[n]).dot(u);
    inertia += soil.masses()[n] * u.squaredNorm();
  }
  if (!(first > least_change * start.internal)) return {};
  const double kinetic = soil.kinetic_energy();
  Swing swing{last / first, 0, work};
  if (kinetic > 0) swing.amplitude = std::hypot(swing.amplitude, std::sqrt(2 * kinetic / std::max(work, 0.0)));
  if (restored > 0) swing.frequency = std::sqrt(restored / inertia);  // Rayleigh's quotient
  return swing;
}

std::string rest_remedy(const Scenario& scenario, const Swing& swing) {
  const double damping = 2 * best_damping * swing.frequency;
  const double energy = 0.001 * std::pow(largest_amplitude, 2) * swing.work;
  const auto& quasi_static = scenario.quasi_static;
  // Damped too little, a soil that swings has next to no kinetic energy where it turns.
  if (quasi_static && damping > 0 && !(energy > 0 && energy < quasi_static->kinetic_energy))
    return fmt::format("give quasi_static.soil_damping = {:.3g}", damping);
  const std::string rest =
      energy > 0 ? fmt::format("give quasi_static.kinetic_energy = {:.2g}", energy) : "give [quasi_static]";
  if (quasi_static || !(damping > 0)) return rest;
  const double longer = dying / swing.frequency;
  return fmt::format("{}, or soil.damping = {:.3g}{}", rest, damping,
                     scenario.duration < longer ? fmt::format(" and time.duration = {:.3g}", longer) : "");
}

double sum_of(const std::vector<Vec2>& forces) {
  double sum = 0;
  for (const Vec2& force : forces) sum += force.norm();
  return sum;
}

std::vector<Doubt> inertia_doubts(const OutOfBalance& start, const OutOfBalance& now) {
  const double share = sum_of(now.forces) / now.internal;
  if (!(share > largest_inertia)) return {};
  // A load that was not balanced at the start makes the soil swing at any speed.
  const std::string slower =
      sum_of(start.forces) > least_change * start.internal
          ? "damp it by soil.damping"
          : fmt::format("drive it {:.2g} times slower for as much longer a time", share / (0.5 * largest_inertia));
  return {{"inertia", fmt::format("the soil does not follow what drives it: forces of inertia and damping are {:.0f} % "
                                  "of its internal forces at the end; where slow loading is meant, {}, or give "
                                  "[quasi_static]",
                                  100 * share, slower)}};
}

}  // namespace

OutOfBalance out_of_balance(const ModelSetup& setup, const Model& model) {
  const Soil& soil = model.soil();
  std::vector<Mat2> stresses;
  for (const auto& point : model.points()) stresses.push_back(point->stress());
  OutOfBalance sum{traction_forces(soil.mesh(), soil.positions(), setup.soil.tractions)};
  if (model.bars()) {
    const std::vector<Index> line = soil.mesh().line(setup.along);
    for (Index k = 0; k < line.size(); ++k) sum.forces[line[k]] += model.bars()->interface_forces()[k];
  }
  const std::vector<Vec2> internal = soil.internal_forces(stresses);
  const std::vector<HeldNode> held = held_nodes(soil.mesh(), setup.soil.supports);
  for (Index n = 0; n < internal.size(); ++n) {
    sum.forces[n] -= internal[n];
    for (const std::size_t axis : {0, 1})
      if (held[n][axis]) sum.forces[n][static_cast<Eigen::Index>(axis)] = 0;
    sum.internal += internal[n].norm();
  }
  return sum;
}

std::vector<Doubt> rest_doubts(const Scenario& scenario, const Model& model, const OutOfBalance& start,
                               const std::vector<Doubt>& said) {
  constexpr std::array<std::string_view, 3> explaining = {"soil_free", "wave", "few_steps"};
  const bool explained = std::any_of(said.begin(), said.end(), [&](const Doubt& d) {
    return std::find(explaining.begin(), explaining.end(), d.key) != explaining.end();
  });
  if (explained) return {};
  const OutOfBalance now = out_of_balance(scenario.model, model);
  if (is_driven(scenario.model)) return scenario.quasi_static ? std::vector<Doubt>() : inertia_doubts(start, now);
  const Swing swing = swing_of(model.soil(), start, now);
  if (!(swing.amplitude > largest_amplitude)) return {};
  return {{"unrest",
           fmt::format("the soil is not at rest at the end: it swings by about {:.0f} % of the change that its loads "
                       "cause, so that stresses and displacements vary in time; to bring it to rest, {}",
                       100 * std::min(swing.amplitude, 1.0), rest_remedy(scenario, swing))}};
}

}  // namespace soilweave::fem
