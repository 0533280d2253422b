// Whole files as bytes: "-" is standard input or output, and a file that is written is never met half done.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace soilweave::io {

/// Everything in a file, or in standard input for "-". Throws MissingInput, DataError (a directory, a terminal),
/// IoError.
std::string read_bytes(const std::filesystem::path& path);

/// Writes under a temporary name in the same folder, syncs, renames, syncs the folder; an existing file stays as it was
/// until then, and after any failure, and its permissions stay. A link's target is made or replaced, not the link.
/// Devices and pipes are written in place; "-" is standard output. Throws CannotCreate, IoError.
void write_bytes(const std::filesystem::path& path, std::string_view bytes);

/// Writes likewise into a folder that the program made for itself: whatever has the name, a link too, is replaced, and
/// nothing is cleaned up.
void write_own_bytes(const std::filesystem::path& path, std::string_view bytes);

/// Makes a folder, so that it is still there after a crash; one that is there already is left as it is, a link to one
/// is refused. Throws CannotCreate.
void make_folder(const std::filesystem::path& path);

/// How messages call a path: "standard input" for "-".
std::string input_name(const std::filesystem::path& path);

}  // namespace soilweave::io
