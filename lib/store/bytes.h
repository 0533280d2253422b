// Reads and writes whole files. "-" is standard input or output. Readers never meet half a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace soilweave::io {

/// Returns all bytes of a file or of standard input ("-"). Throws MissingInput, DataError (a directory, a terminal),
/// IoError.
std::string read_bytes(const std::filesystem::path& path);

/// Writes a temporary file in the same folder, syncs and renames it, and syncs the folder. After a failure the old file
/// is as it was. Permissions stay. A link's target is replaced; devices and pipes are written in place. Throws
/// CannotCreate, IoError.
void write_bytes(const std::filesystem::path& path, std::string_view bytes);

/// Writes a file into a folder that the program made. Replaces whatever has the name, even a link.
void write_own_bytes(const std::filesystem::path& path, std::string_view bytes);

/// Makes a folder durably unless it exists. Throws CannotCreate, also for a link to a folder.
void make_folder(const std::filesystem::path& path);

/// Returns the path, or "standard input" for "-", for messages.
std::string input_name(const std::filesystem::path& path);

}  // namespace soilweave::io
