// What a run cost.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/price.h"

#include <fmt/format.h>

namespace soilweave::dem {

double Price::share(Phase phase) const {
  if (times.looked_at == 0 || !(stepping + output > 0)) return 0;
  return times.of(phase) * static_cast<double>(steps) / static_cast<double>(times.looked_at) / (stepping + output);
}

std::string Price::line() const {
  const double total = stepping + output;
  return fmt::format(
      "{} steps of {} grains with {:.0f} contacts in {:.3g} s: {:.4g} steps/s, {:.3g} ns per contact; contacts {:.0f} "
      "%, "
      "integration {:.0f} %, neighbours {:.0f} %, output {:.0f} %",
      steps, grains, contacts(), total, stepping > 0 ? static_cast<double>(steps) / stepping : 0, per_contact(),
      100 * share(Phase::contacts), 100 * share(Phase::integration), 100 * share(Phase::neighbours),
      total > 0 ? 100 * output / total : 0);
}

void Price::archive(Archive& a) {
  a.item("seconds_stepping", stepping), a.item("seconds_output", output);
  a.item("seconds_contacts", times.seconds[0]), a.item("seconds_integration", times.seconds[1]);
  a.item("seconds_neighbours", times.seconds[2]), a.item("steps_looked_at", times.looked_at);
}

}  // namespace soilweave::dem
