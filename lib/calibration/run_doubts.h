// Doubts about the tables of runs that are compared with observations.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "calibration/observations.h"
#include "core/doubts.h"
#include "files/records.h"

namespace soilweave::calibration {

/// Finds the widest gap between two rows of a run in which a station of the observations lies.
class WidestGap {
 public:
  explicit WidestGap(const Observations& observed) : observed_(observed) {}
  /// Takes the stations of the rows of a member's run, increasing.
  void compare(const std::vector<double>& rows, std::int64_t id);
  /// Adds "coarse" if the gap is wider than a fifth of the stations' range: no curve is a straight line so far.
  void doubt(std::vector<Doubt>& doubts) const;

 private:
  const Observations& observed_;
  std::int64_t id_ = 0;
  double from_ = 0, to_ = 0, station_ = 0;
};

/// Finds runs whose tables name other parameters than the sets of their ids have, and members of other parameters whose
/// runs are equal.
class OtherSets {
 public:
  /// sets: parameters, one row a member. Columns that are compared with observations are no parameters.
  OtherSets(const io::Series& sets, const Observations& observed, const Choice& choice);
  /// Compares a run with row `member` of the sets. A column that varies is a quantity, not a parameter.
  void compare(const io::Series& run, std::int64_t id, std::size_t member);
  /// Adds "other_sets" if a run has a parameter that differs by more than a hundredth, and "equal_runs".
  void doubt(std::vector<Doubt>& doubts) const;

 private:
  void compare_rows(const io::Series& run, std::int64_t id, std::size_t member);

  const io::Series& sets_;
  std::vector<std::string> compared_;
  std::size_t runs_ = 0;
  std::string example_;
  /// First id and member by the digest of a run.
  std::map<std::string, std::pair<std::int64_t, std::size_t>> first_;
  std::vector<std::string> equal_;
};

/// Finds rows of several runs under one id where only the greatest values count, so that no station tells them apart.
class MixedRuns {
 public:
  MixedRuns(const Observations& observed, const Choice& choice);
  /// Takes the rows of a member's run. The runs are told apart by the first of these columns: step, time, the station,
  /// strain_axial. Without any of them the number of rows has to do.
  void compare(const io::Series& run, std::int64_t id);
  /// Adds "mixed" if a column falls by more than half of its rise, as no loop of unloading does, or if a run has a
  /// multiple of the rows that most runs have.
  void doubt(std::vector<Doubt>& doubts) const;

 private:
  std::vector<std::string> progress_;
  std::vector<std::string> begun_again_;
  std::map<std::int64_t, std::size_t> rows_;
};

}  // namespace soilweave::calibration
