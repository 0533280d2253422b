// An ensemble: parameter sets, each with a number that stays with it, where they were drawn from, and their weights.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "calibration/prior.h"
#include "calibration/rounds.h"
#include "io/files.h"

namespace soilweave::calibration {

struct Ensemble {
  Prior prior;
  std::vector<std::int64_t> id;
  Matrix values;              // a row a member, a column a parameter, in its unit
  Vector log_importance;      // log of the prior density over that of all rounds together; 0 where drawn from the prior
  Vector weight;              // after assimilation, sum 1; empty before
  std::vector<Round> rounds;  // what the members were drawn from; empty where that is not known

  std::size_t size() const { return id.size(); }
  /// Values in the prior's coordinates, a row a member.
  Matrix coordinates() const;
  /// What importance alone gives, before any observation: log weights, sum of weights 1.
  Vector log_prior_weight() const;
};

/// Members numbered from first_id at the given coordinates (a row each), drawn from the prior.
Ensemble members_at(const Prior& prior, const Matrix& coordinates, std::int64_t first_id = 0);

/// id, parameters, log_importance where it is not 0 for all, weight where there is one.
io::Series members_table(const Ensemble& ensemble);

/// For files; log_importance is always there.
io::EnsembleFile ensemble_file(const Ensemble& ensemble, std::vector<io::FieldsFile::Group> groups = {});

/// An ensemble file, or a TSV with the column id and one a parameter; a TSV needs the prior's TOML, else the prior is
/// the range that its values span. Throws DataError.
Ensemble read_ensemble(const std::filesystem::path& path, const std::filesystem::path& prior,
                       std::vector<io::Source>& sources);

}  // namespace soilweave::calibration
