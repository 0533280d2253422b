// The folder of an unfinished run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/part.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string_view>
#include <utility>

#include "files/files.h"
#include "files/finite_part.h"
#include "store/bytes.h"

namespace soilweave::io {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view left_name = "stopped.h5";
// Number of newest files that are kept. Older ones stay only if they are recorded states.
constexpr std::size_t kept_files = 2;
const std::string recorded_steps = "recorded_steps";

/// Throws CannotCreate if the folder is another user's in a shared (sticky) folder, since that user controls its files.
void demand_own(int folder, const fs::path& path) {
  struct stat own = {}, around = {};
  if (folder < 0 || ::fstat(folder, &own) != 0 || ::stat((path / "..").c_str(), &around) != 0) return;
  if (own.st_uid != ::geteuid() && own.st_uid != around.st_uid && (around.st_mode & S_ISVTX) != 0)
    throw CannotCreate(path.string() + ": belongs to another user, in a folder of all users; write elsewhere");
}

bool is_temporary(std::string_view name) { return name.starts_with('.') && name.ends_with(".tmp"); }

// Returns the part in which two runs differ, for messages; empty if they are equal. Doubts do not count, since they
// arise during a run.
std::string difference(const History& found, const History& wanted) {
  if (describe(without_doubts(found)) == describe(without_doubts(wanted))) return "";
  if (found.empty() || wanted.empty()) return "history";
  const ProvenanceRecord &a = found.back(), &b = wanted.back();
  if (a.tool != b.tool || a.version != b.version) return "tool or version";
  for (std::size_t k = 0; k < std::min(a.inputs.size(), b.inputs.size()); ++k)
    if (a.inputs[k].sha256 != b.inputs[k].sha256) return b.inputs[k].role;
  if (a.seed != b.seed) return "seed";
  if (a.command != b.command || a.scenario != b.scenario) return "options";
  return "inputs";
}

}  // namespace

fs::path part_of(const fs::path& output) { return output.string() + ".part"; }

bool finished(const fs::path& output, const History& history) {
  std::error_code ignored;
  if (!fs::is_regular_file(output, ignored)) return false;
  std::string what;
  try {
    what = difference(read_history(output), history);
  } catch (const DataError&) {
    what = "kind";
  }
  if (what.empty()) return true;
  if (fs::exists(part_of(output), ignored)) return false;
  throw CannotCreate(
      fmt::format("{}: exists, of a run whose {} differs; give --force to overwrite it", output.string(), what));
}

