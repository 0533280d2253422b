// Output of a long computation: its folder, and the file at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/progress.h"
#include "files/part.h"

namespace soilweave::io {

/// Throws CannotCreate if `output` is a file that the last record read. `option` named the output.
void demand_no_input(const std::filesystem::path& output, const History& history, std::string_view option);

/// Output of one invocation.
class SafeOutput {
 public:
  /// Enters the output's folder as --resume and --force say; standard output, pipes and devices have none. Throws like
  /// Part; CannotCreate if a finished output has another history.
  SafeOutput(const std::filesystem::path& output, const History& history, const tool::Invocation& invocation);

  /// Returns whether nothing is left to do, and reports where work begins.
  bool finished(Progress& progress) const;
  /// Returns the folder, or nullptr.
  Part* part() { return part_ ? &*part_ : nullptr; }
  /// Calls write(), removes the folder, returns the seconds. Errors say what is kept.
  double write(const std::function<void()>& write);

 private:
  std::optional<Part> part_;
  std::string note_;
  bool finished_ = false;
};

}  // namespace soilweave::io
