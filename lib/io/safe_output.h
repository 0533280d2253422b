// The way of an output that takes long to make: entered anew or where it was left, and written at its end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "io/part.h"

namespace soilweave::io {

class SafeOutput {
 public:
  /// Enters the folder of the output as the options say (--resume, --force); standard output, pipes and devices have
  /// none. Throws what Part does, CannotCreate where a finished output of another history is in the way.
  SafeOutput(const std::filesystem::path& output, const History& history, const tool::Invocation& invocation);

  /// Whether there is nothing left to do.
  bool finished() const { return finished_; }
  /// nullptr where there is no folder.
  Part* part() { return part_ ? &*part_ : nullptr; }
  /// A line for the user about where it begins; empty where there is nothing to say.
  const std::string& note() const { return note_; }
  /// Calls write(), then removes the folder. Errors say what is kept. Returns the seconds it took.
  double write(const std::function<void()>& write);

 private:
  std::optional<Part> part_;
  std::string note_;
  bool finished_ = false;
};

}  // namespace soilweave::io
