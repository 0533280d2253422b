// Plain arrays for an assembly at one time, as all files hold them.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/tensor.h"

namespace soilweave::io {

/// The periodic cell.
struct CellRecord {
  /// Cell vectors as columns, m.
  Mat3 matrix = Mat3::Identity();
  /// False for an aperiodic axis.
  std::array<bool, 3> periodic = {true, true, true};
  /// Velocity gradient L, 1/s, extension positive.
  Mat3 velocity_gradient = Mat3::Zero();
  /// Deformation gradient F since the reference of the strains.
  Mat3 deformation_gradient = Mat3::Identity();
};

/// N grains; each array has N entries. In 2D (disks) z components are zero.
struct GrainsRecord {
  /// 3: spheres; 2: disks.
  int dimension = 3;
  /// Number that stays with the grain.
  std::vector<std::int64_t> body_id;
  /// Centres, m, not wrapped: they continue through periodic faces.
  std::vector<Vec3> position;
  /// Quaternions w x y z.
  std::vector<Vec4> orientation;
  /// Fluctuation about the cell's affine motion, m/s, half a step behind position.
  std::vector<Vec3> velocity;
  std::vector<Vec3> angular_velocity;  // rad/s, half a step behind position
  std::vector<double> radius;          // m
  /// Masses with scaled density, kg (2D: kg/m of thickness).
  std::vector<double> mass;
  std::vector<std::int32_t> material_id;
  /// Copy of a tiled representative volume; 0 if not tiled.
  std::vector<std::int32_t> copy_id;

  /// Returns the number of grains.
  std::size_t size() const { return position.size(); }
};

/// History that one contact law alone keeps.
struct OwnHistory {
  std::string name, unit, long_name;
  std::size_t width = 1;  // 1, or 3 for a vector
  /// `width` numbers per contact, contact by contact.
  std::vector<double> values;
};

/// M contacts, sorted by (first, second). The history is complete, so that runs continue bit by bit.
struct ContactsRecord {
  /// Indices of two grains, first < second. A rigid plane is -1 - (its number) in `second`.
  std::vector<std::array<std::int32_t, 2>> bodies;
  std::vector<Vec3i> image;             // cell offset added to the second grain's position
  std::vector<Vec3> normal;             // unit, from first to second
  std::vector<Vec3> branch_vector;      // m, centre to centre (plane: to the contact point)
  std::vector<double> overlap;          // m
  std::vector<double> normal_force;     // N, compression positive, viscous part included
  std::vector<Vec3> shear_force;        // N, on the SECOND body, normal to `normal`
  std::vector<Vec3> rolling_moment;     // N m, on the second body
  std::vector<double> twisting_moment;  // N m, about `normal`, on the second body
  std::vector<std::uint8_t> sliding;    // 1 if the Coulomb limit holds the shear force
  std::vector<OwnHistory> own = {};     // further fields of the contact law

  /// Returns the number of contacts.
  std::size_t size() const { return bodies.size(); }
  /// Returns the force on the second body, N.
  Vec3 force(std::size_t c) const { return normal_force[c] * normal[c] + shear_force[c]; }
  /// Appends contact c of another record, whose own fields must be equal. An empty record copies those fields.
  void append(const ContactsRecord& from, std::size_t c);
  /// Appends the law's own fields of contact c. side: factor on vectors; -1 if the two bodies are swapped.
  void append_own(const ContactsRecord& from, std::size_t c, double side = 1);
};

/// Rigid planes of aperiodic runs.
struct PlanesRecord {
  /// One point, the unit normal towards the grains, and the velocity of each.
  std::vector<Vec3> point, normal, velocity;
  std::vector<std::int32_t> material_id;
  /// Bodies that touch each plane. 0: all, 1: soil, 2: geotextile nodes. Empty: all touch every plane.
  std::vector<std::int32_t> partners = {};
};

/// Yarns of geotextiles: springs between nodes. A node is a grain where a yarn ends, broken or not.
struct YarnsRecord {
  std::vector<std::array<std::int32_t, 2>> nodes;  // indices into GrainsRecord
  std::vector<std::int32_t> fabric;                // nodes of one fabric do not touch each other
  std::vector<std::int32_t> geotextile_id;         // index of the geotextile in the scenario
  std::vector<std::int32_t> family;                // 0: faces; 1: sides, in plane; 2: sides, from face to face
  std::vector<double> rest_length;                 // m
  std::vector<double> largest_strain;              // 1, greatest so far
  std::vector<double> tension;                     // N
  /// 1 if the yarn is broken.
  std::vector<std::uint8_t> broken;
  std::vector<double> break_time;    // s; 0 if unbroken
  std::vector<Vec3> break_position;  // m, of its middle; zero if unbroken

  /// Returns the number of yarns.
  std::size_t size() const { return nodes.size(); }
};

/// A state of an assembly.
struct Snapshot {
  std::int64_t step = 0;
  double time = 0;  // s
  CellRecord cell;
  GrainsRecord grains;
  ContactsRecord contacts;  // empty if only the geometry is known
  PlanesRecord planes;
  YarnsRecord yarns;
};

/// Returns for each grain whether it is a node of a geotextile, the end of a yarn.
std::vector<bool> nodes(const Snapshot& state);

/// A column, with a value per recorded state.
struct Column {
  std::string name, unit, long_name;
  std::vector<double> values;
};

/// Columns of equal length, one row per recorded state.
struct Series {
  std::vector<Column> columns;

  /// Returns the column of this name, or nullptr.
  const Column* find(std::string_view name) const;
  /// Returns the column. Throws DataError naming the nearest one.
  const Column& at(std::string_view name) const;
  /// Returns the number of rows.
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

}  // namespace soilweave::io
