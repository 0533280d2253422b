// Global heaps of HDF5 files, which hold texts of variable length. HDF5 1.10 does not check them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace soilweave::io {

/// Returns whether objects of a global heap do not fill it one after the other (HDF5 File Format Specification 3.0,
/// section III.E). HDF5 would then read beyond the heap. Sizes of lengths must be 8 bytes.
bool has_broken_heap(std::string_view bytes);

}  // namespace soilweave::io
