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
  t.refuse(
      {"at"}, [this] { return greatest; }, "beside --greatest, which compares at no station");
  t.refuse(
      {"station"}, [this] { return greatest && until.empty(); },
      "beside --greatest without --until, where no station counts");
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

std::vector<Doubt> ComparisonOptions::doubts(const Observations& observed) const {
  std::vector<Doubt> list;
  const double first = observed.at.front(), last = observed.at.back(), slack = 1e-3 * std::abs(last);
  const std::string unit = observed.station.unit.empty() ? "" : " " + observed.station.unit;
  const std::string ends = fmt::format("{} from {:.6g} to {:.6g}{}", observed.station.name, first, last, unit);
  for (const double at : chosen_stations())
    if (list.empty() && (at < first - slack || at > last + slack))
      list.push_back({"at", fmt::format("--at {:.6g} lies outside of the observations, {}, and the nearest one counts "
                                        "instead; give a station among them, in the unit of {}",
                                        at, ends, observed.station.name)});
  const double limit = number_of(until.substr(0, until.find_first_of(" %"))).value_or(NAN);
  // A strain in per cent read as a fraction is a hundred times the last one.
  if (until.find_first_of(" %") == std::string::npos && limit > 20 * std::abs(last))
    list.push_back(
        {"until", fmt::format("--until {} lies far beyond the observations, {}, and leaves none out; {}", until, ends,
                              observed.station.unit.empty() || observed.station.unit == "1"
                                  ? fmt::format("if per cent are meant, write \"{} %\"", until)
                                  : fmt::format("give it in {}, or leave it out", observed.station.unit))});
  return list;
}

void demand_weights(const Ensemble& ensemble, const std::string& where, bool keep) {
  if (ensemble.weight.size() == 0)
    throw DataError(fmt::format("{}: has no weights; assimilate observations first", where));
  if (!(ensemble.weight.sum() > 0))
    throw DataError(fmt::format(
        "{}: all weights are zero: no set is left to go on from; assimilate again, with a larger --error", where));
  if (keep && ensemble.rounds.empty())
    throw DataError(fmt::format(
        "{}: does not record the distribution of its sets; draw them anew, or resample without --keep", where));
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
