// A checkpoint of a simulation, from which the run continues to equal bits.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"
#include "dem/engine/simulation.h"
#include "dem/run/cost.h"
#include "files/part.h"

namespace soilweave::dem {

/// Returns a checkpoint of the simulation, its clock, its table and all other parts with an archive().
/// `keeping`: time spent on recording, s.
template <class... Parts>
io::Checkpoint checkpoint_of(const Simulation& simulation, CostClock& clock, double keeping, const io::Series& table,
                             Parts&... parts) {
  Archive archive;
  simulation.archive(archive);
  (parts.archive(archive), ...);
  clock.archive(simulation, keeping, archive);
  return {simulation.snapshot(), table, archive.numbers()};
}

/// Throws DataError, which names the checkpoint and the number, if the number is impossible in this run.
inline void demand_kept(bool possible, const std::filesystem::path& file, const char* what) {
  if (!possible)
    throw DataError(file.string() + ": keeps a " + what +
                    " that this run cannot have; it was changed: give --force without --resume to begin anew");
}

}  // namespace soilweave::dem
