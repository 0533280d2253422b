// Tab-separated tables: a header of "name [unit]" columns, then numbers; # lines are comments.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "io/records.h"

namespace soilweave::io {

/// The shortest text that reads back as the same number.
std::string exact(double value);
/// Header line and rows, numbers exact.
std::string to_tsv(const Series& series);
/// Throws DataError naming file, line and column of what cannot be read. `where` names the document.
Series from_tsv(std::string_view text, const std::string& where);

}  // namespace soilweave::io
