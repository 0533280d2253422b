// Options of pf-weight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/output/options.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/text/number_word.h"
#include "files/exchange/table.h"
#include "files/provenance.h"

namespace soilweave::calibration {
namespace {

/// Parses COLUMN=NUMBER; an empty name for any other form.
std::pair<std::string, double> condition(const std::string& text) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos) return {};
  const std::vector<double> value = numbers_of_list(text.substr(equals + 1));
  return value.size() == 1 ? std::pair{text.substr(0, equals), value.front()} : std::pair<std::string, double>{};
}

/// True where the error model is made of variances, false where it is made of relative standard deviations.
bool squared(const std::string& covariance) { return covariance == "uniform" || covariance == "component"; }

/// Returns the sizes of errors; none if a part is no number above 0. A share may be in per cent.
std::vector<double> error_sizes(const std::string& text, bool share) {
  std::vector<double> sizes;
  for (const std::string& part : parts_of_list(text)) {
    const bool per_cent = share && part.ends_with('%');
    const double size = number_of(trimmed(part.substr(0, part.size() - (per_cent ? 1 : 0)))).value_or(NAN);
    if (!(size > 0 && std::isfinite(size))) return {};
    sizes.push_back(per_cent ? size / 100 : size);
  }
  return sizes;
}

/// Returns the expected form of errors that are not shares, for messages.
std::string squared_words(const std::string& text) {
  return std::string("numbers above 0, as 0.1 or 0.1,0.02") +
         (text.find('%') == std::string::npos ? "" : "; a share of the observations goes with --covariance largest");
}

}  // namespace

void ComparisonOptions::declare(tool::Table& t) {
  t.option(station, "station", "NAME[=COLUMN]", "column by which runs are compared; else the first one");
  t.option(observables, "observe", "NAME[=COLUMN,...]", "compare with (the mean of) columns of runs; else all");
  t.option(where, "where", "COLUMN=NUMBER", "use only these rows of the runs, as stage=1");
  t.option(until, "until", "STATION", "last station to use, in its unit or with one, as \"7 %\"");
  t.flag(greatest, "greatest", "compare the greatest values of each run, with a single row of observations");
  t.choice(covariance, "covariance", {"uniform", "component", "relative", "largest"},
           "error's variance: one for all, one each; or a share of each value, or of the greatest");
  t.option(error, "error", "S[,S...]", "standard deviations, or a share, as 0.05 or \"5 %\"");
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
    const std::vector<double> sizes = error_sizes(text, !squares);
    if (!text.empty() && sizes.empty())
      mistakes.push_back(fmt::format("{} {}: give {}", name, text,
                                     squares ? squared_words(text) : "a share above 0, as 0.05 or \"5 %\""));
    else if (!squares && !sizes.empty() && *std::max_element(sizes.begin(), sizes.end()) > 1)
      mistakes.push_back(
          fmt::format("{} {}: is a share with --covariance {}, and above 1; write 5 per cent as 0.05 or \"5 %\"", name,
                      text, covariance));
  }
  if (!until.empty() && !std::isfinite(number_of(until.substr(0, until.find_first_of(" %"))).value_or(NAN)))
    mistakes.push_back(fmt::format("--until: {}", no_number(until, "finite number")));
  for (const std::string& text : where)
    if (condition(text).first.empty())
      mistakes.push_back(fmt::format("--where {}: write COLUMN=NUMBER, as stage=1", text));
  for (const std::string& text : stations)
    if (numbers_of_list(text).empty()) mistakes.push_back(fmt::format("--at {}: give a number", text));
}

Choice ComparisonOptions::choice() const {
  Choice chosen{station, observables, until, {}, greatest};
  for (const std::string& text : where) chosen.where.push_back(condition(text));
  return chosen;
}

ErrorModel ComparisonOptions::model() const {
  if (!variance.empty()) return {error_kind(covariance), numbers_of_list(variance)};
  std::vector<double> sizes = error.empty() ? std::vector<double>{1} : error_sizes(error, !squared(covariance));
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
    for (const double at : numbers_of_list(text)) list.push_back(at);
  return list;
}

void Output::declare(tool::Table& table, std::string_view sentence) {
  TableOutput::declare(table, "print tab-separated text", std::string(sentence));
  table.unrecorded("tsv");
}

void Output::check(std::vector<std::string> mistakes, bool needed) const {
  needed ? check_needed(mistakes) : TableOutput::check(mistakes);
  io::demand_none(mistakes);
}

bool Output::tells_weights(std::string_view name) const {
  return !tsv || !file.empty() || (name != "runs" && name != "curves");
}

void Output::put(const io::EnsembleFile& ensemble, const io::Series& table, const std::string& text,
                 const std::vector<io::Source>& sources, const tool::Invocation& invocation,
                 const std::vector<Doubt>& doubts) const {
  print(table, text);
  Doubts said(invocation.tool);
  said.add_all(doubts);
  if (file.empty()) return;
  io::write_ensemble(file, ensemble, io::with_doubts(io::extend(sources, invocation, ensemble.prior), said));
}

}  // namespace soilweave::calibration
