// Packings, runs, fields and ensembles, each whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/files.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <set>
#include <utility>

#include "core/error.h"
#include "core/text/plain_text.h"
#include "files/file_head.h"
#include "files/under_way.h"
#include "store/bytes.h"

namespace soilweave::io {
namespace {

const std::string fields_group = "/fields", members_group = "/members";

std::string output_name(const std::filesystem::path& path) { return path == "-" ? "standard output" : path.string(); }

std::array<std::pair<const char*, std::int64_t*>, 2> numbers_of(Work& work) {
  return {{{"/price/steps", &work.steps}, {"/price/contact_steps", &work.contact_steps}}};
}

Label label_of(const char* path) {
  const Entry& e = entry(path);
  return {std::string(e.units), std::string(e.long_name)};
}

/// Returns whether the path may be the folder of an unfinished run. Other folders are refused when they are read.
bool is_folder(const std::filesystem::path& path) {
  std::error_code ignored;
  const std::filesystem::path name = path.has_filename() ? path : path.parent_path();  // "run.h5.part/" too
  return name.extension() == ".part" && std::filesystem::is_directory(path, ignored);
}

/// Reads and checks all states; the file's history goes into its source.
std::vector<Snapshot> states_in(OpenFile& file) {
  if (file.kind != "checkpoint") file.demand_kind("packing run");
  file.source.history = read_history(file.reader);
  std::vector<Snapshot> states = read_frames(file.reader);
  for (std::size_t f = 0; f < states.size(); ++f)
    check(states[f], states.size() == 1 ? file.reader.where() : fmt::format("{}: state {}", file.reader.where(), f));
  return states;
}

RunFile run_in(OpenFile& file) {
  RunFile run;
  run.snapshots = states_in(file);
  if (file.kind == "run") {
    run.series = read_columns(file.reader, series_group);
    run.scenario = file.reader.read_text("/scenario");
    for (const auto& [path, number] : numbers_of(run.work))
      if (file.reader.has(path)) *number = file.reader.read<std::int64_t>(path, {}).front();
  }
  run.source = std::move(file.source);
  return run;
}

/// Returns the row of the series for each state: the last one of its step. Empty if a state has none.
std::vector<std::size_t> rows_of(const std::vector<Snapshot>& states, const Column& steps) {
  std::vector<std::size_t> rows;
  for (const Snapshot& state : states) {
    const auto found = std::find(steps.values.rbegin(), steps.values.rend(), static_cast<double>(state.step));
    if (found == steps.values.rend()) return {};
    rows.push_back(static_cast<std::size_t>(steps.values.rend() - found) - 1);
  }
  return rows;
}

/// Writes the series again as H5MD observables. H5MD readers read frame by frame, so each frame gets the row of its
/// state. If a state has no row, links to the whole series take the place of these values.
void write_observables(Writer& file, const Series& series, const std::vector<Snapshot>& states) {
  const Column* steps = series.find("step");
  if (!steps || !series.find("time")) return;
  const std::vector<std::size_t> rows = rows_of(states, *steps);
  const std::string clock = rows.empty() ? series_group : "/particles/grains/position";
  for (const Column& column : series.columns) {
    if (column.name == "step" || column.name == "time") continue;
    const std::string element = "/observables/" + column.name;
    if (rows.empty()) {
      file.link(series_group + "/" + column.name, element + "/value");
    } else {
      std::vector<double> values;
      for (const std::size_t row : rows) values.push_back(column.values.at(row));
      file.write<double>(element + "/value", values, {values.size()}, {column.unit, column.long_name});
    }
    for (const char* name : {"/step", "/time"}) file.link(clock + name, element + name);
  }
}

/// Writes the course of a run of either kind: series, scenario, work.
void write_course(Writer& file, const Series& series, const std::vector<Snapshot>& states, const std::string& scenario,
                  Work work) {
  write_columns(file, series_group, series);
  write_observables(file, series, states);
  file.write_text("/scenario", scenario, label_of("/scenario"));
  if (work.steps > 0)
    for (const auto& [place, number] : numbers_of(work))
      file.write<std::int64_t>(place, {number, 1}, {}, label_of(place));
}

/// Builds a file by build(file) and writes it. Errors name the file.
template <class Build>
void write_file(const std::filesystem::path& path, const std::string& kind, const History& history,
                const Build& build) {
  Writer file;
  write_head(file, kind, history);
  try {
    build(file);
  } catch (const DataError& error) {
    throw DataError(output_name(path) + ": " + error.what());
  }
  write_bytes(path, file.image());
}

}  // namespace

void write_groups(Writer& file, const std::vector<FieldsFile::Group>& groups) {
  file.group(fields_group);
  std::set<std::string> names;
  for (std::size_t k = 0; k < groups.size(); ++k) {
    const std::string place = child_path(fields_group, groups[k].name);
    if (!names.insert(groups[k].name).second) throw DataError(place + ": two groups of this name");
    write_columns(file, place, groups[k].table);
    file.attribute(place, "long_name", groups[k].long_name);
    file.attribute(place, "order", static_cast<std::int64_t>(k));
  }
}

std::vector<FieldsFile::Group> read_groups(const Reader& file) {
  std::map<std::int64_t, FieldsFile::Group> ordered;
  for (const std::string& name : file.children(fields_group)) {
    const std::string place = fields_group + "/" + name;
    ordered[file.integer<std::int64_t>(place, "order")] = {name, file.text_attribute(place, "long_name"),
                                                           read_columns(file, place)};
  }
  std::vector<FieldsFile::Group> groups;
  for (auto& [order, group] : ordered) groups.push_back(std::move(group));
  return groups;
}

void write_recorded(Writer& file, const std::vector<FieldsFile::Group>& groups, const std::vector<Snapshot>& frames,
                    const History& history) {
  std::vector<const Snapshot*> states;
  for (const Snapshot& frame : frames) states.push_back(&frame);
  if (!states.empty()) write_states(file, states, history);
  write_groups(file, groups);
}

void write_packing(const std::filesystem::path& path, const Snapshot& state, const History& history) {
  check(state, output_name(path));
  write_file(path, "packing", history, [&](Writer& file) { write_states(file, {&state}, history); });
}

std::size_t packing_bytes(const Snapshot& state) {
  Writer file;
  write_head(file, "packing", {});
  write_states(file, {&state}, {});
  return file.image().size();
}

void write_run(const std::filesystem::path& path, const RunFile& run, const History& history) {
  std::vector<const Snapshot*> states;
  for (const Snapshot& state : run.snapshots) {
    check(state, fmt::format("{}: state {}", output_name(path), states.size()));
    states.push_back(&state);
  }
  write_file(path, "run", history, [&](Writer& file) {
    write_states(file, states, history);
    write_course(file, run.series, run.snapshots, run.scenario, run.work);
  });
}

void write_multiscale(const std::filesystem::path& path, const MultiscaleFile& run, const History& history) {
  write_file(path, "multiscale", history, [&](Writer& file) {
    write_recorded(file, run.groups, run.frames, history);
    // The frames belong to several packings, not to one trajectory, so the observables have no value per frame.
    write_course(file, run.series, {}, run.scenario, run.work);
  });
}

void write_fields(const std::filesystem::path& path, const FieldsFile& fields, const History& history) {
  write_file(path, "fields", history, [&](Writer& file) { write_groups(file, fields.groups); });
}

void write_ensemble(const std::filesystem::path& path, const EnsembleFile& ensemble, const History& history) {
  write_file(path, "ensemble", history, [&](Writer& file) {
    file.write_text("/prior", ensemble.prior, label_of("/prior"));
    write_columns(file, members_group, ensemble.members);
    write_groups(file, ensemble.groups);
  });
}

RunFile read_states(const std::filesystem::path& path, std::string role) {
  if (is_folder(path)) return read_run_so_far(path, std::move(role));
  OpenFile file(path, std::move(role));
  return run_in(file);
}

PackingFile read_state(const std::filesystem::path& path, std::string role) {
  if (is_folder(path)) return read_newest_state(path, std::move(role));
  OpenFile file(path, std::move(role));
  std::vector<Snapshot> states = states_in(file);
  return {std::move(states.back()), std::move(file.source)};
}

MultiscaleFile read_multiscale(const std::filesystem::path& path, std::string role) {
  OpenFile file(path, std::move(role));
  file.demand_kind("multiscale");
  MultiscaleFile run;
  run.groups = read_groups(file.reader);
  run.series = read_columns(file.reader, series_group);
  run.scenario = file.reader.read_text("/scenario");
  if (file.reader.has("/particles")) run.frames = read_frames(file.reader);
  run.source = std::move(file.source);
  run.source.history = read_history(file.reader);
  return run;
}

FieldsFile read_fields(const std::filesystem::path& path, std::string role) {
  OpenFile file(path, std::move(role));
  file.demand_kind("fields");
  FieldsFile fields;
  fields.groups = read_groups(file.reader);
  fields.source = std::move(file.source);
  fields.source.history = read_history(file.reader);
  return fields;
}

EnsembleFile read_ensemble(const std::filesystem::path& path, std::string role) {
  OpenFile file(path, std::move(role));
  file.demand_kind("ensemble");
  EnsembleFile ensemble{read_columns(file.reader, members_group), file.reader.read_text("/prior"),
                        read_groups(file.reader), std::move(file.source)};
  ensemble.source.history = read_history(file.reader);
  return ensemble;
}

SeriesFile read_run_series(const std::filesystem::path& path, std::string role) {
  OpenFile file(path, std::move(role));
  file.demand_kind("run fields multiscale");
  const std::string place = file.kind != "fields" ? series_group : fields_group + "/series";
  if (!file.reader.has(place)) file.reader.fail(place, "is missing: the fields are not those of a run");
  SeriesFile read{read_columns(file.reader, place), std::move(file.source)};
  read.source.history = read_history(file.reader);
  return read;
}

TextFile read_text(const std::filesystem::path& path, std::string role) {
  std::string bytes = read_bytes(path);
  TextFile file;
  file.source = {role, sha256(bytes), {}, path};
  file.text = plain_text(std::move(bytes), input_name(path), role);
  return file;
}

bool is_hdf5(const std::filesystem::path& path) {
  std::array<char, 4> first{};
  std::ifstream(path, std::ios::binary).read(first.data(), first.size());
  return std::string_view(first.data(), first.size()) == "\x89HDF";
}

std::string read_kind(const std::filesystem::path& path) { return is_folder(path) ? "run" : OpenFile(path, "").kind; }

History read_history(const std::filesystem::path& path) {
  return is_folder(path) ? read_history_so_far(path) : read_history(OpenFile(path, "").reader);
}

}  // namespace soilweave::io
