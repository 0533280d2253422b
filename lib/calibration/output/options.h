// Options of pf-weight, and its output.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "calibration/ensemble.h"
#include "calibration/observations.h"
#include "calibration/particle_filter.h"
#include "core/cli/tool.h"
#include "files/exchange/table_output.h"
#include "files/files.h"

namespace soilweave::calibration {

inline constexpr Parameter samples_range{"samples,n", "1", 1, 1e7, false, "parameter sets", "an ensemble has members"};
inline constexpr Parameter first_range{
    "first", "1", 0, 1e15, false, "row of the sequence to begin with (0: the origin)", "rows count from 0"};
inline constexpr Parameter first_id_range{
    "first-id", "1", 0, 1e15, false, "number of the first parameter set", "numbers count from 0"};
inline constexpr Parameter least_size_range{
    "least-size", "1", 0, 1, true, "seek the error that keeps this share effective", "it is a share of the members"};
inline constexpr Parameter kept_size_range{"least-size",
                                           "1",
                                           0,
                                           1,
                                           true,
                                           "temper weights until this share of sets is effective",
                                           "it is a share of the members"};
inline constexpr Parameter components_range{"components",         "1", 1, 100, false, "most Gaussians of a mixture",
                                            "a mixture has parts"};
inline constexpr Parameter prior_share_range{
    "prior-share", "1", 0, 1, false, "share drawn from the prior, which bounds importance", "it is a share"};

/// Options for observations, columns of runs, and accuracy.
struct ComparisonOptions {
  std::string station, until, error, variance;
  std::string covariance = "uniform";
  std::vector<std::string> observables, where, stations;
  std::optional<double> least_size;
  bool greatest = false;

  /// Declares the options in a tool's table.
  void declare(tool::Table& table);
  /// Adds usage mistakes.
  void check(std::vector<std::string>& mistakes) const;
  /// Returns the selection.
  Choice choice() const;
  /// Returns the error model from --variance, or from --error, its standard deviation.
  ErrorModel model() const;
  /// Returns a reminder that --error is a standard deviation, if it applies: earlier scripts gave variances.
  std::optional<std::string> remark() const;
  /// Returns the stations of --at.
  std::vector<double> chosen_stations() const;
  /// Returns doubts about stations that the observations do not have: "at" if --at lies outside of them, "until" if
  /// --until lies so far beyond them that another unit is meant.
  std::vector<Doubt> doubts(const Observations& observed) const;
};

/// Throws DataError unless the ensemble has weights from which the next round can be drawn. keep: earlier rounds are
/// kept, so that their distributions are needed.
void demand_weights(const Ensemble& ensemble, const std::string& where, bool keep);

/// Output of a verb.
struct Output : io::TableOutput {
  /// Declares the options in a tool's table.
  void declare(tool::Table& table, std::string_view sentence);
  /// Throws UsageError with these mistakes and its own.
  void check(std::vector<std::string> mistakes, bool needed) const;
  /// Returns whether what is written or printed depends on the weights. name: of an assimilation's table.
  bool tells_weights(std::string_view name) const;
  /// Prints table (--tsv) or text, unless the file goes to standard output. Says the doubts. Writes the file, with the
  /// doubts in its history.
  void put(const io::EnsembleFile& ensemble, const io::Series& table, const std::string& text,
           const std::vector<io::Source>& sources, const tool::Invocation& invocation,
           const std::vector<Doubt>& doubts = {}) const;
};

}  // namespace soilweave::calibration
