// Report of an assimilation for a reader.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/output/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "calibration/posterior.h"

namespace soilweave::calibration {
namespace {

// Least Assimilation::kept_share at which the observations tell almost nothing about the parameters.
constexpr double nothing_learnt = 0.99;
constexpr std::size_t listed_runs = 20, listed_steps = 12, named_runs = 3;

double degenerate_below(const Assimilation& a) { return static_cast<double>(a.ensemble.prior.size()) + 1; }

// Squared deviation of the nearest run, in variances per observation, that no error model explains: five deviations.
constexpr double far_misfit = 25;
// Root mean square of the deviations over that of the observations, above which a run does not have their size.
constexpr double far_share = 0.5;

std::string unit_of(const std::string& unit) { return unit.empty() || unit == "1" ? "" : " " + unit; }

std::string runs_text(const Assimilation& a) {
  std::string text = fmt::format("{} parameter sets, {} runs used", a.ensemble.size(), a.runs.used());
  for (const Fate fate : {Fate::missing, Fate::unreadable, Fate::unordered, Fate::not_finite, Fate::too_short})
    if (const auto n = std::count(a.runs.fate.begin(), a.runs.fate.end(), fate))
      text += fmt::format(", {} {}", n, word(fate));
  text += a.runs.used() == a.ensemble.size() ? ".\n" : "; those have no weight:\n";
  std::size_t listed = 0;
  for (std::size_t i = 0; i < a.runs.why.size(); ++i)
    if (a.runs.fate[i] != Fate::used && listed++ < listed_runs)
      text += fmt::format("  {} {}: {}\n", a.ensemble.id[i], word(a.runs.fate[i]), a.runs.why[i]);
  if (listed > listed_runs) text += fmt::format("  and {} more (--table runs)\n", listed - listed_runs);
  return text;
}

std::string observations_text(const Assimilation& a) {
  std::string text =
      fmt::format("{} observations to {} {:.6g}{}; standard deviation of their error:", a.observed.stations(),
                  a.observed.station.name, a.observed.at.back(), unit_of(a.observed.station.unit));
  for (std::size_t k = 0; k < a.observed.observables.size(); ++k) {
    const auto error = a.variance.col(static_cast<Eigen::Index>(k)).cwiseSqrt().eval();
    const double least = error.minCoeff(), most = error.maxCoeff();
    const Observable& what = a.observed.observables[k];
    text += fmt::format("{} {} {}{}", k > 0 ? "," : "", what.name,
                        least == most ? fmt::format("{:.4g}", least) : fmt::format("{:.4g} to {:.4g}", least, most),
                        unit_of(what.unit));
  }
  if (a.filtered.variance_factor != 1)
    text += fmt::format(" (variance {:.4g} times the given one)", a.filtered.variance_factor);
  return text + ".\n";
}

/// Returns about a dozen steps, with the last.
std::string steps_text(const Assimilation& a) {
  const auto last = static_cast<Eigen::Index>(a.observed.stations()) - 1;
  std::set<Eigen::Index> shown(a.chosen.begin(), a.chosen.end());
  for (std::size_t k = 0; k <= listed_steps; ++k)
    shown.insert(static_cast<Eigen::Index>(static_cast<std::size_t>(last) * k / listed_steps));
  std::string text = fmt::format("\n{:>16} {:>10} {:>13}", a.observed.station.name, "effective", "log evidence");
  for (const std::string& name : a.ensemble.prior.names()) text += fmt::format(" {:>17}", name);
  text += "\n";
  for (const Eigen::Index t : shown) {
    text += fmt::format("{:>16.6g} {:>10.4g} {:>13.6g}", a.observed.at[static_cast<std::size_t>(t)],
                        a.filtered.effective_size[t], a.filtered.log_evidence[t]);
    for (const double mean : weighted_mean(a.ensemble.values, a.filtered.weights(t)))
      text += fmt::format(" {:>17.7g}", mean);
    text += "\n";
  }
  return text;
}

std::string parameters_text(const Assimilation& a) {
  const Vector& w = a.ensemble.weight;
  const Vector mean = weighted_mean(a.ensemble.values, w);
  const Matrix covariance = weighted_covariance(a.ensemble.values, w);
  std::string text = fmt::format("\n{:<20} {:>12} {:>12} {:>12} {:>12}  {}\n", "at the end", "mean", "deviation", "5 %",
                                 "95 %", "prior");
  for (std::size_t k = 0; k < a.ensemble.prior.size(); ++k) {
    const auto c = static_cast<Eigen::Index>(k);
    const Range& range = a.ensemble.prior.ranges[k];
    const Vector values = a.ensemble.values.col(c);
    text +=
        fmt::format("{:<20} {:>12.6g} {:>12.4g} {:>12.6g} {:>12.6g}  {:.4g} to {:.4g}{}{}\n", range.name, mean[c],
                    std::sqrt(covariance(c, c)), weighted_quantile(values, w, 0.05), weighted_quantile(values, w, 0.95),
                    range.low, range.high, unit_of(range.unit), range.scale == Scale::log ? ", log" : "");
  }
  return text;
}

/// Returns the least root mean square of any run's deviations from observable c, over that of the observations. A
/// column of zeros has no size to compare with, and gives 0.
double nearest_share(const Assimilation& a, Eigen::Index c) {
  const Vector observed = a.observed.values.col(c);
  if (!(observed.norm() > 0)) return 0;
  double nearest = std::numeric_limits<double>::infinity();
  for (const Matrix& run : a.runs.values)
    if (run.size() > 0) nearest = std::min(nearest, (run.col(c) - observed).norm() / observed.norm());
  return nearest;
}

/// Returns the ways in which all runs are far from the observations. A variance that was searched for an effective size
/// says nothing about the fit; the share of the observed values does.
std::vector<std::string> distances(const Assimilation& a) {
  std::vector<std::string> all;
  const double misfit = a.misfit.rowwise().sum().minCoeff() / static_cast<double>(a.observed.values.size());
  if (a.filtered.variance_factor == 1 && misfit > far_misfit)
    all.push_back(fmt::format("the nearest run has a squared deviation of {:.4g} variances per observation", misfit));
  for (std::size_t k = 0; k < a.observed.observables.size(); ++k)
    if (const double share = nearest_share(a, static_cast<Eigen::Index>(k)); share > far_share)
      all.push_back(fmt::format("every run is off by {:.0f} % or more of the observed {}", 100 * share,
                                a.observed.observables[k].name));
  return all;
}

/// Returns how many runs have no weight, with the first of them and their reasons.
std::string unused_text(const Assimilation& a) {
  const std::size_t n = a.ensemble.size(), unused = n - a.runs.used();
  std::vector<std::string> first;
  for (std::size_t i = 0; i < n && first.size() < named_runs; ++i)
    if (a.runs.fate[i] != Fate::used)
      first.push_back(fmt::format("member {}, {} ({})", a.ensemble.id[i], word(a.runs.fate[i]),
                                  a.runs.why[i].substr(0, a.runs.why[i].find('\n'))));
  return fmt::format("{} of {} runs {} not used and {} no weight: {}{}; make such runs anew, or mend their tables",
                     unused, n, unused == 1 ? "is" : "are", unused == 1 ? "has" : "have", fmt::join(first, "; "),
                     unused > first.size() ? fmt::format("; {} more (--table runs)", unused - first.size()) : "");
}

}  // namespace

std::vector<Doubt> doubts(const Assimilation& a, bool weights_told) {
  std::vector<Doubt> list;
  const auto n = a.ensemble.size();
  if (a.runs.used() < n) list.push_back({"unused", unused_text(a)});
  if (!a.runs.unknown.empty())
    list.push_back(
        {"unknown",
         fmt::format("ids in --runs that no member of the ensemble has: {}, the first {}; their rows are left out",
                     a.runs.unknown.size(), a.runs.unknown.front())});
  if (const std::vector<std::string> far = distances(a); !far.empty() && !all_zero(a))
    list.push_back(
        {"far", fmt::format("no run comes near the observations: {}; check the units in the heads of both tables, and "
                            "the observables; else widen the prior",
                            fmt::join(far, ", and "))});
  list.insert(list.end(), a.runs.doubts.begin(), a.runs.doubts.end());
  if (!weights_told) return list;
  if (!a.ensemble.unused.empty())
    list.push_back({"unused_columns",
                    fmt::format("the sets differ in {}, which the prior lacks: no weight tells which values fit; give "
                                "the prior a [[parameter]] for each, or leave the columns out",
                                fmt::join(a.ensemble.unused, ", "))});
  const auto last = static_cast<Eigen::Index>(a.observed.stations()) - 1;
  const double size = a.filtered.effective_size[last];
  if (size < degenerate_below(a)) {
    Eigen::Index heaviest = 0;
    const double most = a.ensemble.weight.maxCoeff(&heaviest);
    Eigen::Index since = last;
    while (since > 0 && a.filtered.effective_size[since - 1] < degenerate_below(a)) --since;
    list.push_back(
        {"degenerate",
         fmt::format("degenerate: an effective sample size of {:.4g} of {} for {} parameters (so since {} {:.6g}); "
                     "{:.3g} of the weight is on member {}, means are next to its values, and deviations mean "
                     "nothing: resample, give more runs or a larger error",
                     size, n, a.ensemble.prior.size(), a.observed.station.name,
                     a.observed.at[static_cast<std::size_t>(since)], most,
                     a.ensemble.id[static_cast<std::size_t>(heaviest)])});
  } else if (a.runs.used() > 1 && a.kept_share > nothing_learnt) {
    list.push_back(
        {"uninformative",
         fmt::format("nothing is learnt: the observations leave {:.4g} of the weights before them effective; give a "
                     "smaller error, or check that the parameters change what the runs are compared by",
                     a.kept_share)});
  }
  return list;
}

std::optional<std::string> all_zero(const Assimilation& a) {
  for (Eigen::Index t = 0; t < a.filtered.least_misfit.size(); ++t)
    if (a.filtered.least_misfit[t] > underflow_misfit)
      return fmt::format(
          "at {} {:.6g} every likelihood is zero: the nearest run has a squared deviation of {:.4g} variances; weights "
          "only "
          "rank runs that are all far off: check units and observables, widen the prior or give a larger error",
          a.observed.station.name, a.observed.at[static_cast<std::size_t>(t)], a.filtered.least_misfit[t]);
  return std::nullopt;
}

std::string describe(const Assimilation& a) {
  return runs_text(a) + observations_text(a) + steps_text(a) + parameters_text(a);
}

}  // namespace soilweave::calibration
