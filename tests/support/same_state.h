// Bitwise equality of records: negative zeros and the bits of NaN count.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstring>

#include "files/files.h"

namespace soilweave::io::test {

template <class Item>
bool same_bits(const std::vector<Item>& a, const std::vector<Item>& b) {
  return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(Item)) == 0);
}
inline bool same_bits(const Mat3& a, const Mat3& b) { return std::memcmp(a.data(), b.data(), sizeof(Mat3)) == 0; }

inline void expect_same(const Snapshot& a, const Snapshot& b) {
  EXPECT_EQ(a.step, b.step);
  EXPECT_EQ(a.time, b.time);
  EXPECT_TRUE(same_bits(a.cell.matrix, b.cell.matrix));
  EXPECT_TRUE(same_bits(a.cell.velocity_gradient, b.cell.velocity_gradient));
  EXPECT_TRUE(same_bits(a.cell.deformation_gradient, b.cell.deformation_gradient));
  EXPECT_EQ(a.cell.periodic, b.cell.periodic);
  EXPECT_EQ(a.grains.dimension, b.grains.dimension);
  EXPECT_TRUE(same_bits(a.grains.body_id, b.grains.body_id));
  EXPECT_TRUE(same_bits(a.grains.position, b.grains.position));
  EXPECT_TRUE(same_bits(a.grains.orientation, b.grains.orientation));
  EXPECT_TRUE(same_bits(a.grains.velocity, b.grains.velocity));
  EXPECT_TRUE(same_bits(a.grains.angular_velocity, b.grains.angular_velocity));
  EXPECT_TRUE(same_bits(a.grains.radius, b.grains.radius));
  EXPECT_TRUE(same_bits(a.grains.mass, b.grains.mass));
  EXPECT_TRUE(same_bits(a.grains.material_id, b.grains.material_id));
  EXPECT_TRUE(same_bits(a.grains.copy_id, b.grains.copy_id));
  EXPECT_TRUE(same_bits(a.contacts.bodies, b.contacts.bodies));
  EXPECT_TRUE(same_bits(a.contacts.image, b.contacts.image));
  EXPECT_TRUE(same_bits(a.contacts.normal, b.contacts.normal));
  EXPECT_TRUE(same_bits(a.contacts.branch_vector, b.contacts.branch_vector));
  EXPECT_TRUE(same_bits(a.contacts.overlap, b.contacts.overlap));
  EXPECT_TRUE(same_bits(a.contacts.normal_force, b.contacts.normal_force));
  EXPECT_TRUE(same_bits(a.contacts.shear_force, b.contacts.shear_force));
  EXPECT_TRUE(same_bits(a.contacts.rolling_moment, b.contacts.rolling_moment));
  EXPECT_TRUE(same_bits(a.contacts.twisting_moment, b.contacts.twisting_moment));
  EXPECT_TRUE(same_bits(a.contacts.sliding, b.contacts.sliding));
  EXPECT_TRUE(same_bits(a.planes.point, b.planes.point));
  EXPECT_TRUE(same_bits(a.planes.normal, b.planes.normal));
  EXPECT_TRUE(same_bits(a.planes.velocity, b.planes.velocity));
  EXPECT_TRUE(same_bits(a.planes.material_id, b.planes.material_id));
}

inline void expect_same(const Series& a, const Series& b) {
  ASSERT_EQ(a.columns.size(), b.columns.size());
  for (std::size_t k = 0; k < a.columns.size(); ++k) {
    EXPECT_EQ(a.columns[k].name, b.columns[k].name);
    EXPECT_EQ(a.columns[k].unit, b.columns[k].unit);
    EXPECT_EQ(a.columns[k].long_name, b.columns[k].long_name);
    EXPECT_TRUE(same_bits(a.columns[k].values, b.columns[k].values)) << a.columns[k].name;
  }
}

inline void expect_same(const History& a, const History& b) {
  ASSERT_EQ(a.size(), b.size());
  EXPECT_EQ(describe(a), describe(b));
}

/// Expects that `act` throws an Error of this kind, in one line that contains the words.
template <class Kind, class Act>
void expect_error(const Act& act, const std::string& words) {
  try {
    act();
    ADD_FAILURE() << "nothing thrown where \"" << words << "\" belongs";
  } catch (const Kind& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

}  // namespace soilweave::io::test
