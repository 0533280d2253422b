// Doubts on standard error.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/doubts.h"

#include <unistd.h>

#include <algorithm>

#include "core/terminal.h"

namespace soilweave {

void Doubts::add(const Doubt& doubt) {
  if (std::any_of(all_.begin(), all_.end(), [&](const Doubt& known) { return known.key == doubt.key; })) return;
  all_.push_back(doubt);
  if (tool_.empty()) return;
  // On a terminal a progress line may stand where the doubt will be written.
  const std::string clear = isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "";
  tell(clear + printable(tool_ + ": doubt: " + doubt.sentence) + "\n");
}

void Doubts::add_all(const std::vector<Doubt>& doubts) {
  for (const Doubt& doubt : doubts) add(doubt);
}

std::vector<Doubt> one_a_key(const std::vector<Doubt>& found, const std::string& things) {
  std::vector<Doubt> firsts, different;
  for (const Doubt& doubt : found)
    if (std::find(different.begin(), different.end(), doubt) == different.end()) different.push_back(doubt);
  for (const Doubt& doubt : different) {
    const auto same = [&](const Doubt& other) { return other.key == doubt.key; };
    if (std::any_of(firsts.begin(), firsts.end(), same)) continue;
    firsts.push_back(doubt);
    const auto more = std::count_if(different.begin(), different.end(), same) - 1;
    if (more > 0) firsts.back().sentence += "; this concerns " + std::to_string(more) + " more of the " + things;
  }
  return firsts;
}

}  // namespace soilweave
