// What gws-solve writes: tables in SI for files and pipes, and the same for a reader's eyes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gws/respond.h"
#include "io/records.h"

namespace soilweave::gws {

/// One row per state, SI, strains as fractions, counted from the unloaded bag; `settlement` from the compacted one.
io::Series response_table(const std::vector<Point>& points, const Case& what);

/// The main columns in kPa, kN/m and percent.
io::Series readable(const std::vector<Point>& points);

/// What the bag is, and how the response ends, in a few lines.
/// chosen: false where the soil is the default; the first line then says so.
std::string heading(const Case& what, const std::string& soil, bool chosen);
std::string verdict(const Response& response, const Case& what);

/// Throws TargetNotReached where the response ended before the surcharge asked for.
void demand_reached(const Response& response, std::optional<double> surcharge);

/// Aligned columns for a terminal: names, units, then numbers; each column has the decimals that leave its
/// greatest number `digits` significant digits, three at most.
std::string aligned(const io::Series& table, int digits = 5);

}  // namespace soilweave::gws
