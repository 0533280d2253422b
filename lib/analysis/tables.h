// What homogenize and fabric write: one row per state, column by column.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/stress.h"
#include "io/files.h"

namespace soilweave::analysis {

/// Appends a value to the named column, which is made where it is missing.
void put(io::Series& table, const std::string& name, const std::string& unit, const std::string& long_name, double value);
/// The components of a symmetric tensor of the space as columns PREFIX_xx, PREFIX_yy ...
void put(io::Series& table, const std::string& prefix, const std::string& unit, const std::string& long_name,
         const Mat3& tensor, int dimension);

/// Step, time, strains, stresses, p, q, principal values and directions, void ratio, of the whole cell.
void put_cell(io::Series& table, const io::Snapshot& state, bool tessellate);
/// One volume of interest: number of grains, volume, void ratio, stress, p, q.
void put_volume(io::Series& table, const io::Snapshot& state, double number, const Volume& volume,
                const std::vector<Mat3>& dyads, const std::vector<double>& cell_volumes);
/// One row per grain: identity, position, power-cell volume, stress on it.
void put_grains(io::Series& table, const io::Snapshot& state, const std::vector<Mat3>& dyads,
                const std::vector<double>& cell_volumes);
/// One row per state: fabric tensors, anisotropies, coordination, the stress-force-fabric relation, force chains.
void put_fabric(io::Series& table, const io::Snapshot& state);
/// Rows for one state of the coordination histogram, and of the contact-orientation rose.
void put_histogram(io::Series& table, const io::Snapshot& state);
void put_rose(io::Series& table, const io::Snapshot& state, std::size_t classes);

/// The states meant by "all", "first", "last" or a number (0-based; negative from the end). Throws DataError.
std::vector<std::size_t> chosen_states(const std::string& which, std::size_t count, const std::string& where);

}  // namespace soilweave::analysis
