// What homogenize and fabric write: one row per state, column by column.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "analysis/volume_of_interest.h"
#include "io/files.h"

namespace soilweave::analysis {

/// Appends a value to the named column, which is made where it is missing.
void put(io::Series& table, const std::string& name, const std::string& unit, const std::string& long_name,
         double value);
/// The components of a symmetric tensor of the space as columns PREFIX_xx, PREFIX_yy ...
void put(io::Series& table, const std::string& prefix, const std::string& unit, const std::string& long_name,
         const Mat3& tensor, int dimension);

/// Step, time, strains, stresses, p, q, principal values and directions, void ratio, of the whole cell.
void put_cell(io::Series& table, const io::Snapshot& state, bool tessellate);

/// What is read off one state for its volumes of interest and grains.
struct Local {
  std::vector<Mat3> dyads;           // N m, per grain
  std::vector<double> cell_volumes;  // m3 (2D: m2), per grain
  std::vector<Mat3> deformation;     // gradient since the reference, per grain
};
/// `reference` is the state that strains count from; it may be `state` itself.
Local local(const io::Snapshot& reference, const io::Snapshot& state);
/// Step and time of the state, as every table of several states begins.
void put_step(io::Series& table, const io::Snapshot& state);
/// One volume of interest: number of grains, volume, void ratio, stress, p, q, strain by the best fit.
void put_volume(io::Series& table, const io::Snapshot& reference, const io::Snapshot& state, double number,
                const Volume& volume, const Local& local);
/// One row per grain: identity, position, its part where there is fill, power-cell volume, stress on it (none where it
/// has no cell), strain of the tetrahedra around it.
void put_grains(io::Series& table, const io::Snapshot& state, const Local& local);

/// One row per state: fabric tensors, anisotropies, coordination, the stress-force-fabric relation, force chains.
void put_fabric(io::Series& table, const io::Snapshot& state);
/// Rows for one state of the coordination histogram, and of the contact-orientation rose.
void put_histogram(io::Series& table, const io::Snapshot& state);
void put_rose(io::Series& table, const io::Snapshot& state, std::size_t classes);
/// One row per contact of a force chain.
void put_chains(io::Series& table, const io::Snapshot& state);

/// The columns that `names` lists, separated by commas, in that order; the whole table where it is empty. Throws
/// UsageError naming the nearest column, or the column that is listed twice.
io::Series chosen_columns(const io::Series& table, const std::string& names);

/// Whether the text can name states: all, first, last or a whole number.
bool names_states(const std::string& which);
/// The states it names (numbered from 0, or from the end where negative). Throws UsageError where there are not so
/// many.
std::vector<std::size_t> chosen_states(const std::string& which, std::size_t count, const std::string& where);

}  // namespace soilweave::analysis
