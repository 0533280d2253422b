// Builds a file in memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include "core/error.h"
#include "store/hdf5_memory.h"
#include "store/store.h"
#include "store/superblock.h"

namespace soilweave::io {
namespace {

using hdf5::Id;
using hdf5::native;

Id string_type(std::size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, size);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose};
}

Id space_of(const Shape& shape) {
  if (shape.empty()) return {H5Screate(H5S_SCALAR), H5Sclose};
  return {H5Screate_simple(static_cast<int>(shape.size()), hdf5::extents(shape).data(), nullptr), H5Sclose};
}

void demand(bool good, const std::string& path) {
  if (!good) throw IoError(path + ": HDF5 could not add it to the file in memory; is there memory left?");
}

/// Returns chunks of about a megabyte: whole trailing dimensions as far as they fit, then part of the next one, then
/// single rows.
Shape chunk_of(const Shape& shape) {
  Extent room = Extent{1} << 17;
  Shape chunk(shape.size(), 1);
  for (std::size_t d = shape.size(); d-- > 0 && room > 1;) {
    chunk[d] = std::min(shape[d], room);
    room /= std::max<Extent>(chunk[d], 1);
  }
  return chunk;
}

/// Returns the storage of an array. Small arrays lie in the object header, whose checksum covers them. Large ones lie
/// in chunks with checksums of their own.
Id creation(const Shape& shape, std::size_t element_size) {
  constexpr Extent compact_bytes = 4096;
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(list, false);
  if (count(shape) * element_size <= compact_bytes) {
    H5Pset_layout(list, H5D_COMPACT);
    return {list, H5Pclose};
  }
  H5Pset_chunk(list, static_cast<int>(shape.size()), hdf5::extents(chunk_of(shape)).data());
  H5Pset_shuffle(list);
  // The last digits of doubles are noise and do not compress: levels above 1 cost time and save almost nothing.
  H5Pset_deflate(list, 1);
  H5Pset_fletcher32(list);
  return {list, H5Pclose};
}

void write_attribute(hid_t file, const std::string& path, const std::string& name, hid_t type, const Shape& shape,
                     const void* values) {
  const Id space = space_of(shape);
  const Id attribute(
      H5Acreate_by_name(file, path.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  demand(attribute >= 0 && H5Awrite(attribute, type, values) >= 0, path + "@" + name);
}

}  // namespace

Writer::Writer() {
  file_ = hdf5::create_in_memory(bytes_);
  demand(file_ >= 0, "/");
}

Writer::~Writer() {
  if (file_ >= 0) H5Fclose(file_);
}

void Writer::make_parents(const std::string& path) {
  for (std::size_t slash = path.find('/', 1); slash != std::string::npos; slash = path.find('/', slash + 1))
    group(path.substr(0, slash));
}

void Writer::group(const std::string& path) {
  if (path == "/") return;
  make_parents(path);
  if (H5Lexists(file_, path.c_str(), H5P_DEFAULT) > 0) return;
  const Id list(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_obj_track_times(list, false);
  const Id made(H5Gcreate2(file_, path.c_str(), H5P_DEFAULT, list, H5P_DEFAULT), H5Gclose);
  demand(made >= 0, path);
}

void Writer::describe(const std::string& path, const Label& label) {
  attribute(path, "units", label.units);
  attribute(path, "long_name", label.long_name);
}

template <class T>
void Writer::write(const std::string& path, std::span<const T> values, const Shape& shape, const Label& label) {
  make_parents(path);
  demand(values.size() == count(shape), path);
  const Id space = space_of(shape);
  const Id list = creation(shape, sizeof(T));
  const Id dataset(H5Dcreate2(file_, path.c_str(), native<T>(), space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose);
  demand(dataset >= 0, path);
  if (!values.empty()) demand(H5Dwrite(dataset, native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) >= 0, path);
  describe(path, label);
}
template void Writer::write(const std::string&, std::span<const double>, const Shape&, const Label&);
template void Writer::write(const std::string&, std::span<const std::int64_t>, const Shape&, const Label&);
template void Writer::write(const std::string&, std::span<const std::int32_t>, const Shape&, const Label&);
template void Writer::write(const std::string&, std::span<const std::uint8_t>, const Shape&, const Label&);

void Writer::write_text(const std::string& path, const std::string& text, const Label& label) {
  make_parents(path);
  // An object header holds at most 64 KiB.
  constexpr std::size_t compact_bytes = 32768;
  const Id type = string_type(text.size() + 1);
  const Id space = space_of({});
  const Id list(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
  H5Pset_obj_track_times(list, false);
  H5Pset_layout(list, text.size() < compact_bytes ? H5D_COMPACT : H5D_CONTIGUOUS);
  const Id dataset(H5Dcreate2(file_, path.c_str(), type, space, H5P_DEFAULT, list, H5P_DEFAULT), H5Dclose);
  demand(dataset >= 0 && H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, text.c_str()) >= 0, path);
  describe(path, label);
}

void Writer::attribute(const std::string& path, const std::string& name, const std::string& text) {
  write_attribute(file_, path, name, string_type(text.size() + 1), {}, text.c_str());
}

void Writer::attribute(const std::string& path, const std::string& name, const std::vector<std::string>& texts) {
  std::size_t width = 1;
  for (const std::string& text : texts) width = std::max(width, text.size() + 1);
  std::string padded(width * texts.size(), '\0');
  for (std::size_t k = 0; k < texts.size(); ++k) texts[k].copy(padded.data() + k * width, width);
  write_attribute(file_, path, name, string_type(width), {texts.size()}, padded.data());
}

void Writer::attribute(const std::string& path, const std::string& name, const std::vector<std::int64_t>& values) {
  write_attribute(file_, path, name, H5T_NATIVE_INT64, {values.size()}, values.data());
}

void Writer::variable_text(const std::string& path, const std::string& name, const std::string& text) {
  const char* const words = text.c_str();
  write_attribute(file_, path, name, string_type(H5T_VARIABLE), {}, &words);
}

void Writer::variable_texts(const std::string& path, const std::string& name, const std::vector<std::string>& texts) {
  std::vector<const char*> words;
  for (const std::string& text : texts) words.push_back(text.c_str());
  write_attribute(file_, path, name, string_type(H5T_VARIABLE), {texts.size()}, words.data());
}

template <class T>
void Writer::attribute(const std::string& path, const std::string& name, T value) {
  write_attribute(file_, path, name, native<T>(), {}, &value);
}
template void Writer::attribute(const std::string&, const std::string&, std::int64_t);
template void Writer::attribute(const std::string&, const std::string&, std::uint64_t);
template void Writer::attribute(const std::string&, const std::string&, double);

void Writer::link(const std::string& target, const std::string& path) {
  make_parents(path);
  demand(H5Lcreate_hard(file_, target.c_str(), file_, path.c_str(), H5P_DEFAULT, H5P_DEFAULT) >= 0, path);
}

std::string Writer::image() {
  demand(H5Fclose(std::exchange(file_, -1)) >= 0, "/");
  bytes_.resize(stated_end(bytes_));
  return std::move(bytes_);
}

}  // namespace soilweave::io
