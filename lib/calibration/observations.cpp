// Observations of the laboratory, and runs interpolated to their stations.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "calibration/observations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "calibration/run_doubts.h"
#include "core/error.h"
#include "core/text/number_word.h"
#include "core/text/text.h"
#include "core/text/units.h"
#include "files/exchange/table.h"
#include "files/provenance.h"

namespace soilweave::calibration {
namespace {

/// Parses "NAME=COLUMN,COLUMN": the observed column and those of a run.
Observable observable(const std::string& text, const io::Series& table) {
  const std::size_t equals = text.find('=');
  const io::Column& column = table.at(text.substr(0, equals));
  Observable one{column.name, column.unit, {}};
  one.columns = equals == std::string::npos ? std::vector{column.name} : parts_of_list(text.substr(equals + 1));
  return one;
}

/// Returns the factor from a run's column to the observation's unit. A column without a unit holds pure numbers.
double factor_between(const io::Column& run, const Observable& observed) {
  if (run.unit == observed.unit) return 1;
  if (run.unit.empty() != observed.unit.empty()) {
    const std::string& known = run.unit.empty() ? observed.unit : run.unit;
    if (known == "1") return 1;
    throw DataError(fmt::format(
        "column {} has no unit {}, and is in {} {}: write {} [{}] in the header",
        run.unit.empty() ? run.name : observed.name, run.unit.empty() ? "in the run" : "in the observations", known,
        run.unit.empty() ? "in the observations" : "in the run", run.unit.empty() ? run.name : observed.name, known));
  }
  return unit_factor(run.unit, observed.unit);
}

/// Returns the mean of the columns of a run, in the observation's unit.
std::vector<double> column_of(const io::Series& run, const Observable& what) {
  std::vector<double> mean(run.rows(), 0);
  for (const std::string& name : what.columns) {
    const io::Column& column = run.at(name);
    const double factor = factor_between(column, what);
    for (std::size_t r = 0; r < mean.size(); ++r)
      mean[r] += column.values[r] * factor / static_cast<double>(what.columns.size());
  }
  return mean;
}

/// Returns the rows of a table that meet every condition.
io::Series selected(const io::Series& table, const std::vector<std::pair<std::string, double>>& conditions) {
  if (conditions.empty()) return table;
  std::vector<bool> keep(table.rows(), true);
  for (const auto& [name, value] : conditions) {
    const io::Column& column = table.at(name);
    for (std::size_t r = 0; r < keep.size(); ++r) keep[r] = keep[r] && column.values[r] == value;
  }
  io::Series rows = table;
  for (io::Column& column : rows.columns) {
    std::size_t kept = 0;
    for (std::size_t r = 0; r < keep.size(); ++r)
      if (keep[r]) column.values[kept++] = column.values[r];
    column.values.resize(kept);
  }
  return rows;
}

struct Unfit {
  Fate fate;
  std::string why;
};

/// Returns the greatest value of each observable over the rows of a run. Throws Unfit.
Matrix greatest_values(const std::vector<std::vector<double>>& columns, const Observations& observed) {
  Matrix values(1, index(columns.size()));
  for (std::size_t c = 0; c < columns.size(); ++c) {
    for (std::size_t r = 0; r < columns[c].size(); ++r)
      if (!std::isfinite(columns[c][r]))
        throw Unfit{Fate::not_finite, fmt::format("{} of row {} is not finite", observed.observables[c].name, r + 1)};
    values(0, index(c)) = *std::max_element(columns[c].begin(), columns[c].end());
  }
  return values;
}

/// Returns a run at the stations. Widens the widest gap between rows, and notes mixed runs. Throws Unfit.
Matrix at_stations(const io::Series& whole, const Observations& observed, const Choice& choice, std::int64_t id,
                   WidestGap& widest, MixedRuns& mixed) {
  const io::Series run = selected(whole, choice.where);
  std::vector<std::vector<double>> columns;  // read first, since a missing column is a mistake of the user
  for (const Observable& what : observed.observables) columns.push_back(column_of(run, what));
  if (run.rows() == 0) throw Unfit{Fate::too_short, "has no rows"};
  if (choice.greatest) {
    mixed.compare(run, id);
    return greatest_values(columns, observed);
  }
  const std::vector<double> x = column_of(run, observed.station);
  for (std::size_t r = 0; r < x.size(); ++r) {
    if (!std::isfinite(x[r]))
      throw Unfit{Fate::not_finite, fmt::format("{} of row {} is not finite", observed.station.name, r + 1)};
    if (r > 0 && !(x[r] > x[r - 1]))
      throw Unfit{Fate::unordered,
                  fmt::format("{} does not increase from row {} to {}", observed.station.name, r, r + 1)};
  }
  const double slack = observed.rounding();
  const auto& name = observed.station.name;
  if (x.back() < observed.at.back() - slack)
    throw Unfit{Fate::too_short,
                fmt::format("ends at {} {:.6g}, the observations at {:.6g}", name, x.back(), observed.at.back())};
  if (x.front() > observed.at.front() + slack)
    throw Unfit{Fate::too_short,
                fmt::format("begins at {} {:.6g}, the observations at {:.6g}", name, x.front(), observed.at.front())};
  Matrix values(index(observed.stations()), index(observed.observables.size()));
  for (std::size_t c = 0; c < observed.observables.size(); ++c) {
    const std::vector<double>& y = columns[c];
    std::size_t r = 0;
    for (std::size_t t = 0; t < observed.stations(); ++t) {
      while (r + 2 < x.size() && x[r + 1] < observed.at[t]) ++r;
      const double at = std::clamp(observed.at[t], x.front(), x.back());
      const double value = x.size() == 1 ? y[0] : std::lerp(y[r], y[r + 1], (at - x[r]) / (x[r + 1] - x[r]));
      if (!std::isfinite(value))
        throw Unfit{Fate::not_finite,
                    fmt::format("{} at {} {:.6g} is not finite", observed.observables[c].name, name, observed.at[t])};
      values(index(t), index(c)) = value;
    }
  }
  widest.compare(x, id);
  return values;
}

/// Splits one table for all members by its column id.
std::map<std::int64_t, io::Series> by_member(const io::Series& table, const std::string& where) {
  std::map<std::int64_t, io::Series> members;
  const io::Column& id = table.at("id");
  for (std::size_t r = 0; r < table.rows(); ++r) {
    if (!(std::abs(id.values[r]) < 1e15 && id.values[r] == std::round(id.values[r])))
      throw DataError(fmt::format("{}: row {}: id {} is no whole number", where, r + 1, id.values[r]));
    io::Series& member = members[static_cast<std::int64_t>(id.values[r])];
    if (member.columns.empty())
      for (const io::Column& c : table.columns) member.columns.push_back({c.name, c.unit, c.long_name, {}});
    for (std::size_t c = 0; c < table.columns.size(); ++c)
      member.columns[c].values.push_back(table.columns[c].values[r]);
  }
  return members;
}

std::string path_of(const std::string& pattern, std::int64_t id) {
  // The width is checked first, since formatting would otherwise build a name of a million digits.
  for (std::size_t at = pattern.find('{'); at != std::string::npos; at = pattern.find('{', at + 1)) {
    const std::string_view field = std::string_view(pattern).substr(at, pattern.find('}', at) - at);
    if (std::count_if(field.begin(), field.end(), [](char c) { return c >= '0' && c <= '9'; }) > 3)
      throw UsageError(
          fmt::format("--runs {}: the member's number is too wide; write it as {{id}} or {{id:06}}", pattern));
  }
  try {
    return fmt::format(fmt::runtime(pattern), fmt::arg("id", id));
  } catch (const fmt::format_error& error) {
    throw UsageError(
        fmt::format("--runs {}: {}; write the member's number as {{id}} or {{id:06}}", pattern, error.what()));
  }
}

/// Returns the series of one run. Throws Unfit if it is missing or cannot be read.
io::SeriesFile read_member(const std::string& path) {
  try {
    if (io::is_hdf5(path)) return io::read_run_series(path);
    const io::TextFile text = io::read_text(path, "run");
    return {io::from_tsv(text.text, path), text.source};
  } catch (const MissingInput&) {
    throw Unfit{Fate::missing, path + ": no such file"};
  } catch (const Error& error) {
    throw Unfit{Fate::unreadable, error.what()};
  }
}

/// Returns all runs as one source: a digest of the lines "id digest", and the history of the first run.
io::Source together(const std::vector<std::pair<std::int64_t, io::Source>>& runs) {
  std::string lines;
  for (const auto& [id, source] : runs) lines += fmt::format("{} {}\n", id, source.sha256);
  return {"runs", io::sha256(lines), runs.empty() ? io::History{} : runs.front().second.history};
}

/// Returns the last station, in the unit of the stations; infinity if all are used.
double last_station(const std::string& until, const Observable& station, const std::string& where) {
  if (until.empty()) return INFINITY;
  try {
    return quantity(until, station.unit.empty() ? "1" : station.unit);
  } catch (const DataError& error) {
    throw DataError(fmt::format("{}: --until: {}", where, error.what()));
  }
}

}  // namespace

std::string_view word(Fate fate) {
  switch (fate) {
    case Fate::used:
      return "used";
    case Fate::missing:
      return "missing";
    case Fate::unreadable:
      return "unreadable";
    case Fate::unordered:
      return "out of order";
    case Fate::not_finite:
      return "diverged";
    case Fate::too_short:
      return "too short";
  }
  return "";
}

double Observations::rounding() const { return 1e-6 * (std::abs(at.back()) + std::abs(at.front())); }

std::size_t Simulated::used() const {
  return static_cast<std::size_t>(std::count(fate.begin(), fate.end(), Fate::used));
}

Observations observations(const io::Series& table, const Choice& choice, const std::string& where) {
  if (table.columns.empty()) throw DataError(where + ": has no columns");
  Observations found;
  const auto named = [&](const std::string& name) {
    try {
      return observable(name, table);
    } catch (const DataError& error) {
      throw DataError(fmt::format("{}: {}", where, error.what()));
    }
  };
  found.station = named(choice.station.empty() ? table.columns.front().name : choice.station);
  for (const std::string& name : choice.observables) found.observables.push_back(named(name));
  if (found.observables.empty())
    for (const io::Column& column : table.columns)
      if (column.name != found.station.name) found.observables.push_back(observable(column.name, table));
  if (found.observables.empty()) throw DataError(where + ": nothing observed beside " + found.station.name);
  for (std::size_t k = 0; k < found.observables.size(); ++k) {
    const std::string& name = found.observables[k].name;
    if (std::count_if(found.observables.begin(), found.observables.end(),
                      [&](const Observable& other) { return other.name == name; }) > 1)
      throw DataError(fmt::format("{}: {} is to be observed twice, and would count twice: name it once", where, name));
    if (name == found.station.name && !choice.greatest)
      throw DataError(
          fmt::format("{}: {} is the station, at which every run agrees with it: leave it out of --observe, or name "
                      "another --station",
                      where, name));
  }
  const std::vector<double>& at = table.at(found.station.name).values;
  std::size_t rows = 0;
  const double limit = last_station(choice.until, found.station, where);
  while (rows < at.size() && !(at[rows] > limit + 1e-9 * std::abs(limit))) ++rows;
  if (rows == 0)
    throw DataError(at.empty() ? where + ": no observations"
                               : fmt::format("{}: no observations up to --until {}: the first is at {}{}{}", where,
                                             choice.until, number_text(at.front()),
                                             found.station.unit.empty() ? "" : " ", found.station.unit));
  if (choice.greatest && rows != 1)
    throw DataError(fmt::format(
        "{}: {} rows where --greatest compares one value of a run: keep the row of its test, or end at it with --until",
        where, rows));
  found.at.assign(at.begin(), at.begin() + static_cast<std::ptrdiff_t>(rows));
  for (std::size_t r = 0; r < rows; ++r) {
    if (!std::isfinite(at[r]))
      throw DataError(fmt::format("{}: row {}: {} is not finite", where, r + 1, found.station.name));
    if (r > 0 && !(at[r] > at[r - 1]))
      throw DataError(fmt::format("{}: row {}: {} {} is not above {}; sort the rows, keep one of equal ones", where,
                                  r + 1, found.station.name, at[r], at[r - 1]));
  }
  found.values.resize(index(rows), index(found.observables.size()));
  for (std::size_t c = 0; c < found.observables.size(); ++c) {
    const io::Column& column = table.at(found.observables[c].name);
    for (std::size_t r = 0; r < rows; ++r) {
      if (!std::isfinite(column.values[r]))
        throw DataError(
            fmt::format("{}: row {}: {} is not finite; take the row out, or leave the column out by --observe", where,
                        r + 1, column.name));
      found.values(index(r), index(c)) = column.values[r];
    }
  }
  return found;
}

Simulated simulated(const std::string& pattern, const std::vector<std::int64_t>& ids, const Observations& observed,
                    const Choice& choice, std::vector<io::Source>& sources, const io::Series& sets) {
  Simulated all;
  WidestGap widest(observed);
  OtherSets others(sets, observed, choice);
  MixedRuns mixed(observed, choice);
  const bool one_table = pattern.find('{') == std::string::npos;
  std::map<std::int64_t, io::Series> members;
  if (one_table) {
    const io::TextFile text = io::read_text(pattern, "runs");
    sources.push_back(text.source);
    const io::Series table = io::from_tsv(text.text, pattern);
    try {
      if (!choice.greatest) column_of(table, observed.station);
      table.at("id");
    } catch (const DataError& error) {
      throw DataError(fmt::format("{}: {}", pattern, error.what()));
    }
    members = by_member(table, pattern);
    for (const auto& [id, rows] : members)
      if (std::ranges::count(ids, id) == 0) all.unknown.push_back(id);
  }
  std::vector<std::pair<std::int64_t, io::Source>> read;
  for (std::size_t member = 0; member < ids.size(); ++member) {
    const std::int64_t id = ids[member];
    try {
      if (one_table && !members.contains(id))
        throw Unfit{Fate::missing, fmt::format("{}: no rows with id {}", pattern, id)};
      const io::SeriesFile file = one_table ? io::SeriesFile{members.at(id), {}} : read_member(path_of(pattern, id));
      if (!one_table) read.emplace_back(id, file.source);
      all.values.push_back(at_stations(file.series, observed, choice, id, widest, mixed));
      others.compare(file.series, id, member);
      all.fate.push_back(Fate::used);
      all.why.emplace_back();
    } catch (const Unfit& unfit) {
      all.values.emplace_back();
      all.fate.push_back(unfit.fate);
      all.why.push_back(unfit.why);
    } catch (const DataError& error) {
      throw DataError(fmt::format("{}: run of member {}: {}", path_of(pattern, id), id, error.what()));
    }
  }
  if (!one_table) sources.push_back(together(read));
  widest.doubt(all.doubts);
  others.doubt(all.doubts);
  mixed.doubt(all.doubts);
  return all;
}

}  // namespace soilweave::calibration
