// HDF5 files in a string.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "store/hdf5_id.h"

namespace soilweave::io::hdf5 {

/// Creates a file that grows in the string; negative on failure. The string must outlive the file, unmoved.
hid_t create_in_memory(std::string& bytes);

/// Opens the string for reading; negative on failure. The string must outlive the file, unmoved.
hid_t open_in_memory(std::string& bytes);

}  // namespace soilweave::io::hdf5
