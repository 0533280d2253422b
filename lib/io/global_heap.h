// The global heaps of an HDF5 file, where texts of variable length lie: the one structure that HDF5 1.10 neither checks
// nor bounds when it reads.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace soilweave::io {

/// True if a global heap in this image of a file holds objects that do not fill it one after the other (HDF5 File
/// Format Specification 3.0, section III.E). HDF5 would then copy from beyond the heap. Sizes of lengths are 8 bytes,
/// as in all files that current programs write.
bool has_broken_heap(std::string_view bytes);

}  // namespace soilweave::io
