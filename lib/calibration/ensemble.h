// Numbered parameter sets, their distributions, and their weights.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "calibration/prior.h"
#include "calibration/rounds.h"
#include "calibration/weighings.h"
#include "core/doubts.h"
#include "files/files.h"

namespace soilweave::calibration {

/// N parameter sets of a prior.
struct Ensemble {
  Prior prior;
  std::vector<std::int64_t> id;
  /// Row = member, column = parameter, in its unit.
  Matrix values;
  /// log(prior density / density of all rounds); 0 if drawn from the prior.
  Vector log_importance;
  /// Weights after assimilation, sum 1; empty before.
  Vector weight;
  /// Distributions of the draws; empty if unknown.
  std::vector<Round> rounds;
  /// True if no prior was given beside a table: the ranges are those of its sets.
  bool assumed_prior = false;
  /// Calls whose observations the weights include, from the history of the file.
  std::vector<Weighing> weighings;
  /// Columns of a table that differ between sets and that its prior lacks.
  std::vector<std::string> unused;

  /// Returns the number of members.
  std::size_t size() const { return id.size(); }
  /// Returns the parameters alone, one row per member.
  io::Series parameters() const;
  /// Returns the prior's coordinates, one row per member.
  Matrix coordinates() const;
  /// Returns log weights by importance alone; the weights sum to 1.
  Vector log_prior_weight() const;
  /// Returns log weights after assimilation, -inf for none. Throws DataError if no set has one.
  Vector log_weight() const;
};

/// Returns members drawn from the prior at coordinates, one row each, numbered from first_id.
Ensemble members_at(const Prior& prior, const Matrix& coordinates, std::int64_t first_id = 0);

/// Returns id, parameters, log_importance if not all 0, and weight if present.
io::Series members_table(const Ensemble& ensemble);

/// Returns the file, with log_importance.
io::EnsembleFile ensemble_file(const Ensemble& ensemble, std::vector<io::FieldsFile::Group> groups = {});

/// Reads an ensemble file, or a TSV with id and one column per parameter. A TSV takes the prior's TOML, else the range
/// of its values on a linear scale. A file has its own prior. Throws DataError, also for a given prior that differs
/// from the file's.
Ensemble read_ensemble(const std::filesystem::path& path, const std::filesystem::path& prior,
                       std::vector<io::Source>& sources);

/// Returns "prior" if the ranges are those of the sets alone, and "weights" if the ensemble has weights of an earlier
/// test but the next one does not go on from them.
std::vector<Doubt> doubts(const Ensemble& ensemble, bool goes_on);

}  // namespace soilweave::calibration
