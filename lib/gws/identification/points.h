// Points of tests without a bag: compression under a mean stress, and strengths under confining pressures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "core/doubts.h"
#include "files/provenance.h"
#include "gws/identification/line.h"

namespace soilweave::gws {

/// Reads the columns mean_stress and strain_volumetric as points (p, eps_v) in Pa and 1; none for an empty path. Adds
/// the table's source. Throws DataError, by row, for a mean stress beyond 500 Pa to 100 MPa, and for a strain of 0.3 or
/// more. The doubt "compression-points" is a strain without a unit.
Points compression_points(const std::filesystem::path& path, std::vector<io::Source>& sources);

/// Reads the columns confining_pressure and obliquity_at_failure as points (p, q/p) in Pa and 1; none for an empty
/// path. p = 3 sigma_r / (3 - q/p), since q = sigma_a - sigma_r; confined: the confining pressure sigma_r in the place
/// of p, as in the thesis. Adds the table's source. Throws DataError, by row, for a pressure beyond 500 Pa to 100 MPa,
/// and for q/p beyond 0 to 42/17, an axial over radial stress of 15. Doubts: "failure-points", a friction angle that
/// granular soils do not have, and "failure-pressures", no pressure from 10 kPa to 10 MPa.
Points failure_points(const std::filesystem::path& path, bool confined, std::vector<io::Source>& sources);

}  // namespace soilweave::gws
