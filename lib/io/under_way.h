// The folder OUTPUT.part seen from outside: which closed files it holds, and the run that they tell so far.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "io/files.h"

namespace soilweave::io {

/// A closed file in the folder of a run under way, named by the number of steps taken. `recorded` ones stay until the
/// end of the run; the others are checkpoints, which newer ones replace.
struct PartFile {
  std::int64_t step;
  bool recorded;
};

/// The name of the file within its folder.
std::string name_of(const PartFile& file);
/// The files of a folder by step. Throws IoError where the folder cannot be read.
std::vector<PartFile> part_files(const std::filesystem::path& folder);

/// Reads a run so far, without disturbing it: the states it will keep, then the newest checkpoint where
/// that is later, and the series up to there. The source's digest is that of the lines "file digest". Throws
/// MissingInput where nothing is written yet or the run has ended meanwhile, DataError for a run of several scales or
/// damaged files.
RunFile read_run_so_far(const std::filesystem::path& folder, std::string role);
/// The newest state alone; throws what read_run_so_far does.
PackingFile read_newest_state(const std::filesystem::path& folder, std::string role);
/// The history that the output will carry; throws what read_run_so_far does.
History read_history_so_far(const std::filesystem::path& folder);

}  // namespace soilweave::io
