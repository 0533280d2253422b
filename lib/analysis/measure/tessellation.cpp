// Power cells and Delaunay tetrahedra.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/tessellation.h"

#include <CGAL/Cartesian_converter.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Regular_triangulation_cell_base_3.h>
#include <CGAL/Regular_triangulation_vertex_base_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>
#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "core/error.h"

namespace soilweave::analysis {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
constexpr double fill_tolerance = 1e-10;

// A grain or one of its images.
struct Site {
  Vec3 centre;
  double radius;
  std::size_t grain;
  Vec3i image;  // counted from the recorded, unwrapped position
  Vec3i shift;  // counted from the wrapped position; zero for the grain itself
  bool original;
};

// Returns the width of the margin of images, as a share of the cell along each axis.
Vec3 margin_of(const io::Snapshot& s, double diameters) {
  const double largest = *std::max_element(s.grains.radius.begin(), s.grains.radius.end());
  const Mat3 inverse = s.cell.matrix.inverse();
  Vec3 margin = Vec3::Zero();
  for (int a = 0; a < s.grains.dimension; ++a)
    if (s.cell.periodic[static_cast<std::size_t>(a)])
      margin[a] = std::min(2.0, 2 * largest * diameters * inverse.row(a).norm());
  return margin;
}

// Returns all grains, wrapped along the periodic axes, and the images whose centres lie in the margin around the cell.
std::vector<Site> sites(const io::Snapshot& s, const Vec3& margin) {
  const int d = s.grains.dimension;
  const Mat3 inverse = s.cell.matrix.inverse();
  const Vec3i reach = margin.array().ceil().cast<int>();
  std::vector<Site> all;
  for (std::size_t i = 0; i < s.grains.size(); ++i) {
    Vec3 reduced = inverse * s.grains.position[i];
    Vec3i wrap = Vec3i::Zero();
    for (int a = 0; a < d; ++a)
      if (s.cell.periodic[static_cast<std::size_t>(a)]) wrap[a] = -static_cast<int>(std::floor(reduced[a]));
    reduced += wrap.cast<double>();
    for (int z = -reach[2]; z <= reach[2]; ++z)
      for (int y = -reach[1]; y <= reach[1]; ++y)
        for (int x = -reach[0]; x <= reach[0]; ++x) {
          const Vec3i shift(x, y, z);
          const bool original = shift.isZero();
          bool near = true;
          for (int a = 0; a < d; ++a) {
            const double at = reduced[a] + shift[a];
            near = near && (shift[a] == 0 || (at >= -margin[a] && at <= 1 + margin[a]));
          }
          const Vec3i image = wrap + shift;
          if (near)
            all.push_back({s.grains.position[i] + s.cell.matrix * image.cast<double>(), s.grains.radius[i], i, image,
                           shift, original});
        }
  }
  return all;
}

template <class Point>
Vec3 to_vec3(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

// Returns the centre of the sphere orthogonal to four weighted points. For flat tetrahedra, which occur in lattices of
// equal spheres, doubles lose all digits. So these are computed in rational numbers.
template <class Triangulation, class Cell>
Vec3 dual(const Triangulation& t, const Cell& cell) {
  const auto vertex = [&](int k) { return to_vec3(cell->vertex(k)->point().point()); };
  const Vec3 a = vertex(1) - vertex(0), b = vertex(2) - vertex(0), c = vertex(3) - vertex(0);
  if (std::abs(a.cross(b).dot(c)) > 1e-4 * a.norm() * b.norm() * c.norm()) return to_vec3(t.dual(cell));
  using Exact = CGAL::Simple_cartesian<CGAL::Exact_rational>;
  const CGAL::Cartesian_converter<Kernel, Exact> exact;
  const auto point = [&](int k) { return exact(cell->vertex(k)->point()); };
  const auto centre = Exact().construct_weighted_circumcenter_3_object()(point(0), point(1), point(2), point(3));
  return {CGAL::to_double(centre.x()), CGAL::to_double(centre.y()), CGAL::to_double(centre.z())};
}

// CGAL visits edges, and cells around an edge, in an order that depends on memory addresses. Facets are sorted before
// they are summed, so that equal states give equal bits.
struct Facet {
  std::size_t one, other;   // sites
  double of_one, of_other;  // volumes of the pyramids, m3
};

void from_first_corner(std::vector<Vec3>& polygon) {
  const auto before = [](const Vec3& p, const Vec3& q) {
    return std::lexicographical_compare(p.data(), p.data() + 3, q.data(), q.data() + 3);
  };
  std::rotate(polygon.begin(), std::min_element(polygon.begin(), polygon.end(), before), polygon.end());
  if (before(polygon.back(), polygon[1])) std::reverse(polygon.begin() + 1, polygon.end());
}

std::vector<double> volumes_3d(const std::vector<Site>& all, std::size_t n, std::vector<bool>* unbounded = nullptr) {
  using Base = CGAL::Regular_triangulation_vertex_base_3<Kernel>;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel, Base>;
  // Each tetrahedron keeps its dual point, because its six edges all need it.
  using Dual = std::optional<Vec3>;
  using Cell = CGAL::Triangulation_cell_base_with_info_3<Dual, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
  using Structure = CGAL::Triangulation_data_structure_3<Vertex, Cell>;
  using Triangulation = CGAL::Regular_triangulation_3<Kernel, Structure>;
  std::vector<std::pair<Triangulation::Weighted_point, std::size_t>> points;
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Vec3& x = all[k].centre;
    points.emplace_back(Triangulation::Weighted_point({x.x(), x.y(), x.z()}, all[k].radius * all[k].radius), k);
  }
  const Triangulation t(points.begin(), points.end());
  std::vector<double> volume(n, 0.0);
  // Every facet of a power cell is dual to an edge: a polygon through the duals of the tetrahedra around it.
  std::vector<Vec3> polygon;
  std::vector<Facet> facets;
  for (auto edge = t.finite_edges_begin(); edge != t.finite_edges_end(); ++edge) {
    const auto [a, b] =
        std::minmax(edge->first->vertex(edge->second)->info(), edge->first->vertex(edge->third)->info());
    const Site &one = all[a], &other = all[b];
    if (!one.original && !other.original) continue;
    polygon.clear();
    const auto first = t.incident_cells(*edge);
    auto around = first;
    bool open = false;
    do {
      Dual& kept = around->info();
      if (t.is_infinite(around))
        open = true;
      else
        polygon.push_back(kept ? *kept : kept.emplace(dual(t, around)));
    } while (++around != first);
    if (open) {  // in a periodic cell only at the hull of the margin; the check of the sum would show it
      if (unbounded) (*unbounded)[one.grain] = (*unbounded)[other.grain] = true;
      continue;
    }
    from_first_corner(polygon);
    Vec3 area = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
      area += 0.5 * (polygon[k] - polygon[0]).cross(polygon[k + 1] - polygon[0]);
    const Vec3 normal = (other.centre - one.centre).normalized();
    const double third = std::abs(area.dot(normal)) / 3;
    facets.push_back(
        {a, b, third * (polygon[0] - one.centre).dot(normal), -third * (polygon[0] - other.centre).dot(normal)});
  }
  std::sort(facets.begin(), facets.end(),
            [](const Facet& f, const Facet& g) { return std::pair(f.one, f.other) < std::pair(g.one, g.other); });
  for (const Facet& f : facets) {
    if (all[f.one].original) volume[all[f.one].grain] += f.of_one;
    if (all[f.other].original) volume[all[f.other].grain] += f.of_other;
  }
  return volume;
}

std::vector<double> volumes_2d(const std::vector<Site>& all, std::size_t n) {
  using Base = CGAL::Regular_triangulation_vertex_base_2<Kernel>;
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel, Base>;
  using Structure = CGAL::Triangulation_data_structure_2<Vertex, CGAL::Regular_triangulation_face_base_2<Kernel>>;
  using Triangulation = CGAL::Regular_triangulation_2<Kernel, Structure>;
  std::vector<std::pair<Triangulation::Weighted_point, std::size_t>> points;
  for (std::size_t k = 0; k < all.size(); ++k)
    points.emplace_back(
        Triangulation::Weighted_point({all[k].centre.x(), all[k].centre.y()}, all[k].radius * all[k].radius), k);
  const Triangulation t(points.begin(), points.end());
  std::vector<double> area(n, 0.0);
  std::vector<Kernel::Point_2> polygon;
  for (auto v = t.finite_vertices_begin(); v != t.finite_vertices_end(); ++v) {
    if (!all[v->info()].original) continue;
    polygon.clear();
    const auto first = t.incident_faces(v);
    auto around = first;
    do {
      if (!t.is_infinite(around)) polygon.push_back(t.dual(around));
    } while (++around != first);
    double twice = 0;
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      const Vec3& o = all[v->info()].centre;  // differences from the centre keep the digits
      const auto &p = polygon[k], &q = polygon[(k + 1) % polygon.size()];
      twice += (p.x() - o.x()) * (q.y() - o.y()) - (p.y() - o.y()) * (q.x() - o.x());
    }
    area[all[v->info()].grain] = 0.5 * twice;
  }
  return area;
}

