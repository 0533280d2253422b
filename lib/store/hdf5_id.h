// HDF5 identifiers that close themselves, and HDF5's types. Only this file includes HDF5.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <hdf5.h>

#include <cstdint>
#include <type_traits>
#include <vector>

#include "store/schema.h"

namespace soilweave::io::hdf5 {

/// An HDF5 identifier, closed by the function for its kind.
class Id {
 public:
  /// Takes an identifier and the function that closes it.
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  ~Id() {
    if (id_ >= 0) close_(id_);
  }
  /// Returns the identifier; negative if HDF5 failed.
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

/// Returns HDF5's type of a number. T: double, int64, uint64, int32, uint8.
template <class T>
hid_t native() {
  if (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
  return std::is_same_v<T, std::int32_t> ? H5T_NATIVE_INT32 : H5T_NATIVE_UINT8;
}

/// Returns the extents in HDF5's type, which depends on its version.
inline std::vector<hsize_t> extents(const Shape& shape) { return {shape.begin(), shape.end()}; }

}  // namespace soilweave::io::hdf5
