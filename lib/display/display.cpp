// Pictures of an assembly of grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "display/display.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/linear_algebra.h"

namespace soilweave::io {
namespace {

VtkPicture picture_of(const Snapshot& state, VtkShape shape) {
  VtkPicture picture;
  picture.time = state.time;
  picture.step = state.step;
  picture.shape = shape;
  return picture;
}

/// Flattens vectors or tensors to one array, row major.
template <class Item>
VtkArray flat(std::string name, const std::vector<Item>& items) {
  constexpr int size = Item::SizeAtCompileTime;
  constexpr int columns = Item::ColsAtCompileTime;
  std::vector<double> values;
  values.reserve(items.size() * size);
  for (const Item& item : items)
    for (int k = 0; k < size; ++k) values.push_back(item(k / columns, k % columns));
  return {std::move(name), size, std::move(values)};
}

/// Returns the cell matrix with a unit vector for a missing cell vector (the third axis in 2D), so that it can be
/// inverted.
Mat3 invertible(const CellRecord& cell) {
  Mat3 matrix = cell.matrix;
  for (int axis = 0; axis < 3; ++axis)
    if (matrix.col(axis).isZero(0.0)) matrix.col(axis) = Vec3::Unit(axis);
  return matrix;
}

/// A bounding box of grains.
struct Box {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();

  explicit Box(const GrainsRecord& grains) {
    for (std::size_t g = 0; g < grains.size(); ++g) {
      const Vec3 reach = Vec3::Constant(grains.radius[g]);
      low = g == 0 ? Vec3(grains.position[g] - reach) : Vec3(low.cwiseMin(grains.position[g] - reach));
      high = g == 0 ? Vec3(grains.position[g] + reach) : Vec3(high.cwiseMax(grains.position[g] + reach));
    }
  }
};

/// Range of the drawn cell in cell vectors. Along periodic axes it is one cell from the origin, otherwise the extent of
/// the grains.
struct Reach {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
};

Reach cell_reach(const Snapshot& state, const Mat3& inverse) {
  Reach extent;
  const Vec3 origin = cell_origin(state);
  for (int axis = 0; axis < state.grains.dimension; ++axis) {
    extent.low[axis] = origin[axis], extent.high[axis] = origin[axis] + 1;
    if (state.cell.periodic[static_cast<std::size_t>(axis)]) continue;
    for (std::size_t g = 0; g < state.grains.size(); ++g) {
      const double middle = inverse.row(axis) * state.grains.position[g];
      const double reach = inverse.row(axis).norm() * state.grains.radius[g];
      extent.low[axis] = g == 0 ? middle - reach : std::min(extent.low[axis], middle - reach);
      extent.high[axis] = g == 0 ? middle + reach : std::max(extent.high[axis], middle + reach);
    }
  }
  return extent;
}

double solid_volume(double radius, int dimension) {
  return dimension == 3 ? 4.0 / 3.0 * std::numbers::pi * radius * radius * radius : std::numbers::pi * radius * radius;
}

std::vector<std::int32_t> coordination(const Snapshot& state) {
  std::vector<std::int32_t> number(state.grains.size(), 0);
  for (const auto& [first, second] : state.contacts.bodies) {
    ++number[static_cast<std::size_t>(first)];
    if (second >= 0) ++number[static_cast<std::size_t>(second)];
  }
  return number;
}

/// Contact that each line in show_contacts() represents, and its number of lines.
struct Lines {
  std::vector<std::size_t> contact;
  std::vector<std::uint8_t> copies;
};

Lines draw_lines(const Snapshot& state, bool unwrapped, std::vector<Vec3>& points) {
  const auto& contacts = state.contacts;
  Lines lines;
  const auto draw = [&](std::size_t c, const Vec3& start, int copies) {
    points.push_back(start);
    points.push_back(start + contacts.branch_vector[c]);
    lines.contact.push_back(c);
    lines.copies.push_back(static_cast<std::uint8_t>(copies));
  };
  const Vec3 origin = cell_origin(state);
  const auto index = [&](std::size_t g) {
    return unwrapped ? Vec3i(Vec3i::Zero()) : cell_index(state.cell, state.grains.position[g], origin);
  };
  const auto shown = [&](std::size_t g) {
    return Vec3(state.grains.position[g] - state.cell.matrix * index(g).cast<double>());
  };
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const auto first = static_cast<std::size_t>(contacts.bodies[c][0]);
    const bool plane = contacts.bodies[c][1] < 0;
    const auto second = plane ? first : static_cast<std::size_t>(contacts.bodies[c][1]);
    // A contact is split if its second grain, seen from the first, lies in another cell than where it is shown.
    const bool split = !plane && (contacts.image[c] - index(first) + index(second)) != Vec3i(Vec3i::Zero());
    draw(c, shown(first), split ? 2 : 1);
    if (split) draw(c, shown(second) - contacts.branch_vector[c], 2);
  }
  return lines;
}

template <class Item>
std::vector<Item> picked(const std::vector<Item>& items, const std::vector<std::size_t>& chosen) {
  std::vector<Item> result;
  result.reserve(chosen.size());
  for (const std::size_t i : chosen) result.push_back(items[i]);
  return result;
}

/// Returns body_id of the first (side 0) or second (side 1) body of each chosen contact; planes keep their negative
/// number.
std::vector<std::int64_t> body_ids(const Snapshot& state, const std::vector<std::size_t>& chosen, std::size_t side) {
  std::vector<std::int64_t> ids;
  for (const std::size_t c : chosen) {
    const std::int32_t body = state.contacts.bodies[c][side];
    ids.push_back(body < 0 ? body : state.grains.body_id[static_cast<std::size_t>(body)]);
  }
  return ids;
}

}  // namespace

