// Check that a processor can run what was compiled.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave {

/// Exit status if the processor is too old.
inline constexpr int old_processor_status = 69;

/// Does nothing, but links the check, which runs before main.
void link_processor_check();

}  // namespace soilweave
