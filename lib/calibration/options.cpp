// Options of pf-weight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "core/error.h"
#include "files/exchange/table.h"

namespace soilweave::calibration {
namespace {

/// Parses "0.1,0.2"; empty if a part is no number.
std::vector<double> numbers(const std::string& text) {
  std::vector<double> list;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t end = std::min(text.find(',', at), text.size());
    double value = 0;
    const auto [stop, status] = std::from_chars(text.data() + at, text.data() + end, value);
    if (status != std::errc() || stop != text.data() + end || !std::isfinite(value)) return {};
    list.push_back(value);
    at = end + 1;
  }
  return list;
}

/// Parses COLUMN=NUMBER; an empty name for any other form.
std::pair<std::string, double> condition(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return {};
  const std::vector<double> value = numbers(text.substr(equals + 1));
  return value.size() == 1 ? std::pair{text.substr(0, equals), value.front()} : std::pair<std::string, double>{};
}

/// True where the error model is made of variances, false where it is made of relative standard deviations.
bool squared(const std::string& covariance) { return covariance == "uniform" || covariance == "component"; }

}  // namespace

void ComparisonOptions::declare(tool::Table& t) {
  t.option(station, "station", "NAME[=COLUMN]", "column by which runs are compared; else the first one");
  t.option(observables, "observe", "NAME[=COLUMN,...]", "compare with (the mean of) columns of runs; else all");
  t.option(where, "where", "COLUMN=NUMBER", "use only these rows of the runs, as stage=1");
  t.option(until, until_range);
  t.flag(greatest, "greatest", "compare the greatest values of each run, with a single row of observations");
  t.choice(covariance, "covariance", {"uniform", "component", "relative", "largest"},
           "error's variance: one for all, one each; or a share of each value, or of the greatest");
  t.option(error, "error", "S[,S...]", "standard deviations, or a relative one");
  t.option(variance, "variance", "V[,V...]", "variances instead (uniform, component)");
  t.option(least_size, least_size_range);
  t.option(stations, "at", "STATION", "also give densities and covariances here");
}

void ComparisonOptions::check(std::vector<std::string>& mistakes) const {
  const bool squares = squared(covariance);
  if (!error.empty() && !variance.empty())
    mistakes.emplace_back("--error and --variance both say how exact the observations are: give one of them");
  else if (!variance.empty() && !squares)
    mistakes.push_back(
        fmt::format("--covariance {}: an error that is a share has no --variance; give --error, its standard deviation",
                    covariance));
  else if (error.empty() && variance.empty() && !least_size)
    mistakes.emplace_back("how exact are the observations? Give --error, as 0.1, or --least-size, as 0.2");
  else if (error.empty() && variance.empty() && covariance == "component")
    mistakes.emplace_back("--covariance component: give --error with a standard deviation for each observable");
  for (const auto& [name, text] : {std::pair{"--error", error}, std::pair{"--variance", variance}}) {
    const std::vector<double> sizes = numbers(text);
    if (!text.empty() && (sizes.empty() || *std::min_element(sizes.begin(), sizes.end()) <= 0))
      mistakes.push_back(fmt::format("{} {}: give numbers above 0, as 0.1 or 0.1,0.02", name, text));
  }
  for (const std::string& text : where)
    if (condition(text).first.empty())
      mistakes.push_back(fmt::format("--where {}: write COLUMN=NUMBER, as stage=1", text));
  for (const std::string& text : stations)
    if (numbers(text).empty()) mistakes.push_back(fmt::format("--at {}: give a number", text));
}

Choice ComparisonOptions::choice() const {
  Choice chosen{station, observables, until, {}, greatest};
  for (const std::string& text : where) chosen.where.push_back(condition(text));
  return chosen;
}

ErrorModel ComparisonOptions::model() const {
  if (!variance.empty()) return {error_kind(covariance), numbers(variance)};
  std::vector<double> sizes = error.empty() ? std::vector<double>{1} : numbers(error);
  if (squared(covariance))
    for (double& size : sizes) size *= size;
  return {error_kind(covariance), sizes};
}

std::optional<std::string> ComparisonOptions::remark() const {
  if (error.empty() || !squared(covariance)) return std::nullopt;
  return fmt::format("--error {} is a standard deviation; for what used to be --error, a variance, write --variance {}",
                     error, error);
}

std::vector<double> ComparisonOptions::chosen_stations() const {
  std::vector<double> list;
  for (const std::string& text : stations)
    for (const double at : numbers(text)) list.push_back(at);
  return list;
}

void Output::declare(tool::Table& table, std::string_view sentence) {
  table.flag(tsv, "tsv", "print tab-separated text");
  table.unrecorded("tsv");
  table.optional_output(file, std::string(sentence));
}

void Output::check(std::vector<std::string> mistakes, bool needed) const {
  if (tsv && file == "-") mistakes.emplace_back("--tsv and -o - both write to standard output: give one of them");
  if (needed && !tsv && file.empty()) mistakes.emplace_back("nothing to do: give --tsv or -o FILE");
  if (!mistakes.empty()) throw UsageError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

void Output::put(const io::EnsembleFile& ensemble, const io::Series& table, const std::string& text,
                 const std::vector<io::Source>& sources, const tool::Invocation& invocation) const {
  if (file != "-") std::fputs(tsv ? io::to_tsv(table).c_str() : text.c_str(), stdout);
  if (!file.empty()) io::write_ensemble(file, ensemble, io::extend(sources, invocation, ensemble.prior));
}

}  // namespace soilweave::calibration