Vec3 cell_origin(const Snapshot& state) {
  Vec3 origin = Vec3::Zero();
  if (state.yarns.size() == 0) return origin;
  Vec3 sum = Vec3::Zero();
  for (const auto& ends : state.yarns.nodes)
    for (const std::int32_t node : ends) sum += state.grains.position[static_cast<std::size_t>(node)];
  const Vec3 middle = invertible(state.cell).inverse() * sum / (2 * static_cast<double>(state.yarns.size()));
  for (int axis = 0; axis < 3; ++axis)
    if (state.cell.periodic[static_cast<std::size_t>(axis)]) origin[axis] = middle[axis] - 0.5;
  return origin;
}

Vec3i cell_index(const CellRecord& cell, const Vec3& position, const Vec3& origin) {
  const Vec3 fraction = invertible(cell).inverse() * position - origin;
  Vec3i index = Vec3i::Zero();
  for (int axis = 0; axis < 3; ++axis)
    if (cell.periodic[static_cast<std::size_t>(axis)]) index[axis] = static_cast<int>(std::floor(fraction[axis]));
  return index;
}

double fitting_force_scale(const std::vector<const Snapshot*>& states) {
  double greatest = 0, radii = 0;
  std::size_t grains = 0;
  for (const Snapshot* state : states) {
    for (const double force : state->contacts.normal_force) greatest = std::max(greatest, force);
    for (const double radius : state->grains.radius) radii += radius;
    grains += state->grains.size();
  }
  return greatest > 0 && grains > 0 ? 0.5 * radii / static_cast<double>(grains) / greatest : 1.0;
}

VtkPicture show_grains(const Snapshot& state, const std::vector<Mat3>& dyads, bool unwrapped) {
  const auto& grains = state.grains;
  VtkPicture picture = picture_of(state, VtkShape::vertex);
  const Vec3 origin = cell_origin(state);
  for (const Vec3& position : grains.position) {
    const Vec3 cells = cell_index(state.cell, position, origin).cast<double>();
    picture.points.push_back(unwrapped ? position : Vec3(position - state.cell.matrix * cells));
  }
  picture.point_data = {{"body_id", 1, grains.body_id},
                        {"material_id", 1, grains.material_id},
                        {"copy_id", 1, grains.copy_id},
                        {"radius", 1, grains.radius},
                        {"mass", 1, grains.mass},
                        flat("velocity", grains.velocity),
                        flat("angular_velocity", grains.angular_velocity),
                        flat("orientation", grains.orientation),
                        {"coordination", 1, coordination(state)}};
  if (!dyads.empty()) {
    std::vector<Mat3> stress = dyads;
    for (std::size_t g = 0; g < grains.size(); ++g) stress[g] /= solid_volume(grains.radius[g], grains.dimension);
    picture.point_data.push_back(flat("stress", stress));
    add_principal(picture, grains.dimension);
  }
  return picture;
}

