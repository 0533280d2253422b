// State of a program as named numbers, to save it and to restore it. One list of items serves both.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/tensor.h"

namespace soilweave {

/// Named numbers to save or to restore. Each class lists its items once, in archive(), for both directions.
class Archive {
 public:
  /// Values by item name.
  using Numbers = std::map<std::string, std::vector<double>, std::less<>>;

  /// Makes an archive that saves items.
  Archive() = default;
  /// Makes an archive that restores items from saved numbers. `where`: name of their source in messages.
  Archive(Numbers numbers, std::string where);

  /// Returns whether the archive restores items; otherwise it saves them.
  bool giving_back() const { return giving_back_; }
  /// Returns the numbers saved so far.
  const Numbers& numbers() const { return numbers_; }
  /// Packs the numbers as bytes for another process on an equal machine.
  static std::string packed(const Numbers& numbers);
  /// Unpacks bytes of packed().
  static Numbers unpacked(const std::string& bytes);

  /// Saves or restores a number, bit for bit. Throws DataError if the name is missing or the length differs.
  void item(const std::string& name, double& value);
  /// Saves or restores an integer, exact below 2^53.
  void item(const std::string& name, std::int64_t& value);
  /// Saves or restores a vector.
  void item(const std::string& name, Vec3& value);
  /// Saves or restores a tensor.
  void item(const std::string& name, Mat3& value);
  /// Saves or restores an array of any length.
  void item(const std::string& name, std::vector<double>& values);
  /// Saves or restores `values` at their present length. Throws DataError if another length was saved.
  void sized(const std::string& name, std::vector<double>& values);
  /// Saves or restores an integer or enumeration as a whole number.
  template <class Whole>
  void whole(const std::string& name, Whole& value) {
    auto number = static_cast<std::int64_t>(value);
    item(name, number);
    value = static_cast<Whole>(number);
  }

 private:
  // Saves or restores `length` numbers from `values` on.
  void numbers_of(const std::string& name, double* values, std::size_t length);
  // Returns the saved numbers of an item. Throws DataError if there are none.
  const std::vector<double>& kept(const std::string& name) const;

  /// Numbers by name.
  Numbers numbers_;
  /// Source of the numbers, for messages.
  std::string where_;
  /// Whether items are restored.
  bool giving_back_ = false;
};

}  // namespace soilweave
