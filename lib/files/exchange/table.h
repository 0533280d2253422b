// Tables as text: a header of "name [unit]" columns, then numbers; # lines are comments. The header tells the
// separator: tabs, commas or semicolons. Written tables have tabs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "files/records.h"

namespace soilweave::io {

/// Returns the shortest text that reads back as the same number.
std::string exact(double value);
/// Returns header line and rows with tabs and exact numbers.
std::string to_tsv(const Series& series);
/// Reads a table. Cells may be quoted, with "" for a quote; no-break spaces are spaces. Throws DataError naming
/// `where`, line and column.
Series from_tsv(std::string_view text, const std::string& where);

/// Returns column `name`, converted to `unit`. Without a unit it holds pure numbers. Throws DataError if the column is
/// missing, or its unit is unknown, missing or of another quantity.
std::vector<double> in_unit(const Series& table, std::string_view name, std::string_view unit,
                            const std::string& where);

/// Returns the names of other columns that hold `name`, in any case, and could be meant for it: mean_diameter,
/// Diameter.
std::vector<std::string> columns_like(const Series& table, std::string_view name);
/// Throws DataError if there is such a column.
void demand_one(const Series& table, std::string_view name, const std::string& where);

/// Returns "a, b, c" for messages; the first names and a count if there are many.
std::string column_names(const Series& table);

/// Returns a line's cells without quotes and outer blanks. The separator ' ' means any blanks and tabs.
std::vector<std::string> cells(std::string_view line, char separator);

/// Returns the separator of a header line: the first tab, semicolon or comma outside quotes; ' ' if there is none.
char separator_of(std::string_view header);

/// Returns "tabs", "commas", "semicolons" or "blanks".
std::string_view separator_name(char separator);

}  // namespace soilweave::io
