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

/// Throws CannotCreate if `output` is an input of the history's last record. `option`: name of the output's option.
void demand_no_input(const std::filesystem::path& output, const History& history, std::string_view option);

/// Output of one invocation.
class SafeOutput {
 public:
  /// Opens the folder OUTPUT.part as --resume and --force demand. Standard output, pipes and devices have no folder.
  /// Throws like Part; CannotCreate if a finished output has another history.
  SafeOutput(const std::filesystem::path& output, const History& history, const tool::Invocation& invocation);

  /// Returns whether the output is finished already. Reports that, or where a resumed run begins.
  bool finished(Progress& progress) const;
  /// Returns the folder, or nullptr.
  Part* part() { return part_ ? &*part_ : nullptr; }
  /// Calls write(), removes the folder and returns the seconds taken. Errors name the files that are kept.
  double write(const std::function<void()>& write);

 private:
  std::optional<Part> part_;
  std::string note_;
  bool finished_ = false;
};

}  // namespace soilweave::io
