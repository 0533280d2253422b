// Errors, one type per exit status. tool::start translates them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace soilweave {

/// Exit statuses (values of sysexits). Every man page lists them.
enum class Exit : int {
  /// Success.
  done = 0,
  /// Ran to the end, but missed the target.
  not_reached = 1,
  /// Wrong usage.
  usage = 64,
  /// Invalid input data or scenario.
  bad_data = 65,
  /// Missing input.
  no_input = 66,
  /// A defect of the program, or broken physics (NaN, energy, lost grain).
  internal = 70,
  /// Output cannot be created.
  cannot_create = 73,
  /// Reading or writing failed.
  io = 74,
  /// Stopped early, resumable.
  stopped = 75,
};

/// An error in one line for the user: what is wrong, where (file, line, dataset), and how to mend it.
class Error : public std::runtime_error {
 public:
  Error(Exit status, const std::string& message) : std::runtime_error(message), status_(status) {}
  /// Returns the exit status that the error leads to.
  Exit status() const { return status_; }

 private:
  Exit status_;
};

/// The run ended, but missed a target. The message says whether output exists.
struct TargetNotReached : Error {
  explicit TargetNotReached(const std::string& m) : Error(Exit::not_reached, m) {}
};
/// The command line is wrong.
struct UsageError : Error {
  explicit UsageError(const std::string& m) : Error(Exit::usage, m) {}
};
/// Content of a file is invalid. The message begins with its name and, if there is one, line.
struct DataError : Error {
  explicit DataError(const std::string& m) : Error(Exit::bad_data, m) {}
};
/// An input file does not exist or cannot be opened.
struct MissingInput : Error {
  explicit MissingInput(const std::string& m) : Error(Exit::no_input, m) {}
};
/// Physics broke: a number is not finite, energy appears, grains overlap too deeply, a grain is lost.
struct PhysicsError : Error {
  explicit PhysicsError(const std::string& m) : Error(Exit::internal, m) {}
};
/// An output cannot be made, or would replace something that is still needed.
struct CannotCreate : Error {
  explicit CannotCreate(const std::string& m) : Error(Exit::cannot_create, m) {}
};
/// Reading or writing failed midway, for example on a full disk.
struct IoError : Error {
  explicit IoError(const std::string& m) : Error(Exit::io, m) {}
};
/// A signal stopped the work after its state was written. It can be resumed.
struct Stopped : Error {
  explicit Stopped(const std::string& m) : Error(Exit::stopped, m) {}
};

}  // namespace soilweave
