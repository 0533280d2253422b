// The folder of an unfinished run, seen from outside.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/under_way.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "files/file_head.h"
#include "files/part.h"
#include "store/bytes.h"

namespace soilweave::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view state_name = "state-", checkpoint_name = "checkpoint-", ending = ".h5";

// Returns the step in "state-000000000120.h5" after its prefix; -1 for other names.
std::int64_t step_in(std::string_view name, std::string_view prefix) {
  if (!name.starts_with(prefix) || !name.ends_with(ending)) return -1;
  name.remove_prefix(prefix.size());
  name.remove_suffix(ending.size());
  std::int64_t step = -1;
  const auto [end, failure] = std::from_chars(name.data(), name.data() + name.size(), step);
  return failure == std::errc() && end == name.data() + name.size() ? step : -1;
}

// Calls read(files), and lists the folder again if the run has meanwhile removed one of the files.
template <class Read>
auto while_it_changes(const fs::path& folder, const Read& read) {
  constexpr int attempts = 5;
  for (int attempt = 1;; ++attempt) {
    const std::vector<PartFile> files = part_files(folder);
    if (files.empty()) throw MissingInput(folder.string() + ": holds no state yet; wait for the first checkpoint");
    try {
      return read(files);
    } catch (const MissingInput&) {
      std::error_code ignored;
      if (attempt == attempts || !fs::is_directory(folder, ignored))
        throw MissingInput(fmt::format("{}: the run has ended meanwhile; read its output", folder.string()));
    }
  }
}

Checkpoint checkpoint_of(const fs::path& path, History& history) {
  Checkpoint checkpoint = read_checkpoint(path, history);
  if (checkpoint.state.grains.size() == 0)
    throw DataError(path.string() + ": is of a run of several scales; fem-dem --table reads it when it has ended");
  return checkpoint;
}

}  // namespace

std::string name_of(const PartFile& file) {
  return fmt::format("{}{:012}{}", file.recorded ? state_name : checkpoint_name, file.step, ending);
}

std::vector<PartFile> part_files(const fs::path& folder) {
  std::vector<PartFile> files;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    // A link may lead to a file of another run, and reading a pipe would wait for ever.
    std::error_code unknown;
    if (!fs::is_regular_file(entry.symlink_status(unknown))) continue;
    const std::string name = entry.path().filename().string();
    if (const std::int64_t step = step_in(name, state_name); step >= 0) files.push_back({step, true});
    if (const std::int64_t step = step_in(name, checkpoint_name); step >= 0) files.push_back({step, false});
  }
  if (failure) throw IoError(folder.string() + ": cannot be read: " + failure.message());
  std::sort(files.begin(), files.end(), [](const PartFile& a, const PartFile& b) {
    return std::pair(a.step, a.recorded) < std::pair(b.step, b.recorded);
  });
  return files;
}

RunFile read_run_so_far(const fs::path& folder, std::string role) {
  return while_it_changes(folder, [&](const std::vector<PartFile>& files) {
    RunFile run;
    std::string digests;
    for (std::size_t k = 0; k < files.size(); ++k) {
      const bool newest = k + 1 == files.size();
      if (!files[k].recorded && !newest) continue;
      const fs::path path = folder / name_of(files[k]);
      Checkpoint checkpoint = checkpoint_of(path, run.source.history);
      digests += fmt::format("{} {}\n", name_of(files[k]), sha256(read_bytes(path)));
      run.snapshots.push_back(std::move(checkpoint.state));
      if (newest) run.series = std::move(checkpoint.series);
    }
    if (!run.source.history.empty()) run.scenario = run.source.history.back().scenario;
    run.source.role = role;
    run.source.sha256 = sha256(digests);
    run.source.file = folder;
    return run;
  });
}

PackingFile read_newest_state(const fs::path& folder, std::string role) {
  return while_it_changes(folder, [&](const std::vector<PartFile>& files) {
    const fs::path path = folder / name_of(files.back());
    PackingFile packing;
    packing.state = checkpoint_of(path, packing.source.history).state;
    packing.source.role = role;
    packing.source.sha256 = sha256(read_bytes(path));
    packing.source.file = path;
    return packing;
  });
}

History read_history_so_far(const fs::path& folder) {
  return while_it_changes(folder, [&](const std::vector<PartFile>& files) {
    return read_history(OpenFile(folder / name_of(files.back()), "").reader);
  });
}

}  // namespace soilweave::io
