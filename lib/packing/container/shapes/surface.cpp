// Containers given as closed triangulated surfaces.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/container/shapes/surface.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/polygon_soup_to_polygon_mesh.h>
#include <CGAL/Polygon_mesh_processing/repair_polygon_soup.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <boost/variant/get.hpp>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <variant>

#include "core/error.h"
#include "display/vtk.h"
#include "files/exchange/triangles.h"
#include "store/bytes.h"

#if __has_include(<CGAL/AABB_traits_3.h>)
#include <CGAL/AABB_traits_3.h>
#else  // before CGAL 6 it has another name
#include <CGAL/AABB_traits.h>
namespace CGAL {
template <class Kernel, class Primitive>
using AABB_traits_3 = AABB_traits<Kernel, Primitive>;
}
#endif

namespace soilweave::packing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits_3<Kernel, CGAL::AABB_face_graph_triangle_primitive<Triangles>>>;
namespace pmp = CGAL::Polygon_mesh_processing;

// Number of grid points along the longest side, for the count of depths.
constexpr int fineness = 60;
constexpr double farthest = 1e3;  // largest coordinate of a corner, m

void say_nothing(const char*, const char*, const char*, int, const char*) {}

void demand_near(double coordinate, const std::string& path) {
  if (!(std::abs(coordinate) <= farthest))
    throw DataError(
        fmt::format("'{}' has a corner more than {} m away; lengths are in m: are these millimetres? "
                    "container.scale = 0.001 makes them m",
                    path, farthest));
}

/// Returns the T in a result of CGAL, or a null pointer. CGAL 6 returns standard variants, CGAL 5 those of Boost.
template <class T, class... Held>
const T* held(const std::variant<Held...>& result) {
  return std::get_if<T>(&result);
}
template <class T, class Variant>
const T* held(const Variant& result) {
  return boost::get<T>(&result);
}

// Joins triangles edge to edge. Returns whether they form a surface.
bool join(const io::TriangleSoup& soup, Triangles& triangles) {
  std::vector<Kernel::Point_3> points;
  for (const Vec3& x : soup.points) points.emplace_back(x.x(), x.y(), x.z());
  std::vector<std::array<std::size_t, 3>> corners = soup.triangles;
  pmp::repair_polygon_soup(points, corners);
  if (!pmp::orient_polygon_soup(points, corners) || !pmp::is_polygon_soup_a_polygon_mesh(corners)) return false;
  pmp::polygon_soup_to_polygon_mesh(points, corners, triangles);
  return true;
}

io::TriangleSoup soup_of(const std::string& path) {
  std::string form = std::filesystem::path(path).extension();
  std::transform(form.begin(), form.end(), form.begin(), [](unsigned char c) { return std::tolower(c); });
  if (form == ".stl") return io::read_stl(io::read_bytes(path), path);
  if (form != ".vtp") throw DataError(fmt::format("'{}': a surface is read from .stl or .vtp; convert it", path));
  if (io::read_vtp == nullptr)
    throw DataError(fmt::format("'{}': this program was built without VTK; convert the surface to .stl", path));
  return io::read_vtp(path);
}

Triangles triangles_of(const std::string& path, double scale) {
  io::TriangleSoup soup = soup_of(path);
  for (Vec3& x : soup.points) {
    x *= scale;
    for (const double coordinate : x) demand_near(coordinate, path);
  }
  CGAL::set_error_handler(say_nothing);  // else CGAL prints what it also throws, about its own sources
  Triangles triangles;
  bool known = false;
  try {
    known = join(soup, triangles);
  } catch (const std::exception&) {
    known = false;
  }
  if (soup.triangles.empty()) throw DataError(fmt::format("'{}' holds no triangles; write the surface again", path));
  if (!known || triangles.is_empty())
    throw DataError(
        fmt::format("'{}' is no surface whose {} triangles meet edge to edge; mend it", path, soup.triangles.size()));
  std::size_t border = 0;
  for (const auto edge : triangles.edges()) border += triangles.is_border(edge);
  if (border > 0)
    throw DataError(fmt::format("'{}' is open: {} edges belong to one triangle only; close its holes", path, border));
  if (pmp::does_self_intersect(triangles))
    throw DataError(fmt::format("'{}' cuts itself, so that its inside is not defined; mend the surface", path));
  if (pmp::volume(triangles) < 0) pmp::reverse_face_orientations(triangles);
  return triangles;
}

}  // namespace

struct Surface::Mesh {
  Mesh(const std::string& path, double scale)
      : triangles(triangles_of(path, scale)),
        tree(faces(triangles).begin(), faces(triangles).end(), triangles),
        side(tree) {
    tree.accelerate_distance_queries();
  }
  Triangles triangles;
  Tree tree;
  CGAL::Side_of_triangle_mesh<Triangles, Kernel> side;
};

