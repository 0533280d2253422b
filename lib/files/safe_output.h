// Output of a long computation: its folder is entered anew or resumed, and the file is written at the end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "core/progress.h"
#include "files/part.h"

namespace soilweave::io {

/// Throws CannotCreate if the file at `output` has the bytes of an input in the history's last record. `option` named
/// the output.
void demand_no_input(const std::filesystem::path& output, const History& history, std::string_view option);

/// Output of one invocation.
class SafeOutput {
 public:
  /// Enters the folder of the output as --resume and --force say; standard output, pipes and devices have none. Throws
  /// what Part throws, and CannotCreate if a finished output has another history.
  SafeOutput(const std::filesystem::path& output, const History& history, const tool::Invocation& invocation);

  /// Returns whether nothing is left to do. Reports where the work begins.
  bool finished(Progress& progress) const;
  /// Returns the folder, nullptr if there is none.
  Part* part() { return part_ ? &*part_ : nullptr; }
  /// Calls write(), then removes the folder, and returns the seconds it took. Errors say what is kept.
  double write(const std::function<void()>& write);

 private:
  std::optional<Part> part_;
  std::string note_;
  bool finished_ = false;
};

}  // namespace soilweave::io
