// Pictures of a table: rows become points, or data of grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "display/vtk.h"
#include "files/records.h"

namespace soilweave::io {

/// Consecutive rows of one `step` (or `time`), if there is such a column.
struct TableState {
  /// Time, s.
  double time = 0;
  std::int64_t step = 0;
  /// Indices of the rows.
  std::vector<std::size_t> rows;
};
/// Splits a table into its states.
std::vector<TableState> states_of(const Series& table);

/// Returns whether there are columns x y (z), also after "position_" or "centre_".
bool has_positions(const Series& table);

/// Returns one state's rows as arrays. Columns name_x name_y (name_z) become a vector, name_xx name_xy ... a tensor. A
/// missing yx equals xy; other missing components are zero. Positions, step and time are left out.
std::vector<VtkArray> arrays_of(const Series& table, const std::vector<std::size_t>& rows);

/// Returns one vertex per row, with the arrays of arrays_of() and add_principal(). Rows with direction and length
/// become lines. Throws DataError without positions.
VtkPicture show_rows(const Series& table, const TableState& state);

/// Returns the principal axes of each row as lines, as in thesis Fig. 5.4. Empty without positions, `volume` or
/// principal stresses (columns principal_K, direction_Kx ...). Lengths are proportional to stresses. The greatest
/// stress of all states is as long as the edge of a cube (2D: square) of the mean volume. Cell data: principal (1: the
/// greatest, 2, 3), principal_stress (Pa). A NaN has no line.
std::optional<VtkPicture> show_axes(const Series& table, const TableState& state);

/// Returns the table of the group "grains" of a fields file. Throws DataError if it has none.
Series read_grain_fields(const std::filesystem::path& path);
/// Adds the table's columns to the picture's grains with the same body_id, at its step if the table has steps. A grain
/// without a row gets NaN. Arrays of the same name are replaced. Throws DataError if the table lacks body_id, this step
/// or every grain of `state`, if its radii are those of another packing, or its positions those of another run.
void join_grains(VtkPicture& grains, const Snapshot& state, const Series& table);

/// Returns CSV with bare column names, for ParaView.
std::string to_csv(const Series& table);

}  // namespace soilweave::io
