// Containers given as closed triangulated surfaces.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/surface.h"

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/orientation.h>
#include <CGAL/Polygon_mesh_processing/self_intersections.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.h"

namespace soilweave::packing {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = CGAL::Surface_mesh<Kernel::Point_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_face_graph_triangle_primitive<Triangles>>>;
namespace pmp = CGAL::Polygon_mesh_processing;

// Points of the grid that depths are counted on, along the longest side.
constexpr int fineness = 60;
constexpr double farthest = 1e3;  // m, corner of a surface

void say_nothing(const char*, const char*, const char*, int, const char*) {}

// Of the forms CGAL reads, only STL withstands damaged files.
Triangles read(const std::string& path) {
  if (std::filesystem::path(path).extension() != ".stl")
    throw DataError(fmt::format("'{}': a surface is read from .stl; convert it", path));
  CGAL::set_error_handler(say_nothing);  // or it would print what it also throws, in terms of its own sources
  Triangles triangles;
  bool known = false;
  try {
    known = pmp::IO::read_polygon_mesh(path, triangles, CGAL::parameters::verbose(false));
  } catch (const std::exception&) {
    known = false;
  }
  if (!known || triangles.is_empty())
    throw DataError(fmt::format("'{}' is no surface in STL whose triangles meet edge to edge", path));
  for (const auto vertex : triangles.vertices())
    for (int a = 0; a < 3; ++a)
      if (!(std::abs(triangles.point(vertex)[a]) <= farthest))
        throw DataError(fmt::format("'{}' has a corner more than {} m away; lengths are in m", path, farthest));
  std::size_t border = 0;
  for (const auto edge : triangles.edges()) border += triangles.is_border(edge);
  if (border > 0)
    throw DataError(fmt::format("'{}' is open: {} edges belong to one triangle only; close its holes", path, border));
  if (pmp::does_self_intersect(triangles))
    throw DataError(fmt::format("'{}' cuts itself: what lies inside is not told; mend the surface", path));
  if (pmp::volume(triangles) < 0) pmp::reverse_face_orientations(triangles);
  return triangles;
}

}  // namespace

struct Surface::Mesh {
  explicit Mesh(const std::string& path)
      : triangles(read(path)), tree(faces(triangles).begin(), faces(triangles).end(), triangles), side(tree) {
    tree.accelerate_distance_queries();
  }
  Triangles triangles;
  Tree tree;
  CGAL::Side_of_triangle_mesh<Triangles, Kernel> side;
};

Surface::Surface(const std::string& path) : mesh_(std::make_unique<Mesh>(path)) {
  const CGAL::Bbox_3 box = pmp::bbox(mesh_->triangles);
  low_ = {box.xmin(), box.ymin(), box.zmin()}, high_ = {box.xmax(), box.ymax(), box.zmax()};
  enclosed_ = pmp::volume(mesh_->triangles);
  if (!(enclosed_ > 0)) throw DataError(fmt::format("'{}' encloses nothing", path));
}

Surface::~Surface() = default;

double Surface::depth(const Vec3& point) const {
  const Kernel::Point_3 at(point.x(), point.y(), point.z());
  const double distance = std::sqrt(mesh_->tree.squared_distance(at));
  return mesh_->side(at) == CGAL::ON_UNBOUNDED_SIDE ? -distance : distance;
}

double Surface::volume(double depth) const {
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
  return depth <= 0 ? enclosed_ : enclosed_ * deeper / static_cast<double>(depths_.size());
}

}  // namespace soilweave::packing
