// Root attributes, provenance groups, columns of tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/file_head.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "core/error.h"
#include "store/bytes.h"

namespace soilweave::io {
namespace {

const std::string provenance = "/provenance";

std::string numbered(const std::string& folder, std::size_t index) { return fmt::format("{}/{:06}", folder, index); }

void write_record(Writer& file, const std::string& path, const ProvenanceRecord& record) {
  file.group(path);
  file.attribute(path, "tool", record.tool);
  file.attribute(path, "version", record.version);
  file.attribute(path, "command", record.command);
  file.attribute(path, "seed", record.seed);
  if (!record.scenario.empty()) {
    const Entry& e = entry("/provenance/<n>/scenario");
    file.write_text(path + "/scenario", record.scenario, {std::string(e.units), std::string(e.long_name)});
  }
  for (std::size_t k = 0; k < record.inputs.size(); ++k) {
    const InputRecord& input = record.inputs[k];
    const std::string place = numbered(path + "/inputs", k);
    file.group(place);
    file.attribute(place, "role", input.role);
    file.attribute(place, "sha256", input.sha256);
    file.attribute(place, "origin", std::int64_t{input.origin});
  }
  for (std::size_t k = 0; k < record.doubts.size(); ++k) {
    const std::string place = numbered(path + "/doubts", k);
    file.group(place);
    file.attribute(place, "key", record.doubts[k].key);
    file.attribute(place, "sentence", record.doubts[k].sentence);
  }
}

ProvenanceRecord read_record(const Reader& file, const std::string& path, std::size_t index) {
  ProvenanceRecord record;
  record.tool = file.text_attribute(path, "tool");
  record.version = file.text_attribute(path, "version");
  record.command = file.text_attribute(path, "command");
  record.seed = file.integer<std::uint64_t>(path, "seed");
  if (file.has(path + "/scenario")) record.scenario = file.read_text(path + "/scenario");
  if (file.has(path + "/doubts"))
    for (const std::string& child : file.children(path + "/doubts")) {
      const std::string place = path + "/doubts/" + child;
      record.doubts.push_back({file.text_attribute(place, "key"), file.text_attribute(place, "sentence")});
    }
  if (!file.has(path + "/inputs")) return record;
  for (const std::string& child : file.children(path + "/inputs")) {
    const std::string place = path + "/inputs/" + child;
    const std::int64_t origin = file.integer<std::int64_t>(place, "origin");
    if (origin < -1 || origin >= static_cast<std::int64_t>(index))
      file.fail(place, fmt::format("names the record {} as its origin, which is not before it", origin));
    record.inputs.push_back(
        {file.text_attribute(place, "role"), file.text_attribute(place, "sha256"), static_cast<int>(origin)});
  }
  return record;
}

bool whole_numbers(const std::vector<double>& values) {
  return std::all_of(values.begin(), values.end(),
                     [](double v) { return std::abs(v) < 9007199254740992.0 && v == std::nearbyint(v); });
}

/// Writes `step`, and the `id` of an ensemble, as integers if that loses nothing; H5MD requires integer steps.
void write_column(Writer& file, const std::string& place, const Column& column) {
  const Label label = {column.unit, column.long_name};
  if ((column.name == "step" || place == "/members/id") && whole_numbers(column.values)) {
    const std::vector<std::int64_t> steps(column.values.begin(), column.values.end());
    file.write<std::int64_t>(place, steps, {steps.size()}, label);
  } else {
    file.write<double>(place, column.values, {column.values.size()}, label);
  }
}

}  // namespace

void write_head(Writer& file, const std::string& kind, const History& history) {
  file.attribute("/", "format", std::string("soilweave"));
  file.attribute("/", "kind", kind);
  file.attribute("/", "format_version", std::vector<std::int64_t>{format_major, format_minor});
  file.attribute("/", "creator", history.empty() ? std::string("soilweave") : history.back().tool);
  file.attribute("/", "creator_version", history.empty() ? std::string("unknown") : history.back().version);
  file.group(provenance);
  for (std::size_t k = 0; k < history.size(); ++k) write_record(file, numbered(provenance, k), history[k]);
}

OpenFile::OpenFile(const std::filesystem::path& path, std::string role)
    : OpenFile(read_bytes(path), input_name(path), std::move(role)) {
  source.file = path;
}

OpenFile::OpenFile(std::string bytes, const std::string& where, std::string role)
    : source{std::move(role), sha256(bytes), {}}, reader(std::move(bytes), where) {
  if (!reader.has_attribute("/", "format") || reader.text_attribute("/", "format") != "soilweave")
    throw DataError(where + ": an HDF5 file, but none of soilweave's; give a file that a soilweave tool wrote");
  const std::vector<std::int64_t> version = reader.integers<std::int64_t>("/", "format_version", {2});
  if (version[0] > format_major)
    throw DataError(fmt::format("{}: has the format version {}.{}, this program reads {}.{} at most; use a newer one",
                                where, version[0], version[1], format_major, format_minor));
  kind = reader.text_attribute("/", "kind");
  if (kind != "packing" && kind != "run" && kind != "fields" && kind != "checkpoint" && kind != "ensemble" &&
      kind != "multiscale")
    throw DataError(where + ": has the unknown kind \"" + kind +
                    "\"; known are packing, run, fields, checkpoint, ensemble, multiscale");
}

void OpenFile::demand_kind(std::string_view kinds) const {
  std::string wanted;
  for (std::size_t at = 0; at <= kinds.size();) {
    const std::size_t end = std::min(kinds.find(' ', at), kinds.size());
    const std::string_view word = kinds.substr(at, end - at);
    if (word == kind) return;
    wanted += (wanted.empty() ? "" : " or ") + std::string(word);
    at = end + 1;
  }
  throw DataError(fmt::format("{}: holds {}, but {} is needed here", reader.where(), kind, wanted));
}

History read_history(const Reader& file) {
  History history;
  std::vector<std::string> numbers = file.children(provenance);
  std::stable_sort(numbers.begin(), numbers.end(),
                   [](const std::string& a, const std::string& b) { return a.size() < b.size(); });
  for (const std::string& child : numbers)
    history.push_back(read_record(file, provenance + "/" + child, history.size()));
  return history;
}

std::string child_path(const std::string& group, const std::string& name) {
  if (name.empty() || name == "." || name == ".." || name.find('/') != std::string::npos ||
      name.find('\0') != std::string::npos)
    throw DataError(group + ": \"" + name + "\" cannot name a column or table; use letters, digits and _");
  return group + "/" + name;
}

void write_columns(Writer& file, const std::string& path, const Series& table) {
  file.group(path);
  std::set<std::string> names;
  for (std::size_t k = 0; k < table.columns.size(); ++k) {
    const Column& column = table.columns[k];
    const std::string place = child_path(path, column.name);
    if (!names.insert(column.name).second) throw DataError(path + ": has two columns named " + column.name);
    if (column.values.size() != table.rows())
      throw DataError(fmt::format("{}/{} has {} values where {} has {}", path, column.name, column.values.size(),
                                  table.columns.front().name, table.rows()));
    write_column(file, place, column);
    file.attribute(place, "column", static_cast<std::int64_t>(k));
  }
}

Series read_columns(const Reader& file, const std::string& path) {
  const std::vector<std::string> names = file.children(path);
  Series table;
  table.columns.resize(names.size());
  std::vector<bool> filled(names.size(), false);
  const Shape rows = names.empty() ? Shape{} : file.shape(path + "/" + names.front());
  for (const std::string& name : names) {
    const std::string place = path + "/" + name;
    const std::int64_t k = file.integer<std::int64_t>(place, "column");
    if (k < 0 || k >= static_cast<std::int64_t>(names.size()) || filled[static_cast<std::size_t>(k)])
      file.fail(place,
                fmt::format("says it is column {}, but the columns are 0 to {}, each once", k, names.size() - 1));
    if (rows.size() != 1) file.fail(place, "is no column of values");
    filled[static_cast<std::size_t>(k)] = true;
    Column& column = table.columns[static_cast<std::size_t>(k)];
    column = {name, file.text_attribute(place, "units"), file.text_attribute(place, "long_name"), {}};
    if (file.is_integer(place)) {
      const std::vector<std::int64_t> values = file.read<std::int64_t>(place, rows);
      column.values.assign(values.begin(), values.end());
    } else {
      column.values = file.read<double>(place, rows);
    }
  }
  return table;
}

}  // namespace soilweave::io
