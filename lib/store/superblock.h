// First bytes of an HDF5 file: its signature and its stated end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace soilweave::io {

/// Returns the end of the file that its superblock states (versions 2 and 3; Writer makes these); 0 for other versions.
std::uint64_t stated_end(std::string_view bytes);

/// Throws DataError naming `where` unless the bytes begin an HDF5 file and reach to its stated end.
void check_whole(std::string_view bytes, const std::string& where);

}  // namespace soilweave::io
