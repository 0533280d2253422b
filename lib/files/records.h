// Plain arrays for an assembly of grains at one time. All tools exchange them through files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "core/tensor.h"

namespace soilweave::io {

/// The periodic cell. Columns of `matrix` are the cell vectors, m. periodic[i] is false for an aperiodic axis.
struct CellRecord {
  Mat3 matrix = Mat3::Identity();
  std::array<bool, 3> periodic = {true, true, true};
  /// Velocity gradient L, 1/s, extension positive.
  Mat3 velocity_gradient = Mat3::Zero();
  /// Deformation gradient F, relative to the reference state of the strains.
  Mat3 deformation_gradient = Mat3::Identity();
};

/// N grains; every array has N entries. In 2D (disks) z components are zero and masses are per metre of thickness.
struct GrainsRecord {
  /// 3: spheres; 2: disks.
  int dimension = 3;
  /// Number that stays with the grain.
  std::vector<std::int64_t> body_id;
  /// Centres, m, not wrapped: they continue through periodic faces.
  std::vector<Vec3> position;
  /// Quaternions w x y z.
  std::vector<Vec4> orientation;
  std::vector<Vec3> velocity;          // m/s, fluctuation about the cell's affine motion, half a step behind position
  std::vector<Vec3> angular_velocity;  // rad/s, half a step behind position
  std::vector<double> radius;          // m
  std::vector<double> mass;            // kg (2D: kg/m), with scaled density
  std::vector<std::int32_t> material_id;
  std::vector<std::int32_t> copy_id;  // number of the copy of a tiled representative volume; 0 if not tiled

  /// Returns the number of grains.
  std::size_t size() const { return position.size(); }
};

/// A field of history that only one contact law keeps: one number a contact, or three for a vector.
struct OwnHistory {
  std::string name, unit, long_name;
  std::size_t width = 1;       // 1 or 3
  std::vector<double> values;  // width numbers a contact, contact by contact
};

/// M contacts, sorted by (first, second). Grains are indices into GrainsRecord, first < second; a rigid plane is -1 -
/// (its number) in `second`. The contact's history is complete, so that a run can continue bit by bit.
struct ContactsRecord {
  /// The two bodies of each contact.
  std::vector<std::array<std::int32_t, 2>> bodies;
  std::vector<Vec3i> image;             // cell offset added to the second grain's position
  std::vector<Vec3> normal;             // unit, from first to second
  std::vector<Vec3> branch_vector;      // m, centre to centre (for a plane: to the contact point)
  std::vector<double> overlap;          // m
  std::vector<double> normal_force;     // N, compression positive, viscous part included
  std::vector<Vec3> shear_force;        // N, on the SECOND body (the first gets the opposite), normal to `normal`
  std::vector<Vec3> rolling_moment;     // N m, on the second body
  std::vector<double> twisting_moment;  // N m, about `normal`, on the second body
  std::vector<std::uint8_t> sliding;    // 1 if the Coulomb limit holds the shear force
  std::vector<OwnHistory> own = {};     // further fields of the contact law; a number stays with its contact

  /// Returns the number of contacts.
  std::size_t size() const { return bodies.size(); }
  /// Returns the force on the second body, normal_force * normal + shear_force, N.
  Vec3 force(std::size_t c) const { return normal_force[c] * normal[c] + shear_force[c]; }
  /// Appends contact c of another record, whose fields it has or, if it is empty, takes over.
  void append(const ContactsRecord& from, std::size_t c);
  /// Appends the law's own fields of contact c alone. side: factor on vectors, -1 if the bodies change places.
  void append_own(const ContactsRecord& from, std::size_t c, double side = 1);
};

/// Rigid planes (aperiodic runs): a point, and the unit normal towards the grains.
struct PlanesRecord {
  std::vector<Vec3> point, normal, velocity;
  std::vector<std::int32_t> material_id;
  std::vector<std::int32_t> partners =
      {};  // bodies that touch it, 0: all, 1: soil, 2: nodes of geotextiles; empty: all, for every plane
};

/// Yarns of woven geotextiles: springs between nodes. A grain is a node if a yarn ends in it, broken or not.
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

/// One state of an assembly.
struct Snapshot {
  std::int64_t step = 0;
  double time = 0;  // s
  CellRecord cell;
  GrainsRecord grains;
  ContactsRecord contacts;  // empty if only the geometry is known
  PlanesRecord planes;
  YarnsRecord yarns;
};

/// One column of a series, with a value per recorded state.
struct Column {
  std::string name, unit, long_name;
  std::vector<double> values;
};

/// Columns of equal length, one row per recorded state. `step` and `time` are ordinary columns.
struct Series {
  std::vector<Column> columns;

  /// Returns the column of this name, or nullptr.
  const Column* find(std::string_view name) const;
  const Column& at(std::string_view name) const;  // throws DataError that names the nearest column
  /// Returns the number of rows.
  std::size_t rows() const { return columns.empty() ? 0 : columns.front().values.size(); }
};

}  // namespace soilweave::io
