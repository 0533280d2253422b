// Files as lines of text, and bytes that are no text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/plain_text.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "support/same_state.h"

namespace soilweave {
namespace {

using namespace std::string_literals;

std::string read(const std::string& bytes) { return plain_text(bytes, "f.tsv", "grading"); }
void refuses(const std::string& bytes, const std::string& words) {
  io::test::expect_error<DataError>([&] { read(bytes); }, "f.tsv: " + words);
}

TEST(PlainText, EndsEveryLineByOneLineFeed) {
  EXPECT_EQ(read("a\nb\n"), "a\nb\n");
  EXPECT_EQ(read("a\r\nb\r\n"), "a\nb\n");
  EXPECT_EQ(read("a\rb\r"), "a\nb\n");
  EXPECT_EQ(read("a\r\nb\rc\nd"), "a\nb\nc\nd\n");
  EXPECT_EQ(read("a\r\r\nb"), "a\n\nb\n");
  EXPECT_EQ(read("\t\f\v1"), "\t\f\v1\n");
}

TEST(PlainText, SkipsAByteOrderMarkAndKeepsOtherLetters) {
  EXPECT_EQ(read("\xef\xbb\xbf"
                 "1 2"),
            "1 2\n");
  EXPECT_EQ(read("\u00b5m \u202f \U0001F600"), "\u00b5m \u202f \U0001F600\n");
}

TEST(PlainText, NamesWideCharactersWithTheWayToConvertThem) {
  refuses(
      "\xff\xfe"
      "1\0\n\0"s,
      "UTF-16 text; convert it to UTF-8: iconv -f UTF-16 -t UTF-8");
  refuses("\xfe\xff\0001\0\n"s, "UTF-16 text");
  refuses("\xff\xfe\0\0001\0\0\0"s, "UTF-32 text");
  refuses(
      "1\0 \0"
      "2\0\n\0"s,
      "UTF-16LE text");
  refuses("\0001\0 \0002\0\n"s, "UTF-16BE text");
  refuses("1\0\0\0 \0\0\0"s, "UTF-32LE text");
}

TEST(PlainText, NamesFilesOfOtherKinds) {
  refuses("\x89HDF\r\n\x1a\n\0"s, "an HDF5 file where a text belongs (the grading)");
  refuses("\x1f\x8b\x08\0\0"s, "a gzip file where a text belongs (the grading); unpack it with gunzip");
  refuses("PK\x03\x04\x14", "a ZIP archive, as Excel's .xlsx");
  refuses("%PDF-1.4\n", "a PDF where");
  refuses("\x89PNG\r\n\x1a\n", "a PNG picture");
  refuses("<!DOCTYPE HTML><p>404", "a web page (HTML) where");
  refuses("version https://git-lfs.github.com/spec/v1\noid sha256:0\n", "a Git LFS pointer");
  std::string stl = "solid of another program" + std::string(60, '\0') + std::string(50, '\x01');
  stl.replace(80, 4, "\x01\0\0\0"s);
  refuses(stl.substr(0, 84) + std::string(50, '\x01'), "a binary STL surface");
  EXPECT_EQ(binary_kind("$MeshFormat\n4.1 0 8\n"), "");
  EXPECT_NE(binary_kind("$MeshFormat\n4.1 1 8\n\x01\0\0\0"s), "");
}

TEST(PlainText, RefusesWhatStandsInNoText) {
  refuses("", "the file is empty (the grading)");
  refuses("\xef\xbb\xbf\r\n \t\n", "the file is empty");
  refuses("1 2\n3\0 4\n"s, "holds zero bytes");
  refuses("1\r\n2 \x1b[31m\n", "line 2, byte 3: the control character 0x1b");
  refuses("1\n\xb5m\n", "line 2, byte 1: 0xb5 is not UTF-8; convert the file, from Latin-1 by: iconv");
  refuses("\xe2\x82", "line 1, byte 1: 0xe2 is not UTF-8");
  refuses("\xed\xa0\x80", "line 1, byte 1: 0xed is not UTF-8");
  refuses("\xc0\x80", "line 1, byte 1: 0xc0 is not UTF-8");
}

}  // namespace
}  // namespace soilweave
