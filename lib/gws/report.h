// What gws-solve tells of identification, design and sensitivity: tables in SI, and paragraphs for a reader.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gws/design.h"
#include "gws/identify.h"
#include "gws/sensitivity.h"
#include "io/files.h"

namespace soilweave::gws {

/// What the model assumes and where it ends, with its source.
inline constexpr std::string_view assumptions =
    "The elastoplastic solution of H. Cheng's dissertation (Hiroshima University, 2016, section 5.3) for a cuboid of "
    "soil wrapped in a geotextile, under vertical pressure and, if asked, lateral stress. It assumes principal "
    "stresses along the axes, uniform in the soil (no friction at the fabric, no corners); q/p and dilatancy on lines "
    "identified by discrete-element analysis of Toyoura sand, unique for all geotextiles; one elastic tension in all "
    "hoops; and, empirically, Young's modulus as a power of the geotextile's stiffness. It knows no unloading, no "
    "creep, no tilting or stacking of bags. Failure is counted at half the strength; loads there lie 20-25 % above "
    "the discrete elements' own, settlements agree. Beyond 53 to 1160 kN/m and 100 kPa of lateral stress it is "
    "untested; a lateral stress makes its beginning too soft.";

/// One row: each constant with the ends of its interval of 95 % and the value identification started from (NAME,
/// NAME_low, NAME_high, NAME_given).
io::Series constants_table(const Identification& found);
/// One row per point: series (number from 0; as many as there are: a table of its own), row, x, y, fitted, residual,
/// studentized residual, and whether it is an outlier.
io::Series line_table(const Line& line);
/// One row per increment of each series (thesis Fig. 5.13).
io::Series increments_table(const Identification& found);
/// The names of what groups_of() can give.
std::vector<std::string> table_names();
/// Adds a mistake if there is no such table.
void check_table(const std::string& name, std::vector<std::string>& mistakes);
/// All of them as groups of a fields file.
std::vector<io::FieldsFile::Group> groups_of(const Identification& found);
/// Lines, constants, intervals, differences from what was given, outliers, and what was left out.
std::string describe(const Identification& found, const std::vector<BagSeries>& series);
/// The identified soil as TOML, whose comment says by which command, and which rows of which runs.
std::string identified_soil(const Identification& found, const std::vector<BagSeries>& series,
                            const std::string& command);

std::string describe(const Design& design, const Demand& demand, const Case& bag);
std::string describe(const Allowance& allowance, double settlement, double safety, const Case& bag);
io::Series design_table(const Design& design);
io::Series allowance_table(const Allowance& allowance);
io::Series chart_table(const std::vector<ChartRow>& rows);
/// The same in kPa, kN/m and percent.
io::Series readable(const std::vector<ChartRow>& rows);

/// One row per constant, in the order of describe(); `constant` is its number.
io::Series sensitivity_table(const std::vector<Sensitivity>& rows);
std::string describe(const std::vector<Sensitivity>& rows);
io::Series bands_table(const Bands& bands);
/// The main columns in kPa and percent.
io::Series readable(const Bands& bands);
std::string describe(const Bands& bands);

}  // namespace soilweave::gws
