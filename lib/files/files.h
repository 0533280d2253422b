// File kinds that tools exchange (FORMAT.md), read and written whole. The path "-" is an HDF5 image on standard input
// or output.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "files/provenance.h"
#include "files/records.h"

namespace soilweave::io {

/// A packing: one state, at rest or nearly so.
struct PackingFile {
  Snapshot state;
  /// File from which the state was read.
  Source source;
};

/// Work of a run, equal for equal runs.
struct Work {
  /// Steps, and contacts summed over the steps.
  std::int64_t steps = 0, contact_steps = 0;
};

/// A run: series of all states, snapshots of some. The last snapshot is the state to continue from.
struct RunFile {
  std::vector<Snapshot> snapshots;
  Series series;
  std::string scenario;  // resolved TOML
  Work work;             // zeros if the file has none
  Source source;
};

/// A plain-text table or scenario with its digest.
struct TextFile {
  std::string text;
  Source source;
};

/// Output of an analysis tool: groups of columns ("global", "volumes", "grains", "rose", ...).
struct FieldsFile {
  /// One table with its name and sentence.
  struct Group {
    std::string name, long_name;
    Series table;
  };
  std::vector<Group> groups;
  Source source;
};

/// An ensemble of parameter sets from a prior, one per row, before or after assimilation.
struct EnsembleFile {
  /// Columns id, parameters, log_importance; after assimilation also weight.
  Series members;
  /// The prior as TOML.
  std::string prior;
  std::vector<FieldsFile::Group> groups;
  Source source;
};

/// A two-scale run over all recorded times.
struct MultiscaleFile {
  /// Tables of the mesh, nodes, points and bars.
  std::vector<FieldsFile::Group> groups;
  Series series;
  /// Grains of recorded points, one per time and point, in the order of the table "recorded".
  std::vector<Snapshot> frames;
  std::string scenario;  // resolved TOML
  Work work;             // sum over the packings of all points
  Source source;
};

/// Series of a run or of a fields file of homogenize, without states.
struct SeriesFile {
  Series series;
  Source source;
};

/// Writes a packing. All writers are atomic (temporary name, fsync, rename), give equal bytes for equal content, and
/// throw CannotCreate, IoError.
void write_packing(const std::filesystem::path& path, const Snapshot& state, const History& history);
/// Returns the size of the file that write_packing() would write, bytes.
std::size_t packing_bytes(const Snapshot& state);
/// Writes a run: its states, series and scenario.
void write_run(const std::filesystem::path& path, const RunFile& run, const History& history);
/// Writes a two-scale run.
void write_multiscale(const std::filesystem::path& path, const MultiscaleFile& run, const History& history);
/// Writes the tables of an analysis tool.
void write_fields(const std::filesystem::path& path, const FieldsFile& fields, const History& history);
/// Writes an ensemble, assimilated or not.
void write_ensemble(const std::filesystem::path& path, const EnsembleFile& ensemble, const History& history);

/// Reads tables. All readers throw DataError for a wrong kind, a newer major version, a truncated file, NaN or unequal
/// lengths; MissingInput, IoError. `role` names the input in provenance.
FieldsFile read_fields(const std::filesystem::path& path, std::string role = "fields");
/// Reads a two-scale run.
MultiscaleFile read_multiscale(const std::filesystem::path& path, std::string role = "run");
/// Reads an ensemble.
EnsembleFile read_ensemble(const std::filesystem::path& path, std::string role = "ensemble");
/// Reads the series of a run or a fields file.
SeriesFile read_run_series(const std::filesystem::path& path, std::string role = "run");
/// Reads a plain text whole.
TextFile read_text(const std::filesystem::path& path, std::string role);

/// Reads a state to start from: a packing, or a run's last snapshot. A folder OUTPUT.part gives its newest state
/// (under_way.h), also for read_states, read_kind and read_history.
PackingFile read_state(const std::filesystem::path& path, std::string role = "packing");
/// Reads all states in a file; a packing has one.
RunFile read_states(const std::filesystem::path& path, std::string role = "states");
/// Returns whether a file begins like HDF5; false if it cannot be opened.
bool is_hdf5(const std::filesystem::path& path);
/// Reads only the kind: "packing", "run", "fields", "ensemble", "multiscale".
std::string read_kind(const std::filesystem::path& path);
/// Reads only the history of a file.
History read_history(const std::filesystem::path& path);

/// Throws DataError naming `where` unless lengths are equal, numbers finite, radii positive, grains smaller than half a
/// periodic cell, and contacts between existing grains.
void check(const Snapshot& state, const std::string& where);

}  // namespace soilweave::io
