// Pairs datasets with arrays of a snapshot, as rows of numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "files/records.h"
#include "store/schema.h"

namespace soilweave::io::layout {

/// Group of the grains.
inline const std::string grains = "/particles/grains";
/// Returns the group of a frame's contacts.
inline std::string contacts_of(std::size_t frame) { return fmt::format("/contacts/{:06}", frame); }

/// Appends items as rows: `width` numbers per item, in order.
template <class T>
void append(std::vector<T>& out, const std::vector<T>& items, Extent) {
  out.insert(out.end(), items.begin(), items.end());
}
template <class T, int Rows>
void append(std::vector<T>& out, const std::vector<Eigen::Matrix<T, Rows, 1>>& items, Extent width) {
  for (const auto& item : items) out.insert(out.end(), item.data(), item.data() + width);
}
inline void append(std::vector<std::int32_t>& out, const std::vector<std::array<std::int32_t, 2>>& items, Extent) {
  for (const auto& item : items) out.insert(out.end(), item.begin(), item.end());
}
/// Appends the first `dimension` rows and columns of a matrix.
inline void append_rows(std::vector<double>& out, const Mat3& matrix, int dimension) {
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j) out.push_back(matrix(i, j));
}

/// Reads `n` items of `width` numbers back.
template <class T>
void assign(std::vector<T>& items, const T* numbers, Extent n, Extent) {
  items.assign(numbers, numbers + n);
}
template <class T, int Rows>
void assign(std::vector<Eigen::Matrix<T, Rows, 1>>& items, const T* numbers, Extent n, Extent width) {
  items.assign(n, Eigen::Matrix<T, Rows, 1>::Zero());
  for (auto& item : items) {
    std::copy_n(numbers, width, item.data());
    numbers += width;
  }
}
inline void assign(std::vector<std::array<std::int32_t, 2>>& items, const std::int32_t* numbers, Extent n, Extent) {
  items.resize(n);
  for (auto& item : items) {
    std::copy_n(numbers, 2, item.begin());
    numbers += 2;
  }
}
/// Reads a matrix back; missing rows are taken from the identity.
inline Mat3 matrix_of_rows(const double* numbers, int dimension) {
  Mat3 matrix = Mat3::Identity();
  for (int i = 0; i < dimension; ++i)
    for (int j = 0; j < dimension; ++j) matrix(i, j) = numbers[dimension * i + j];
  return matrix;
}

/// Element type of the arrays in records.
template <class Items>
struct NumberOf {
  using type = typename Items::value_type;
};
template <class T, int Rows>
struct NumberOf<std::vector<Eigen::Matrix<T, Rows, 1>>> {
  using type = T;
};
template <>
struct NumberOf<std::vector<std::array<std::int32_t, 2>>> {
  using type = std::int32_t;
};

// The only list that pairs datasets with records. Writing and reading both use it.

/// Visits arrays of grains that change with time.
template <class Visit>
void moving(const Visit& visit) {
  visit(grains + "/position/value", &GrainsRecord::position);
  visit(grains + "/orientation/value", &GrainsRecord::orientation);
  visit(grains + "/velocity/value", &GrainsRecord::velocity);
  visit(grains + "/angular_velocity/value", &GrainsRecord::angular_velocity);
}
/// Visits arrays of grains that do not change with time.
template <class Visit>
void lasting(const Visit& visit) {
  visit(grains + "/radius", &GrainsRecord::radius);
  visit(grains + "/mass", &GrainsRecord::mass);
  visit(grains + "/species", &GrainsRecord::material_id);
  visit(grains + "/id", &GrainsRecord::body_id);
  visit(grains + "/copy_id", &GrainsRecord::copy_id);
}
/// Visits arrays of contacts.
template <class Visit>
void of_contacts(const Visit& visit) {
  visit("bodies", &ContactsRecord::bodies);
  visit("image", &ContactsRecord::image);
  visit("normal", &ContactsRecord::normal);
  visit("branch_vector", &ContactsRecord::branch_vector);
  visit("overlap", &ContactsRecord::overlap);
  visit("normal_force", &ContactsRecord::normal_force);
  visit("shear_force", &ContactsRecord::shear_force);
  visit("rolling_moment", &ContactsRecord::rolling_moment);
  visit("twisting_moment", &ContactsRecord::twisting_moment);
  visit("sliding", &ContactsRecord::sliding);
}
/// Visits arrays of planes.
template <class Visit>
void of_planes(const Visit& visit) {
  visit("/planes/point", &PlanesRecord::point);
  visit("/planes/normal", &PlanesRecord::normal);
  visit("/planes/velocity", &PlanesRecord::velocity);
  visit("/planes/material_id", &PlanesRecord::material_id);
  visit("/planes/partners", &PlanesRecord::partners);
}
/// Visits arrays of yarns.
template <class Visit>
void of_yarns(const Visit& visit) {
  visit("/yarns/nodes", &YarnsRecord::nodes);
  visit("/yarns/fabric", &YarnsRecord::fabric);
  visit("/yarns/geotextile_id", &YarnsRecord::geotextile_id);
  visit("/yarns/family", &YarnsRecord::family);
  visit("/yarns/rest_length", &YarnsRecord::rest_length);
  visit("/yarns/largest_strain", &YarnsRecord::largest_strain);
  visit("/yarns/tension", &YarnsRecord::tension);
  visit("/yarns/broken", &YarnsRecord::broken);
  visit("/yarns/break_time", &YarnsRecord::break_time);
  visit("/yarns/break_position", &YarnsRecord::break_position);
}

}  // namespace soilweave::io::layout
