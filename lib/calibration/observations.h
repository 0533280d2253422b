// Observations of the laboratory, and runs interpolated to their stations.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibration/prior.h"
#include "files/files.h"

namespace soilweave::calibration {

/// An observed quantity, and the columns of a run whose mean is compared with it.
struct Observable {
  std::string name, unit;
  std::vector<std::string> columns;
};

/// Observations of C quantities at T stations.
struct Observations {
  Observable station;
  std::vector<double> at;  // T, increasing
  std::vector<Observable> observables;
  Matrix values;  // T x C, in the units of the table

  /// Returns the number of stations.
  std::size_t stations() const { return at.size(); }
};

/// Selection from tables.
struct Choice {
  std::string station;                                // NAME or NAME=COLUMN; empty: the first column
  std::vector<std::string> observables;               // NAME or NAME=COLUMN,...; empty: all columns except the station
  std::optional<double> until;                        // last station
  std::vector<std::pair<std::string, double>> where;  // selects rows of a run: COLUMN equals number
  bool greatest = false;                              // compare the greatest value of a run, without stations
};

/// Returns the observations of a table. Throws DataError for NaN (line and column), stations that do not increase, an
/// empty selection, and several rows if Choice::greatest is set.
Observations observations(const io::Series& table, const Choice& choice, const std::string& where);

/// Fate of a member's run.
enum class Fate { used, missing, unreadable, unordered, not_finite, too_short };
/// Returns the fate as a word for tables and messages.
std::string_view word(Fate fate);

/// Runs of N members at the stations of the observations.
struct Simulated {
  std::vector<Matrix> values;  // T x C per member, in the units of the observations; empty without a run
  std::vector<Fate> fate;
  std::vector<std::string> why;  // reason; empty if used

  /// Returns the number of members with a used run.
  std::size_t used() const;
};

/// Returns the runs of the members. A `pattern` with {id} (in fmt's forms, {id:06}) names one file per member, an HDF5
/// run or a TSV. Without it, `pattern` is one TSV whose column id names the member of each row. Values are interpolated
/// between rows, never beyond them; with Choice::greatest they are the greatest of the run's rows. The result tells of
/// missing and unfit runs. A missing column throws DataError.
Simulated simulated(const std::string& pattern, const std::vector<std::int64_t>& ids, const Observations& observed,
                    const Choice& choice, std::vector<io::Source>& sources);

}  // namespace soilweave::calibration
