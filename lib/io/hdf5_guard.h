// Refuses HDF5 objects that lie outside the file, and more values than a file of its size can hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "io/hdf5_id.h"
#include "io/schema.h"

namespace soilweave::io::hdf5 {

/// Where a path leads, link by link; none is followed out of the file.
struct Way {
  bool there = false;
  std::string refusal;  // why a link on the way is not followed ("is a link to ..."); empty: none is refused
};
Way way_to(hid_t file, const std::string& path);

/// Why the values of a dataset may not be read ("keeps its values in ..."): they are in other files, or packed by a
/// filter that this HDF5 lacks. Empty: they may. To be asked before its dataspace, for which HDF5 opens other files.
std::string refusal(hid_t dataset);

/// How many bytes reading the values unpacks, by the dataset's shape and chunks; `gap` says what of them is not in the
/// file ("lacks 3 of its 5 chunks"), empty: nothing.
struct Unpacked {
  Extent bytes = 0;
  std::string gap;
};
Unpacked unpacked(hid_t dataset, hid_t space, hid_t type);

}  // namespace soilweave::io::hdf5
