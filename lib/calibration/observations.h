// What the laboratory measured, and the runs brought to the same stations.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "calibration/prior.h"
#include "io/files.h"

namespace soilweave::calibration {

/// One observed quantity and the columns of a run whose mean it is compared with.
struct Observable {
  std::string name, unit;
  std::vector<std::string> columns;
};

/// T stations, C observables.
struct Observations {
  Observable station;
  std::vector<double> at;  // T, increasing
  std::vector<Observable> observables;
  Matrix values;  // T x C, in the units of the table

  std::size_t stations() const { return at.size(); }
};

/// What to take from tables.
struct Choice {
  std::string station;                                // NAME or NAME=COLUMN; empty: the first column
  std::vector<std::string> observables;               // NAME or NAME=COLUMN,...; empty: all columns but the station
  std::optional<double> until;                        // the last station
  std::vector<std::pair<std::string, double>> where;  // rows of a run: COLUMN equal to the number
  bool greatest = false;                              // compare the greatest value of a run, at no station
};

/// Throws DataError for NaN (line and column), stations that do not increase, nothing left, and more rows than the one
/// that Choice::greatest can be compared with.
Observations observations(const io::Series& table, const Choice& choice, const std::string& where);

/// What became of a member's run.
enum class Fate { used, missing, unreadable, unordered, not_finite, too_short };
std::string_view word(Fate fate);

struct Simulated {
  std::vector<Matrix> values;  // of each member T x C in the units of the observations; empty where there is none
  std::vector<Fate> fate;
  std::vector<std::string> why;  // empty where used

  std::size_t used() const;
};

/// The runs of the members: `pattern` with {id} in it (fmt's forms, {id:06}) names a file each, an HDF5 run or a TSV;
/// without, one TSV whose column id names the member of each row. Values at stations are interpolated between rows,
/// never beyond them; with Choice::greatest each value is the greatest of the run's rows. A run that is missing or
/// unfit is told in the result; a column that is not there throws DataError.
Simulated simulated(const std::string& pattern, const std::vector<std::int64_t>& ids, const Observations& observed,
                    const Choice& choice, std::vector<io::Source>& sources);

}  // namespace soilweave::calibration
