// Turns bytes of a file into lines of text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/plain_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>

#include "core/error.h"

namespace soilweave {
namespace {

using namespace std::string_view_literals;

struct Kind {
  std::string_view begins;  // first bytes of the file
  std::string_view name;    // kind of file, with the remedy
  bool also_as_text;        // true: the file may be text, but is still refused
};

constexpr std::array kinds{
    Kind{"\x89HDF"sv, "an HDF5 file", true},
    Kind{"\x1f\x8b"sv, "a gzip file; unpack it with gunzip", true},
    Kind{"BZh"sv, "a bzip2 file; unpack it with bunzip2", false},
    Kind{"\xfd\x37zXZ"sv, "an xz file; unpack it with unxz", true},
    Kind{"\x28\xb5\x2f\xfd"sv, "a Zstandard file; unpack it with unzstd", true},
    Kind{"7z\xbc\xaf\x27\x1c"sv, "a 7z archive; unpack it with 7z x", true},
    Kind{"PK\x03\x04"sv, "a ZIP archive, as Excel's .xlsx and LibreOffice's .ods are; save the sheet as text (CSV)",
         true},
    Kind{"PK\x05\x06"sv, "an empty ZIP archive", true},
    Kind{"\xd0\xcf\x11\xe0"sv, "a document of Excel or Word of old; save it as text (CSV)", true},
    Kind{"%PDF"sv, "a PDF; copy the numbers into a text file", true},
    Kind{"{\\rtf"sv, "a rich text document (RTF); save it as plain text", true},
    Kind{"\x89PNG"sv, "a PNG picture", true},
    Kind{"\xff\xd8\xff"sv, "a JPEG picture", true},
    Kind{"GIF8"sv, "a GIF picture", false},
    Kind{"II*\0"sv, "a TIFF picture", true},
    Kind{"MM\0*"sv, "a TIFF picture", true},
    Kind{"\x93NUMPY"sv, "a NumPy array; write it with numpy.savetxt", true},
    Kind{"MATLAB 5.0 MAT"sv, "a MATLAB file; write the table with writetable", true},
    Kind{"CDF\x01"sv, "a NetCDF file", true},
    Kind{"CDF\x02"sv, "a NetCDF file", true},
    Kind{"PAR1"sv, "a Parquet file; write it as CSV", false},
    Kind{"SQLite format 3"sv, "an SQLite database; write the table as CSV", true},
    Kind{"\x7f"
         "ELF"sv,
         "a program", true},
    Kind{"version https://git-lfs"sv, "a Git LFS pointer, not the file itself; fetch it with git lfs pull", true},
    Kind{"$MeshFormat"sv, "a binary Gmsh mesh; write it as ASCII (gmsh FILE -save -o NEW.msh)", false},
    Kind{"# vtk DataFile"sv, "a binary VTK file; write it as ASCII", false},
};

bool has_prefix(std::string_view bytes, std::string_view prefix) { return bytes.substr(0, prefix.size()) == prefix; }

/// Returns whether the bytes are a web page, saved instead of a file.
bool is_web_page(std::string_view bytes) {
  std::string begin(bytes.substr(0, std::min<std::size_t>(bytes.size(), 64)));
  std::transform(begin.begin(), begin.end(), begin.begin(), [](unsigned char c) { return std::tolower(c); });
  begin.erase(0, std::min(begin.find_first_not_of(" \t\r\n"), begin.size()));
  return begin.starts_with("<!doctype html") || begin.starts_with("<html");
}

/// Returns whether the bytes are a binary STL: a head of 80 bytes, the number of triangles, 50 bytes for each.
bool is_binary_stl(std::string_view bytes) {
  constexpr std::size_t head = 80, triangle = 50;
  if (bytes.size() < head + sizeof(std::uint32_t)) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + head, sizeof count);
  return bytes.size() == head + sizeof count + triangle * static_cast<std::size_t>(count);
}

/// Returns the encoding of a text in wide characters, from its mark or from the places of its zeros; empty for other
/// bytes.
std::string_view wide_encoding(std::string_view bytes) {
  if (has_prefix(bytes, "\xff\xfe\0\0"sv) || has_prefix(bytes, "\0\0\xfe\xff"sv)) return "UTF-32";
  if (has_prefix(bytes, "\xff\xfe"sv) || has_prefix(bytes, "\xfe\xff"sv)) return "UTF-16";
  const std::string_view begin = bytes.substr(0, std::min<std::size_t>(bytes.size(), 512) / 4 * 4);
  std::array<std::size_t, 4> zeros{};
  for (std::size_t i = 0; i < begin.size(); ++i) zeros[i % 4] += begin[i] == '\0';
  // In digits, Latin letters and line ends all bytes of a wide character but one are zero.
  const std::size_t characters = begin.size() / 4;
  if (characters == 0) return "";
  const std::array<bool, 4> zero{zeros[0] == characters, zeros[1] == characters, zeros[2] == characters,
                                 zeros[3] == characters};
  if (zeros[0] == 0 && zero[1] && zero[2] && zero[3]) return "UTF-32LE";
  if (zeros[3] == 0 && zero[0] && zero[1] && zero[2]) return "UTF-32BE";
  if (zeros[0] + zeros[2] == 0 && zero[1] && zero[3]) return "UTF-16LE";
  if (zeros[1] + zeros[3] == 0 && zero[0] && zero[2]) return "UTF-16BE";
  return "";
}

/// Returns the length of the UTF-8 sequence at `at`, or 0 if it is invalid (RFC 3629, table of section 4).
std::size_t sequence_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t k) {
    return at + k < text.size() ? static_cast<unsigned char>(text[at + k]) : std::uint8_t{0};
  };
  const auto follows = [&](std::size_t k) { return (byte(k) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0), second = byte(1);
  if (first < 0x80) return 1;
  if (first < 0xC2 || first > 0xF4 || !follows(1)) return 0;
  if (first < 0xE0) return 2;
  if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second > 0x9F) || !follows(2)) return 0;
  if (first < 0xF0) return 3;
  if ((first == 0xF0 && second < 0x90) || (first == 0xF4 && second > 0x8F) || !follows(3)) return 0;
  return 4;
}

