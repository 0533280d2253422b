// Tables of gws-solve, in SI for files, in readable units for terminals.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "files/records.h"
#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Returns one row per state, SI. Strains count from the unloaded bag, `settlement` from the compacted one.
io::Series response_table(const std::vector<Point>& points, const Case& what);

/// Returns the main columns in kPa, kN/m and percent.
io::Series readable(const std::vector<Point>& points);

/// Describes the bag in a few lines.
std::string heading(const Case& what, const std::string& soil);
/// Describes the end of its response.
std::string verdict(const Response& response, const Case& what);

/// Throws TargetNotReached if the response ended before the requested surcharge.
void demand_reached(const Response& response, std::optional<double> surcharge);

/// Aligns a table for a terminal. The greatest number of each column has `digits` significant digits, with at most
/// three decimals.
std::string aligned(const io::Series& table, int digits = 5);

}  // namespace soilweave::gws
