// Curves of a drained triaxial test, and the rules by which tables of such tests are refused or doubted.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/doubts.h"
#include "files/provenance.h"

namespace soilweave::gws {

/// Curves of one test, a value for each row. Strains are fractions, compression and contraction positive.
struct Curves {
  /// Axial and volumetric strain, axial over radial stress.
  std::vector<double> strain, volumetric, ratio;
  /// Column that the ratio is computed from, "stress_ratio" or "deviatoric_stress".
  std::string stress;
  /// Strains without a unit, columns that are not read, and sentences on columns that could be meant for those that
  /// are.
  std::vector<std::string> without_unit, unread, alike;
};

/// Reads a table with strain_axial, strain_volumetric and stress_ratio (or deviatoric_stress). pressure: confining
/// pressure, Pa. Adds the table's source. Throws DataError, with the row, for values that no drained test from
/// isotropic stress gives, by the bounds of calibration (pipelines/calibration/plausible.py): an undrained test, stress
/// ratios or strains beyond those of soil, cells left at 0, a lateral stress that is not the pressure.
Curves read_curves(const std::string& path, double pressure, std::vector<io::Source>& sources);

/// Returns the doubts about curves that have a peak, each beginning with the path, by the bounds of calibration:
/// "triaxial-units", "-rest" (strains before shearing), "-signs", "-volume" (hardly any volumetric strain), "-unread",
/// "-outlier", "-strength".
std::vector<Doubt> doubts(const Curves& curves, const std::string& path);

}  // namespace soilweave::gws
