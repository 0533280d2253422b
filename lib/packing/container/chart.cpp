// Closed surfaces of any shape divided like a box.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/chart.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soilweave::packing {
namespace {

using std::numbers::pi;

constexpr std::size_t sections = 360;
constexpr std::size_t points_of_section = 720;  // many, since on a flat bag one step of the angle spans a long piece

}  // namespace

void Chart::Line::add(const Vec3& point) {
  lengths.push_back(points.empty() ? 0 : lengths.back() + (point - points.back()).norm());
  points.push_back(point);
}

Chart::RowPosition Chart::Line::at_share(double share) const {
  const double length = share * lengths.back();
  const auto next = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, length);
  const auto k = static_cast<std::size_t>(next - lengths.begin());
  const double piece = lengths[k] - lengths[k - 1];
  return {k - 1, piece > 0 ? std::clamp((length - lengths[k - 1]) / piece, 0.0, 1.0) : 0};
}

Vec3 Chart::Line::point(const RowPosition& place) const {
  return points[place.first] + place.part * (points[place.first + 1] - points[place.first]);
}

Chart::RowPosition Chart::section(double azimuth) {
  const double turns = azimuth / (2 * pi), place = (turns - std::floor(turns)) * sections;
  const auto k = std::min(static_cast<std::size_t>(place), sections - 1);
  return {k, place - static_cast<double>(k)};
}

Chart::Chart(const Vec3& middle, const Vec3& half, const std::function<double(const Vec3&)>& reach)
    : sections_(sections), corner_(std::atan2(half.y(), half.x())) {
  for (std::size_t k = 0; k < sections; ++k) {
    const double around = 2 * pi * static_cast<double>(k) / sections;
    for (std::size_t j = 0; j <= points_of_section; ++j) {
      const double down = pi * static_cast<double>(j) / points_of_section;
      const Vec3 along(std::sin(down) * std::cos(around), std::sin(down) * std::sin(around), std::cos(down));
      const Vec3 point = middle + reach(along) * along;
      sections_[k].add(point);
      if (2 * j == points_of_section) equator_.add(point);
    }
  }
  equator_.add(equator_.points.front());
}

// Returns the position along the equator in turns. It keeps growing beyond a whole turn.
double Chart::along_equator(double azimuth) const {
  const auto [k, part] = section(azimuth);
  const std::vector<double>& up_to = equator_.lengths;
  return std::floor(azimuth / (2 * pi)) + (up_to[k] + part * (up_to[k + 1] - up_to[k])) / up_to.back();
}

// Sides in order: x+, y+, x-, y-; t runs from -1 to 1 along each.
double Chart::azimuth(double u, double v) const {
  const bool across_x = std::abs(u) >= std::abs(v);
  const double ring = across_x ? std::abs(u) : std::abs(v);
  if (ring == 0) return 0;
  const double t = (across_x ? (u > 0 ? v : -v) : (v > 0 ? -u : u)) / ring;
  const double first = across_x ? (u > 0 ? -corner_ : pi - corner_) : (v > 0 ? corner_ : pi + corner_);
  const double last = across_x ? first + 2 * corner_ : first + pi - 2 * corner_;
  const double start = along_equator(first);
  const double share = start + 0.5 * (1 + t) * (along_equator(last) - start);
  const double whole = std::floor(share);
  const auto [k, part] = equator_.at_share(share - whole);
  return 2 * pi * (whole + (static_cast<double>(k) + part) / sections);
}

Vec3 Chart::at(double azimuth, double share) const {
  const auto [k, part] = section(azimuth);
  const Line &one = sections_[k], &next = sections_[(k + 1) % sections];
  return (1 - part) * one.point(one.at_share(share)) + part * next.point(next.at_share(share));
}

double cells_across(const Vec3& box, const std::array<int, 3>& cells) {
  const double u = std::abs(box.x()), v = std::abs(box.y());
  const double t = std::max(u, v) > 0 ? std::min(u, v) / std::max(u, v) : 0;
  const double own = cells[u >= v ? 0 : 1], other = cells[u >= v ? 1 : 0];
  return own + 0.5 * t * (other - own);
}

Vec3 Chart::at(const Vec3& box, const std::array<int, 3>& cells) const {
  const double across = cells_across(box, cells);
  const double face = 0.5 * std::max(std::abs(box.x()), std::abs(box.y())) * across;
  const bool top = box.z() >= 1, bottom = box.z() <= -1;
  const double down = top ? face : bottom ? across + cells[2] - face : 0.5 * across + 0.5 * (1 - box.z()) * cells[2];
  return at(azimuth(box.x(), box.y()), down / (across + cells[2]));
}

}  // namespace soilweave::packing
