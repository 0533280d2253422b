// Triangulated surfaces from STL files, binary and text.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <map>

#include "core/error.h"
#include "core/text/plain_text.h"
#include "files/exchange/triangles.h"

namespace soilweave::io {
namespace {

// Layout of a binary file: a header, the number of triangles; for each triangle its normal, its corners and two bytes.
constexpr std::size_t head_bytes = 80, of_triangle = 50, normal = 12;

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t n = 0;
  for (int k = 3; k >= 0; --k) n = n << 8U | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)]);
  return n;
}

std::size_t triangles_counted(std::string_view bytes) {
  return bytes.size() < head_bytes + 4 ? 0 : number_at(bytes, head_bytes);
}

// Points numbered in order of appearance, each place once.
class Points {
 public:
  explicit Points(TriangleSoup& soup) : soup_(soup) {}
  std::size_t number(const Vec3& x) {
    const auto [known, fresh] = number_.try_emplace({x.x(), x.y(), x.z()}, soup_.points.size());
    if (fresh) soup_.points.push_back(x);
    return known->second;
  }

 private:
  TriangleSoup& soup_;
  std::map<std::array<double, 3>, std::size_t> number_;
};

TriangleSoup read_binary(std::string_view bytes, const std::string& where) {
  TriangleSoup soup;
  Points points(soup);
  for (std::size_t t = 0; t < triangles_counted(bytes); ++t) {
    std::array<std::size_t, 3> triangle{};
    for (std::size_t c = 0; c < 3; ++c) {
      Vec3 x;
      for (std::size_t a = 0; a < 3; ++a) {
        const std::uint32_t bits = number_at(bytes, head_bytes + 4 + of_triangle * t + normal * (c + 1) + 4 * a);
        float value = 0;
        std::memcpy(&value, &bits, sizeof value);
        if (!std::isfinite(value))
          throw DataError(
              fmt::format("{}: the corner {} of triangle {} is at {}; mend the surface", where, c + 1, t + 1, value));
        x[static_cast<Eigen::Index>(a)] = static_cast<double>(value);
      }
      triangle[c] = points.number(x);
    }
    soup.triangles.push_back(triangle);
  }
  return soup;
}

bool same_letters(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) == std::tolower(static_cast<unsigned char>(y));
  });
}

// Grammar: solid NAME { facet normal x y z outer loop vertex x y z (three times) endloop endfacet } endsolid NAME,
// repeated.
class Text {
 public:
  Text(std::string_view text, const std::string& where) : text_(text), where_(where) {}

  TriangleSoup read() {
    while (!next().empty()) {
      if (!same_letters(word_, "solid")) unexpected("solid");
      skip_line();
      solid();
    }
    return std::move(soup_);
  }

 private:
  void solid() {
    for (;;) {
      if (next().empty()) fail("ends within a solid: endsolid is missing, the file is cut short");
      if (same_letters(word_, "endsolid")) return skip_line();
      if (!same_letters(word_, "facet")) unexpected("facet or endsolid");
      facet();
    }
  }

  void facet() {
    expect("normal");
    for (int k = 0; k < 3; ++k) next();  // not needed, and not always a number
    expect("outer"), expect("loop");
    std::array<std::size_t, 3> triangle{};
    for (std::size_t& corner : triangle) {
      expect("vertex");
      Vec3 x;
      for (double& coordinate : x) coordinate = number();
      corner = points_.number(x);
    }
    expect("endloop"), expect("endfacet");
    soup_.triangles.push_back(triangle);
  }

  std::string_view next() {
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) <= ' ') line_ += text_[at_++] == '\n';
    const std::size_t from = at_;
    while (at_ < text_.size() && static_cast<unsigned char>(text_[at_]) > ' ') ++at_;
    return word_ = text_.substr(from, at_ - from);
  }
  void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }
  void expect(std::string_view word) {
    if (!same_letters(next(), word)) unexpected(word);
  }
  double number() {
    std::string_view word = next();
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, failure] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (failure != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
      unexpected("a finite number");
    return value;
  }
  [[noreturn]] void unexpected(std::string_view wanted) const {
    if (word_.empty()) fail(fmt::format("ends where {} belongs: the file is cut short", wanted));
    const std::string_view remedy = word_.find(',') == word_.npos ? "" : "; write decimal points, not commas";
    fail(fmt::format("has \"{}\" where {} belongs{}", word_.substr(0, 40), wanted, remedy));
  }
  [[noreturn]] void fail(const std::string& what) const {
    throw DataError(fmt::format("{}:{}: the surface {}", where_, line_, what));
  }

  std::string_view text_, word_;
  const std::string& where_;
  std::size_t at_ = 0, line_ = 1;
  TriangleSoup soup_;
  Points points_{soup_};
};

}  // namespace

TriangleSoup read_stl(std::string_view bytes, const std::string& where) {
  const std::size_t counted = triangles_counted(bytes), wanted = head_bytes + 4 + of_triangle * counted;
  if (bytes.size() == wanted) return read_binary(bytes, where);
  // A text with zero bytes is refused as the kind of file that it is.
  if (bytes.find('\0') == bytes.npos || bytes.size() < head_bytes + 4 || !binary_kind(bytes).empty()) {
    const std::string text = plain_text(std::string(bytes), where, "surface");
    if (!same_letters(text.substr(std::min(text.find_first_not_of(" \t\n"), text.size()), 5), "solid"))
      throw DataError(fmt::format("{}: is no surface: text that does not begin with solid is no STL", where));
    return Text(text, where).read();
  }
  throw DataError(
      fmt::format("{}: is no whole binary STL: its header counts {} triangles, which take {} bytes, but it has "
                  "{}; write it again",
                  where, counted, wanted, bytes.size()));
}

}  // namespace soilweave::io