/// Refuses bytes that no text contains. Line ends are line feeds by now.
void demand_characters(std::string_view text, const std::string& where, std::string_view role) {
  const auto place = [&](std::size_t at) {
    const std::size_t start = text.rfind('\n', at) == text.npos ? 0 : text.rfind('\n', at) + 1;
    return fmt::format("{}: line {}, byte {}", where,
                       1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'),
                       at - start + 1);
  };
  for (std::size_t at = 0; at < text.size();) {
    const auto byte = static_cast<unsigned char>(text[at]);
    if (byte < 0x20 && (byte < '\t' || byte > '\r'))
      throw DataError(fmt::format("{}: the control character 0x{:02x} belongs in no text; is this the file of the {}?",
                                  place(at), byte, role));
    const std::size_t length = sequence_length(text, at);
    if (length == 0)
      throw DataError(
          fmt::format("{}: 0x{:02x} is not UTF-8; convert the file, from Latin-1 by: iconv -f WINDOWS-1252 -t "
                      "UTF-8 FILE > NEW",
                      place(at), byte));
    at += length;
  }
}

/// Ends every line by one line feed.
void end_lines(std::string& text) {
  if (text.find('\r') != std::string::npos) {
    std::size_t to = 0;
    for (std::size_t from = 0; from < text.size(); ++from) {
      if (text[from] == '\r' && from + 1 < text.size() && text[from + 1] == '\n') continue;
      text[to++] = text[from] == '\r' ? '\n' : text[from];
    }
    text.resize(to);
  }
  if (!text.ends_with('\n')) text += '\n';
}

}  // namespace

std::string binary_kind(std::string_view bytes) {
  const bool zeros = bytes.find('\0') != bytes.npos;
  for (const Kind& kind : kinds)
    if (has_prefix(bytes, kind.begins) && (zeros || kind.also_as_text)) return std::string(kind.name);
  if (is_web_page(bytes)) return "a web page (HTML); download the file itself";
  if (zeros && is_binary_stl(bytes)) return "a binary STL surface";
  constexpr std::size_t tar_mark = 257;
  if (bytes.size() > tar_mark && has_prefix(bytes.substr(tar_mark), "ustar"))
    return "a tar archive; unpack it with tar -xf";
  return "";
}

std::string plain_text(std::string bytes, const std::string& where, std::string_view role) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (bytes.starts_with(mark)) bytes.erase(0, mark.size());
  if (bytes.find_first_not_of(" \t\r\n") == bytes.npos)
    throw DataError(fmt::format("{}: the file is empty (the {})", where, role));
  if (const std::string_view wide = wide_encoding(bytes); !wide.empty())
    throw DataError(
        fmt::format("{}: {} text; convert it to UTF-8: iconv -f {} -t UTF-8 FILE > NEW", where, wide, wide));
  if (const std::string kind = binary_kind(bytes); !kind.empty()) {
    const std::size_t remedy = std::min(kind.find(';'), kind.size());
    throw DataError(fmt::format("{}: {} where a text belongs (the {}){}", where, kind.substr(0, remedy), role,
                                kind.substr(remedy)));
  }
  end_lines(bytes);
  if (bytes.find('\0') != bytes.npos)
    throw DataError(fmt::format("{}: holds zero bytes: not a text file; name the {} as text", where, role));
  demand_characters(bytes, where, role);
  return bytes;
}

}  // namespace soilweave
