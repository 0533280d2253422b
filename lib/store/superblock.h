// Start of an HDF5 file: signature and stated end.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace soilweave::io {

/// Returns the end that the superblock states; 0 unless its version is 2 or 3.
std::uint64_t stated_end(std::string_view bytes);

/// Throws DataError naming `where` unless the bytes are HDF5 and reach the stated end.
void check_whole(std::string_view bytes, const std::string& where);

}  // namespace soilweave::io
