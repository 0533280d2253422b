// Named numbers that a program needs to go on later. One list of items serves for keeping and for giving back, so that
// the two cannot drift apart.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/tensor.h"

namespace soilweave {

class Archive {
 public:
  using Numbers = std::map<std::string, std::vector<double>, std::less<>>;

  /// Keeps what it is shown.
  Archive() = default;
  /// Gives back what was kept. where: what messages call the place it comes from.
  Archive(Numbers numbers, std::string where);

  bool giving_back() const { return giving_back_; }
  const Numbers& numbers() const { return numbers_; }
  /// Numbers as bytes for another process on an equal machine, and back.
  static std::string packed(const Numbers& numbers);
  static Numbers unpacked(const std::string& bytes);

  // Keeps the value, or sets it to the one kept, bit for bit. Throws DataError where none of the name and length is.
  void item(const std::string& name, double& value);
  void item(const std::string& name, std::int64_t& value);  // exact below 2^53
  void item(const std::string& name, Vec3& value);
  void item(const std::string& name, Mat3& value);
  void item(const std::string& name, std::vector<double>& values);  // of any length
  /// Likewise, of the length that `values` has already. Throws DataError where another length was kept.
  void sized(const std::string& name, std::vector<double>& values);
  template <class Whole>
  void whole(const std::string& name, Whole& value) {
    auto number = static_cast<std::int64_t>(value);
    item(name, number);
    value = static_cast<Whole>(number);
  }

 private:
  void numbers_of(const std::string& name, double* values, std::size_t length);
  const std::vector<double>& kept(const std::string& name) const;

  Numbers numbers_;
  std::string where_;
  bool giving_back_ = false;
};

}  // namespace soilweave
