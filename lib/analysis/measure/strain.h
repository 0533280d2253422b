// Strain of the cell, of a volume of interest, and of the space between neighbouring grains; compression positive.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/measure/tessellation.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns minus the logarithm of the left stretch of a deformation gradient.
Mat3 natural_strain(const Mat3& deformation_gradient);
/// Returns the natural strains of the cell since its reference.
Mat3 cell_strain(const io::CellRecord& cell);
/// Return the trace of the natural strains, contraction positive, and sqrt(2/3 e:e) of their deviator e (in 2D the
/// difference of the principal strains).
double volumetric_strain(const Mat3& strain, int dimension);
double deviatoric_strain(const Mat3& strain, int dimension);

/// Returns the deformation gradient of each simplex of the reference, from the displacements of its grains, matched by
/// body_id. Throws DataError if one is missing. Exact for an affine motion. Bagi 1996.
std::vector<Mat3> simplex_gradients(const io::Snapshot& reference, const io::Snapshot& present,
                                    const std::vector<Simplex>& simplices);
/// Returns for each present grain the mean gradient of the simplices around it, weighted by their reference volume.
std::vector<Mat3> grain_gradients(const io::Snapshot& reference, const io::Snapshot& present,
                                  const std::vector<Simplex>& simplices, const std::vector<Mat3>& gradients);
/// Returns the gradient that best maps the reference positions of some grains (indices in the present state) to the
/// present ones by least squares. Throws DataError if they are too few or lie in a plane.
Mat3 best_fit_gradient(const io::Snapshot& reference, const io::Snapshot& present,
                       const std::vector<std::size_t>& grains);

}  // namespace soilweave::analysis
