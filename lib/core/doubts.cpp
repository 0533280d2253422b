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

}  // namespace soilweave
