// The folder of a run under way, OUTPUT.part: its recorded states and checkpoints, each a closed file from which the
// run can go on to the same bytes. FORMAT.md says what they hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.h"
#include "core/error.h"
#include "io/files.h"
#include "io/under_way.h"

namespace soilweave::io {

/// A moment of a run from which it can go on: the state, the rows of the series so far, and the numbers that only the
/// running program knows. A run of several scales has no grains in `state` (its step names the file): its grains are in
/// the numbers, and what it has recorded so far in `tables` and `frames`.
struct Moment {
  Snapshot state;
  Series series;
  Archive::Numbers numbers;
  std::vector<FieldsFile::Group> tables = {};
  std::vector<Snapshot> frames = {};
};

/// Writes a moment as a file of kind "checkpoint", atomically. Throws CannotCreate, IoError, DataError for a state that
/// is not finite.
void write_moment(const std::filesystem::path& path, const Moment& moment, const History& history);
/// Throws DataError where the file is damaged or of another kind.
Moment read_moment(const std::filesystem::path& path, History& history);

/// The folder holds another run.
struct AnotherRun : DataError {
  using DataError::DataError;
};

class Part {
 public:
  /// How to take a folder that is there already.
  enum class Entry {
    fresh,          // refuse one that holds more than the start of a run
    anew,           // refuse a folder that holds more than the start of a run
    resume,         // go on from its last moment; refuse another run
    resume_or_anew  // go on from its last checkpoint; refuse another run
  };

  /// Makes the folder beside the output and locks it for this process. history: what the output will carry; a moment of
  /// another history is of another run. Throws CannotCreate where another process has the folder, or work in it would
  /// be lost; AnotherRun where the run in it is another one: the message names what differs.
  Part(const std::filesystem::path& output, History history, Entry entry);
  /// Leaves the folder, unless nothing is in it.
  ~Part();
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;

  /// The moment to go on from; none at the beginning of a run. Taken out once.
  std::optional<Moment> take_last();
  /// Writes the moment; recorded ones stay until the end, of the others the last two files.
  void keep(Moment moment, bool recorded);
  /// The recorded states in order, read back.
  std::vector<Snapshot> recorded() const;
  /// Removes the folder: the output is there.
  void remove();

  /// The newest file, empty before the first; its step, -1 before the first.
  std::filesystem::path last() const;
  std::int64_t last_step() const { return files_.empty() ? -1 : files_.back().step; }
  /// Whether it held another run's work, which is gone.
  bool replaced() const { return replaced_; }
  /// The error with what is whole and how to go on in its line.
  Error explained(const Error& error) const;
  /// The error of a guard. The state it stopped at is left beside the moments, for the eye; grains whose numbers are
  /// not finite are not in it.
  Error stopped(const Error& error, const Snapshot& state) const;
  /// The same, of what leave() writes to the path it is given.
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
  std::vector<PartFile> files_;  // by step
  std::optional<Moment> last_;
  bool replaced_ = false;
  int lock_ = -1;
};

/// Whether the output is there already and of this history. Throws CannotCreate where it is of another, and no run
/// under way beside it was allowed to overwrite it.
bool finished(const std::filesystem::path& output, const History& history);

/// The folder of an output.
std::filesystem::path part_of(const std::filesystem::path& output);

}  // namespace soilweave::io
