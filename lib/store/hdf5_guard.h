// Refuses HDF5 objects outside the file or larger than it can hold.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "store/hdf5_id.h"
#include "store/schema.h"

namespace soilweave::io::hdf5 {

/// Result of following a path within the file, link by link.
struct Way {
  /// Whether the path leads to an object.
  bool there = false;
  /// Reason why a link is not followed ("is a link to ..."); else empty.
  std::string refusal;
};
/// Follows a path.
Way way_to(hid_t file, const std::string& path);

/// Returns the reason not to read values (they are in other files, or their filter is missing); else an empty text.
/// Call it before H5Dget_space, which makes HDF5 open those other files.
std::string refusal(hid_t dataset);

/// Size of a dataset once unpacked.
struct Unpacked {
  /// Bytes, from shape and chunks.
  Extent bytes = 0;
  /// Description of missing values; empty if there are none.
  std::string gap;
};
/// Measures a dataset before it is read.
Unpacked unpacked(hid_t dataset, hid_t space, hid_t type);

}  // namespace soilweave::io::hdf5
