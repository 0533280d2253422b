// Tables of homogenize and fabric, filled state by state and column by column.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/measure/volume_of_interest.h"
#include "files/files.h"

namespace soilweave::analysis {

/// Appends a value to the named column; makes a missing column.
void put(io::Series& table, const std::string& name, const std::string& unit, const std::string& long_name,
         double value);
/// Appends the components of a symmetric tensor to columns PREFIX_xx, PREFIX_yy ...
void put(io::Series& table, const std::string& prefix, const std::string& unit, const std::string& long_name,
         const Mat3& tensor, int dimension);

/// Appends step, time, strains, stresses, p, q, principal values and directions, and void ratio of the whole cell.
void put_cell(io::Series& table, const io::Snapshot& state, bool tessellate);

/// Data of one state for its volumes of interest and grains.
struct Local {
  std::vector<Mat3> dyads;           // N m, per grain
  std::vector<double> cell_volumes;  // m3 (2D: m2), per grain
  std::vector<Mat3> deformation;     // gradient since the reference, per grain
};
/// Computes the data. Strains count from `reference`, which may be `state` itself.
Local local(const io::Snapshot& reference, const io::Snapshot& state);
/// Appends step and time, the first columns of every table of several states.
void put_step(io::Series& table, const io::Snapshot& state);
/// Appends one volume of interest: number of grains, centre, volume, void ratio, stress, p, q, principal stresses and
/// their directions, best-fit strain.
void put_volume(io::Series& table, const io::Snapshot& reference, const io::Snapshot& state, double number,
                const Volume& volume, const Local& local);
/// Appends one row per grain: identity, position, part (with fill), power-cell volume, stress (none without a cell),
/// strain of the tetrahedra around it.
void put_grains(io::Series& table, const io::Snapshot& state, const Local& local);

/// Appends one row: fabric tensors, anisotropies, coordination, the stress-force-fabric relation, force chains.
void put_fabric(io::Series& table, const io::Snapshot& state);
/// Append the rows of one state to the coordination histogram and to the contact-orientation rose.
void put_histogram(io::Series& table, const io::Snapshot& state);
void put_rose(io::Series& table, const io::Snapshot& state, std::size_t classes);
/// Appends one row per contact of a force chain.
void put_chains(io::Series& table, const io::Snapshot& state);

/// Returns the columns that `names` lists, separated by commas, in that order; the whole table if empty. Throws
/// UsageError naming the nearest column, or a column listed twice.
io::Series chosen_columns(const io::Series& table, const std::string& names);

}  // namespace soilweave::analysis
