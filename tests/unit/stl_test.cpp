// Surfaces from STL files, binary and text, whole and truncated; memory is checked before it is taken.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <string>

#include "core/error.h"
#include "core/memory.h"
#include "files/exchange/triangles.h"
#include "support/same_state.h"

namespace soilweave::io {
namespace {

// A tetrahedron, three corners a row.
constexpr std::array<std::array<float, 3>, 4> corners = {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.1F}}};
constexpr std::array<std::array<int, 3>, 4> faces = {{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};

std::string binary(const std::string& header) {
  std::string bytes = header;
  bytes.resize(80, ' ');
  const auto put = [&](const auto& value) {
    std::array<char, sizeof value> raw;
    std::memcpy(raw.data(), &value, sizeof value);
    bytes.append(raw.data(), raw.size());
  };
  put(std::uint32_t{4});
  for (const auto& face : faces) {
    put(std::array<float, 3>{});
    for (const int corner : face) put(corners[static_cast<std::size_t>(corner)]);
    put(std::uint16_t{0});
  }
  return bytes;
}

std::string text() {
  std::string all = "solid a tetrahedron\n";
  for (const auto& face : faces) {
    all += "facet normal nan nan nan\n  outer loop\n";
    for (const int c : face) {
      const auto& x = corners[static_cast<std::size_t>(c)];
      all += fmt::format("    vertex {} {} {}\n", x[0], x[1], static_cast<double>(x[2]));
    }
    all += "  endloop\nendfacet\n";
  }
  return all + "endsolid a tetrahedron\n";
}

void expect_tetrahedron(const TriangleSoup& soup) {
  ASSERT_EQ(soup.points.size(), 4U);
  EXPECT_EQ(soup.triangles.size(), 4U);
  EXPECT_EQ(soup.points[1], Vec3(0, 1, 0)) << "in the order in which they come";
  EXPECT_NEAR(soup.points[3].z(), 0.1, 1e-8);
}

std::string replaced(std::string in, const std::string& from, const std::string& to) {
  return in.replace(in.find(from), from.size(), to);
}

TEST(Stl, IsReadAsTextAndBinary) {
  expect_tetrahedron(read_stl(text(), "x.stl"));
  expect_tetrahedron(read_stl(binary("made by a program"), "x.stl"));
  expect_tetrahedron(read_stl(binary("solid, as many programs write in binary files"), "x.stl"));
  std::string windows = "\xEF\xBB\xBF";
  for (const char c : text()) windows += c == '\n' ? "\r\n" : std::string(1, c);
  expect_tetrahedron(read_stl(windows, "x.stl"));
  std::string capitals = text();
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  expect_tetrahedron(read_stl(capitals, "x.stl"));
  EXPECT_EQ(read_stl(text() + text(), "x.stl").triangles.size(), 8U) << "two solids";
}

TEST(Stl, WhatIsNoneIsRefusedWithItsLineOrLength) {
  const auto refused = [](const std::string& bytes, const std::string& words) {
    test::expect_error<DataError>([&] { read_stl(bytes, "x.stl"); }, words);
  };
  const std::string whole = binary("solid");
  refused(whole.substr(0, whole.size() - 7), "counts 4 triangles, which take 284 bytes, but it has 277");
  refused(whole + "more", "but it has 288");
  refused(std::string("\0\1\2", 3), "x.stl");
  std::string not_finite = whole;
  std::memcpy(not_finite.data() + 96, "\0\0\xC0\x7F", 4);
  refused(not_finite, "the corner 1 of triangle 1 is at nan");
  refused("hello\n", "x.stl: is no surface");
  refused("", "x.stl");
  const std::string good = text();
  refused(good.substr(0, good.find("endsolid")), "endsolid is missing");
  refused(good.substr(0, good.find("endloop")), "ends where endloop belongs: the file is cut short");
  refused(replaced(good, "0.1", "0,1"), "where a finite number belongs; write decimal points");
  refused(replaced(good, "vertex 1", "vertex x1"), "x.stl:6: the surface has \"x1\"");
}

TEST(Memory, MoreThanIsAtHandIsNamed) {
  EXPECT_EQ(lack_of_memory(1), "");
  EXPECT_GT(memory_at_hand(), 1e8);
  test::expect_error<DataError>([] { demand_memory(1e15, "1e12 grains", "give fewer"); },
                                "1e12 grains take about 1 PB of memory, and ");
  EXPECT_EQ(bytes_text(999.7e6), "1 GB");
  EXPECT_EQ(bytes_text(1500), "1.5 kB");
}

}  // namespace
}  // namespace soilweave::io
