// Progress on standard error: in place on a terminal, otherwise a line now and then, nothing if quiet.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace soilweave {

/// Receives the fraction done (0 to 1) and a line on the present state.
using ProgressReport = std::function<void(double fraction, const std::string& detail)>;

/// Progress of one piece of work. The destructor clears its line on a terminal.
class Progress {
 public:
  /// name: the advancing quantity ("axial strain"). quiet: print nothing.
  Progress(std::string name, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Shows progress, at most 10 times a second on a terminal and every 30 s elsewhere.
  /// fraction: 0 to 1; resumed work may begin above 0. detail: free text ("step 1200").
  void update(double fraction, std::string_view detail = "");
  /// Prints a note on its own line ("isotropic: done, e = 0.664").
  void note(std::string_view line);

 private:
  /// The advancing quantity.
  std::string name_;
  bool quiet_;
  /// Whether standard error is a terminal.
  bool terminal_;
  bool shown_ = false;
  // Fraction of the first call.
  double first_ = 1;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace soilweave
