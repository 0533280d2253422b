// The folder of an unfinished run, OUTPUT.part: recorded states and checkpoints. A run resumed from any of them ends in
// the same bytes (FORMAT.md).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.h"
#include "core/error.h"
#include "files/files.h"
#include "files/under_way.h"

namespace soilweave::io {

/// A checkpoint.
struct Checkpoint {
  /// The state; in a two-scale run only the step.
  Snapshot state;
  /// Rows of the series so far.
  Series series;
  /// Numbers that only the program knows; in a two-scale run also its grains.
  Archive::Numbers numbers;
  /// Tables recorded so far in a two-scale run.
  std::vector<FieldsFile::Group> tables = {};
  /// Grains recorded so far in a two-scale run.
  std::vector<Snapshot> frames = {};
};

/// Writes a checkpoint atomically. Throws CannotCreate, IoError; DataError for a state that is not finite.
void write_checkpoint(const std::filesystem::path& path, const Checkpoint& checkpoint, const History& history);
/// Reads a checkpoint. Throws DataError for a damaged file or another kind.
Checkpoint read_checkpoint(const std::filesystem::path& path, History& history);

/// Error: the folder holds another run.
struct AnotherRun : DataError {
  using DataError::DataError;
};

/// A folder OUTPUT.part that this process owns.
class Part {
 public:
  /// Treatment of an existing folder.
  enum class Entry {
    fresh,          // refuse a folder that holds more than the start of a run
    anew,           // empty it
    resume,         // go on from its last checkpoint; refuse another run
    resume_or_anew  // go on from its last checkpoint; empty the folder of another run
  };

  /// Makes and locks the folder. Throws CannotCreate if another process holds the lock, or if work would be lost;
  /// AnotherRun if a checkpoint has another history.
  Part(const std::filesystem::path& output, History history, Entry entry);
  /// Unlocks the folder, and removes it if it is empty.
  ~Part();
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  /// Returns the checkpoint to resume from, at the first call only. A new run has none.
  std::optional<Checkpoint> take_last();
  /// Writes a checkpoint. Recorded ones stay until the end, others only while among the last two files.
  void keep(Checkpoint checkpoint, bool recorded);
  /// Reads the recorded states back, in order.
  std::vector<Snapshot> recorded() const;
  /// Removes all files once the output is written. The destructor then removes the folder.
  void remove();

  /// Returns the path of the newest file; empty before the first.
  std::filesystem::path last() const;
  /// Returns the step of the newest file; -1 before the first.
  std::int64_t last_step() const { return files_.empty() ? -1 : files_.back().step; }
  /// Returns whether the folder held another run, which was removed.
  bool replaced() const { return replaced_; }
  /// Returns the error, with a text on which files are kept and how to resume.
  Error explained(const Error& error) const;
  /// Returns a guard's error, naming the last checkpoint. Writes the finite part of `state` beside the checkpoints.
  Error stopped(const Error& error, const Snapshot& state) const;
  /// Returns a guard's error likewise, for a state that leave(path) writes.
  Error stopped(const Error& error, const std::function<void(const std::filesystem::path&)>& leave) const;

 private:
  std::filesystem::path path_of(const PartFile& file) const;
  Error stopped_at(const Error& error, const std::filesystem::path& left) const;
  std::filesystem::path leave(const Snapshot& state) const;
  void enter(Entry entry);
  void find_last();
  void demand_same_run(const History& found, const std::filesystem::path& file) const;
  void drop(std::size_t first);

  std::filesystem::path folder_;
  History history_;
  /// Files in order of steps.
  std::vector<PartFile> files_;
  std::optional<Checkpoint> last_;
  bool replaced_ = false;
  int lock_ = -1;
};

/// Returns whether the output exists with this history. Throws CannotCreate if its history differs, unless the folder
/// OUTPUT.part shows that a run is to overwrite it.
bool finished(const std::filesystem::path& output, const History& history);

/// Returns the folder of an output.
std::filesystem::path part_of(const std::filesystem::path& output);

}  // namespace soilweave::io
