// The one front end for every file that is read as text: what may stand before, between and behind its lines, and what
// it must not be.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave {

/// Returns the text in the bytes of a file: UTF-8 without a byte-order mark, every line ended by one line feed, the
/// last one too. Line ends may be LF, CR LF or CR, also mixed. `where` names the file in messages, `role` says what it
/// is to be ("grading", "scenario"). Throws DataError with a remedy where the bytes are no text: an empty file, UTF-16
/// or UTF-32, bytes that are not UTF-8, control characters, or a file of another kind (binary_kind).
std::string plain_text(std::string bytes, const std::string& where, std::string_view role);

/// Returns what the bytes are where their beginning tells that they are no text, with the remedy: "a gzip file; unpack
/// it with gunzip". Returns an empty string for bytes that may be text.
std::string binary_kind(std::string_view bytes);

}  // namespace soilweave
