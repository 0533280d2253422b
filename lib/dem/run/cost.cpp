// Cost of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/cost.h"

#include <fmt/format.h>

namespace soilweave::dem {
namespace {

std::string waits(const Cost& c) {
  if (c.waiting == 0) return {};
  const auto percent = [&c](std::int64_t n) { return 100.0 * static_cast<double>(n) / static_cast<double>(c.steps); };
  const std::string for_energy = fmt::format(", {:.0f} % for the kinetic energy alone", percent(c.waiting_for_energy));
  return fmt::format(" ({:.0f} % of them waiting for rest{})", percent(c.waiting),
                     c.waiting_for_energy > 0 ? for_energy : "");
}

}  // namespace

double Cost::share(Phase phase) const {
  if (times.looked_at == 0 || !(stepping + output > 0)) return 0;
  const double all_steps = static_cast<double>(steps) / static_cast<double>(times.looked_at);
  double phases = 0;
  for (const double s : times.seconds) phases += s * all_steps;
  // Sampled steps may have been slow by chance, so the phases are scaled down to the time of stepping.
  const double scale = phases > stepping ? stepping / phases : 1;
  return scale * times.of(phase) * all_steps / (stepping + output);
}

std::string Cost::line() const {
  const double total = stepping + output;
  return fmt::format(
      "{} steps{} of {} grains with {:.0f} contacts in {:.3g} s: {:.4g} steps/s, {:.3g} ns per contact; contacts "
      "{:.0f} "
      "%, integration {:.0f} %, neighbours {:.0f} %, output {:.0f} %",
      steps, waits(*this), grains, contacts(), total, stepping > 0 ? static_cast<double>(steps) / stepping : 0,
      per_contact(), 100 * share(Phase::contacts), 100 * share(Phase::integration), 100 * share(Phase::neighbours),
      total > 0 ? 100 * output / total : 0);
}

Cost CostClock::cost(const Simulation& simulation, double keeping) const {
  Cost p;
  p.grains = simulation.grains();
  p.steps = simulation.steps();
  p.contact_steps = simulation.contact_steps();
  const double now = std::chrono::duration<double>(std::chrono::steady_clock::now() - began_).count();
  p.stepping = stepping_ + now - keeping;
  p.output = output_ + keeping;
  p.times = simulation.step_times();
  for (std::size_t k = 0; k < p.times.seconds.size(); ++k) p.times.seconds[k] += times_.seconds[k];
  p.times.looked_at += times_.looked_at;
  return p;
}

void CostClock::archive(const Simulation& simulation, double keeping, Archive& a) {
  Cost p = cost(simulation, keeping);
  a.item("seconds_stepping", p.stepping), a.item("seconds_output", p.output);
  a.item("seconds_contacts", p.times.seconds[0]), a.item("seconds_integration", p.times.seconds[1]);
  a.item("seconds_neighbours", p.times.seconds[2]), a.item("steps_looked_at", p.times.looked_at);
  if (a.giving_back()) stepping_ = p.stepping, output_ = p.output, times_ = p.times;
}

}  // namespace soilweave::dem
