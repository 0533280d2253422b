// HDF5 in memory: written data are read back, and missing or unfit data are reported by path.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/store.h"

#include <gtest/gtest.h>

#include <cstring>

#include "core/error.h"
#include "store/superblock.h"
#include "support/same_state.h"

namespace soilweave::io {
namespace {

using test::expect_error;

std::string example_image(std::size_t rows = 20000) {
  Writer file;
  std::vector<double> numbers(3 * rows);
  for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = 1.0 / static_cast<double>(k + 1);
  file.write<double>("/a/b/numbers", numbers, {rows, 3}, {"m", "numbers"});
  file.write<std::int64_t>("/a/whole", std::vector<std::int64_t>{-1, std::int64_t{1} << 62}, {2}, {"1", "whole"});
  file.write<std::int32_t>("/a/none", {}, {0, 3}, {"1", "none"});
  file.write<std::uint8_t>("/a/flag", std::vector<std::uint8_t>{1}, {}, {"1", "flag"});
  file.write_text("/text", "a line\nµ\n", {"1", "text"});
  file.write_text("/long", std::string(100000, 'x'), {"1", "text"});
  file.write_text("/nothing", "", {"1", "text"});
  file.attribute("/a", "words", std::vector<std::string>{"one", "", "three"});
  file.attribute("/a", "empty", std::string());
  file.attribute("/a", "large", ~std::uint64_t{0});
  file.attribute("/a", "pair", std::vector<std::int64_t>{1, -2});
  file.link("/a/whole", "/other/name");
  return file.image();
}

TEST(Store, GivesBackWhatItWasGiven) {
  const Reader file(example_image(), "file");
  const std::vector<double> numbers = file.read<double>("/a/b/numbers", {20000, 3});
  for (std::size_t k = 0; k < numbers.size(); ++k) ASSERT_EQ(numbers[k], 1.0 / static_cast<double>(k + 1));
  EXPECT_EQ(file.read<std::int64_t>("/a/whole", {2}), (std::vector<std::int64_t>{-1, std::int64_t{1} << 62}));
  EXPECT_EQ(file.read<std::int64_t>("/other/name", {2}).front(), -1);
  EXPECT_TRUE(file.read<std::int32_t>("/a/none", {0, 3}).empty());
  EXPECT_EQ(file.read<std::uint8_t>("/a/flag", {}), std::vector<std::uint8_t>{1});
  EXPECT_EQ(file.read_text("/text"), "a line\nµ\n");
  EXPECT_EQ(file.read_text("/long"), std::string(100000, 'x'));
  EXPECT_EQ(file.read_text("/nothing"), "");
  EXPECT_EQ(file.text_attributes("/a", "words"), (std::vector<std::string>{"one", "", "three"}));
  EXPECT_EQ(file.text_attribute("/a", "empty"), "");
  EXPECT_EQ(file.integer<std::uint64_t>("/a", "large"), ~std::uint64_t{0});
  EXPECT_EQ(file.integers<std::int64_t>("/a", "pair", {2}), (std::vector<std::int64_t>{1, -2}));
  EXPECT_EQ(file.text_attribute("/a/b/numbers", "units"), "m");
  EXPECT_EQ(file.text_attribute("/a/b/numbers", "long_name"), "numbers");
}

TEST(Store, TellsGroupsNamesAndTypes) {
  const Reader file(example_image(), "file");
  EXPECT_TRUE(file.is_group("/a/b"));
  EXPECT_FALSE(file.is_group("/a/whole"));
  EXPECT_FALSE(file.has("/a/b/c/d"));
  EXPECT_TRUE(file.has("/"));
  EXPECT_EQ(file.children("/a"), (std::vector<std::string>{"b", "flag", "none", "whole"}));
  EXPECT_TRUE(file.is_integer("/a/flag"));
  EXPECT_FALSE(file.is_integer("/a/b/numbers"));
}

TEST(Store, KeepsFilesApartThatAreOpenTogether) {
  Writer one, two;
  one.write_text("/text", "one", {"1", "text"});
  two.write_text("/text", "two", {"1", "text"});
  const Reader first(one.image(), "first"), second(two.image(), "second");
  EXPECT_EQ(first.read_text("/text"), "one");
  EXPECT_EQ(second.read_text("/text"), "two");
}

TEST(Store, SameCallsGiveTheSameBytes) { EXPECT_EQ(example_image(), example_image()); }

TEST(Store, LargeArraysArePackedAndSmallOnesLieInTheHeader) {
  Writer zeros;
  zeros.write<double>("/zeros", std::vector<double>(1000000), {1000000}, {"1", "zeros"});
  EXPECT_LT(zeros.image().size(), 100000U);
}

TEST(Store, TellsWhatDoesNotFit) {
  const Reader file(example_image(), "file.h5");
  expect_error<DataError>([&] { file.read<double>("/a/c", {1}); }, "file.h5: /a/c is missing");
  expect_error<DataError>([&] { file.read<double>("/a", {1}); }, "file.h5: /a is no dataset");
  expect_error<DataError>(
      [&] {
        file.read<double>("/a/b/numbers", {20000, 2});
      },
      "/a/b/numbers has the shape 20000 x 3 where 20000 x 2 belongs");
  expect_error<DataError>([&] { file.read<double>("/a/whole", {2}); }, "/a/whole holds another type of value");
  expect_error<DataError>([&] { file.read<std::int32_t>("/a/whole", {2}); }, "another type of value");
  expect_error<DataError>([&] { file.read<double>("/text", {}); }, "another type of value");
  expect_error<DataError>([&] { file.read_text("/a/whole"); }, "/a/whole is no text");
  expect_error<DataError>([&] { file.text_attribute("/a", "pair"); }, "/a has an attribute pair that is no text");
  expect_error<DataError>([&] { file.text_attribute("/a", "words"); }, "attribute words that is not one text");
  expect_error<DataError>([&] { file.integer<std::int64_t>("/a", "pair"); }, "attribute pair that is not");
  expect_error<DataError>([&] { file.integer<std::int64_t>("/a", "none"); }, "/a has no attribute none");
  expect_error<DataError>([&] { file.children("/text"); }, "/text is missing or no group");
  expect_error<IoError>([] { Writer().write<double>("/x", std::vector<double>(3), {2}, {"1", "x"}); }, "/x: HDF5");
}

TEST(Store, SuperblockTellsWhereTheFileEnds) {
  const std::string image = example_image();
  EXPECT_EQ(stated_end(image), image.size());
  expect_error<DataError>(
      [&] { Reader(image.substr(0, image.size() - 1), "file.h5"); },
      "file.h5: truncated: " + std::to_string(image.size() - 1) + " bytes of " + std::to_string(image.size()));
  expect_error<DataError>([&] { Reader("\x89HDF", "file.h5"); }, "file.h5: truncated: 4 bytes of more");
  expect_error<DataError>([&] { Reader(std::string(5000, ' '), "file.h5"); }, "file.h5: not an HDF5 file");
  // HDF5 ignores bytes after its end, so a copy padded by a tape or a transfer still reads.
  EXPECT_EQ(Reader(image + std::string(100, '\0'), "file.h5").read_text("/nothing"), "");
}

TEST(Store, ChunksNoticeAFlippedBit) {
  std::string image = example_image();
  // The middle of the file holds nothing but packed numbers.
  image[image.size() / 2] = static_cast<char>(image[image.size() / 2] ^ 1);
  const Reader file(image, "file.h5");
  expect_error<DataError>([&] { file.read<double>("/a/b/numbers", {20000, 3}); }, "/a/b/numbers is damaged");
}

}  // namespace
}  // namespace soilweave::io
