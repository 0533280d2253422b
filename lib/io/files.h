// The file kinds the tools exchange, read and written whole. FORMAT.md is their specification; store.h the only door
// to HDF5. A path "-" is an HDF5 file image on standard input or output.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "io/provenance.h"
#include "io/records.h"

namespace soilweave::io {

/// A packing: one state, at rest or nearly so.
struct PackingFile {
  Snapshot state;
  Source source;  // of the file this was read from
};

/// What a run took, as far as equal runs take the same: no seconds.
struct Work {
  std::int64_t steps = 0, contact_steps = 0;  // contact_steps: contacts, summed over the steps
};

/// A run: series over all recorded states, snapshots at some of them; the last snapshot is the state to continue from.
struct RunFile {
  std::vector<Snapshot> snapshots;
  Series series;
  std::string scenario;  // resolved TOML
  Work work;             // zeros where the file does not say
  Source source;
};

/// A plain-text table or scenario with its digest.
struct TextFile {
  std::string text;
  Source source;
};

/// Fields: the product of an analysis tool. Groups of columns ("global", "volumes", "grains", "rose", ...).
struct FieldsFile {
  struct Group {
    std::string name, long_name;
    Series table;
  };
  std::vector<Group> groups;
  Source source;
};

/// An ensemble: parameter sets drawn from a prior, one row each; once assimilated, their weights and what follows.
struct EnsembleFile {
  Series members;     // id, the parameters, log_importance; weight after assimilation
  std::string prior;  // TOML
  std::vector<FieldsFile::Group> groups;
  Source source;
};

/// A run of finite elements whose points are material: tables of the mesh, nodes, points and bars over all recorded
/// moments, series, and the grains of the points that were recorded whole: one frame a moment and point, in the order
/// of the table "recorded".
struct MultiscaleFile {
  std::vector<FieldsFile::Group> groups;
  Series series;
  std::vector<Snapshot> frames;
  std::string scenario;  // resolved TOML
  Work work;             // of all grains
  Source source;
};

/// The series of a run without its states, from the run or from the fields that homogenize made of it.
struct SeriesFile {
  Series series;
  Source source;
};

/// Writes of every kind: atomically (temporary name, fsync, rename), equal content gives equal bytes.
/// Throws CannotCreate, IoError.
void write_packing(const std::filesystem::path& path, const Snapshot& state, const History& history);
/// The size of the file that write_packing would write of a state, bytes.
std::size_t packing_bytes(const Snapshot& state);
void write_run(const std::filesystem::path& path, const RunFile& run, const History& history);
void write_multiscale(const std::filesystem::path& path, const MultiscaleFile& run, const History& history);
void write_fields(const std::filesystem::path& path, const FieldsFile& fields, const History& history);
void write_ensemble(const std::filesystem::path& path, const EnsembleFile& ensemble, const History& history);

/// Readers reject an unknown kind or a newer major version. Throw MissingInput, DataError (truncated, wrong kind,
/// NaN, overlapping array lengths that disagree ...), IoError. `role` names the input in provenance.
PackingFile read_packing(const std::filesystem::path& path, std::string role = "packing");
RunFile read_run(const std::filesystem::path& path, std::string role = "run");
FieldsFile read_fields(const std::filesystem::path& path, std::string role = "fields");
MultiscaleFile read_multiscale(const std::filesystem::path& path, std::string role = "run");
EnsembleFile read_ensemble(const std::filesystem::path& path, std::string role = "ensemble");
SeriesFile read_run_series(const std::filesystem::path& path, std::string role = "run");
TextFile read_text(const std::filesystem::path& path, std::string role);

/// A packing, or the last snapshot of a run: whatever a tool can start from. A path OUTPUT.part is the folder of a run
/// under way, of which the newest state is read (under_way.h); read_states, read_kind and read_history take it, too.
PackingFile read_state(const std::filesystem::path& path, std::string role = "packing");
/// All states in a file: a packing gives one.
RunFile read_states(const std::filesystem::path& path, std::string role = "states");
/// Whether a file's first bytes are HDF5's; false where it cannot be opened.
bool is_hdf5(const std::filesystem::path& path);
/// The kind written in the file's root ("packing", "run", "fields", "ensemble", "multiscale"), its version, and its
/// history alone.
std::string read_kind(const std::filesystem::path& path);
History read_history(const std::filesystem::path& path);

/// Checks what every reader promises and every writer is given: equal lengths, finite numbers, positive radii, grains
/// smaller than half the cell along periodic axes, contacts that name existing grains. Throws DataError naming `where`.
void check(const Snapshot& state, const std::string& where);

}  // namespace soilweave::io
