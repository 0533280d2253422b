// An ensemble: numbered parameter sets, the distributions they were drawn from, and their weights.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "calibration/prior.h"
#include "calibration/rounds.h"
#include "files/files.h"

namespace soilweave::calibration {

/// N parameter sets of a prior.
struct Ensemble {
  Prior prior;
  std::vector<std::int64_t> id;
  Matrix values;              // row = member, column = parameter, in its unit
  Vector log_importance;      // log(prior density / density of all rounds together); 0 if drawn from the prior
  Vector weight;              // weights after assimilation, sum 1; empty before
  std::vector<Round> rounds;  // distributions that the members were drawn from; empty if unknown

  /// Returns the number of members.
  std::size_t size() const { return id.size(); }
  /// Returns the values in the prior's coordinates, one row per member.
  Matrix coordinates() const;
  /// Returns the log weights by importance alone, before any observation. The weights sum to 1.
  Vector log_prior_weight() const;
  /// Logs of the weights that assimilation gave, -inf for none. Throws DataError where no set has one.
  Vector log_weight() const;
};

/// Returns members drawn from the prior at the given coordinates (one row each), numbered from first_id.
Ensemble members_at(const Prior& prior, const Matrix& coordinates, std::int64_t first_id = 0);

/// Returns the table of id, parameters, log_importance if not all 0, and weight if there is one.
io::Series members_table(const Ensemble& ensemble);

/// Returns the file; log_importance is always in it.
io::EnsembleFile ensemble_file(const Ensemble& ensemble, std::vector<io::FieldsFile::Group> groups = {});

/// Reads an ensemble file, or a TSV with the column id and one column per parameter. A TSV needs the prior's TOML;
/// otherwise the prior is the range of its values. Throws DataError.
Ensemble read_ensemble(const std::filesystem::path& path, const std::filesystem::path& prior,
                       std::vector<io::Source>& sources);

}  // namespace soilweave::calibration
