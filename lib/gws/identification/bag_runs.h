// Series for identification, from runs of bags under uniaxial compression.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "files/files.h"
#include "gws/identification/identify.h"
#include "gws/solution/geotextile.h"

namespace soilweave::gws {

/// Returns whether the table is from `homogenize --table loading`.
bool is_loading(const io::Series& table);

/// Returns whether the table is from `homogenize --table reinforced`.
bool is_reinforced(const io::Series& table);

/// A tensile stiffness.
struct Stiffness {
  /// Stiffness J, N/m.
  double value = 0;
  /// Its source, in words.
  std::string source;
};
/// Returns the series of a bag from its loading. Rows begin at the reference row, where the settlement is first zero.
/// They end before the first broken yarn, because the solution takes the geotextile to be whole, or at the greatest
/// axial stress. The note names rows and stiffness. Throws DataError naming `where`.
BagSeries bag_of_loading(const io::Series& loading, const std::string& where, const Stiffness& stiffness);

/// Returns the series of reinforced soil in a periodic cell, by the same rules. Strains count from the last row of zero
/// axial strain in the cell. That row is already stressed, so the series serves the near-failure line alone.
BagSeries bag_of_reinforced(const io::Series& table, const std::string& where, const Stiffness& stiffness);

/// Returns the stiffness of the geotextile around a run's bag. A curve from data/geotextiles has its file's stiffness,
/// times the layers in its name. The scenario's `multiple` does not count here: one modelled yarn then represents
/// several yarns of one geotextile. A curve of numbers has its secant stiffness at failure, times the multiple, over
/// the spacing of yarns on the faces, which equals their length. Throws DataError naming `where` if the curve's file is
/// not in the run or has changed since.
Stiffness stiffness_in(const io::RunFile& run, const std::string& where);

/// Returns the series of a run's bag, between plates (packing/expand/loaded_bag.h) or in a periodic cell. given:
/// geotextile instead of the run's own.
BagSeries bag_of_run(const io::RunFile& run, const std::string& where, const std::optional<Geotextile>& given);

}  // namespace soilweave::gws
