// HDF5 files in a string.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/hdf5_memory.h"

#include <bit>
#include <exception>

namespace soilweave::io::hdf5 {
namespace {

// These callbacks keep the file in the caller's string. H5Fget_file_image would copy it, and leaves a wrong checksum in
// this format's superblock (HDF5 1.10).
void* grow(void*, size_t size, H5FD_file_image_op_t, void* bytes) {
  try {
    static_cast<std::string*>(bytes)->resize(size);
  } catch (const std::exception&) {
    return nullptr;
  }
  return static_cast<std::string*>(bytes)->data();
}
void* start(size_t size, H5FD_file_image_op_t op, void* bytes) { return grow(nullptr, size, op, bytes); }
// For reading, the string holds the file already.
void* lend(size_t, H5FD_file_image_op_t, void* bytes) { return static_cast<std::string*>(bytes)->data(); }
void* already_there(void* to, const void*, size_t, H5FD_file_image_op_t, void*) { return to; }
herr_t keep(void*, H5FD_file_image_op_t, void*) { return 0; }
void* share(void* bytes) { return bytes; }
herr_t leave(void*) { return 0; }

Id in_memory(std::string& bytes, void* (*obtain)(size_t, H5FD_file_image_op_t, void*)) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // otherwise HDF5 prints a stack on every failure
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, std::size_t{1} << 22, false);
  H5FD_file_image_callbacks_t callbacks = {obtain, already_there, grow, keep, share, leave, &bytes};
  H5Pset_file_image_callbacks(access, &callbacks);
  return {access, H5Pclose};
}

/// Returns a name that no other open file has: HDF5 takes files in memory with equal names for one file.
std::string name_in_memory(const std::string& bytes) {
  return "at " + std::to_string(std::bit_cast<std::size_t>(&bytes));
}

}  // namespace

hid_t create_in_memory(std::string& bytes) {
  const Id access = in_memory(bytes, start);
  const Id create(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  H5Pset_libver_bounds(access, H5F_LIBVER_V110, H5F_LIBVER_V110);
  H5Pset_obj_track_times(create, false);
  return H5Fcreate(name_in_memory(bytes).c_str(), H5F_ACC_TRUNC, create, access);
}

hid_t open_in_memory(std::string& bytes) {
  const Id access = in_memory(bytes, lend);
  H5Pset_file_image(access, bytes.data(), bytes.size());
  return H5Fopen(name_in_memory(bytes).c_str(), H5F_ACC_RDONLY, access);
}

}  // namespace soilweave::io::hdf5
