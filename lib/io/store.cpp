// The only file that includes HDF5.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/store.h"

#include <hdf5.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/error.h"
#include "io/superblock.h"

namespace soilweave::io {
namespace {

/// An HDF5 identifier, closed by the function that fits its kind.
class Id {
 public:
  Id(hid_t id, herr_t (*close)(hid_t)) : id_(id), close_(close) {}
  Id(const Id&) = delete;
  Id& operator=(const Id&) = delete;
  ~Id() {
    if (id_ >= 0) close_(id_);
  }
  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  herr_t (*close_)(hid_t);
};

template <class T>
hid_t native() {
  if (std::is_same_v<T, double>) return H5T_NATIVE_DOUBLE;
  if (std::is_same_v<T, std::int64_t>) return H5T_NATIVE_INT64;
  if (std::is_same_v<T, std::uint64_t>) return H5T_NATIVE_UINT64;
  return std::is_same_v<T, std::int32_t> ? H5T_NATIVE_INT32 : H5T_NATIVE_UINT8;
}

Id string_type(std::size_t size) {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, size), H5Tset_cset(type, H5T_CSET_UTF8);
  return {type, H5Tclose};
}

Id space_of(const Shape& shape) {
  if (shape.empty()) return {H5Screate(H5S_SCALAR), H5Sclose};
  return {H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose};
}

void demand(bool good, const std::string& path) {
  if (!good) throw IoError(path + ": HDF5 could not add it to the file in memory; is there memory left?");
}

/// Chunks of about a megabyte: whole trailing dimensions as far as they fit, then a part of the next, then single rows.
Shape chunk_of(const Shape& shape) {
  Extent room = Extent{1} << 17;
  Shape chunk(shape.size(), 1);
  for (std::size_t d = shape.size(); d-- > 0 && room > 1;) {
    chunk[d] = std::min(shape[d], room);
    room /= std::max<Extent>(chunk[d], 1);
  }
  return chunk;
}

/// Small arrays lie in the object header, whose checksum covers them; large ones in chunks with checksums of their own.
Id creation(const Shape& shape, std::size_t element_size) {
  constexpr Extent compact_bytes = 4096;
  const hid_t list = H5Pcreate(H5P_DATASET_CREATE);
  H5Pset_obj_track_times(list, false);
  if (count(shape) * element_size <= compact_bytes) {
    H5Pset_layout(list, H5D_COMPACT);
    return {list, H5Pclose};
  }
  H5Pset_chunk(list, static_cast<int>(shape.size()), chunk_of(shape).data());
  H5Pset_shuffle(list);
  // The noise in the last digits of doubles does not compress: levels above 1 cost time and save next to nothing.
  H5Pset_deflate(list, 1);
  H5Pset_fletcher32(list);
  return {list, H5Pclose};
}

// HDF5 keeps the file in the caller's string, by these: H5Fget_file_image would copy it, and leaves the checksum of
// this format's superblock wrong (HDF5 1.10).
void* grow(void*, size_t size, H5FD_file_image_op_t, void* bytes) {
  try {
    static_cast<std::string*>(bytes)->resize(size);
  } catch (const std::exception&) {
    return nullptr;
  }
  return static_cast<std::string*>(bytes)->data();
}
void* start(size_t size, H5FD_file_image_op_t op, void* bytes) { return grow(nullptr, size, op, bytes); }
// A file opened for reading lies in its string from the start.
void* lend(size_t, H5FD_file_image_op_t, void* bytes) { return static_cast<std::string*>(bytes)->data(); }
void* already_there(void* to, const void*, size_t, H5FD_file_image_op_t, void*) { return to; }
herr_t keep(void*, H5FD_file_image_op_t, void*) { return 0; }
void* share(void* bytes) { return bytes; }
herr_t leave(void*) { return 0; }

Id in_memory(std::string& bytes, void* (*obtain)(size_t, H5FD_file_image_op_t, void*)) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // or HDF5 prints a stack of its own on every failure
  const hid_t access = H5Pcreate(H5P_FILE_ACCESS);
  H5Pset_fapl_core(access, std::size_t{1} << 22, false);
  H5FD_file_image_callbacks_t callbacks = {obtain, already_there, grow, keep, share, leave, &bytes};
  H5Pset_file_image_callbacks(access, &callbacks);
  return {access, H5Pclose};
}

