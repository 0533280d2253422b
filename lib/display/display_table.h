// Pictures of a table: rows with a position become points, or are added to the grains that they describe.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "display/vtk.h"
#include "files/records.h"

namespace soilweave::io {

/// A range of consecutive rows of one state. They share `step` (or `time`), if there is such a column.
struct TableState {
  double time = 0;  // s
  std::int64_t step = 0;
  std::vector<std::size_t> rows;
};
/// Splits a table into its states.
std::vector<TableState> states_of(const Series& table);

/// Returns whether rows have a position: columns x y (z), or these names after "position_" or "centre_".
bool has_positions(const Series& table);

/// Returns the rows of one state as arrays. Columns name_x name_y (name_z) become a vector; name_xx name_xy ... become
/// a tensor, whose missing yx equals xy and whose other missing components are zero. Other columns become scalars.
/// Positions, step and time are left out.
std::vector<VtkArray> arrays_of(const Series& table, const std::vector<std::size_t>& rows);

/// Returns one vertex per row with the arrays of arrays_of() and add_principal(). Rows with a direction and a length
/// become lines. Throws DataError if rows have no positions.
VtkPicture show_rows(const Series& table, const TableState& state);

/// Returns the principal axes at the place of each row, a line each, as thesis Fig. 5.4 shows them. Returns nothing if
/// the rows have no place, no `volume` or no principal stresses (columns principal_K, direction_Kx ...). A length is
/// proportional to the size of the stress. The greatest stress of all states is as long as the edge of a cube (2D:
/// square) of the mean volume. Cell data: principal (1: the greatest, 2, 3), principal_stress (Pa). A NaN has no line.
std::optional<VtkPicture> show_axes(const Series& table, const TableState& state);

/// Adds the table as point arrays to the grains with the same body_id, at the picture's step if the table has steps. A
/// grain without a row gets NaN; an array of the same name is replaced. Throws DataError if the column body_id or this
/// state is missing.
void join_grains(VtkPicture& grains, const Series& table);

/// Returns comma-separated values below a header of bare column names, as ParaView reads them.
std::string to_csv(const Series& table);

}  // namespace soilweave::io
