// A bag between two plates: settlement, pressures, soil strains and tensions.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "files/records.h"

namespace soilweave::analysis {

/// A bag and its plates, beyond the run's series (packing/expand/loaded_bag.h).
struct LoadedBag {
  /// Names of the plates.
  std::string upper = "top", lower = "bottom";
  /// Area under the plates' forces, m2.
  double area = 0;
  /// Initial distance of the faces, m: reference of engineering strains.
  double height = 0;
  /// Volume of the layer that the geotextile's nodes fill, m3.
  double fabric_volume = 0;
  /// Distance of the plates at zero displacement, m.
  double gap = 0;
  /// Whether strains count from the end of the first stage.
  bool preloaded = false;
  /// Real yarns per modelled yarn, by family.
  std::array<double, 3> multiple = {1, 1, 1};
  /// Yarns in an upright cut through the middle: on one face, on one side.
  double face_yarns = 0, side_yarns = 0;
  /// Greatest speed of the plates by stage, m/s; empty for a stage under a given load.
  std::vector<std::optional<double>> closing_speed;
  /// Time of the first broken yarn, s.
  std::optional<double> first_break;
};

/// Returns the row from which strains count: the end of the first stage, or row 0.
std::size_t reference_row(const io::Series& run, const LoadedBag& bag);
/// Returns the first row with a broken yarn, or the last row.
std::size_t first_broken_row(const io::Series& run);

/// Returns the engineering axial strain at the first break; NaN if no yarn broke in these rows. From the row before the
/// break, the plates close at their greatest speed, at most to the strain of the row after. Without a speed the strain
/// is interpolated in time.
double first_break_strain(const io::Series& run, const LoadedBag& bag);

/// Returns one row per row of the series (columns: files/FORMAT.md). Throws DataError naming a missing column.
io::Series loading(const io::Series& run, const LoadedBag& bag);

/// A stress path, fitted by a line through the origin.
struct StressPath {
  /// Slope by least squares.
  double slope = 0;
  /// Greatest difference of q from the line, over the greatest q.
  double deviation = 0;
  /// Number of points.
  std::size_t points = 0;
};
/// Fits p = mean and q = deviatoric, Pa, of equal length. NaN without points, or if all are unloaded.
StressPath stress_path(const std::vector<double>& mean, const std::vector<double>& deviatoric);

/// Returns the stress paths from the reference row to the first break. Row -1 is the whole soil, from the series. The
/// others are groups along x (volume_of_interest.h), from `states`.
io::Series stress_paths(const io::Series& run, const std::vector<io::Snapshot>& states, const LoadedBag& bag);

/// Returns the numbers of yarns that an upright plane through the middle cuts on a face and on a side. They are
/// averages over planes across x and across y. A rim's yarns count half to the face and half to the side.
std::array<double, 2> yarns_in_cut(const io::Snapshot& state, std::int32_t fabric);
/// Returns the area of all quadrilaterals between four yarns, m2.
double fabric_area(const io::Snapshot& state, std::int32_t fabric);

}  // namespace soilweave::analysis
