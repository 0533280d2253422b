// Pages of the documentation with tables that the library prints.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <string>

#include "support/states.h"

namespace soilweave::test {

/// Demands that the page has `printed` between two marks. SOILWEAVE_GOLDEN=write (make golden) writes it there instead.
inline void demand_on_page(const std::filesystem::path& page, const std::string& begin_mark,
                           const std::string& end_mark, const std::string& printed) {
  if (!std::filesystem::exists(page)) GTEST_SKIP() << "not run in the root of the source tree";
  const std::string text = io::test::bytes_of(page);
  const std::size_t begin = text.find(begin_mark), end = text.find(end_mark);
  ASSERT_TRUE(begin != std::string::npos && end != std::string::npos && begin < end) << page << ": no marks";
  const std::string wanted = text.substr(0, begin + begin_mark.size()) + "\n" + printed + text.substr(end);
  const char* golden = std::getenv("SOILWEAVE_GOLDEN");
  if (golden && std::string(golden) == "write")
    io::test::put_bytes(page, wanted);
  else
    EXPECT_EQ(text, wanted) << "run: make golden, or correct what prints it";
}

}  // namespace soilweave::test
