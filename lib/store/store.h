// HDF5 behind two plain classes: Writer builds a file in memory, Reader reads one from memory.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An HDF5 file is a tree: groups hold groups and arrays, and each may carry attributes. Writer makes a string of bytes
// from such a tree, and Reader reads it. File access is in bytes.h, the meaning of arrays in schema.h:
//
//   records of a packing or run  --schema-->  groups and arrays  --Writer-->  bytes  -->  file or pipe
//
// Equal content gives equal files, so that two runs can be compared by digest. Writer fixes what HDF5 leaves open: no
// times, one format version, chunk sizes by shape alone. Checksums show damage to structure and arrays.
//
// Reader trusts nothing: a file may be cut short, foreign or malicious. It refuses links that lead out of the file,
// sizes that the file cannot hold, and unexpected shapes and types:
//
//   Writer file;
//   file.write<double>("/particles/radius", radii, {radii.size()}, {"m", "radius of each grain"});
//   write_bytes("packing.h5", file.image());
//   const Reader again(read_bytes("packing.h5"), "packing.h5");
//   const std::vector<double> radius = again.read<double>("/particles/radius", {1000});
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "store/schema.h"

namespace soilweave::io {

/// Description of a dataset.
struct Label {
  std::string units, long_name;
};

/// A file under construction, in memory. Equal calls give equal bytes (HDF5 1.10). Parent groups are made as needed.
/// Throws IoError naming the object.
class Writer {
 public:
  /// Begins an empty file.
  Writer();
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  /// Makes a group.
  void group(const std::string& path);
  /// Writes an array. T: double, int64, int32, uint8. `values` must fill the shape.
  template <class T>
  void write(const std::string& path, std::span<const T> values, const Shape& shape, const Label& label);
  /// Writes a text as a dataset.
  void write_text(const std::string& path, const std::string& text, const Label& label);

  /// Writes a text as an attribute.
  void attribute(const std::string& path, const std::string& name, const std::string& text);
  /// Writes several texts.
  void attribute(const std::string& path, const std::string& name, const std::vector<std::string>& texts);
  /// Writes integers.
  void attribute(const std::string& path, const std::string& name, const std::vector<std::int64_t>& values);
  /// Writes a number. T: double, int64, uint64.
  template <class T>
  void attribute(const std::string& path, const std::string& name, T value);
  /// Writes a text of variable length, which Python reads as str. It has no checksum: use it only for other programs,
  /// or for words that are checked when read.
  void variable_text(const std::string& path, const std::string& name, const std::string& text);
  /// Writes several such texts.
  void variable_texts(const std::string& path, const std::string& name, const std::vector<std::string>& texts);

  /// Gives an object a second name (a hard link).
  void link(const std::string& target, const std::string& path);

  /// Ends the file and hands over its bytes.
  std::string image();

 private:
  void make_parents(const std::string& path);
  void describe(const std::string& path, const Label& label);
  std::string bytes_;
  std::int64_t file_ = -1;
};

/// A file read from its bytes. Errors are DataErrors: file, path, mistake. Refuses external links and storage, virtual
/// datasets and values never written.
class Reader {
 public:
  /// `where` names the file in messages. Throws DataError for other formats and truncated files.
  Reader(std::string bytes, std::string where);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  /// Returns the file's name for messages.
  const std::string& where() const { return where_; }
  /// Returns whether the path exists. Throws DataError if it leads out of the file.
  bool has(const std::string& path) const;
  /// Returns whether the path is a group.
  bool is_group(const std::string& path) const;
  /// Returns the names in a group, sorted.
  std::vector<std::string> children(const std::string& path) const;

  /// Returns the shape of a dataset.
  Shape shape(const std::string& path) const;
  /// Returns whether a dataset holds integers.
  bool is_integer(const std::string& path) const;
  /// Returns the whole array, row major. Throws DataError for another shape or class of type, and for wider integers.
  template <class T>
  std::vector<T> read(const std::string& path, const Shape& expected) const;
  /// Returns a text of fixed or variable length.
  std::string read_text(const std::string& path) const;

  /// Returns whether an object has an attribute.
  bool has_attribute(const std::string& path, const std::string& name) const;
  /// Returns a text attribute.
  std::string text_attribute(const std::string& path, const std::string& name) const;
  /// Returns an attribute of several texts.
  std::vector<std::string> text_attributes(const std::string& path, const std::string& name) const;
  /// Returns integer attributes. T: int64, uint64.
  template <class T>
  std::vector<T> integers(const std::string& path, const std::string& name, const Shape& expected) const;
  template <class T>
  T integer(const std::string& path, const std::string& name) const {
    return integers<T>(path, name, {}).front();
  }

  /// Adds the bytes of an object to the memory claimed so far. Throws DataError if the sum is more than this file can
  /// hold.
  void claim(const std::string& path, Extent bytes) const;

  /// Throws DataError: "FILE: PATH what".
  [[noreturn]] void fail(const std::string& path, const std::string& what) const;

 private:
  std::int64_t file_ = -1;
  std::string bytes_, where_;
  mutable Extent claimed_ = 0;
};

}  // namespace soilweave::io
