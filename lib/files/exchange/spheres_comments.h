// Comments in a text of spheres: columns and units that they state are obeyed or refused, never passed over.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "files/exchange/spheres_columns.h"

namespace soilweave::io {

/// Comments of one text of spheres, in the order of its lines.
class SpheresComments {
 public:
  /// `where`: name of the text, for messages.
  explicit SpheresComments(std::string where) : where_(std::move(where)) {}

  /// Takes a comment above the first grain. Throws DataError if it gives a periodic cell in another spelling than
  /// ##PERIODIC::, unless the caller gives the cell.
  void add(std::size_t line, std::string_view text, bool cell_is_given);
  /// Throws DataError if a comment below the first grain names columns again, or another unit than that of `columns`.
  void below(std::size_t line, std::string_view text, const SphereColumns& columns) const;

  /// Returns the columns that the last fitting comment names for lines of `width` columns; nothing if no comment names
  /// columns. Throws DataError if none fits. `dimension`: 3 if disks are excluded.
  std::optional<SphereColumns> columns(std::size_t width, std::optional<int> dimension) const;
  /// Takes the unit that comments give. Throws DataError if a comment contradicts the columns.
  void heed(SphereColumns& columns) const;

 private:
  struct Comment {
    std::size_t line = 0;
    /// Columns, as in "# x y z r".
    std::optional<SphereColumns> columns;
    /// Reason why the comment is not understood, although it names x, y and a size.
    std::string unclear;
    /// Whether it seems to name as many columns, or speaks of positions and diameters.
    std::size_t seems_to_name = 0;
    bool of_diameters = false;
    /// Unit of length, as in "# units: mm"; empty if there is none, or columns have it.
    std::string unit;
    /// Why the unit is unknown; empty if it is known.
    std::string unknown_unit;
    /// Whether the unit may belong to something else, because other words surround it, as in "# resolution in mm".
    bool unit_is_vague = false;

    bool names_columns() const { return columns || !unclear.empty(); }
  };
  static Comment read(std::size_t line, std::string_view text);
  void heed_unit(const Comment& comment, SphereColumns& columns) const;
  [[noreturn]] void fail(const Comment& comment, const std::string& what) const;

  std::string where_;
  std::vector<Comment> comments_;
};

/// Returns whether a comment was probably meant to be a line ##PERIODIC::, in another spelling, or gives the lengths of
/// a cell.
bool is_like_a_cell(std::string_view comment);

}  // namespace soilweave::io
