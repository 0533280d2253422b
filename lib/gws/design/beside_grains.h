// The ultimate load of the solution beside full-size bags and cells of discrete elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Load of the solution for Toyoura sand beside that of a full-size run.
struct BesideGrains {
  /// Tensile stiffness of the geotextile, N/m; the solution's surcharge over the run's, 1, at failure and at a
  /// settlement of 5 % of the height; its settlement at failure less the run's, % of the height; lateral stress of the
  /// run, Pa.
  double stiffness, ratio, early, settlement, lateral = 0;
};

/// Returns the seven bags of chapter 5, by rising stiffness (pipelines/ch5/kept/misfits.tsv).
std::span<const BesideGrains> bags_of_grains();
/// Returns the cells of wrapped soil, by rising lateral stress and stiffness (same table).
std::span<const BesideGrains> cells_of_grains();

/// Returns how the ultimate load of `bag` compares with that of the runs nearest in lateral stress (as a ratio) and
/// stiffness, as lines. A lateral stress that varies counts with its greatest value. They are empty where no run is
/// comparable: another soil than Toyoura sand, another bag, a compacted one, or a failure that is not counted at half
/// of the whole strength.
std::string beside_grains(const Case& bag);

}  // namespace soilweave::gws
