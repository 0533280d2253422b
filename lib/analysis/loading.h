// A bag of geotextile between two plates: settlement, pressures, strains of its soil and tensions, from a run's series.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "io/records.h"

namespace soilweave::analysis {

/// A bag and the plates around it, as far as the series of its run does not tell them (packing/loaded_bag.h reads them
/// from the run).
struct LoadedBag {
  std::string upper = "top", lower = "bottom";  // names of the plates
  double area = 0;                              // m2, which the forces of the plates are spread over
  double height = 0;                            // m, between the faces as made, which engineering strains refer to
  double fabric_volume = 0;                     // m3, of the layer that the nodes of the geotextile fill
  double gap = 0;                               // m, between the plates while their displacements are zero
  bool preloaded = false;                       // strains count from the end of the first stage, else from the start
  std::array<double, 3> multiple = {1, 1, 1};   // by family: how many yarns of the geotextile one yarn stands for
  double face_yarns = 0, side_yarns = 0;        // which an upright plane in the middle cuts on one face and on one side
  std::vector<std::optional<double>> closing_speed;  // m/s, largest, of the plates in each stage; none under a load
  std::optional<double> first_break;                 // s, when the first yarn broke
};

/// Row that settlements and strains count from: the last one of the first stage so far, or the first of all.
std::size_t reference_row(const io::Series& run, const LoadedBag& bag);
/// First row in which a yarn is broken, or the last of all.
std::size_t first_broken_row(const io::Series& run);

/// Engineering axial strain at which the first yarn broke: that of the row before, and what the plates, at their
/// largest speed, close in the time from there; no farther than the row after it. NaN where none broke in these rows.
double first_break_strain(const io::Series& run, const LoadedBag& bag);

/// One row per row of the series; the columns are listed in io/FORMAT.md. Throws DataError naming a column that the
/// series lacks.
io::Series loading(const io::Series& run, const LoadedBag& bag);

/// A path in the plane of mean and deviatoric stress beside the line through the origin that fits it best.
struct StressPath {
  double slope = 0;      // of the line, by least squares
  double deviation = 0;  // greatest difference of q from the line, over the greatest q
  std::size_t points = 0;
};
/// mean, deviatoric: p and q of the points, Pa, equally many. NaN where there is none, or where all are unloaded.
StressPath stress_path(const std::vector<double>& mean, const std::vector<double>& deviatoric);

/// The paths of stress from the reference row to the row of the first break: row -1 of the whole soil, from the series;
/// the others of its groups along x (volume_of_interest.h), from those of the states that lie between.
io::Series stress_paths(const io::Series& run, const std::vector<io::Snapshot>& states, const LoadedBag& bag);

/// Number of yarns that an upright plane in the middle of the fabric's `yarns` cuts on one face and on one side, mean
/// of the planes across x and y. The yarns of a rim count half to the face and half to the side.
std::array<double, 2> yarns_in_cut(const io::Snapshot& state, std::int32_t fabric);
/// Area of the fabric's quadrilaterals, m2, each four yarns around.
double fabric_area(const io::Snapshot& state, std::int32_t fabric);

}  // namespace soilweave::analysis
