// A sign of life on standard error: in place on a terminal, a plain line now and then otherwise, none when quiet.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <string>
#include <string_view>

namespace soilweave {

class Progress {
 public:
  /// name: what is advancing ("axial strain"); quiet: print nothing at all.
  Progress(std::string name, bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// fraction: 0 to 1 of a quantity that really advances, from the first call on, since work may be resumed; detail:
  /// free text ("step 1200, unbalanced 2e-3"). Rate-limited here (10 Hz on a terminal, every 30 s otherwise), so call
  /// it as often as convenient.
  void update(double fraction, std::string_view detail = "");
  /// A note on its own line ("isotropic: done, e = 0.664").
  void note(std::string_view line);

 private:
  std::string name_;
  bool quiet_;
  bool terminal_;
  bool shown_ = false;
  double first_ = 1;
  std::chrono::steady_clock::time_point start_, last_;
};

}  // namespace soilweave
