// Reads and writes whole files as bytes. "-" is standard input or output. No reader meets a half-written file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace soilweave::io {

/// Returns all bytes of a file, or of standard input for "-". Throws MissingInput, DataError (a directory, a terminal),
/// IoError.
std::string read_bytes(const std::filesystem::path& path);

/// Writes a file under a temporary name in the same folder, syncs it and renames it. After a failure an existing file
/// is as it was; its permissions stay in any case. A link's target is replaced, not the link. Devices and pipes are
/// written in place; "-" is standard output. Throws CannotCreate, IoError.
void write_bytes(const std::filesystem::path& path, std::string_view bytes);

/// Writes a file into a folder that the program made for itself. Replaces whatever has the name, even a link.
void write_own_bytes(const std::filesystem::path& path, std::string_view bytes);

/// Makes a folder that survives a crash, unless it exists. Throws CannotCreate, also for a link to a folder.
void make_folder(const std::filesystem::path& path);

/// Returns how messages call a path: "standard input" for "-".
std::string input_name(const std::filesystem::path& path);

}  // namespace soilweave::io