/// HDF5 takes files in memory with equal names for one file: each gets a name that no other has while it is open.
std::string name_in_memory(const std::string& bytes) {
  return "at " + std::to_string(std::bit_cast<std::size_t>(&bytes));
}

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

void write_attribute(hid_t file, const std::string& path, const std::string& name, hid_t type, const Shape& shape,
                     const void* values) {
  const Id space = space_of(shape);
  const Id attribute(
      H5Acreate_by_name(file, path.c_str(), name.c_str(), type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
      H5Aclose);
  demand(attribute >= 0 && H5Awrite(attribute, type, values) >= 0, path + "@" + name);
}

}  // namespace

// ---- Writing --------------------------------------------------------------------------------------------------------

Writer::Writer() {
  file_ = create_in_memory(bytes_);
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

// ---- Reading --------------------------------------------------------------------------------------------------------

namespace {

/// A dataset, or an attribute of an object, with its space and type; negative identifiers where it is not there.
struct Opened {
  Opened(hid_t file, const std::string& path)
      : id(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose),
        space(id >= 0 ? H5Dget_space(id) : -1, H5Sclose),
        type(id >= 0 ? H5Dget_type(id) : -1, H5Tclose) {}
  Opened(hid_t file, const std::string& path, const std::string& name)
      : id(H5Aopen_by_name(file, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose),
        space(id >= 0 ? H5Aget_space(id) : -1, H5Sclose),
        type(id >= 0 ? H5Aget_type(id) : -1, H5Tclose) {}
  Id id, space, type;
};

Shape extents_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  Shape shape(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space, shape.data(), nullptr);
  return shape;
}

/// Strings of fixed or variable length; read(type, buffer) does the reading. most: bytes that can be there.
template <class Read>
bool read_texts(const Opened& object, std::size_t most, std::vector<std::string>& texts, const Read& read) {
  const hssize_t n = H5Sget_simple_extent_npoints(object.space);
  const std::size_t width = H5Tget_size(object.type);
  if (H5Tget_class(object.type) != H5T_STRING || n < 0 || width > most || static_cast<std::size_t>(n) > most / width)
    return false;
  texts.resize(static_cast<std::size_t>(n));
  if (H5Tis_variable_str(object.type) > 0) {
    std::vector<char*> pointers(texts.size());
    if (!read(object.type, pointers.data())) return false;
    for (std::size_t k = 0; k < texts.size(); ++k) texts[k] = pointers[k] ? pointers[k] : "";
    return H5Dvlen_reclaim(object.type, object.space, H5P_DEFAULT, pointers.data()) >= 0;
  }
  std::string buffer(width * texts.size(), '\0');
  if (!read(object.type, buffer.data())) return false;
  for (std::size_t k = 0; k < texts.size(); ++k)
    texts[k].assign(buffer.data() + k * width, strnlen(buffer.data() + k * width, width));
  return true;
}

}  // namespace

Reader::Reader(std::string bytes, std::string where) : bytes_(std::move(bytes)), where_(std::move(where)) {
  check_whole(bytes_, where_);
  file_ = open_in_memory(bytes_);
  if (file_ < 0) throw DataError(where_ + ": damaged: HDF5 cannot open it; copy or make the file again");
}

Reader::~Reader() {
  if (file_ >= 0) H5Fclose(file_);
}

void Reader::fail(const std::string& path, const std::string& what) const {
  throw DataError(where_ + ": " + path + " " + what);
}

bool Reader::has(const std::string& path) const {
  if (path == "/") return true;
  for (std::size_t slash = path.find('/', 1);; slash = path.find('/', slash + 1)) {
    if (H5Lexists(file_, path.substr(0, slash).c_str(), H5P_DEFAULT) <= 0) return false;
    if (slash == std::string::npos) return H5Oexists_by_name(file_, path.c_str(), H5P_DEFAULT) > 0;
  }
}

bool Reader::is_group(const std::string& path) const {
  if (!has(path)) return false;
  const Id object(H5Oopen(file_, path.c_str(), H5P_DEFAULT), H5Oclose);
  return object >= 0 && H5Iget_type(object) == H5I_GROUP;
}

std::vector<std::string> Reader::children(const std::string& path) const {
  std::vector<std::string> names;
  const Id group(has(path) ? H5Gopen2(file_, path.c_str(), H5P_DEFAULT) : -1, H5Gclose);
  if (group < 0) fail(path, "is missing or no group; make the file again");
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* list) -> herr_t {
    return static_cast<std::vector<std::string>*>(list)->push_back(name), 0;
  };
  // In a given order HDF5 1.10 would list the links first, and where one is damaged free what it has not listed.
  if (H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect, &names) < 0) fail(path, "is damaged");
  std::sort(names.begin(), names.end());
  return names;
}

