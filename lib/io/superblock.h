// The first bytes of an HDF5 file: what it is and where it ends.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace soilweave::io {

/// Where the file says it ends (superblock versions 2 and 3, which Writer makes); 0 for other versions.
std::uint64_t stated_end(std::string_view bytes);

/// Throws DataError, naming `where`, unless the bytes begin an HDF5 file and reach to its end.
void check_whole(std::string_view bytes, const std::string& where);

}  // namespace soilweave::io
