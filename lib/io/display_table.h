// What to show of a table: rows that have a place in space become points, or are added to the grains they speak of.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "io/records.h"
#include "io/vtk.h"

namespace soilweave::io {

/// A stretch of consecutive rows that belong to one state: equal `step` (or `time`) where there is such a column.
struct TableState {
  double time = 0;  // s
  std::int64_t step = 0;
  std::vector<std::size_t> rows;
};
std::vector<TableState> states_of(const Series& table);

/// Whether rows have a place: columns x y (z), or the same after "position_" or "centre_".
bool has_positions(const Series& table);

/// The rows of one state as arrays: columns name_x name_y (name_z) become a vector, name_xx name_xy ... a tensor (yx is
/// taken from xy where absent; what a 2D table leaves out is zero), the others scalars. Positions, step and time are
/// left out.
std::vector<VtkArray> arrays_of(const Series& table, const std::vector<std::size_t>& rows);

/// One vertex a row, with arrays_of it; a line a row, about its place, where the rows have a direction and a length
/// (the arrays are cell data then). Throws DataError without positions.
VtkPicture show_rows(const Series& table, const TableState& state);

/// Adds the rows of the table that have the picture's step (all of them if it has no step) to the grains with the same
/// body_id, as point arrays; a grain without a row gets NaN, an array of the same name is replaced. Throws DataError if
/// the table has no body_id column or no row for this state.
void join_grains(VtkPicture& grains, const Series& table);

/// Comma-separated values with a header of bare column names, as ParaView reads them.
std::string to_csv(const Series& table);

}  // namespace soilweave::io