// Returns whether to keep this one of a simplex's images. It is kept if its first vertex, in the order of grain and
// shift, is no image.
bool keep(const std::vector<Site>& all, const std::array<std::size_t, 4>& corners, int count) {
  const auto order = [&](std::size_t k) {
    const Vec3i& s = all[k].shift;
    return std::tuple(all[k].grain, s[0], s[1], s[2]);
  };
  std::size_t first = corners[0];
  for (int k = 1; k < count; ++k)
    if (order(corners[static_cast<std::size_t>(k)]) < order(first)) first = corners[static_cast<std::size_t>(k)];
  return all[first].original;
}

Simplex simplex_of(const std::vector<Site>& all, const std::array<std::size_t, 4>& corners, int dimension) {
  Simplex simplex;
  Mat3 edges = Mat3::Identity();
  for (std::size_t k = 0; k <= static_cast<std::size_t>(dimension); ++k) {
    simplex.vertices[k] = {all[corners[k]].grain, all[corners[k]].image};
    if (k > 0) edges.col(static_cast<int>(k) - 1) = all[corners[k]].centre - all[corners[0]].centre;
  }
  simplex.volume = std::abs(edges.determinant()) / (dimension == 3 ? 6 : 2);
  return simplex;
}

std::vector<Simplex> simplices(const std::vector<Site>& all, int dimension) {
  std::vector<Simplex> found;
  const auto take = [&](const std::array<std::size_t, 4>& corners) {
    if (keep(all, corners, dimension + 1)) found.push_back(simplex_of(all, corners, dimension));
  };
  if (dimension == 3) {
    using Vertex = CGAL::Triangulation_vertex_base_with_info_3<std::size_t, Kernel>;
    using Structure = CGAL::Triangulation_data_structure_3<Vertex, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>;
    std::vector<std::pair<Kernel::Point_3, std::size_t>> points;
    for (std::size_t k = 0; k < all.size(); ++k)
      points.emplace_back(Kernel::Point_3(all[k].centre.x(), all[k].centre.y(), all[k].centre.z()), k);
    const CGAL::Delaunay_triangulation_3<Kernel, Structure> t(points.begin(), points.end());
    for (auto c = t.finite_cells_begin(); c != t.finite_cells_end(); ++c)
      take({c->vertex(0)->info(), c->vertex(1)->info(), c->vertex(2)->info(), c->vertex(3)->info()});
  } else {
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
    using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
    std::vector<std::pair<Kernel::Point_2, std::size_t>> points;
    for (std::size_t k = 0; k < all.size(); ++k)
      points.emplace_back(Kernel::Point_2(all[k].centre.x(), all[k].centre.y()), k);
    const CGAL::Delaunay_triangulation_2<Kernel, Structure> t(points.begin(), points.end());
    for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
      take({f->vertex(0)->info(), f->vertex(1)->info(), f->vertex(2)->info(), 0});
  }
  return found;
}

