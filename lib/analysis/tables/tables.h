// Tables of homogenize and fabric, one state at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "analysis/measure/volume_of_interest.h"
#include "files/files.h"

namespace soilweave::analysis {

/// Value of an empty cell in a table.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

/// Returns the values of a column, made if missing.
std::vector<double>& column(io::Series& table, const std::string& name, const std::string& unit,
                            const std::string& long_name);
/// Appends of(k) for each k of `rows` to a column. A missing column is made, even if `rows` is empty.
template <class Of>
void put_rows(io::Series& table, const std::string& name, const std::string& unit, const std::string& long_name,
              const std::vector<std::size_t>& rows, const Of& of) {
  std::vector<double>& values = column(table, name, unit, long_name);
  for (const std::size_t k : rows) values.push_back(of(k));
}
/// Appends a value to a column, made if missing.
void put(io::Series& table, const std::string& name, const std::string& unit, const std::string& long_name,
         double value);
/// Appends a symmetric tensor to columns PREFIX_xx, PREFIX_yy ...
void put(io::Series& table, const std::string& prefix, const std::string& unit, const std::string& long_name,
         const Mat3& tensor, int dimension);

/// Appends step, time, strains, stresses, p, q, principal values and directions, and void ratio of the cell.
void put_cell(io::Series& table, const io::Snapshot& state, bool tessellate);

/// Data of one state, one entry per grain.
struct Local {
  /// Sum of force (x) branch over each grain's contacts, N m.
  std::vector<Mat3> dyads;
  /// Power-cell volumes, m3 (2D: m2).
  std::vector<double> cell_volumes;
  /// Deformation gradients since the reference.
  std::vector<Mat3> deformation;
};
/// Computes the local data of `state`. `reference` may be `state` itself.
Local local(const io::Snapshot& reference, const io::Snapshot& state);
/// Appends step and time, the first columns of each table, `rows` times.
void put_step(io::Series& table, const io::Snapshot& state, std::size_t rows = 1);
/// Appends grains, centre, size, void ratio, stress, p, q, principal stresses and directions, and best-fit strain of a
/// volume.
void put_volume(io::Series& table, const io::Snapshot& reference, const io::Snapshot& state, double number,
                const Volume& volume, const Local& local);
/// Appends one row per grain: identity, position, part (with fill), cell volume, stress (if there is a cell), strain of
/// its tetrahedra.
void put_grains(io::Series& table, const io::Snapshot& state, const Local& local);

/// Appends one row: fabric tensors, anisotropies, coordination, stress-force-fabric relation, force chains.
void put_fabric(io::Series& table, const io::Snapshot& state);
/// Appends the coordination histogram of a state.
void put_histogram(io::Series& table, const io::Snapshot& state);
/// Appends the contact-orientation rose of a state.
void put_rose(io::Series& table, const io::Snapshot& state, std::size_t classes);
/// Appends one row per contact of a chain.
void put_chains(io::Series& table, const io::Snapshot& state);

/// Returns whether any column is NaN in all rows.
bool lacks_values(const io::Series& table);

/// Returns the columns listed in `names` (separated by commas), or all if empty. Throws UsageError for an unknown or
/// repeated column.
io::Series chosen_columns(const io::Series& table, const std::string& names);

}  // namespace soilweave::analysis
