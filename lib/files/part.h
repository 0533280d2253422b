// The folder of an unfinished run, OUTPUT.part. It holds recorded states and checkpoints, each a closed file from which
// the run can go on to the same bytes. FORMAT.md specifies the files.
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

/// A checkpoint: the state, the rows of the series so far, and numbers that only the running program knows. In a
/// two-scale run `state` has no grains, only the step that names the file. Its grains are in the numbers, and its
/// records so far in `tables` and `frames`.
struct Checkpoint {
  Snapshot state;
  Series series;
  Archive::Numbers numbers;
  std::vector<FieldsFile::Group> tables = {};
  std::vector<Snapshot> frames = {};
};

/// Writes a file of kind "checkpoint" atomically. Throws CannotCreate, IoError; DataError for a state that is not
/// finite.
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

  /// Makes the folder beside the output and locks it for this process. history: the output's; a checkpoint with another
  /// history is of another run. Throws CannotCreate if another process has the folder or if work in it would be lost.
  /// Throws AnotherRun, which names the difference.
  Part(const std::filesystem::path& output, History history, Entry entry);
  /// Leaves the folder; removes it if it is empty.
  ~Part();
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  /// Hands over the checkpoint to go on from, once; none at the beginning of a run.
  std::optional<Checkpoint> take_last();
  /// Writes a checkpoint. Recorded ones stay until the end; of the others the last two files stay.
  void keep(Checkpoint checkpoint, bool recorded);
  /// Reads the recorded states back, in order.
  std::vector<Snapshot> recorded() const;
  /// Removes the folder, once the output is written.
  void remove();

  /// Returns the newest file and its step; an empty path and -1 before the first.
  std::filesystem::path last() const;
  std::int64_t last_step() const { return files_.empty() ? -1 : files_.back().step; }
  /// Returns whether the folder held another run, which is gone.
  bool replaced() const { return replaced_; }
  /// Returns the error with a line on what is kept and how to go on.
  Error explained(const Error& error) const;
  /// Returns the error of a guard. The state at which it stopped is left beside the checkpoints for inspection, without
  /// grains whose numbers are not finite.
  Error stopped(const Error& error, const Snapshot& state) const;
  /// Returns the error of a guard; leave(path) writes what is left for inspection.
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
  std::vector<PartFile> files_;  // files in order of steps
  std::optional<Checkpoint> last_;
  bool replaced_ = false;
  int lock_ = -1;
};

/// Returns whether the output exists with this history. Throws CannotCreate if it has another history, unless an
/// unfinished run beside it was allowed to overwrite it.
bool finished(const std::filesystem::path& output, const History& history);

/// Returns the folder of an output.
std::filesystem::path part_of(const std::filesystem::path& output);

}  // namespace soilweave::io
