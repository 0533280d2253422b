// Front end of every text file: accepted line ends and encodings, and refusal of what is no text.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// Returns the text of a file: UTF-8 without a byte-order mark, each line ended by one line feed. Line ends may be LF,
/// CR LF or CR, also mixed. `where` names the file and `role` its purpose ("grading", "scenario") in messages. Throws
/// DataError with a remedy for an empty file, UTF-16 or UTF-32, bytes that are not UTF-8, control characters, and files
/// of another kind (binary_kind).
std::string plain_text(std::string bytes, const std::string& where, std::string_view role);

/// Returns the kind and the remedy if the first bytes tell that a file is no text: "a gzip file; unpack it with
/// gunzip". Returns an empty text otherwise.
std::string binary_kind(std::string_view bytes);

}  // namespace soilweave
