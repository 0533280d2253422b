// The conditions that every reader promises and every writer requires of a state.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "files/files.h"

namespace soilweave::io {
namespace {

/// Tolerance on unit vectors in files: rounding of a few normalisations, too small to show in a force.
constexpr double unit_tolerance = 1e-6;
// Greatest distance of a grain from its cell, in cells. Images are counted in 32 bits; larger distances are mistakes.
constexpr double most_cells_away = 1e6;
// Largest coordinate, m. Beyond it rounding falsifies distances between grains.
constexpr double farthest = 1e9;

class Check {
 public:
  Check(const Snapshot& state, const std::string& where) : state_(state), where_(where) {}

  void all() const {
    if (!std::isfinite(state_.time)) fail("time is not finite");
    // Tables keep steps as doubles, which are exact up to 2^53.
    if (state_.step < 0 || state_.step > std::int64_t{1} << 53)
      fail(fmt::format("the step number is {}; it counts from 0", state_.step));
    lengths();
    cell();
    for (std::size_t i = 0; i < state_.grains.size(); ++i) grain(i);
    names();
    size();
    for (std::size_t k = 0; k < state_.planes.point.size(); ++k) plane(k);
    for (std::size_t k = 0; k < state_.yarns.size(); ++k) yarn(k);
    for (std::size_t c = 0; c < state_.contacts.size(); ++c) contact(c);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw DataError(where_ + ": " + what); }

  template <class... Arrays>
  void equal(const char* what, std::size_t n, const Arrays&... arrays) const {
    for (const std::size_t length : {arrays.size()...})
      if (length != n) fail(fmt::format("arrays of {} have different lengths, {} and {}", what, n, length));
  }

  void lengths() const {
    const GrainsRecord& g = state_.grains;
    if (g.dimension != 2 && g.dimension != 3) fail(fmt::format("the dimension is {}; give 2 or 3", g.dimension));
    if (g.size() == 0) fail("holds no grains");
    equal("grains", g.size(), g.body_id, g.orientation, g.velocity, g.angular_velocity, g.radius, g.mass, g.material_id,
          g.copy_id);
    const ContactsRecord& c = state_.contacts;
    equal("contacts", c.size(), c.image, c.normal, c.branch_vector, c.overlap, c.normal_force, c.shear_force,
          c.rolling_moment, c.twisting_moment, c.sliding);
    for (const OwnHistory& field : c.own)
      if (field.values.size() != field.width * c.size())
        fail(fmt::format("contacts have {} numbers of {} for {} contacts", field.values.size(), field.name, c.size()));
    const PlanesRecord& p = state_.planes;
    equal("planes", p.point.size(), p.normal, p.velocity, p.material_id);
    if (!p.partners.empty()) equal("planes", p.point.size(), p.partners);
    const YarnsRecord& y = state_.yarns;
    equal("yarns", y.size(), y.fabric, y.geotextile_id, y.family, y.rest_length, y.largest_strain, y.tension, y.broken,
          y.break_time, y.break_position);
  }

  void cell() const {
    const CellRecord& cell = state_.cell;
    if (!cell.matrix.allFinite()) fail("the cell vectors are not finite");
    if (!cell.velocity_gradient.allFinite()) fail("the velocity gradient is not finite");
    if (!cell.deformation_gradient.allFinite()) fail("the deformation gradient is not finite");
    if (!(cell.matrix.determinant() > 0)) fail("the cell vectors span no volume, or are left-handed");
    const Mat3& m = cell.matrix;
    if (state_.grains.dimension == 2 && (m(0, 2) != 0 || m(1, 2) != 0 || m(2, 0) != 0 || m(2, 1) != 0))
      fail("the cell of a 2D state leaves the plane; keep its third vector along z");
  }

  void grain(std::size_t i) const {
    const GrainsRecord& g = state_.grains;
    const auto bad = [&](const char* what) { fail(fmt::format("grain {} (body_id {}): {}", i, g.body_id[i], what)); };
    if (!g.position[i].allFinite()) bad("position is not finite");
    if (g.position[i].cwiseAbs().maxCoeff() > farthest) bad("lies more than 1e9 m from the origin");
    if (!g.velocity[i].allFinite()) bad("velocity is not finite");
    if (!g.angular_velocity[i].allFinite()) bad("angular velocity is not finite");
    if (!(g.radius[i] > 0 && std::isfinite(g.radius[i]))) bad("radius is not positive");
    if (!(g.mass[i] > 0 && std::isfinite(g.mass[i]))) bad("mass is not positive");
    if (!(std::abs(g.orientation[i].norm() - 1) <= unit_tolerance)) bad("orientation is no unit quaternion");
    if (g.material_id[i] < 0) bad("material_id is negative");
    if (g.dimension == 2 && (g.position[i].z() != 0 || g.velocity[i].z() != 0)) bad("leaves the plane of a 2D state");
  }

  /// Checks that body_ids are unique, because tables and later states identify grains by them.
  void names() const {
    std::vector<std::int64_t> ids(state_.grains.body_id.begin(), state_.grains.body_id.end());
    std::ranges::sort(ids);
    if (const auto twice = std::ranges::adjacent_find(ids); twice != ids.end())
      fail(fmt::format("body_id {} names two grains; give each its own", *twice));
  }