void add_principal(VtkPicture& picture, int dimension) {
  const auto named = [](const std::string& name) {
    return [name](const VtkArray& array) { return array.name == name; };
  };
  const auto stress = std::find_if(picture.point_data.begin(), picture.point_data.end(), named("stress"));
  if (stress == picture.point_data.end() || stress->components != 9) return;
  const auto tensors = std::get<std::vector<double>>(stress->values);
  std::vector<double> principal;
  std::vector<Vec3> directions;
  for (std::size_t start = 0; start < tensors.size(); start += 9) {
    const Eigen::Map<const Mat3> tensor(&tensors[start]);  // transposed, which leaves the symmetric part equal
    if (!tensor.allFinite()) {                             // grain missing in the joined fields
      directions.push_back(Vec3::Constant(std::numeric_limits<double>::quiet_NaN()));
      principal.insert(principal.end(), static_cast<std::size_t>(dimension), directions.back().x());
      continue;
    }
    // Disks have no stress across their plane: it is no principal stress among theirs.
    const Mat3 even = symmetric(tensor);
    const auto add = [&](const auto& system, Vec3 major) {
      for (int k = dimension - 1; k >= 0; --k) principal.push_back(system.values[k]);
      // Bytes must not depend on the arbitrary sign of an eigenvector, so its largest component is made positive.
      Eigen::Index largest = 0;
      major.cwiseAbs().maxCoeff(&largest);
      directions.push_back(major[largest] < 0 ? Vec3(-major) : major);
    };
    if (dimension == 3) {
      const Eigensystem<Mat3> system = eigensystem(even);
      add(system, system.vectors.col(2));
    } else {
      const Eigensystem<Mat2> system = eigensystem(Mat2(even.topLeftCorner<2, 2>()));
      add(system, Vec3(system.vectors(0, 1), system.vectors(1, 1), 0));
    }
  }
  std::erase_if(picture.point_data, named("principal_stress"));
  std::erase_if(picture.point_data, named("major_direction"));
  picture.point_data.push_back({"principal_stress", dimension, std::move(principal)});
  picture.point_data.push_back(flat("major_direction", directions));
}

VtkPicture show_contacts(const Snapshot& state, bool unwrapped, double force_scale) {
  const auto& contacts = state.contacts;
  VtkPicture picture = picture_of(state, VtkShape::line);
  const Lines lines = draw_lines(state, unwrapped, picture.points);
  const auto& chosen = lines.contact;

  const std::vector<Vec3> shear = picked(contacts.shear_force, chosen);
  const std::vector<double> normal_force = picked(contacts.normal_force, chosen);
  std::vector<double> shear_magnitude, tube_radius;
  for (std::size_t l = 0; l < chosen.size(); ++l) {
    shear_magnitude.push_back(shear[l].norm());
    tube_radius.insert(tube_radius.end(), 2, force_scale * std::max(0.0, normal_force[l]));
  }
  picture.point_data = {{"tube_radius", 1, std::move(tube_radius)}};
  picture.cell_data = {{"contact", 1, std::vector<std::int64_t>(chosen.begin(), chosen.end())},
                       {"copies", 1, lines.copies},
                       {"body_id_1", 1, body_ids(state, chosen, 0)},
                       {"body_id_2", 1, body_ids(state, chosen, 1)},
                       flat("normal", picked(contacts.normal, chosen)),
                       {"normal_force", 1, normal_force},
                       flat("shear_force", shear),
                       {"shear_force_magnitude", 1, std::move(shear_magnitude)},
                       flat("rolling_moment", picked(contacts.rolling_moment, chosen)),
                       {"twisting_moment", 1, picked(contacts.twisting_moment, chosen)},
                       {"overlap", 1, picked(contacts.overlap, chosen)},
                       {"sliding", 1, picked(contacts.sliding, chosen)}};
  return picture;
}

