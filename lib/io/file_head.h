// What every file kind has in common: kind, version, history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "io/files.h"
#include "io/store.h"

namespace soilweave::io {

/// Root attributes and /provenance.
void write_head(Writer& file, const std::string& kind, const History& history);

/// A file of ours, open: its kind and version are known to be readable.
struct OpenFile {
  /// role: for the source. Throws what read_bytes and Reader throw, DataError for foreign files and newer versions.
  OpenFile(const std::filesystem::path& path, std::string role);
  /// Throws DataError unless the kind is one of `kinds` (words separated by blanks).
  void demand_kind(std::string_view kinds) const;

  Source source;  // without its history until read_history
  Reader reader;
  std::string kind;

 private:
  OpenFile(std::string bytes, const std::string& where, std::string role);
};

/// Throws DataError where the chain is broken.
History read_history(const Reader& file);

/// group/name. Throws DataError for names HDF5 would take for a path.
std::string child_path(const std::string& group, const std::string& name);

/// Where the table of a run lies.
inline const std::string series_group = "/series";

/// Tables: one dataset a column, in `path`; empty where the group is missing.
void write_columns(Writer& file, const std::string& path, const Series& table);
Series read_columns(const Reader& file, const std::string& path);

/// Groups of tables, in /fields.
void write_groups(Writer& file, const std::vector<FieldsFile::Group>& groups);
std::vector<FieldsFile::Group> read_groups(const Reader& file);
/// The tables and grains that a run of several scales recorded; no trajectory where there are no grains.
void write_recorded(Writer& file, const std::vector<FieldsFile::Group>& groups, const std::vector<Snapshot>& frames,
                    const History& history);

/// The frames of packings and runs. write: throws DataError where frames differ in grains, dimension or planes.
void write_states(Writer& file, const std::vector<const Snapshot*>& states, const History& history);
std::vector<Snapshot> read_frames(const Reader& file);

}  // namespace soilweave::io
