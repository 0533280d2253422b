// Text for a terminal.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/terminal.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <utility>

namespace soilweave {
namespace {

using Point = std::uint32_t;

/// Returns the number of bytes of the first UTF-8 character of a text, and the character; 0 bytes if it is invalid.
std::pair<std::size_t, Point> first_character(std::string_view text) {
  const auto byte = [&](std::size_t k) { return static_cast<Point>(static_cast<unsigned char>(text[k])); };
  const Point lead = byte(0);
  if (lead < 0x80) return {1, lead};
  const std::size_t length = lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (lead < 0xC2 || lead > 0xF4 || text.size() < length) return {0, 0};
  Point point = lead & (0x7FU >> length);
  for (std::size_t k = 1; k < length; ++k) {
    if ((byte(k) & 0xC0U) != 0x80U) return {0, 0};
    point = point << 6U | (byte(k) & 0x3FU);
  }
  constexpr std::array<Point, 5> least = {0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = point >= 0xD800 && point <= 0xDFFF;
  if (point < least[length] || surrogate || point > 0x10FFFF) return {0, 0};
  return {length, point};
}

/// Returns whether a terminal shows the character as itself: no control, no mark of direction, nothing invisible.
bool harmless(Point point) {
  constexpr std::array<std::pair<Point, Point>, 8> others = {{{0, 0x1F},
                                                              {0x7F, 0x9F},
                                                              {0xAD, 0xAD},
                                                              {0x61C, 0x61C},
                                                              {0x200B, 0x200F},
                                                              {0x2028, 0x202E},
                                                              {0x2060, 0x206F},
                                                              {0xFEFF, 0xFEFF}}};
  return std::none_of(others.begin(), others.end(),
                      [&](const auto& range) { return range.first <= point && point <= range.second; });
}

std::string escaped(Point point) {
  switch (point) {
    case '\t':
      return "\\t";
    case '\n':
      return "\\n";
    case '\r':
      return "\\r";
    default:
      return point < 0x80 ? fmt::format("\\x{:02x}", point) : fmt::format("\\u{{{:x}}}", point);
  }
}

}  // namespace

std::string printable(std::string_view text, std::string_view as_they_are) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const auto [length, point] = first_character(text);
    if (length == 0)
      shown += fmt::format("\\x{:02x}", static_cast<unsigned char>(text.front()));
    else if (harmless(point) || as_they_are.find(text.front()) != std::string_view::npos)
      shown += text.substr(0, length);
    else
      shown += escaped(point);
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return shown;
}

void tell(std::string_view bytes) {
  constexpr int patience = 1000;  // ms to wait if standard error is full and non-blocking
  while (!bytes.empty()) {
    const ssize_t put = ::write(STDERR_FILENO, bytes.data(), bytes.size());
    if (put > 0) bytes.remove_prefix(static_cast<std::size_t>(put));
    if (put > 0 || (put < 0 && errno == EINTR)) continue;
    pollfd reader{STDERR_FILENO, POLLOUT, 0};
    if (put < 0 && errno == EAGAIN && poll(&reader, 1, patience) == 1 && (reader.revents & POLLOUT) != 0) continue;
    return;
  }
}

void occupy_standard_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) >= 0 || errno != EBADF) continue;
    // Opened for the wrong direction, the stream still fails when it is used. open() returns its number, the lowest
    // free one.
    const int way = stream == STDIN_FILENO ? O_WRONLY : O_RDONLY;
    if (::open("/dev/null", way) < 0) (void)::open("/", O_RDONLY);
  }
}

}  // namespace soilweave
