// What a run under way is made of, so that it goes on bit by bit.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "dem/price.h"
#include "dem/simulation.h"
#include "io/part.h"

namespace soilweave::dem {

/// The simulation, its clock (keeping: s spent in checkpoints) and table, and whatever else has an archive().
template <class... Parts>
io::Moment moment_of(const Simulation& simulation, PriceClock& clock, double keeping, const io::Series& table,
                     Parts&... parts) {
  Archive archive;
  simulation.archive(archive);
  (parts.archive(archive), ...);
  clock.archive(simulation, keeping, archive);
  return {simulation.snapshot(), table, archive.numbers()};
}

/// Throws DataError where a number that a checkpoint keeps cannot be one of this run (an edited file). file: the
/// checkpoint; what: names the number.
inline void demand_kept(bool possible, const std::filesystem::path& file, const char* what) {
  if (!possible)
    throw DataError(file.string() + ": keeps a " + what +
                    " that this run cannot have; it was changed: give --force without --resume to begin anew");
}

}  // namespace soilweave::dem