// Makes a tessellation, and doubles the margin of images until its `sum` equals the cell's volume.
template <class Make, class Sum>
auto filling(const io::Snapshot& s, const Make& make, const Sum& sum) {
  const int d = s.grains.dimension;
  const double cell = s.cell.matrix.topLeftCorner(d, d).determinant();
  for (double diameters = 2.5;; diameters *= 2) {
    const Vec3 margin = margin_of(s, diameters);
    auto made = make(sites(s, margin));
    const double share = sum(made) / cell;
    if (std::abs(share - 1) < fill_tolerance) return made;
    if (margin.head(d).minCoeff() >= 2)
      throw PhysicsError(fmt::format(
          "step {}: the cells of the tessellation fill {:.12g} of the periodic cell, not 1; are there grains "
          "inside others?",
          s.step, share));
  }
}

// Largest volume of a power cell over the volume of its grain. A larger cell reaches outside through a hole.
constexpr double largest_cell = 8;

std::vector<double> open_volumes(const io::Snapshot& s) {
  std::vector<Site> all = sites(s, Vec3::Zero());
  std::vector<bool> skip(s.grains.size(), false);
  for (const auto& ends : s.yarns.nodes)
    for (const std::int32_t node : ends) {
      all[static_cast<std::size_t>(node)].original = false;
      skip[static_cast<std::size_t>(node)] = true;
    }
  std::vector<double> volumes = volumes_3d(all, s.grains.size(), &skip);
  for (std::size_t i = 0; i < volumes.size(); ++i) {
    const double r = s.grains.radius[i], sphere = 4.0 / 3.0 * std::numbers::pi * r * r * r;
    if (skip[i] || !(volumes[i] > 0) || volumes[i] > largest_cell * sphere) volumes[i] = 0;
  }
  return volumes;
}

}  // namespace

