// Every file kind as a table: path, type, shape, unit, meaning. Writers take units and names from it, readers shapes
// and types. FORMAT.md is its printed form.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace soilweave::io {

inline constexpr std::int64_t format_major = 1, format_minor = 3;

enum class Type { float64, int64, int32, uint8, text };

/// One dataset. Words in <> stand for names that vary. Shapes are letters and numbers, outermost dimension first: F
/// frames, N grains, D space dimension, M contacts of the frame, P planes, Y yarns, R rows of the table, K numbers;
/// empty: a scalar. A leading (F) marks an H5MD element: one dataset without F if all frames are equal, otherwise a
/// group with step, time and value, where value has F.
struct Entry {
  std::string_view path;
  Type type;
  std::string_view shape;
  std::string_view units;  // unit in H5MD's form: "kg m-3"; "1" for pure numbers
  std::string_view long_name;
  bool optional = false;
};

/// One attribute of a group or of the root.
struct AttributeEntry {
  std::string_view path, name, value;  // value: type or fixed text
  std::string_view meaning;
};

/// A part of a file: its file kinds and its entries.
struct Section {
  std::string_view title;
  std::string_view kinds;  // "packing run fields ensemble"
  std::vector<Entry> entries;
  std::vector<AttributeEntry> attributes;
};

/// Returns all parts of all file kinds.
const std::vector<Section>& schema();

/// Returns the entry of a path, written as in the table. Throws std::out_of_range, a defect.
const Entry& entry(std::string_view path);

/// Dimension of an array.
using Extent = unsigned long long;  // holds any hsize_t
using Shape = std::vector<Extent>;
/// Numbers for the letters of shapes in one file.
using Extents = std::map<char, Extent>;

/// Returns a shape in numbers. with_frames: whether a leading (F) counts. Throws std::out_of_range for an unknown
/// letter.
Shape resolve(std::string_view shape, const Extents& extents, bool with_frames = true);

/// Returns the product of the dimensions, or the greatest number on overflow.
Extent count(const Shape& shape);

/// Returns "3 x 100" or "a single value".
std::string print(const Shape& shape);

/// Returns "float64", ...
std::string_view name(Type type);

}  // namespace soilweave::io
