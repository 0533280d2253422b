// Pictures of grains, contacts, planes and yarns for the VTK writer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "display/vtk.h"
#include "files/records.h"

namespace soilweave::io {

/// Returns the origin of the drawn cell, in cell vectors. Along periodic axes, a geotextile lies in the middle, so that
/// a bag is in one piece.
Vec3 cell_origin(const Snapshot& state);

/// Returns the cell vectors to subtract from a position to bring it into the cell at `origin`. Zero along aperiodic
/// axes.
Vec3i cell_index(const CellRecord& cell, const Vec3& position, const Vec3& origin);

/// Returns the factor (m/N) that draws the greatest normal force as a tube half as thick as the mean grain. 1 if there
/// is no force.
double fitting_force_scale(const std::vector<const Snapshot*>& states);

/// Returns one vertex per grain, inside the cell unless `unwrapped`. Arrays: body_id, material_id, copy_id, radius,
/// mass, velocity (fluctuation about the cell's affine motion), angular_velocity, orientation (w x y z), coordination.
/// `dyads` holds the sum of f l^T over each grain's contacts, N m. If given, there are also the arrays of
/// add_principal() and stress = dyad / solid volume (2D: area), Pa, compression positive.
VtkPicture show_grains(const Snapshot& state, const std::vector<Mat3>& dyads, bool unwrapped);

/// Adds principal_stress (greatest first; disks have two) and major_direction (unit) if there is an array `stress`.
/// Replaces earlier ones.
void add_principal(VtkPicture& picture, int dimension);

/// Returns contacts as lines from centre to centre, or to the plane. A contact through a periodic face is drawn twice,
/// with `copies` = 2. Cell data: contact (index in the file), copies, body_id_1, body_id_2 (-1 - number for a plane),
/// normal, normal_force, shear_force (on the second body) and its magnitude, rolling_moment, twisting_moment, overlap,
/// sliding. Point data: tube_radius = force_scale (m/N) times compressive normal force.
VtkPicture show_contacts(const Snapshot& state, bool unwrapped, double force_scale);

/// Returns the cell as one hexahedron (2D: quad). Along aperiodic axes it reaches as far as the grains. Cell data:
/// volume, deformation_gradient, velocity_gradient.
VtkPicture show_cell(const Snapshot& state);

/// Returns planes as quads (2D: lines) as large as the assembly. Cell data: plane (its number), material_id, normal,
/// velocity.
VtkPicture show_planes(const Snapshot& state);

/// Returns unbroken yarns as lines. Cell data: tension (N), strain, family, fabric.
VtkPicture show_yarns(const Snapshot& state);

/// Returns a vertex at each break. Point data: yarn (its number), family, break_time (s).
VtkPicture show_broken(const Snapshot& state);

}  // namespace soilweave::io
