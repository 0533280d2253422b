// Front end of every text file: line ends, encodings, and refusal of other files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// Returns the text of a file: UTF-8 without a byte-order mark, each line ended by one line feed.
/// Accepts LF, CR LF and CR. `where` names the file and `role` its purpose ("grading") in messages.
/// Throws DataError for an empty file, other encodings, control characters and binary files.
std::string plain_text(std::string bytes, const std::string& where, std::string_view role);

/// Returns kind and remedy of a binary file ("a gzip file; unpack it with gunzip"), otherwise an empty text.
std::string binary_kind(std::string_view bytes);

}  // namespace soilweave
