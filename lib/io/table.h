// Tables as text: a header of "name [unit]" columns, then numbers; # lines are comments. Columns are separated by tabs,
// commas or semicolons, as the header is; what we write has tabs.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "io/records.h"

namespace soilweave::io {

/// The shortest text that reads back as the same number.
std::string exact(double value);
/// Header line and rows, separated by tabs, numbers exact.
std::string to_tsv(const Series& series);
/// Reads a table. Cells may be quoted, "" stands for a quote in them; no-break spaces are spaces. Throws DataError
/// naming file, line and column of what cannot be read, with the separator in use. `where` names the document.
Series from_tsv(std::string_view text, const std::string& where);

/// Returns the values of the column `name` in `unit`, converted from the column's own unit. A column without a unit
/// holds pure numbers. Throws DataError naming `where` and the column: there is no such column, its unit is unknown or
/// measures something else, or it has none and needs one.
std::vector<double> in_unit(const Series& table, std::string_view name, std::string_view unit,
                            const std::string& where);

/// Returns "a, b, c" for messages: the names of the columns, of many the first ones and how many more there are.
std::string column_names(const Series& table);

/// Returns the cells of one line, in whose quotes a separator stands for itself, without quotes and outer blanks. For
/// the separator ' ' cells are separated by any number of blanks and tabs.
std::vector<std::string> cells(std::string_view line, char separator);

/// Returns the separator of the header (or first) line of a table: a tab, semicolon or comma, the first of these that
/// it has outside of quotes; ' ' where it has none.
char separator_of(std::string_view header);

/// Returns "tabs", "commas", "semicolons" or "blanks".
std::string_view separator_name(char separator);

}  // namespace soilweave::io