  /// Checks sizes: the nearest image of a touching pair is unique only if grains are smaller than half the cell.
  void size() const {
    double largest = 0;
    for (const double radius : state_.grains.radius) largest = std::max(largest, radius);
    const Vec3 widths = state_.cell.matrix.inverse().rowwise().norm().cwiseInverse();
    for (int a = 0; a < state_.grains.dimension; ++a)
      if (state_.cell.periodic[static_cast<std::size_t>(a)] && 2 * largest >= widths[a] / 2)
        fail(
            fmt::format("the largest grain ({} m across) is not smaller than half the cell along axis {} ({} m wide); "
                        "use a larger cell",
                        2 * largest, "xyz"[a], widths[a]));
    const Mat3 inverse = state_.cell.matrix.inverse();
    for (std::size_t k = 0; k < state_.grains.size(); ++k)
      for (int a = 0; a < state_.grains.dimension; ++a)
        if (state_.cell.periodic[static_cast<std::size_t>(a)] &&
            !(std::abs(inverse.row(a).dot(state_.grains.position[k])) <= most_cells_away))
          fail(fmt::format("grain {} lies more than {:g} cells away along axis {}; bring it back into the cell",
                           state_.grains.body_id[k], most_cells_away, "xyz"[a]));
  }

  void plane(std::size_t k) const {
    const PlanesRecord& p = state_.planes;
    if (!p.point[k].allFinite() || !p.velocity[k].allFinite()) fail(fmt::format("plane {}: is not finite", k));
    if (!(std::abs(p.normal[k].norm() - 1) <= unit_tolerance))
      fail(fmt::format("plane {}: normal is no unit vector", k));
    if (p.material_id[k] < 0) fail(fmt::format("plane {}: material_id is negative", k));
  }

  void yarn(std::size_t k) const {
    const YarnsRecord& y = state_.yarns;
    const auto bad = [&](const char* what) {
      fail(fmt::format("yarn {} (nodes {} and {}): {}", k, y.nodes[k][0], y.nodes[k][1], what));
    };
    const auto grains = static_cast<std::int64_t>(state_.grains.size());
    for (const std::int32_t node : y.nodes[k])
      if (node < 0 || node >= grains) bad("names a grain that is not there");
    if (y.nodes[k][0] == y.nodes[k][1]) bad("ends where it begins");
    if (y.fabric[k] < 0 || y.geotextile_id[k] < 0) bad("fabric or geotextile_id is negative");
    if (!(y.rest_length[k] > 0 && std::isfinite(y.rest_length[k]))) bad("rest_length is not positive");
    if (!std::isfinite(y.largest_strain[k]) || !std::isfinite(y.tension[k])) bad("strain or tension is not finite");
    if (!std::isfinite(y.break_time[k]) || !y.break_position[k].allFinite())
      bad("place or time of break is not finite");
  }

  void contact(std::size_t k) const {
    const ContactsRecord& c = state_.contacts;
    const auto bad = [&](const char* what) {
      fail(fmt::format("contact {} (grains {} and {}): {}", k, c.bodies[k][0], c.bodies[k][1], what));
    };
    const auto [first, second] = c.bodies[k];
    const auto grains = static_cast<std::int64_t>(state_.grains.size());
    const auto planes = static_cast<std::int64_t>(state_.planes.point.size());
    if (first < 0 || first >= grains || second >= grains || second < -planes)
      bad("names a grain or plane that is not there");
    if (second >= 0 && second <= first) bad("the first grain must come before the second");
    if (k > 0 && c.bodies[k] < c.bodies[k - 1]) bad("is out of order; sort contacts by (first, second)");
    if (k > 0 && c.bodies[k] == c.bodies[k - 1] && c.image[k] == c.image[k - 1]) bad("is there twice");
    if (!(std::abs(c.normal[k].norm() - 1) <= unit_tolerance)) bad("normal is no unit vector");
    if (!c.branch_vector[k].allFinite() || !std::isfinite(c.overlap[k])) bad("geometry is not finite");
    if (!(c.normal[k].dot(c.branch_vector[k]) > 0)) bad("normal points away from the second body");
    if (second >= 0 && !joins_centres(k)) bad("branch_vector does not join the grains' centres");
    if (!std::isfinite(c.normal_force[k]) || !c.shear_force[k].allFinite()) bad("force is not finite");
    if (!c.rolling_moment[k].allFinite() || !std::isfinite(c.twisting_moment[k])) bad("moment is not finite");
    for (const OwnHistory& field : c.own)
      for (std::size_t j = 0; j < field.width; ++j)
        if (!std::isfinite(field.values[field.width * k + j])) bad((field.name + " is not finite").c_str());
  }

  bool joins_centres(std::size_t k) const {
    const ContactsRecord& c = state_.contacts;
    const std::vector<Vec3>& x = state_.grains.position;
    const Vec3 branch = x[static_cast<std::size_t>(c.bodies[k][1])] + state_.cell.matrix * c.image[k].cast<double>() -
                        x[static_cast<std::size_t>(c.bodies[k][0])];
    return (branch - c.branch_vector[k]).norm() <= unit_tolerance * branch.norm();
  }

  const Snapshot& state_;
  const std::string& where_;
};

}  // namespace

void check(const Snapshot& state, const std::string& where) { Check(state, where).all(); }

}  // namespace soilweave::io
