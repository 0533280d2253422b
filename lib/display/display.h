// Pictures of an assembly of grains for the VTK writer: points, lines and boxes with their arrays.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "display/vtk.h"
#include "files/records.h"

namespace soilweave::io {

/// Returns the origin of the drawn cell, in cell vectors: zero, or, along periodic axes, half a cell before the middle
/// of the geotextiles' nodes, so that a bag is in one piece.
Vec3 cell_origin(const Snapshot& state);

/// Returns the number of cell vectors to subtract from a position so that it lies in the cell at `origin`; zero along
/// aperiodic axes.
Vec3i cell_index(const CellRecord& cell, const Vec3& position, const Vec3& origin);

/// Returns the factor (m/N) that makes the greatest normal force of all states a tube half as thick as the mean grain;
/// 1 if there is no force.
double fitting_force_scale(const std::vector<const Snapshot*>& states);

/// Returns one vertex per grain, inside the cell unless `unwrapped`. Arrays: body_id, material_id, copy_id, radius,
/// mass, velocity (fluctuation about the cell's affine motion), angular_velocity, orientation (w x y z), coordination.
/// `dyads` holds one tensor per grain, N m: the sum of f l^T over its contacts. With it the arrays include stress =
/// dyad over the grain's solid volume (2D: area), Pa, compression positive, and the arrays of add_principal.
VtkPicture show_grains(const Snapshot& state, const std::vector<Mat3>& dyads, bool unwrapped);

/// Adds principal_stress (greatest first) and major_direction (unit) of the tensors `stress`, if any. Replaces earlier
/// ones.
void add_principal(VtkPicture& picture);

/// Returns contacts as lines from centre to centre. A contact through a periodic face is drawn twice, half out on
/// either side, with `copies` = 2. A contact with a plane ends at the plane. Cell data: contact (its index in the
/// file), copies, body_id_1, body_id_2 (-1 - number for a plane), normal, normal_force, shear_force (on the second
/// body) and its magnitude, rolling_moment, twisting_moment, overlap, sliding. Point data: tube_radius = force_scale
/// (m/N) times the normal force, if compressive.
VtkPicture show_contacts(const Snapshot& state, bool unwrapped, double force_scale);

/// Returns the cell as one hexahedron (2D: quad). Along aperiodic axes it extends as far as the grains. Cell data:
/// volume, deformation_gradient, velocity_gradient.
VtkPicture show_cell(const Snapshot& state);

/// Returns rigid planes as quads (2D: lines) as large as the assembly. Cell data: plane (its number), material_id,
/// normal, velocity.
VtkPicture show_planes(const Snapshot& state);

/// Returns unbroken yarns as lines between their nodes. Cell data: tension (N), strain, family, fabric.
VtkPicture show_yarns(const Snapshot& state);

/// Returns a vertex at the place of each break; none before the first. Point data: yarn (its number), family,
/// break_time (s).
VtkPicture show_broken(const Snapshot& state);

}  // namespace soilweave::io
