// Refuses HDF5 objects outside the file, and more values than a file of its size can hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "store/hdf5_id.h"
#include "store/schema.h"

namespace soilweave::io::hdf5 {

/// Result of following a path link by link. No link is followed out of the file.
struct Way {
  bool there = false;
  std::string refusal;  // reason why a link on the way is not followed ("is a link to ..."); empty: all were followed
};
/// Follows a path.
Way way_to(hid_t file, const std::string& path);

/// Returns why the values of a dataset may not be read: they are in other files, or this HDF5 lacks their filter. Empty
/// if they may. Call it before the dataspace is asked for, which makes HDF5 open other files.
std::string refusal(hid_t dataset);

/// Number of bytes that reading unpacks, from shape and chunks. `gap` tells which values are missing; empty: none.
struct Unpacked {
  Extent bytes = 0;
  std::string gap;
};
/// Measures a dataset before it is read.
Unpacked unpacked(hid_t dataset, hid_t space, hid_t type);

}  // namespace soilweave::io::hdf5
