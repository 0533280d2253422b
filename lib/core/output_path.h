// Resolves an output's name and checks that a file can be made there, before the work begins.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace soilweave {

/// Returns the file that a name leads to, through links even if their target does not exist.
/// Throws CannotCreate for a cycle of links and for another user's link in a sticky folder.
std::filesystem::path followed(const std::filesystem::path& path);

/// Returns whether two names lead to one file (by device and inode), or will once it is made.
bool same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// Returns whether the name leads to a device, pipe or socket, which are written in place.
bool written_in_place(const std::filesystem::path& path);

/// Throws CannotCreate unless a file can be made or replaced at the name.
/// A link counts as its target. Devices and pipes must be writable.
void demand_place(const std::filesystem::path& path);

}  // namespace soilweave
