// Parts that every file kind has: kind, version, history.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "files/files.h"
#include "store/store.h"

namespace soilweave::io {

/// Writes the root attributes and /provenance.
void write_head(Writer& file, const std::string& kind, const History& history);

/// An open file of a known kind and readable version.
struct OpenFile {
  /// `role` names the source in provenance. Throws what read_bytes and Reader throw; DataError for foreign files and
  /// newer versions.
  OpenFile(const std::filesystem::path& path, std::string role);
  /// Throws DataError unless the kind is one of `kinds` (words separated by blanks).
  void demand_kind(std::string_view kinds) const;

  Source source;  // source, without its history until read_history
  Reader reader;
  std::string kind;

 private:
  OpenFile(std::string bytes, const std::string& where, std::string role);
};

/// Returns the history. Throws DataError if its chain is broken.
History read_history(const Reader& file);

/// Returns group/name. Throws DataError for names that HDF5 would take for a path.
std::string child_path(const std::string& group, const std::string& name);

/// Group of a run's table.
inline const std::string series_group = "/series";

/// Writes a table: one dataset per column in group `path`.
void write_columns(Writer& file, const std::string& path, const Series& table);
/// Reads a table; a missing group gives an empty one.
Series read_columns(const Reader& file, const std::string& path);

/// Writes groups of tables in /fields.
void write_groups(Writer& file, const std::vector<FieldsFile::Group>& groups);
/// Reads the groups of tables.
std::vector<FieldsFile::Group> read_groups(const Reader& file);
/// Writes the tables and grains of a two-scale run. Without grains there is no trajectory.
void write_recorded(Writer& file, const std::vector<FieldsFile::Group>& groups, const std::vector<Snapshot>& frames,
                    const History& history);

/// Writes the frames of a packing or run. Throws DataError if grains, dimension or planes differ.
void write_states(Writer& file, const std::vector<const Snapshot*>& states, const History& history);
/// Reads the frames.
std::vector<Snapshot> read_frames(const Reader& file);

}  // namespace soilweave::io
