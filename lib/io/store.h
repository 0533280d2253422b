// HDF5 behind two plain classes: build a file in memory, read one from memory. Others know HDF5 by these alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "io/schema.h"

namespace soilweave::io {

/// What every dataset says about itself.
struct Label {
  std::string units, long_name;
};

/// A file under construction, in memory. Equal calls give equal bytes: no time stamps, a fixed format (HDF5 1.10), and
/// every byte of structure and of numeric arrays under one of HDF5's own checksums. Parent groups are made as needed.
/// Throws IoError naming the object.
class Writer {
 public:
  Writer();
  ~Writer();
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  void group(const std::string& path);
  /// T: double, int64, int32, uint8. values.size() is the product of the shape.
  template <class T>
  void write(const std::string& path, std::span<const T> values, const Shape& shape, const Label& label);
  void write_text(const std::string& path, const std::string& text, const Label& label);

  void attribute(const std::string& path, const std::string& name, const std::string& text);
  void attribute(const std::string& path, const std::string& name, const std::vector<std::string>& texts);
  void attribute(const std::string& path, const std::string& name, const std::vector<std::int64_t>& values);
  /// T: double, int64, uint64.
  template <class T>
  void attribute(const std::string& path, const std::string& name, T value);
  /// A text, or a row of texts, of variable length: Python has them as str, where fixed lengths are bytes to it. They
  /// lie in a heap without a checksum: for what others read, and for words that our reader knows all of.
  void variable_text(const std::string& path, const std::string& name, const std::string& text);
  void variable_texts(const std::string& path, const std::string& name, const std::vector<std::string>& texts);

  /// A second name for an object (a hard link).
  void link(const std::string& target, const std::string& path);

  /// Ends the file and hands over its bytes.
  std::string image();

 private:
  void make_parents(const std::string& path);
  void describe(const std::string& path, const Label& label);
  std::string bytes_;
  std::int64_t file_ = -1;
};

/// A file read from its bytes. Every error is a DataError of one line: file, path within it, what is wrong. Nothing
/// outside the file is read: external links and storage and virtual datasets are refused, and so are values that were
/// never written, for which HDF5 would give zeros.
class Reader {
 public:
  /// where: what messages call the file. Rejects what is not HDF5, and truncated files.
  Reader(std::string bytes, std::string where);
  ~Reader();
  Reader(const Reader&) = delete;
  Reader& operator=(const Reader&) = delete;

  const std::string& where() const { return where_; }
  /// Throws DataError where the path leads out of the file (an external or user-defined link).
  bool has(const std::string& path) const;
  bool is_group(const std::string& path) const;
  /// Names in a group, sorted.
  std::vector<std::string> children(const std::string& path) const;

  Shape shape(const std::string& path) const;
  /// Whether a dataset holds integers.
  bool is_integer(const std::string& path) const;
  /// The whole array, row major. Rejects another shape, another class of type, wider integers.
  template <class T>
  std::vector<T> read(const std::string& path, const Shape& expected) const;
  std::string read_text(const std::string& path) const;

  bool has_attribute(const std::string& path, const std::string& name) const;
  std::string text_attribute(const std::string& path, const std::string& name) const;
  std::vector<std::string> text_attributes(const std::string& path, const std::string& name) const;
  /// Integer attributes; T: int64, uint64.
  template <class T>
  std::vector<T> integers(const std::string& path, const std::string& name, const Shape& expected) const;
  template <class T>
  T integer(const std::string& path, const std::string& name) const {
    return integers<T>(path, name, {}).front();
  }

  /// Counts bytes of memory that something in the file asks for; read() does it by itself. All together they are
  /// bounded by the bytes of the file, whatever it declares. Throws DataError beyond.
  void claim(const std::string& path, Extent bytes) const;

  /// Throws DataError: "FILE: PATH what".
  [[noreturn]] void fail(const std::string& path, const std::string& what) const;

 private:
  std::int64_t file_ = -1;
  std::string bytes_, where_;
  mutable Extent claimed_ = 0;
};

}  // namespace soilweave::io
