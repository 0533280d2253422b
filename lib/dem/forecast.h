// What a run will take, from its input: steps, time, memory, file. A few steps are tried, to time them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "dem/price.h"
#include "dem/scenario.h"

namespace soilweave::dem {

struct Forecast {
  struct OfStage {
    std::string name;
    std::size_t stations = 0;
    double steps = 0;    // a guess: how fast grains come to rest is known when they have
    double waiting = 0;  // of them, until rest
    bool paced = false;  // on the way slower than given, then sooner at rest: not foreseen
  };
  std::vector<OfStage> stages;
  double stability_limit = 0, time_step = 0;  // s, at the start
  double unbalanced_force = 0, largest_overlap = 0;
  std::size_t states = 0;  // recorded
  double file_bytes = 0, memory_bytes = 0;
  Price price;

  /// The lines for the user.
  std::string text() const;
};

/// start: as run() takes it. Throws what a run's first steps throw.
Forecast forecast(const io::Snapshot& start, const Scenario& scenario);

}  // namespace soilweave::dem
