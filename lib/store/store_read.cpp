// Reads a file from memory.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstring>
#include <utility>

#include "core/error.h"
#include "store/global_heap.h"
#include "store/hdf5_guard.h"
#include "store/hdf5_memory.h"
#include "store/store.h"
#include "store/superblock.h"

namespace soilweave::io {
namespace {

using hdf5::Id;
using hdf5::native;

/// A dataset, or an attribute of an object, with its space and type. Identifiers are negative if it does not exist, or
/// if `refusal` says why it is not read.
struct Opened {
  Opened(hid_t file, const std::string& path)
      : id(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose),
        refusal(id >= 0 ? hdf5::refusal(id) : ""),
        space(id >= 0 && refusal.empty() ? H5Dget_space(id) : -1, H5Sclose),
        type(id >= 0 && refusal.empty() ? H5Dget_type(id) : -1, H5Tclose) {}
  Opened(hid_t file, const std::string& path, const std::string& name)
      : id(H5Aopen_by_name(file, path.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose),
        space(id >= 0 ? H5Aget_space(id) : -1, H5Sclose),
        type(id >= 0 ? H5Aget_type(id) : -1, H5Tclose) {}
  Id id;
  std::string refusal;
  Id space, type;
};

Shape extents_of(hid_t space) {
  const int rank = H5Sget_simple_extent_ndims(space);
  std::vector<hsize_t> extents(static_cast<std::size_t>(std::max(rank, 0)));
  if (rank > 0) H5Sget_simple_extent_dims(space, extents.data(), nullptr);
  return Shape(extents.begin(), extents.end());
}

/// Reads strings of fixed or variable length by read(type, buffer). most: largest number of bytes. Variable strings are
/// limited in number too, since all can refer to the same bytes.
template <class Read>
bool read_texts(const Opened& object, std::size_t most, std::vector<std::string>& texts, const Read& read) {
  constexpr hssize_t most_variable = 16;
  const hssize_t n = H5Sget_simple_extent_npoints(object.space);
  const std::size_t width = H5Tget_size(object.type);
  if (H5Tget_class(object.type) != H5T_STRING || n < 0 || width > most || static_cast<std::size_t>(n) > most / width)
    return false;
  const bool variable = H5Tis_variable_str(object.type) > 0;
  if (variable && n > most_variable) return false;
  texts.resize(static_cast<std::size_t>(n));
  if (variable) {
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
  if (has_broken_heap(bytes_))
    throw DataError(where_ +
                    ": damaged: its texts of variable length run over their place; copy or make the file again");
  file_ = hdf5::open_in_memory(bytes_);
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
  const hdf5::Way way = hdf5::way_to(file_, path);
  if (!way.refusal.empty()) throw DataError(where_ + ": " + way.refusal);
  return way.there;
}

void Reader::claim(const std::string& path, Extent bytes) const {
  // Largest plausible compression. Packings compress less: a lattice of equal grains at rest to about a hundredth.
  constexpr Extent packed = 256, free = Extent{256} << 20;
  const Extent most = free + packed * bytes_.size();
  claimed_ = bytes > most - std::min(claimed_, most) ? most + 1 : claimed_ + bytes;
  if (claimed_ > most)
    fail(path, "claims " + std::to_string(bytes) + " bytes of values, more than a file of " +
                   std::to_string(bytes_.size()) + " bytes can hold; make the file again");
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
    static_cast<std::vector<std::string>*>(list)->push_back(name);
    return 0;
  };
  // The native order is safe. For any other, HDF5 1.10 lists the links first, and at a damaged link frees entries that
  // it never set.
  if (H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, nullptr, collect, &names) < 0) fail(path, "is damaged");
  std::sort(names.begin(), names.end());
  return names;
}

Shape Reader::shape(const std::string& path) const {
  if (!has(path)) fail(path, "is missing; make the file again");
  const Opened dataset(file_, path);
  if (!dataset.refusal.empty()) fail(path, dataset.refusal);
  if (dataset.space < 0) fail(path, "is no dataset; make the file again");
  return extents_of(dataset.space);
}

bool Reader::is_integer(const std::string& path) const { return H5Tget_class(Opened(file_, path).type) == H5T_INTEGER; }

template <class T>
std::vector<T> Reader::read(const std::string& path, const Shape& expected) const {
  if (!has(path)) fail(path, "is missing; make the file again");
  const Opened dataset(file_, path);
  if (!dataset.refusal.empty()) fail(path, dataset.refusal);
  if (dataset.space < 0) fail(path, "is no dataset; make the file again");
  const Shape found = extents_of(dataset.space);
  if (found != expected) fail(path, "has the shape " + print(found) + " where " + print(expected) + " belongs");
  if (H5Tget_class(dataset.type) != H5Tget_class(native<T>()) || H5Tget_size(dataset.type) > sizeof(T))
    fail(path, "holds another type of value than belongs there");
  const hdf5::Unpacked unpacked = hdf5::unpacked(dataset.id, dataset.space, dataset.type);
  claim(path, std::max<Extent>(unpacked.bytes, count(Shape{count(found), sizeof(T)})));
  if (!unpacked.gap.empty()) fail(path, unpacked.gap + "; make the file again");
  const Extent n = count(found);
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
  if (!dataset.refusal.empty()) fail(path, dataset.refusal);
  std::vector<std::string> texts;
  if (dataset.space >= 0) {
    const hdf5::Unpacked unpacked = hdf5::unpacked(dataset.id, dataset.space, dataset.type);
    claim(path, unpacked.bytes);
    if (!unpacked.gap.empty()) fail(path, unpacked.gap + "; make the file again");
  }
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
