// The way of an output that takes long to make: entered anew or where it was left, and written at its end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/progress.h"
#include "io/part.h"

namespace soilweave::io {

/// Throws CannotCreate if the file at `output` has the bytes of one of the inputs in the history's last record. Files
/// that a scenario or plan names are known to the command only once these are read. option: what named the output.
void demand_no_input(const std::filesystem::path& output, const History& history, std::string_view option);

class SafeOutput {
 public:
  /// Enters the folder of the output as the options say (--resume, --force); standard output, pipes and devices have
  /// none. Throws what Part does, CannotCreate where a finished output of another history is in the way.
  SafeOutput(const std::filesystem::path& output, const History& history, const tool::Invocation& invocation);

  /// Whether there is nothing left to do; says on the way where the work begins.
  bool finished(Progress& progress) const;
  /// nullptr where there is no folder.
  Part* part() { return part_ ? &*part_ : nullptr; }
  /// Calls write(), then removes the folder. Errors say what is kept. Returns the seconds it took.
  double write(const std::function<void()>& write);

 private:
  std::optional<Part> part_;
  std::string note_;
  bool finished_ = false;
};

}  // namespace soilweave::io
