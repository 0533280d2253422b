// Reads bags under uniaxial compression between plates from their runs, as the series that a soil is identified from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "files/files.h"
#include "gws/identification/identify.h"
#include "gws/solution/geotextile.h"

namespace soilweave::gws {

/// Returns whether the columns of `table` are those of `homogenize --table loading`.
bool is_loading(const io::Series& table);

/// Returns whether the columns of `table` are those of `homogenize --table reinforced`.
bool is_reinforced(const io::Series& table);

/// A tensile stiffness of a geotextile, and where it comes from.
struct Stiffness {
  double value = 0;  // tensile stiffness J, N/m
  std::string source;
};
/// Returns the series of a bag from a table of its loading. The rows begin at the reference row, where the settlement
/// is first zero. They end before the first broken yarn, because the solution takes the geotextile to be whole. Rows
/// after the greatest axial stress are left out, as in every series. The note of the series names the rows and the
/// stiffness. Throws DataError naming `where`.
BagSeries bag_of_loading(const io::Series& loading, const std::string& where, const Stiffness& stiffness);

/// Returns the series of the reinforced soil in a periodic cell, by the same rules; its strains count from the last row
/// where the cell's axial strain is zero. The soil is under the stress of its cell there, where the solution does not
/// begin, so the series serves the near-failure line alone.
BagSeries bag_of_reinforced(const io::Series& table, const std::string& where, const Stiffness& stiffness);

/// Returns the tensile stiffness of the geotextile around the bag of a run. A curve from data/geotextiles has the
/// stiffness that its file states, times the layers in its name; the multiple does not count, since a yarn that stands
/// for several yarns is of the same geotextile. A curve of numbers has its secant stiffness at failure, times the
/// multiple, over the yarns' spacing on the faces. That spacing equals the yarns' length. Throws DataError naming
/// `where` if the curve's file is not in the run, or if data/geotextiles has changed since.
Stiffness stiffness_in(const io::RunFile& run, const std::string& where);

/// Returns the series of a run's bag, between plates (packing/expand/loaded_bag.h) or in a periodic cell. `given`: a
/// geotextile to use instead of the run's own.
BagSeries bag_of_run(const io::RunFile& run, const std::string& where, const std::optional<Geotextile>& given);

}  // namespace soilweave::gws