Surface::Surface(const std::string& path, double scale) : path_(path), mesh_(std::make_unique<Mesh>(path, scale)) {
  const CGAL::Bbox_3 box = pmp::bbox(mesh_->triangles);
  low_ = {box.xmin(), box.ymin(), box.zmin()}, high_ = {box.xmax(), box.ymax(), box.zmax()};
  enclosed_ = pmp::volume(mesh_->triangles);
  if (!(enclosed_ > 0)) throw DataError(fmt::format("'{}' encloses nothing", path));
}

Surface::~Surface() = default;

std::unique_ptr<Container> Surface::read(Settings& table, PlanFiles* files) {
  static constexpr Parameter unit{"scale", "1", 0, 1e6, true, "m in the surface's unit of length, 0.001 for mm"};
  if (!files) return nullptr;
  const std::string word = table.text({"file", "closed surface, .stl or .vtp"});
  const double size = table.number(unit, 1.0);
  if (word.empty()) {
    if (table.has("file")) table.mistake("file", "is empty: name a closed surface, .stl or .vtp");
    return nullptr;
  }
  const std::filesystem::path file = files->names.path("container.file", word);
  files->sources.push_back({"surface", io::sha256(io::read_bytes(file)), {}, file});
  return std::make_unique<Surface>(file.string(), size);
}

double Surface::depth(const Vec3& point) const {
  const Kernel::Point_3 at(point.x(), point.y(), point.z());
  const double distance = std::sqrt(mesh_->tree.squared_distance(at));
  return mesh_->side(at) == CGAL::ON_UNBOUNDED_SIDE ? -distance : distance;
}

double Surface::volume(double depth) const {
  if (depth <= 0) return enclosed_;
  if (depths_.empty()) {
    const Vec3 extent = high_ - low_;
    const double spacing = extent.maxCoeff() / fineness;
    for (double x = 0.5 * spacing; x < extent.x(); x += spacing)
      for (double y = 0.5 * spacing; y < extent.y(); y += spacing)
        for (double z = 0.5 * spacing; z < extent.z(); z += spacing)
          if (const double d = this->depth(low_ + Vec3(x, y, z)); d > 0) depths_.push_back(d);
    std::sort(depths_.begin(), depths_.end());
  }
  const auto deeper = static_cast<double>(depths_.end() - std::lower_bound(depths_.begin(), depths_.end(), depth));
  return enclosed_ * deeper / static_cast<double>(depths_.size());
}

Chart Surface::chart() const {
  const Kernel::Point_3 middle = pmp::centroid(mesh_->triangles);
  const double rounding = 1e-6 * (high_ - low_).norm();
  using Ray = Kernel::Ray_3;
  const auto reach = [&](const Vec3& along) {
    std::vector<Tree::Intersection_and_primitive_id<Ray>::Type> met;
    mesh_->tree.all_intersections(Ray(middle, Kernel::Vector_3(along.x(), along.y(), along.z())),
                                  std::back_inserter(met));
    // Through an edge or a corner the ray meets two or more triangles at one distance.
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const auto& [intersection, face] : met) {
      const auto* point = held<Kernel::Point_3>(intersection);
      const double distance = point ? std::sqrt(CGAL::squared_distance(middle, *point)) : 0;
      least = std::min(least, distance), most = std::max(most, distance);
    }
    if (met.empty() || least == 0 || most - least > rounding)
      throw DataError(
          fmt::format("'{}' is not seen whole from its middle, ({:.3g}, {:.3g}, {:.3g}) m: no geotextile can "
                      "be laid on it; give a surface without hollows, or cut to it alone",
                      path_, middle.x(), middle.y(), middle.z()));
    return least;
  };
  return {Vec3(middle.x(), middle.y(), middle.z()), 0.5 * (high_ - low_), reach};
}

std::vector<Vec3> Surface::spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                                  bool) const {
  if (!chart_) chart_ = std::make_unique<Chart>(chart());
  std::vector<Vec3> points;
  for (const Vec3& b : box) points.push_back(nearest(chart_->at(b, cells), outside));
  return points;
}

Vec3 Surface::nearest(const Vec3& point, double outside) const {
  const Kernel::Point_3 at(point.x(), point.y(), point.z());
  const auto [foot, face] = mesh_->tree.closest_point_and_primitive(at);
  Kernel::Vector_3 out = at - foot;
  // For a point on the surface the face's normal replaces the direction to the nearest point.
  if (const double distance = std::sqrt(out.squared_length()); distance > 1e-9 * (high_ - low_).norm())
    out = out / (mesh_->side(at) == CGAL::ON_BOUNDED_SIDE ? -distance : distance);
  else
    out = pmp::compute_face_normal(face, mesh_->triangles);
  const Kernel::Point_3 there = foot + outside * out;
  return {there.x(), there.y(), there.z()};
}

}  // namespace soilweave::packing
