// State of a program as named numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/archive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.h"

namespace soilweave {
namespace {

constexpr const char* remedy = "it was changed, or is of another version: give --force without --resume to begin anew";
constexpr double most_exact = 9007199254740992.0;  // 2^53: every whole number up to here is a double

}  // namespace

Archive::Archive(Numbers numbers, std::string where)
    : numbers_(std::move(numbers)), where_(std::move(where)), giving_back_(true) {}

const std::vector<double>& Archive::kept(const std::string& name) const {
  const auto found = numbers_.find(name);
  if (found == numbers_.end()) throw DataError(fmt::format("{}: keeps no {}; {}", where_, name, remedy));
  if (std::any_of(found->second.begin(), found->second.end(), [](double x) { return std::isnan(x); }))
    throw DataError(fmt::format("{}: keeps a {} that is not a number; {}", where_, name, remedy));
  return found->second;
}

void Archive::numbers_of(const std::string& name, double* values, std::size_t length) {
  if (!giving_back_) {
    numbers_[name].assign(values, values + length);
    return;
  }
  const std::vector<double>& from = kept(name);
  if (from.size() != length)
    throw DataError(
        fmt::format("{}: keeps {} numbers of {} where {} belong; {}", where_, from.size(), name, length, remedy));
  std::copy(from.begin(), from.end(), values);
}

std::string Archive::packed(const Numbers& numbers) {
  std::string bytes;
  const auto put = [&bytes](const void* from, std::size_t size) { bytes.append(static_cast<const char*>(from), size); };
  for (const auto& [name, values] : numbers) {
    for (const std::size_t size : {name.size(), values.size()}) put(&size, sizeof size);
    put(name.data(), name.size());
    put(values.data(), values.size() * sizeof(double));
  }
  return bytes;
}

Archive::Numbers Archive::unpacked(const std::string& bytes) {
  Numbers numbers;
  for (std::size_t at = 0; at < bytes.size();) {
    const auto take = [&](void* to, std::size_t size) { at += bytes.copy(static_cast<char*>(to), size, at); };
    std::size_t length = 0, size = 0;
    take(&length, sizeof length), take(&size, sizeof size);
    std::string name(length, '\0');
    take(name.data(), length);
    std::vector<double> values(size);
    take(values.data(), size * sizeof(double));
    numbers.emplace(std::move(name), std::move(values));
  }
  return numbers;
}

void Archive::item(const std::string& name, double& value) { numbers_of(name, &value, 1); }

void Archive::item(const std::string& name, std::int64_t& value) {
  auto number = static_cast<double>(value);
  numbers_of(name, &number, 1);
  if (number != std::nearbyint(number) || std::abs(number) > most_exact)
    throw DataError(fmt::format("{}: keeps a {} of {}, which is no whole number; {}", where_, name, number, remedy));
  value = static_cast<std::int64_t>(number);
}

void Archive::item(const std::string& name, Vec3& value) { numbers_of(name, value.data(), 3); }
void Archive::item(const std::string& name, Mat3& value) { numbers_of(name, value.data(), 9); }

void Archive::item(const std::string& name, std::vector<double>& values) {
  if (giving_back_)
    values = kept(name);
  else
    numbers_[name] = values;
}

void Archive::sized(const std::string& name, std::vector<double>& values) {
  numbers_of(name, values.data(), values.size());
}

}  // namespace soilweave
