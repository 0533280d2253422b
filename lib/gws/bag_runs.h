// Bags in uniaxial compression between plates, read from their runs, as the series that a soil is identified from.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "gws/geotextile.h"
#include "gws/identify.h"
#include "io/files.h"

namespace soilweave::gws {

/// Whether a table is one of `homogenize --table loading`, by its columns.
bool is_loading(const io::Series& table);

/// Returns the series of a bag from a table of its loading. Its rows are those from the reference row, where the
/// settlement is zero first, to the last one without a broken yarn: the solution takes the geotextile to be whole.
/// Rows after the greatest axial stress are left out, as of every series. `stiffness`: of the geotextile, and who says
/// so. The series' note tells which rows these are, and the stiffness. Throws DataError naming `where`.
struct Stiffness {
  double value = 0;  // J, N/m
  std::string source;
};
BagSeries bag_of_loading(const io::Series& loading, const std::string& where, const Stiffness& stiffness);

/// Returns the tensile stiffness of the geotextile around the bag of a run. A curve of data/geotextiles has the
/// stiffness that its file states, in as many layers as its name says, whatever its multiple: a yarn that stands for
/// several is of the same geotextile. A curve of numbers has its secant to failure, times the multiple, over the
/// spacing of the yarns on the faces, which are as far apart as they are long. Throws DataError naming `where` for a
/// curve of another file, which is not in the run, and where data/geotextiles has changed since.
Stiffness stiffness_in(const io::RunFile& run, const std::string& where);

/// Returns the series of a run's bag (packing/loaded_bag.h). `given`: a geotextile to take instead of the run's own.
BagSeries bag_of_run(const io::RunFile& run, const std::string& where, const std::optional<Geotextile>& given);

}  // namespace soilweave::gws
