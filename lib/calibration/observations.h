// Observations of the laboratory, and runs at their stations.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibration/prior.h"
#include "core/doubts.h"
#include "files/files.h"

namespace soilweave::calibration {

/// An observed quantity.
struct Observable {
  std::string name, unit;
  /// Columns of a run whose mean is compared with it.
  std::vector<std::string> columns;
};

/// Observations of C quantities at T stations.
struct Observations {
  Observable station;
  /// Positions of the T stations, increasing.
  std::vector<double> at;
  std::vector<Observable> observables;
  /// T x C, in the units of the table.
  Matrix values;

  /// Returns the number of stations.
  std::size_t stations() const { return at.size(); }
  /// Returns the distance by which rounding alone may move a station.
  double rounding() const;
};

/// Selection from tables.
struct Choice {
  /// NAME or NAME=COLUMN; empty: the first column.
  std::string station;
  /// NAME or NAME=COLUMN,...; empty: all columns but the station.
  std::vector<std::string> observables;
  /// Last station, in the unit of the station's column or with its own, as "7 %"; empty: all.
  std::string until;
  /// Rows of a run in which COLUMN equals number.
  std::vector<std::pair<std::string, double>> where;
  /// Compare the greatest value of a run, without stations.
  bool greatest = false;
};

/// Returns the observations of a table. Throws DataError for NaN (line and column), stations that do not increase, an
/// empty selection, a column that is selected twice, and several rows with Choice::greatest.
Observations observations(const io::Series& table, const Choice& choice, const std::string& where);

/// Fate of a member's run.
enum class Fate { used, missing, unreadable, unordered, not_finite, too_short };
/// Returns the fate as a word.
std::string_view word(Fate fate);

/// Runs of N members at the stations.
struct Simulated {
  /// T x C per member, in the observations' units; empty without a run.
  std::vector<Matrix> values;
  std::vector<Fate> fate;
  /// Reason; empty if used.
  std::vector<std::string> why;
  /// Ids in a table of all runs that no member has; their rows are left out.
  std::vector<std::int64_t> unknown;
  /// "coarse": stations lie within a wide gap between rows of a run. "other_sets": runs name other parameters than
  /// their members have. "equal_runs": see OtherSets. "mixed": rows of several runs seem to have one id.
  std::vector<Doubt> doubts;

  /// Returns the number of members with a used run.
  std::size_t used() const;
};

/// Returns the runs. A `pattern` with {id} (fmt's forms, {id:06}) names one HDF5 run or TSV per member; else it is one
/// TSV with column id. Values are interpolated between rows, never beyond; Choice::greatest takes the greatest of the
/// rows. Simulated::fate marks missing and unfit runs. `sets` (optional) holds the members' parameters, one row each.
/// Throws DataError for a missing column.
Simulated simulated(const std::string& pattern, const std::vector<std::int64_t>& ids, const Observations& observed,
                    const Choice& choice, std::vector<io::Source>& sources, const io::Series& sets = {});

}  // namespace soilweave::calibration
