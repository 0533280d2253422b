// The check that a processor can run what was compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave {

/// Exit status where the processor is too old.
inline constexpr int old_processor_status = 69;

/// Does nothing; whoever calls it has the check linked, which runs before main.
void link_processor_check();

}  // namespace soilweave
