// Named numbers that a program needs to go on later. One list of items serves to keep them and to give them back.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/tensor.h"

namespace soilweave {

/// Named numbers, kept or given back. Each class lists its items once, in archive(), for both.
class Archive {
 public:
  /// Values by item name.
  using Numbers = std::map<std::string, std::vector<double>, std::less<>>;

  /// Makes an archive that keeps the items it is given.
  Archive() = default;
  /// Makes an archive that gives back kept numbers. `where`: what messages call their source.
  Archive(Numbers numbers, std::string where);

  /// Returns whether items are set to kept values instead of being kept.
  bool giving_back() const { return giving_back_; }
  /// Returns the numbers kept so far.
  const Numbers& numbers() const { return numbers_; }
  /// Packs the numbers as bytes for another process on an equal machine.
  static std::string packed(const Numbers& numbers);
  /// Unpacks bytes of packed().
  static Numbers unpacked(const std::string& bytes);

  /// Keeps the value or sets it to the kept one, bit for bit. Throws DataError if name or length differ.
  void item(const std::string& name, double& value);
  /// Keeps or sets an integer, exact below 2^53.
  void item(const std::string& name, std::int64_t& value);
  /// Keeps or sets a vector.
  void item(const std::string& name, Vec3& value);
  /// Keeps or sets a tensor.
  void item(const std::string& name, Mat3& value);
  /// Keeps or sets an array of any length.
  void item(const std::string& name, std::vector<double>& values);
  /// Keeps or sets `values` at their present length. Throws DataError if another length was kept.
  void sized(const std::string& name, std::vector<double>& values);
  /// Keeps or sets an integer or enumeration as a whole number.
  template <class Whole>
  void whole(const std::string& name, Whole& value) {
    auto number = static_cast<std::int64_t>(value);
    item(name, number);
    value = static_cast<Whole>(number);
  }

 private:
  // Keeps or sets `length` numbers from `values` on.
  void numbers_of(const std::string& name, double* values, std::size_t length);
  // Returns the kept numbers of an item. Throws DataError if there are none.
  const std::vector<double>& kept(const std::string& name) const;

  /// Numbers by name.
  Numbers numbers_;
  /// Source of the numbers, for messages.
  std::string where_;
  /// Whether items are set to kept values.
  bool giving_back_ = false;
};

}  // namespace soilweave
