// Where an output's name leads, and whether a file can be made there: asked before the work, obeyed after it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace soilweave {

/// Returns the file that a name leads to. A link is followed whether or not its target is there, so that a file written
/// to the result is the one that the link names. Throws CannotCreate for links that lead to themselves, and for a link
/// that another user put into a folder of all users (sticky, as /tmp), which the kernel would not follow either.
std::filesystem::path followed(const std::filesystem::path& path);

/// Whether two names lead to one file (by device and inode), or will, once it is made.
bool same_file(const std::filesystem::path& one, const std::filesystem::path& other);

/// Whether the name leads to something that is written in place: a device, a pipe, a socket.
bool written_in_place(const std::filesystem::path& path);

/// Throws CannotCreate unless a file can be made or replaced at the name: its folder (a link's: that of the target) is
/// there and may be written to, the name is not too long, no directory is in the way, and a file that is there may be
/// replaced. Devices and pipes need to be writable themselves.
void demand_place(const std::filesystem::path& path);

}  // namespace soilweave
