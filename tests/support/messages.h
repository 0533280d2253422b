// The messages of errors, and the numbers that they name.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <string>

namespace soilweave::test {

/// Returns the message of the error of this type that `work` throws; "" without one.
template <class Error, class Work>
std::string message_of(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

/// Returns the number after these words of a message.
inline double number_after(const std::string& words, const std::string& message) {
  const std::size_t at = message.find(words);
  EXPECT_NE(at, std::string::npos) << message;
  return at == std::string::npos ? 0 : std::strtod(message.c_str() + at + words.size(), nullptr);
}

}  // namespace soilweave::test
