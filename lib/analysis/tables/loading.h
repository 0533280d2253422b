// A bag of geotextile between two plates: settlement, pressures, soil strains and tensions, from a run's series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// A bag and its plates, as far as the run's series does not describe them (packing/expand/loaded_bag.h reads them from
/// the run).
struct LoadedBag {
  std::string upper = "top", lower = "bottom";  // names of the plates
  double area = 0;                              // area under the forces of the plates, m2
  double height = 0;         // distance of the faces as made, the reference of engineering strains, m
  double fabric_volume = 0;  // volume of the layer filled by the nodes of the geotextile, m3
  double gap = 0;            // distance of the plates at zero displacement, m
  bool preloaded = false;    // whether strains count from the end of the first stage instead of the start
  std::array<double, 3> multiple = {1, 1, 1};  // number of yarns of the geotextile per modelled yarn, by family
  double face_yarns = 0, side_yarns = 0;  // yarns that an upright plane in the middle cuts on one face and on one side
  std::vector<std::optional<double>> closing_speed;  // greatest speed of the plates by stage, m/s; none under a load
  std::optional<double> first_break;                 // time of the first broken yarn, s
};

/// Returns the row from which settlements and strains count: the last row of the first stage, or the first of all.
std::size_t reference_row(const io::Series& run, const LoadedBag& bag);
/// Returns the first row with a broken yarn, or the last row.
std::size_t first_broken_row(const io::Series& run);

/// Returns the engineering axial strain at which the first yarn broke: strain of the row before, plus closing of the
/// plates at their greatest speed since then, at most the strain of the row after. NaN if none broke in these rows.
double first_break_strain(const io::Series& run, const LoadedBag& bag);

/// Returns one row per row of the series; files/FORMAT.md lists the columns. Throws DataError naming a missing column.
io::Series loading(const io::Series& run, const LoadedBag& bag);

/// A path of mean and deviatoric stress, fitted by the best line through the origin.
struct StressPath {
  double slope = 0;      // slope of the line, by least squares
  double deviation = 0;  // greatest difference of q from the line, over the greatest q
  std::size_t points = 0;
};
/// Fits p = mean and q = deviatoric, Pa, of equally many points. NaN without points, or if all are unloaded.
StressPath stress_path(const std::vector<double>& mean, const std::vector<double>& deviatoric);

/// Returns the stress paths from the reference row to the row of the first break. Row -1 is the whole soil, from the
/// series. The others are its groups along x (volume_of_interest.h), from the states in between.
io::Series stress_paths(const io::Series& run, const std::vector<io::Snapshot>& states, const LoadedBag& bag);

/// Returns the number of yarns of a fabric that an upright plane in its middle cuts on one face and on one side,
/// averaged over the planes across x and y. Yarns of a rim count half to the face and half to the side.
std::array<double, 2> yarns_in_cut(const io::Snapshot& state, std::int32_t fabric);
/// Returns the area of the fabric's quadrilaterals, each between four yarns, m2.
double fabric_area(const io::Snapshot& state, std::int32_t fabric);

}  // namespace soilweave::analysis