Part::Part(const fs::path& output, History history, Entry entry)
    : folder_(part_of(output)), history_(std::move(history)) {
  try {
    make_folder(folder_);
  } catch (const CannotCreate& error) {
    throw CannotCreate(fmt::format("{}: cannot be created: {}", output.string(), error.what()));
  }
  lock_ = ::open(folder_.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
  try {
    // Without file locks, users must avoid two runs of one output themselves.
    if (lock_ >= 0 && ::flock(lock_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
      throw CannotCreate(folder_.string() + ": another process is at work on this run; wait for it, or stop it");
    demand_own(lock_, folder_);
    files_ = part_files(folder_);
    enter(entry);
  } catch (...) {
    if (lock_ >= 0) ::close(lock_);
    throw;
  }
}

Part::~Part() {
  ::rmdir(folder_.c_str());
  if (lock_ >= 0) ::close(lock_);
}

fs::path Part::path_of(const PartFile& file) const { return folder_ / name_of(file); }

void Part::enter(Entry entry) {
  if (entry == Entry::fresh && !files_.empty() && files_.back().step > 0)
    throw CannotCreate(
        fmt::format("{}: holds an unfinished run, at step {}; give --resume to go on with it, or --force "
                    "to begin anew",
                    folder_.string(), files_.back().step));
  if (entry == Entry::fresh || entry == Entry::anew) drop(0);
  try {
    find_last();
  } catch (const AnotherRun&) {
    if (entry == Entry::resume) throw;
    drop(0);
    replaced_ = true;
  }
  std::error_code ignored;
  for (const fs::directory_entry& stray : fs::directory_iterator(folder_, ignored))
    if (is_temporary(stray.path().filename().string())) fs::remove(stray.path(), ignored);
  fs::remove(folder_ / left_name, ignored);
}

// Finds the newest usable checkpoint and removes later files. Damaged files are skipped, and files for which an earlier
// recorded state is missing.
void Part::find_last() {
  std::size_t end = files_.size();
  for (; end > 0 && !last_; --end) {
    const fs::path file = path_of(files_[end - 1]);
    try {
      History found;
      Checkpoint checkpoint = read_checkpoint(file, found);
      demand_same_run(found, file);
      const std::vector<double>& steps = checkpoint.numbers[recorded_steps];
      const bool whole = std::all_of(steps.begin(), steps.end(), [&](double step) {
        return std::any_of(files_.begin(), files_.end(),
                           [&](const PartFile& f) { return f.recorded && static_cast<double>(f.step) == step; });
      });
      if (!whole) continue;
      last_ = std::move(checkpoint);
      break;
    } catch (const AnotherRun&) {
      throw;
    } catch (const DataError&) {
      continue;
    }
  }
  drop(end);
}

void Part::demand_same_run(const History& found, const fs::path& file) const {
  if (const std::string what = difference(found, history_); !what.empty())
    throw AnotherRun(
        fmt::format("{}: is of a run whose {} differs; give the one it began with, or --force too to begin "
                    "anew",
                    file.string(), what));
}

void Part::drop(std::size_t first) {
  std::error_code ignored;
  for (std::size_t k = first; k < files_.size(); ++k) fs::remove(path_of(files_[k]), ignored);
  files_.resize(first);
}

std::optional<Checkpoint> Part::take_last() { return std::exchange(last_, std::nullopt); }

void Part::keep(Checkpoint checkpoint, bool recorded) {
  const PartFile file{checkpoint.state.step, recorded};
  std::vector<double>& steps = checkpoint.numbers[recorded_steps];
  steps.clear();
  for (const PartFile& f : files_)
    if (f.recorded) steps.push_back(static_cast<double>(f.step));
  if (recorded) steps.push_back(static_cast<double>(file.step));
  try {
    write_checkpoint(path_of(file), checkpoint, history_);
  } catch (const DataError& error) {
    // No file is at fault: the run itself made an invalid state, and would make it again.
    throw PhysicsError(fmt::format("step {}: the state cannot be kept: {}", file.step, error.what()));
  } catch (const Error&) {
    // The file is renamed, so it exists even if the folder could not be synced.
    std::error_code ignored;
    if (fs::exists(path_of(file), ignored)) files_.push_back(file);
    throw;
  }
  files_.push_back(file);
  for (std::size_t k = 0; k + kept_files < files_.size(); ++k) {
    if (files_[k].recorded) continue;
    std::error_code ignored;
    fs::remove(path_of(files_[k]), ignored);
    files_.erase(files_.begin() + static_cast<std::ptrdiff_t>(k--));
  }
}

std::vector<Snapshot> Part::recorded() const {
  std::vector<Snapshot> states;
  History ignored;
  for (const PartFile& file : files_)
    if (file.recorded) states.push_back(read_checkpoint(path_of(file), ignored).state);
  return states;
}

fs::path Part::leave(const Snapshot& state) const {
  try {
    const Snapshot left = finite_part(state);
    if (left.grains.size() == 0) return {};
    write_packing(folder_ / left_name, left, history_);
    return folder_ / left_name;
  } catch (const Error&) {
    return {};  // the guard's own message matters more
  }
}

void Part::remove() {
  drop(0);
  std::error_code ignored;
  fs::remove(folder_ / left_name, ignored);
}

fs::path Part::last() const { return files_.empty() ? fs::path() : path_of(files_.back()); }

Error Part::explained(const Error& error) const {
  // To resume or repeat the run would end in the same error.
  if (error.status() == Exit::bad_data || error.status() == Exit::usage) return error;
  std::error_code ignored;
  const fs::path file = last();
  std::string line = error.what();
  if (!file.empty() && fs::exists(file, ignored))
    line += fmt::format("; {} is whole: the same command with --resume goes on from there", file.string());
  else if (!file.empty())
    line += fmt::format("; {} is gone, and with it the record: run it again", folder_.string());
  else
    line += "; nothing is kept yet: run it again";
  return {error.status(), line};
}

Error Part::stopped(const Error& error, const Snapshot& state) const { return stopped_at(error, leave(state)); }

Error Part::stopped(const Error& error, const std::function<void(const fs::path&)>& leave) const {
  fs::path left = folder_ / left_name;
  try {
    leave(left);
  } catch (const Error&) {
    left.clear();  // the guard's own message matters more
  }
  return stopped_at(error, left);
}

Error Part::stopped_at(const Error& error, const fs::path& left) const {
  const fs::path good = last();
  std::string line = error.what();
  if (!left.empty()) line += fmt::format("; {} shows it (to-vtk)", left.string());
  if (!good.empty()) line += fmt::format("; {} is the last good state", good.string());
  return {error.status(), line};
}

}  // namespace soilweave::io
