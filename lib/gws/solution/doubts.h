// Doubts about an analytical answer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/doubts.h"
#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Returns the doubts by name. "default-soil": the soil was not `chosen`. "estimated-soil": no bags of it were
/// computed; those of the test that they were estimated from follow (estimate.h). "exact-fit": see unscattered().
/// "unknown-range": the soil file lacks the ranges of the data that it was identified on. "extrapolation": a stiffness
/// (N/m), mean stress or axial strain leaves the range of the soil's data. "untested": the bag's shape or the lateral
/// stress of `asked` leaves the range of the discrete-element runs. "compressed": in the last state the lateral stress
/// outside exceeds the soil's, which only a geotextile under compression could balance. Those of beyond_history()
/// follow. States that do not exist are skipped.
std::vector<Doubt> doubts(const SoilFile& soil, bool chosen, const Case& asked, const std::vector<double>& stiffnesses,
                          const std::vector<Point>& states);

/// Returns "history-begin" and "history-end" where a solution from one surcharge to another, Pa, leaves the history.
std::vector<Doubt> beyond_history(const LateralStress& lateral, double from, double to);

/// Returns "exact-fit" if lines of the soil were fitted to as many points as they have constants.
std::vector<Doubt> unscattered(const SoilFile& soil);

/// Returns "contradiction" if stiffness times failure strain of a geotextile without a curve is not its strength within
/// a factor of 1.5.
std::vector<Doubt> contradictions(const Geotextile& geotextile);

}  // namespace soilweave::gws
