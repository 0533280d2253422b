// Guides that carry the geosynthetic under its seat pressure.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "fem/model/bars.h"

namespace soilweave::fem {

/// Returns the bars along the soil's boundary that a seat pressure, which acts against y, presses onto no guide: those
/// whose middle has no guide below it within one to three radii. Bars that hang over are not pressed.
std::vector<std::size_t> uncarried_bars(const BarsSetup& setup);

/// Returns a clause for messages: where the uncarried bars are, and the guide that would carry the whole chain. `bars`
/// must not be empty.
std::string uncarried_text(const BarsSetup& setup, const std::vector<std::size_t>& bars);

}  // namespace soilweave::fem
