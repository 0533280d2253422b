// Power cells and Delaunay volumes. The only file that includes CGAL.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tessellation.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace soilweave::analysis {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr double fill_tolerance = 1e-9;
// Width of the margin of images around the cell, in largest diameters: a grain's cell ends at its neighbours'.
constexpr double margin_in_diameters = 2.5;

struct Site {
  Vec3 centre;
  double radius;
  std::ptrdiff_t grain;  // -1 for an image
};

// All grains wrapped into the cell, and the images whose centres lie in the margin around it.
std::vector<Site> sites(const io::Snapshot& s) {
  const int d = s.grains.dimension;
  const Mat3 inverse = s.cell.matrix.inverse();
  const double largest = *std::max_element(s.grains.radius.begin(), s.grains.radius.end());
  Vec3 margin = Vec3::Zero();
  Vec3i reach = Vec3i::Zero();
  for (int a = 0; a < d; ++a) {
    margin[a] = 2 * largest * margin_in_diameters * inverse.row(a).norm();
    reach[a] = static_cast<int>(std::ceil(margin[a]));
  }
  std::vector<Site> all;
  for (std::size_t i = 0; i < s.grains.size(); ++i) {
    Vec3 reduced = inverse * s.grains.position[i];
    for (int a = 0; a < d; ++a) reduced[a] -= std::floor(reduced[a]);
    for (int z = -reach[2]; z <= reach[2]; ++z)
      for (int y = -reach[1]; y <= reach[1]; ++y)
        for (int x = -reach[0]; x <= reach[0]; ++x) {
          const Vec3 at = reduced + Vec3(x, y, z);
          bool near = true;
          for (int a = 0; a < d; ++a) near = near && at[a] >= -margin[a] && at[a] <= 1 + margin[a];
          const bool original = x == 0 && y == 0 && z == 0;
          if (near) all.push_back({s.cell.matrix * at, s.grains.radius[i], original ? static_cast<std::ptrdiff_t>(i) : -1});
        }
  }
  return all;
}

std::vector<double> volumes_3d(const std::vector<Site>& all, std::size_t n) {
  using Base = CGAL::Regular_triangulation_vertex_base_3<Kernel>;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::ptrdiff_t, Kernel, Base>;
  using Structure = CGAL::Triangulation_data_structure_3<Vertex, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
  using Triangulation = CGAL::Regular_triangulation_3<Kernel, Structure>;
  std::vector<std::pair<Triangulation::Weighted_point, std::ptrdiff_t>> points;
  for (const Site& s : all)
    points.push_back({Triangulation::Weighted_point({s.centre.x(), s.centre.y(), s.centre.z()}, s.radius * s.radius), s.grain});
  const Triangulation t(points.begin(), points.end());
  std::vector<double> volume(n, 0.0);
  const auto to_vec3 = [](const auto& p) { return Vec3(p.x(), p.y(), p.z()); };
  // Every facet of a power cell is dual to an edge: a polygon through the duals of the cells around it.
  std::vector<Vec3> polygon;
  for (auto edge = t.finite_edges_begin(); edge != t.finite_edges_end(); ++edge) {
    const auto a = edge->first->vertex(edge->second), b = edge->first->vertex(edge->third);
    if (a->info() < 0 && b->info() < 0) continue;
    polygon.clear();
    auto around = t.incident_cells(*edge), first = around;
    bool open = false;
    do {
      if (t.is_infinite(around))
        open = true;
      else
        polygon.push_back(to_vec3(t.dual(around)));
    } while (++around != first);
    if (open) continue;  // only at the hull of the margin; the check of the sum would show it
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
      area += 0.5 * (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
    const Vec3 xa = to_vec3(a->point().point()), xb = to_vec3(b->point().point());
    const Vec3 n_ab = (xb - xa).normalized();
    const double face = area.norm() / 3;
    if (a->info() >= 0) volume[static_cast<std::size_t>(a->info())] += face * (polygon[0] - xa).dot(n_ab);
    if (b->info() >= 0) volume[static_cast<std::size_t>(b->info())] -= face * (polygon[0] - xb).dot(n_ab);
  }
  return volume;
}

std::vector<double> volumes_2d(const std::vector<Site>& all, std::size_t n) {
  using Base = CGAL::Regular_triangulation_vertex_base_2<Kernel>;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::ptrdiff_t, Kernel, Base>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex, CGAL::Regular_triangulation_face_base_2<Kernel>>;
  using Triangulation = CGAL::Regular_triangulation_2<Kernel, Structure>;
  std::vector<std::pair<Triangulation::Weighted_point, std::ptrdiff_t>> points;
  for (const Site& s : all)
    points.push_back({Triangulation::Weighted_point({s.centre.x(), s.centre.y()}, s.radius * s.radius), s.grain});
  const Triangulation t(points.begin(), points.end());
  std::vector<double> area(n, 0.0);
  for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v) {
    if (v->info() < 0) continue;
    auto around = t.incident_faces(v), first = around;
    std::vector<Kernel::Point_2> polygon;
    do {
      if (!t.is_infinite(around)) polygon.push_back(t.dual(around));
    } while (++around != first);
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const auto &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      twice += p.x() * q.y() - p.y() * q.x();
    }
    area[static_cast<std::size_t>(v->info())] = 0.5 * twice;
  }
  return area;
}

}  // namespace

std::vector<double> power_cell_volumes(const io::Snapshot& state) {
  const int d = state.grains.dimension;
  for (int a = 0; a < d; ++a)
    if (!state.cell.periodic[static_cast<std::size_t>(a)])
      throw DataError("power cells need a cell that is periodic along every axis");
  const std::vector<Site> all = sites(state);
  const std::vector<double> volume = d == 3 ? volumes_3d(all, state.grains.size()) : volumes_2d(all, state.grains.size());
  double sum = 0;
  for (const double v : volume) sum += v;
  const double cell = state.cell.matrix.topLeftCorner(d, d).determinant();
  if (!(std::abs(sum / cell - 1) < fill_tolerance))
    throw PhysicsError(fmt::format("the power cells fill {:.12g} of the cell, not 1: too few grains for its shape, or grains "
                                   "inside others",
                                   sum / cell));
  return volume;
}

double delaunay_volume(const io::Snapshot& state) {
  double sum = 0;
  if (state.grains.dimension == 3) {
    std::vector<Kernel::Point_3> points;
    for (const Vec3& x : state.grains.position) points.emplace_back(x.x(), x.y(), x.z());
    const CGAL::Delaunay_triangulation_3<Kernel> t(points.begin(), points.end());
    for (auto c = t.finite_cells_begin(); c != t.finite_cells_end(); ++c) sum += t.tetrahedron(c).volume();
  } else {
    std::vector<Kernel::Point_2> points;
    for (const Vec3& x : state.grains.position) points.emplace_back(x.x(), x.y());
    const CGAL::Delaunay_triangulation_2<Kernel> t(points.begin(), points.end());
    for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) sum += t.triangle(f).area();
  }
  return sum;
}

}  // namespace soilweave::analysis
