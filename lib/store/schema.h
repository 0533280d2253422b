// Table of all file kinds: path, type, shape, unit, meaning. FORMAT.md is its printed form.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soilweave::io {

/// Version of the format.
inline constexpr std::int64_t format_major = 1, format_minor = 3;

/// Types of numbers and texts in files.
enum class Type { float64, int64, int32, uint8, text };

/// One dataset.
struct Entry {
  /// Words in <> stand for names that vary.
  std::string_view path;
  Type type;
  /// Letters and numbers, outermost dimension first: F frames, N grains, D space dimension, M contacts of the frame, P
  /// planes, Y yarns, R rows of the table, K numbers; empty: a scalar. (F) marks an H5MD element: a dataset without F
  /// if all frames are equal, else a group with step, time and value.
  std::string_view shape;
  /// Unit in H5MD's form: "kg m-3"; "1" for pure numbers.
  std::string_view units;
  std::string_view long_name;
  bool optional = false;
};

/// An attribute of a group or of the root.
struct AttributeEntry {
  /// `value` is a type or fixed text.
  std::string_view path, name, value;
  std::string_view meaning;
};

/// A part of a file.
struct Section {
  std::string_view title;
  /// File kinds that have it: "packing run fields ensemble".
  std::string_view kinds;
  std::vector<Entry> entries;
  std::vector<AttributeEntry> attributes;
};

/// Returns all parts of all file kinds.
const std::vector<Section>& schema();

/// Returns the entry with this path, spelled as in the table. An unknown path is a defect: std::out_of_range.
const Entry& entry(std::string_view path);

/// Dimension of an array; holds any hsize_t.
using Extent = unsigned long long;
/// Dimensions of an array, outermost first.
using Shape = std::vector<Extent>;
/// Numbers for letters of shapes in one file.
using Extents = std::map<char, Extent>;

/// Returns a shape in numbers; `with_frames` counts a leading (F). Throws std::out_of_range for an unknown letter.
Shape resolve(std::string_view shape, const Extents& extents, bool with_frames = true);

/// Returns the product of dimensions, or the greatest number on overflow.
Extent count(const Shape& shape);

/// Returns "3 x 100" or "a single value".
std::string print(const Shape& shape);

/// Returns "float64", ...
std::string_view name(Type type);

}  // namespace soilweave::io
