// Strains of the cell, of volumes and of grain neighbourhoods; compression positive.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "analysis/measure/tessellation.h"
#include "files/records.h"

namespace soilweave::analysis {

/// Returns minus the logarithm of the left stretch.
Mat3 natural_strain(const Mat3& deformation_gradient);
/// Returns the cell's natural strains since its reference.
Mat3 cell_strain(const io::CellRecord& cell);
/// Returns the trace of natural strains, contraction positive.
double volumetric_strain(const Mat3& strain, int dimension);
/// Returns sqrt(2/3 e:e) of the deviator e; 2D: the difference of principal strains.
double deviatoric_strain(const Mat3& strain, int dimension);

/// Returns the deformation gradient of each reference simplex (Bagi 1996), exact for affine motion. Grains are matched
/// by body_id; throws DataError if one is missing.
std::vector<Mat3> simplex_gradients(const io::Snapshot& reference, const io::Snapshot& present,
                                    const std::vector<Simplex>& simplices);
/// Returns for each present grain the mean gradient of its simplices, weighted by reference volume.
std::vector<Mat3> grain_gradients(const io::Snapshot& reference, const io::Snapshot& present,
                                  const std::vector<Simplex>& simplices, const std::vector<Mat3>& gradients);
/// Returns the least-squares gradient from reference to present positions. `grains` are indices in the present state.
/// `images`, one per grain, shift the unwrapped positions to one place; without `images`, grains are wrapped into the
/// reference's cell. Throws DataError if the grains are too few or lie in a plane.
Mat3 best_fit_gradient(const io::Snapshot& reference, const io::Snapshot& present,
                       const std::vector<std::size_t>& grains, const std::vector<Vec3i>& images = {});

}  // namespace soilweave::analysis
