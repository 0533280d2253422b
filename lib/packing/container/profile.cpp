// The cross-section of a filled bag.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace soilweave::packing {

using std::numbers::pi;

Profile Profile::read(Settings& table) {
  static constexpr Parameter width{"width", "m", 0, 1e3, true, "width of the bag's flat faces"};
  static constexpr Parameter height{"half_height", "m", 0, 1e3, true, "half of the bag's height"};
  static constexpr Parameter sides{"side_radius", "m", 0, 1e3, true, "radius of the sides; half_height if not given"};
  Profile p;
  p.width = table.number(width);
  p.half_height = table.number(height);
  p.side_radius = table.number(sides, p.half_height);
  if (p.side_radius < p.half_height)
    table.mistake("side_radius", "is less than half_height: give half_height or more");
  else if (2 * p.overhang() > p.width)
    table.mistake("side_radius", "is so large that the sides cut each other: give less");
  return p;
}

double Profile::overhang() const { return std::sqrt(side_radius * side_radius - half_height * half_height); }

double Profile::first_angle() const { return std::acos(half_height / side_radius); }

double Profile::half_hoop(double outside) const {
  const double first = first_angle();
  return 0.5 * width + first * outside + (0.5 * pi - first) * (side_radius + outside);
}

double Profile::depth(double out, double height) const {
  const double up = std::abs(height), seam = overhang();
  const double below_face = half_height - up, inside_side = side_radius - std::hypot(out, height);
  if (below_face < 0 && out > seam && out * half_height < up * seam) return -std::hypot(out - seam, up - half_height);
  return std::min(below_face, inside_side);
}

Eigen::Vector2d Profile::nearest(double out, double height, double outside) const {
  const double up = std::abs(height), over = std::copysign(1.0, height), seam = overhang();
  if (out <= seam && seam > 0) return {out, over * (half_height + outside)};
  if (out * half_height >= up * seam) return Eigen::Vector2d(out, height).normalized() * (side_radius + outside);
  const Eigen::Vector2d edge(seam, over * half_height);
  return edge + (Eigen::Vector2d(out, height) - edge).normalized() * outside;
}

Profile::SurfacePoint Profile::surface_point(const Vec3& box, double side, double outside) const {
  const double hoop = half_hoop(outside), from_side = side * hoop, face = 0.5 * width;
  const bool top = std::abs(box.z()) >= 1;
  const double ring = std::max(std::abs(box.x()), std::abs(box.y()));
  const double way = top ? ring * (hoop - from_side) : hoop - std::abs(box.z()) * from_side;
  const double up = box.z() < 0 ? -1 : 1;
  if (way <= face) return {way, 0, up * (half_height + outside)};
  // The way leads around the edge of the face, then around the side.
  const double edge = first_angle() * outside, past = way - face;
  const bool on_edge = past < edge;
  const double angle = on_edge ? past / outside : first_angle() + (past - edge) / (side_radius + outside);
  const double radius = on_edge ? outside : side_radius + outside;
  const double beyond = radius * std::sin(angle) - (on_edge ? 0 : overhang());
  const double height = radius * std::cos(angle) + (on_edge ? half_height : 0);
  return {face, beyond, box.z() == 0 ? 0.0 : up * height};
}

Eigen::Vector2d on_outline(double u, double v, double half, double r) {
  const bool along_y = std::abs(u) >= std::abs(v);  // the point is on the side x = +-half
  const double side = along_y ? u : v, along = along_y ? v : u;
  const double ring = std::abs(side);
  if (ring == 0) return {0, 0};
  const double straight = half - r;
  const double s = std::abs(along) / ring * (straight + 0.25 * pi * r);
  double across = half, at = s;
  if (s > straight) {
    const double angle = (s - straight) / std::max(r, 1e-300);
    across = straight + r * std::cos(angle);
    at = straight + r * std::sin(angle);
  }
  const double a = std::copysign(across, side), b = std::copysign(at, along);
  return along_y ? Eigen::Vector2d(a, b) : Eigen::Vector2d(b, a);
}

}  // namespace soilweave::packing
