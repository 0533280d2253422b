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
/// Reads a table. Cells may be quoted, with "" for a quote; no-break spaces are spaces. `where` names the document.
/// Throws DataError with line and column.
Series from_tsv(std::string_view text, const std::string& where);

/// Returns column `name`, converted to `unit`. A column without a unit holds pure numbers. Throws DataError if the
/// column is missing, or its unit is unknown, missing or of another quantity.
std::vector<double> in_unit(const Series& table, std::string_view name, std::string_view unit,
                            const std::string& where);

/// Returns the names of the columns for messages, "a, b, c"; the first ones and a count if there are many.
std::string column_names(const Series& table);

/// Returns the cells of one line without quotes and outer blanks. The separator ' ' stands for any number of blanks and
/// tabs.
std::vector<std::string> cells(std::string_view line, char separator);

/// Returns the separator of a header line: the first tab, semicolon or comma outside quotes; ' ' if there is none.
char separator_of(std::string_view header);

/// Returns "tabs", "commas", "semicolons" or "blanks".
std::string_view separator_name(char separator);

}  // namespace soilweave::io
