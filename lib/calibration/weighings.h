// Observations that the weights of an ensemble include, found in the history of its file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "calibration/observations.h"
#include "files/provenance.h"

namespace soilweave::calibration {

/// One call of assimilate whose likelihoods the weights hold.
struct Weighing {
  /// Digest of the table of observations.
  std::string sha256;
  /// The call, with the observables that it names.
  std::string command;
};

/// Returns the calls that gave a file its weights: the last assimilate, and the earlier calls that it continued.
/// Earlier rounds do not count, since a new round begins without weights.
std::vector<Weighing> weighings_of(const io::History& history);

/// Throws DataError if an observable of this table has weighed the sets already, since it would count twice.
void demand_new(const std::vector<Weighing>& weighings, const io::Source& table, const Observations& observed);

}  // namespace soilweave::calibration
