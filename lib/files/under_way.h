// Reads the folder OUTPUT.part of another process: its closed files, and the run so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::io {

/// A closed file of an unfinished run.
struct PartFile {
  /// Step that names the file.
  std::int64_t step;
  /// True if newer checkpoints do not replace it.
  bool recorded;
};

/// Returns the file's name within its folder.
std::string name_of(const PartFile& file);
/// Returns a folder's files in order of steps. Throws IoError if it cannot be read.
std::vector<PartFile> part_files(const std::filesystem::path& folder);

/// Reads the recorded states, the newest checkpoint, and the series up to it. The digest is taken over one line "FILE
/// DIGEST" per file read. Throws MissingInput for an empty folder, DataError for two-scale runs and damaged files.
RunFile read_run_so_far(const std::filesystem::path& folder, std::string role);
/// Returns the newest state. Throws like read_run_so_far().
PackingFile read_newest_state(const std::filesystem::path& folder, std::string role);
/// Returns the history that the newest file keeps. Throws like read_run_so_far().
History read_history_so_far(const std::filesystem::path& folder);

}  // namespace soilweave::io
