// The folder of an unfinished run, OUTPUT.part: recorded states and checkpoints. A run goes on from each to the same
// bytes (FORMAT.md).
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

  /// Makes and locks the folder. Throws CannotCreate if another process has it or work would be lost; AnotherRun if a
  /// checkpoint has another history.
  Part(const std::filesystem::path& output, History history, Entry entry);
  /// Leaves the folder; removes it if it is empty.
  ~Part();
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  /// Hands over the checkpoint to go on from, once; none for a new run.
  std::optional<Checkpoint> take_last();
  /// Writes a checkpoint. Recorded ones stay until the end, others only as the last two.
  void keep(Checkpoint checkpoint, bool recorded);
  /// Reads the recorded states back, in order.
  std::vector<Snapshot> recorded() const;
  /// Removes the folder, once the output is written.
  void remove();

  /// Returns the newest file and its step; an empty path and -1 before the first.
  std::filesystem::path last() const;
  /// Returns the step of the newest file; -1 before the first.
  std::int64_t last_step() const { return files_.empty() ? -1 : files_.back().step; }
  /// Returns whether the folder held another run, which is gone.
  bool replaced() const { return replaced_; }
  /// Returns the error with a line on what is kept and how to go on.
  Error explained(const Error& error) const;
  /// Returns a guard's error. Leaves `state` beside the checkpoints, without grains whose numbers are not finite.
  Error stopped(const Error& error, const Snapshot& state) const;
  /// Returns a guard's error; leave(path) writes what is left.
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

/// Returns whether the output exists with this history. Throws CannotCreate if it has another, unless an unfinished run
/// may overwrite it.
bool finished(const std::filesystem::path& output, const History& history);

/// Returns the folder of an output.
std::filesystem::path part_of(const std::filesystem::path& output);

}  // namespace soilweave::io