Shape Reader::shape(const std::string& path) const {
  if (!has(path)) fail(path, "is missing; make the file again");
  const Opened dataset(file_, path);
  if (dataset.space < 0) fail(path, "is no dataset; make the file again");
  return extents_of(dataset.space);
}

bool Reader::is_integer(const std::string& path) const { return H5Tget_class(Opened(file_, path).type) == H5T_INTEGER; }

template <class T>
std::vector<T> Reader::read(const std::string& path, const Shape& expected) const {
  const Shape found = shape(path);
  if (found != expected) fail(path, "has the shape " + print(found) + " where " + print(expected) + " belongs");
  const Opened dataset(file_, path);
  if (H5Tget_class(dataset.type) != H5Tget_class(native<T>()) || H5Tget_size(dataset.type) > sizeof(T))
    fail(path, "holds another type of value than belongs there");
  // Deflate packs zeros about a thousandfold at best: what claims more never was in this file.
  constexpr Extent most_packed = 2048;
  const Extent n = count(found);
  if (n / most_packed > bytes_.size()) fail(path, "claims " + print(found) + " values, more than the file can hold");
  std::vector<T> values(n);
  if (n > 0 && H5Dread(dataset.id, native<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()) < 0)
    fail(path, "is damaged: a checksum or a length is wrong; copy or make the file again");
  return values;
}
template std::vector<double> Reader::read(const std::string&, const Shape&) const;
template std::vector<std::int64_t> Reader::read(const std::string&, const Shape&) const;
template std::vector<std::int32_t> Reader::read(const std::string&, const Shape&) const;
template std::vector<std::uint8_t> Reader::read(const std::string&, const Shape&) const;

std::string Reader::read_text(const std::string& path) const {
  if (!has(path)) fail(path, "is missing; make the file again");
  const Opened dataset(file_, path);
  std::vector<std::string> texts;
  const auto read = [&](hid_t memory, void* buffer) {
    return H5Dread(dataset.id, memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, buffer) >= 0;
  };
  if (!read_texts(dataset, bytes_.size(), texts, read) || texts.size() != 1) fail(path, "is no text");
  return texts.front();
}

bool Reader::has_attribute(const std::string& path, const std::string& name) const {
  return has(path) && H5Aexists_by_name(file_, path.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Reader::text_attributes(const std::string& path, const std::string& name) const {
  if (!has_attribute(path, name)) fail(path, "has no attribute " + name + "; make the file again");
  const Opened attribute(file_, path, name);
  std::vector<std::string> texts;
  const auto read = [&](hid_t memory, void* buffer) { return H5Aread(attribute.id, memory, buffer) >= 0; };
  if (!read_texts(attribute, bytes_.size(), texts, read)) fail(path, "has an attribute " + name + " that is no text");
  return texts;
}

std::string Reader::text_attribute(const std::string& path, const std::string& name) const {
  const std::vector<std::string> texts = text_attributes(path, name);
  if (texts.size() != 1) fail(path, "has an attribute " + name + " that is not one text");
  return texts.front();
}

template <class T>
std::vector<T> Reader::integers(const std::string& path, const std::string& name, const Shape& expected) const {
  if (!has_attribute(path, name)) fail(path, "has no attribute " + name + "; make the file again");
  const Opened attribute(file_, path, name);
  if (H5Tget_class(attribute.type) != H5T_INTEGER || extents_of(attribute.space) != expected)
    fail(path, "has an attribute " + name + " that is not " + print(expected) + " integer");
  std::vector<T> values(count(expected));
  if (H5Aread(attribute.id, native<T>(), values.data()) < 0) fail(path, "has a damaged attribute " + name);
  return values;
}
template std::vector<std::int64_t> Reader::integers(const std::string&, const std::string&, const Shape&) const;
template std::vector<std::uint64_t> Reader::integers(const std::string&, const std::string&, const Shape&) const;

}  // namespace soilweave::io
