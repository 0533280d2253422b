// What to show of an assembly of grains: points, lines and boxes with their arrays, ready for the VTK writer.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "io/records.h"
#include "io/vtk.h"

namespace soilweave::io {

/// The number of cell vectors to take off a position so that it lies in the cell (zero along axes that are not
/// periodic).
Vec3i cell_index(const CellRecord& cell, const Vec3& position);

/// m/N: makes the greatest normal force of all states a tube half as thick as the mean grain; 1 without any force.
double fitting_force_scale(const std::vector<const Snapshot*>& states);

/// One vertex a grain, inside the cell unless `unwrapped`. Arrays: body_id, material_id, copy_id, radius, mass,
/// velocity (the fluctuation about the cell's affine motion), angular_velocity, orientation (w x y z), coordination;
/// with dyads (N m, one a grain: sum of f l^T over its contacts) also stress = dyad over the grain's own solid volume
/// (2D: area), Pa, compression positive, and add_principal's.
VtkPicture show_grains(const Snapshot& state, const std::vector<Mat3>& dyads, bool unwrapped);

/// principal_stress (greatest first) and major_direction (unit) of the tensors `stress`, if there are any; replaces
/// earlier ones.
void add_principal(VtkPicture& picture);

/// Lines from centre to centre. A contact through a periodic face is drawn twice, half out at either side, and says so
/// in `copies`; a contact with a plane ends at the plane. Cell data: contact (its index in the file), copies,
/// body_id_1, body_id_2 (-1 - number for a plane), normal, normal_force, shear_force (on the second body) and its
/// magnitude, rolling_moment, twisting_moment, overlap, sliding. Point data: tube_radius = force_scale (m/N) times the
/// normal force, where compressive.
VtkPicture show_contacts(const Snapshot& state, bool unwrapped, double force_scale);

/// The cell as one hexahedron (2D: quad), so that its tilt shows; along axes that are not periodic it reaches as far as
/// the grains do. Cell data: volume, deformation_gradient, velocity_gradient.
VtkPicture show_cell(const Snapshot& state);

/// Rigid planes as quads (2D: lines) as large as the assembly. Cell data: plane (its number), material_id, normal,
/// velocity.
VtkPicture show_planes(const Snapshot& state);

/// Yarns as lines between their nodes, broken ones left out. Cell data: tension (N), strain, family, fabric.
VtkPicture show_yarns(const Snapshot& state);

/// A vertex where each broken yarn broke; none before the first. Point data: yarn (its number), family, break_time (s).
VtkPicture show_broken(const Snapshot& state);

}  // namespace soilweave::io