VtkPicture show_cell(const Snapshot& state) {
  const int dimension = state.grains.dimension;
  const Mat3 matrix = invertible(state.cell);
  const Reach extent = cell_reach(state, matrix.inverse());
  VtkPicture picture = picture_of(state, dimension == 3 ? VtkShape::hexahedron : VtkShape::quad);
  for (int corner = 0; corner < (dimension == 3 ? 8 : 4); ++corner) {
    const bool right = corner % 4 == 1 || corner % 4 == 2, back = corner % 4 >= 2, top = corner >= 4;
    picture.points.push_back(matrix * Vec3((right ? extent.high : extent.low).x(),
                                           (back ? extent.high : extent.low).y(),
                                           (top ? extent.high : extent.low).z()));
  }
  double volume = std::abs(matrix.topLeftCorner(dimension, dimension).determinant());
  for (int axis = 0; axis < dimension; ++axis) volume *= extent.high[axis] - extent.low[axis];
  picture.cell_data = {{"volume", 1, std::vector<double>{volume}},
                       flat("deformation_gradient", std::vector<Mat3>{state.cell.deformation_gradient}),
                       flat("velocity_gradient", std::vector<Mat3>{state.cell.velocity_gradient})};
  return picture;
}

VtkPicture show_planes(const Snapshot& state) {
  const auto& planes = state.planes;
  const bool disks = state.grains.dimension == 2;
  VtkPicture picture = picture_of(state, disks ? VtkShape::line : VtkShape::quad);
  const Box box(state.grains);
  const Vec3 centre = 0.5 * (box.low + box.high);
  const double half = 0.5 * (box.high - box.low).norm();
  std::vector<std::int32_t> number;
  for (std::size_t p = 0; p < planes.point.size(); ++p) {
    const Vec3 normal = planes.normal[p].normalized();
    const Vec3 middle = centre - (centre - planes.point[p]).dot(normal) * normal;
    Vec3 across = disks ? Vec3(-normal.y(), normal.x(), 0) : normal.unitOrthogonal();
    const Vec3 along = normal.cross(across);
    across *= half;
    if (disks)
      picture.points.insert(picture.points.end(), {middle - across, middle + across});
    else
      for (const auto& [u, v] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        picture.points.push_back(middle + u * across + v * half * along);
    number.push_back(static_cast<std::int32_t>(p));
  }
  picture.cell_data = {{"plane", 1, std::move(number)},
                       {"material_id", 1, planes.material_id},
                       flat("normal", planes.normal),
                       flat("velocity", planes.velocity)};
  return picture;
}

VtkPicture show_yarns(const Snapshot& state) {
  const YarnsRecord& y = state.yarns;
  VtkPicture picture = picture_of(state, VtkShape::line);
  std::vector<double> tension, strain;
  std::vector<std::int32_t> family, fabric;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (y.broken[k]) continue;
    const Vec3& a = state.grains.position[static_cast<std::size_t>(y.nodes[k][0])];
    const Vec3& b = state.grains.position[static_cast<std::size_t>(y.nodes[k][1])];
    picture.points.push_back(a), picture.points.push_back(b);
    tension.push_back(y.tension[k]), strain.push_back((b - a).norm() / y.rest_length[k] - 1);
    family.push_back(y.family[k]), fabric.push_back(y.fabric[k]);
  }
  picture.cell_data = {{"tension", 1, std::move(tension)},
                       {"strain", 1, std::move(strain)},
                       {"family", 1, std::move(family)},
                       {"fabric", 1, std::move(fabric)}};
  return picture;
}

VtkPicture show_broken(const Snapshot& state) {
  const YarnsRecord& y = state.yarns;
  VtkPicture picture = picture_of(state, VtkShape::vertex);
  std::vector<std::int64_t> yarn;
  std::vector<std::int32_t> family;
  std::vector<double> break_time;
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (!y.broken[k]) continue;
    picture.points.push_back(y.break_position[k]);
    yarn.push_back(static_cast<std::int64_t>(k));
    family.push_back(y.family[k]), break_time.push_back(y.break_time[k]);
  }
  picture.point_data = {
      {"yarn", 1, std::move(yarn)}, {"family", 1, std::move(family)}, {"break_time", 1, std::move(break_time)}};
  return picture;
}

}  // namespace soilweave::io
