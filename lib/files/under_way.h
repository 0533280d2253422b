// The folder OUTPUT.part seen from outside: its closed files, and the run so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "files/files.h"

namespace soilweave::io {

/// A closed file of an unfinished run, named by its step. Newer checkpoints replace it unless it is `recorded`.
struct PartFile {
  std::int64_t step;
  bool recorded;
};

/// Returns the name of the file within its folder.
std::string name_of(const PartFile& file);
/// Returns the files of a folder in order of steps. Throws IoError if the folder cannot be read.
std::vector<PartFile> part_files(const std::filesystem::path& folder);

/// Reads a run so far: its recorded states, then the newest checkpoint if it is later, and the series up to there. The
/// source's digest is that of the lines "file digest". Throws MissingInput if there is nothing to read, DataError for
/// two-scale runs and damaged files.
RunFile read_run_so_far(const std::filesystem::path& folder, std::string role);
/// Returns the newest state alone. Throws what read_run_so_far() throws.
PackingFile read_newest_state(const std::filesystem::path& folder, std::string role);
/// Returns the history that the output will carry. Throws what read_run_so_far() throws.
History read_history_so_far(const std::filesystem::path& folder);

}  // namespace soilweave::io
