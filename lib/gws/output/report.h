// Reports of gws-solve on identification, design and sensitivity.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/files.h"
#include "gws/design/design.h"
#include "gws/design/sensitivity.h"
#include "gws/identification/identify.h"

namespace soilweave::gws {

/// Assumptions and limits of the model, with their source.
inline constexpr std::string_view assumptions =
    "The elastoplastic solution of H. Cheng's dissertation (Hiroshima University, 2016, section 5.3) for a cuboid of "
    "soil wrapped in a geotextile, under vertical pressure and, if asked, lateral stress. It assumes principal "
    "stresses along the axes, uniform in the soil (no friction at the fabric, no corners); q/p and dilatancy on lines "
    "identified by discrete-element analysis of Toyoura sand, unique for all geotextiles; one elastic tension in all "
    "hoops; and, empirically, Young's modulus as a power of the geotextile's stiffness. It knows no unloading, no "
    "creep, no tilting or stacking of bags. Failure is counted at half the strength; loads there lie 20-25 % above "
    "those of the thesis's discrete elements, and 0-15 % above those of full-size bags simulated since, with like "
    "settlements. They lie 9-30 % above those of full-size cells under 10 to 100 kPa, which settle by up to 8 % of the "
    "height less. Before failure the solution is softer: at 5 % of settlement it bears 0.89-0.97 of the bags' loads, "
    "and 0.34-0.84 of the cells'. Beyond 53 to 1160 kN/m and 100 kPa of lateral stress it is untested.";

/// Returns one row: each constant (NAME), its 95 % interval (NAME_low, NAME_high) and start (NAME_given).
io::Series constants_table(const Identification& found);
/// Returns one row per point: series (from 0), row, x, y, fitted, residual, studentized residual, outlier.
io::Series line_table(const Line& line);
/// Returns one row per increment of each series (thesis Fig. 5.13).
io::Series increments_table(const Identification& found);
/// Returns the names of all tables of groups_of().
std::vector<std::string> table_names();
/// Returns all tables as groups of a fields file.
std::vector<io::FieldsFile::Group> groups_of(const Identification& found);
/// Describes lines, constants, intervals, changes, outliers, and missing lines.
std::string describe(const Identification& found, const std::vector<BagSeries>& series, Method method);
/// Returns the identified soil as TOML, with command, rows and runs in its comment. Its name says whose the others are.
std::string identified_soil(const Identification& found, const std::vector<BagSeries>& series, Method method,
                            const std::string& command);

/// Describe an answer in a paragraph.
std::string describe(const Design& design, const Demand& demand, const Case& bag);
std::string describe(const Allowance& allowance, double settlement, double safety, const Case& bag);
/// Return tables in SI. Strengths are before reduction. Long-term strengths are divided by `reduction`.
io::Series design_table(const Design& design, double reduction);
io::Series allowance_table(const Allowance& allowance);
io::Series chart_table(const std::vector<ChartRow>& rows, double reduction);
/// Returns the chart in kPa, kN/m and percent.
io::Series readable(const std::vector<ChartRow>& rows, double reduction);

/// Returns one row per constant, numbered in the order of describe().
io::Series sensitivity_table(const std::vector<Sensitivity>& rows);
/// Describe sensitivities and bands in paragraphs.
std::string describe(const std::vector<Sensitivity>& rows);
io::Series bands_table(const Bands& bands);
/// Returns the main columns in kPa and percent.
io::Series readable(const Bands& bands);
std::string describe(const Bands& bands);

}  // namespace soilweave::gws