bool is_periodic(const io::Snapshot& state) {
  const auto first = state.cell.periodic.begin();
  return std::all_of(first, first + state.grains.dimension, [](bool axis) { return axis; });
}

std::vector<double> power_cell_volumes(const io::Snapshot& state) {
  const auto& p = state.cell.periodic;
  if (state.grains.dimension == 3 && !p[0] && !p[1] && !p[2]) return open_volumes(state);
  if (!is_periodic(state)) throw DataError("power cells need a cell that is periodic along every axis");
  const std::size_t n = state.grains.size();
  const auto make = [&](const std::vector<Site>& all) {
    return state.grains.dimension == 3 ? volumes_3d(all, n) : volumes_2d(all, n);
  };
  const auto sum = [](const std::vector<double>& volumes) {
    double total = 0;
    for (const double v : volumes) total += v;
    return total;
  };
  std::vector<double> volumes = filling(state, make, sum);
  for (std::size_t i = 0; i < n; ++i)
    if (!(volumes[i] > 0))
      throw PhysicsError(fmt::format("step {}: grain {} has no power cell: it lies inside others", state.step,
                                     state.grains.body_id[i]));
  return volumes;
}

std::vector<Simplex> delaunay(const io::Snapshot& state) {
  const auto make = [&](const std::vector<Site>& all) { return simplices(all, state.grains.dimension); };
  const auto sum = [](const std::vector<Simplex>& all) {
    double total = 0;
    for (const Simplex& s : all) total += s.volume;
    return total;
  };
  if (is_periodic(state)) return filling(state, make, sum);
  return make(sites(state, margin_of(state, 5)));
}

double delaunay_volume(const io::Snapshot& state) {
  double sum = 0;
  for (const Simplex& s : delaunay(state)) sum += s.volume;
  return sum;
}

}  // namespace soilweave::analysis
