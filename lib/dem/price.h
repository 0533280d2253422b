// What a run cost: counts, which equal runs share, and seconds, which they do not.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <string>

#include "core/archive.h"
#include "dem/simulation.h"

namespace soilweave::dem {

struct Price {
  std::size_t grains = 0;
  std::int64_t steps = 0, contact_steps = 0;  // contact_steps: contacts, summed over the steps
  std::int64_t waiting = 0;                   // of the steps, those that stations waited for rest; 0: nothing waited
  double stepping = 0, output = 0;            // s
  StepTimes times;

  double contacts() const { return steps > 0 ? static_cast<double>(contact_steps) / static_cast<double>(steps) : 0; }
  /// ns of a whole step for each contact.
  double per_contact() const { return contact_steps > 0 ? 1e9 * stepping / static_cast<double>(contact_steps) : 0; }
  /// Share of a phase in all the time, from the steps that were looked at; the shares add up to 1 at most.
  double share(Phase phase) const;
  /// One line of it all.
  std::string line() const;
};

/// Counts the price of work that may take several sittings.
class PriceClock {
 public:
  /// So far, of all sittings; the simulation counted its steps from 0. keeping: s, spent in keeping in this sitting.
  Price price(const Simulation& simulation, double keeping) const;
  /// Keeps the seconds of all sittings, or gives back those of the sittings before.
  void archive(const Simulation& simulation, double keeping, Archive& archive);

 private:
  double stepping_ = 0, output_ = 0;  // s, of the sittings before
  StepTimes times_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
};

}  // namespace soilweave::dem
