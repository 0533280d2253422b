// HDF5 files that lie in a string.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "io/hdf5_id.h"

namespace soilweave::io::hdf5 {

/// A new file, which grows in the string; negative where HDF5 cannot make it. The string must outlive it in its place.
hid_t create_in_memory(std::string& bytes);

/// The file that the string is, to be read; negative where HDF5 cannot open it. The string must outlive it in its
/// place.
hid_t open_in_memory(std::string& bytes);

}  // namespace soilweave::io::hdf5
