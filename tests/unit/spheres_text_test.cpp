// Sphere packings as text: YADE's form, comma-separated tables, and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "core/error.h"
#include "io/files.h"
#include "support/reference.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::io {
namespace {

using test::expect_error;

class Spheres : public testing::Test {
 protected:
  Snapshot read(const std::string& text, const CellRecord* cell = nullptr) {
    test::put_bytes(path, text);
    return import_spheres(path, 2650, cell).state;
  }
  void refuses(const std::string& text, const std::string& words) {
    expect_error<DataError>([&] { read(text); }, path.string() + ": " + words);
  }
  test::Folder folder;
  std::filesystem::path path = folder / "spheres.txt";
};

TEST_F(Spheres, periodic_text_gives_cell_and_masses) {
  const Snapshot state = read("##PERIODIC:: 0.1 0.2 0.3\n# x y z r\n0 0.1 0.2 0.01\n1e-2\t0\t0\t0.02 # last\n");
  EXPECT_TRUE(state.cell.matrix.isApprox(Vec3(0.1, 0.2, 0.3).asDiagonal().toDenseMatrix(), 0));
  EXPECT_EQ(state.cell.periodic, (std::array<bool, 3>{true, true, true}));
  ASSERT_EQ(state.grains.size(), 2U);
  EXPECT_EQ(state.grains.position[0], Vec3(0, 0.1, 0.2));
  EXPECT_EQ(state.grains.radius[1], 0.02);
  EXPECT_EQ(state.grains.body_id[1], 1);
  EXPECT_NEAR(state.grains.mass[0], 2650 * 4 * std::numbers::pi / 3 * 1e-6, 1e-15);
  EXPECT_EQ(state.contacts.size(), 0U);
}

TEST_F(Spheres, table_with_a_header_takes_the_callers_cell) {
  CellRecord cell;
  cell.matrix = Mat3::Identity() * 0.5;
  const Snapshot state = read("x_m,y_m,z_m,radius_m\n0.1,0.2,0.3,0.05\n", &cell);
  EXPECT_EQ(state.grains.position[0], Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(state.cell.matrix, cell.matrix);
  EXPECT_TRUE(state.cell.periodic[2]);
}

TEST_F(Spheres, without_a_cell_nothing_is_periodic) {
  const Snapshot state = read("0.1 0.2 -0.3 0.05\n");
  EXPECT_EQ(state.cell.periodic, (std::array<bool, 3>{false, false, false}));
  EXPECT_NEAR(state.cell.matrix(0, 0), 0.15, 1e-15);
  EXPECT_NEAR(state.cell.matrix(2, 2), 0.35, 1e-15);
}

TEST_F(Spheres, errors_tell_line_and_column) {
  refuses("0 0 0 1\n0 0 x 1\n", "line 2, column 3: \"x\" is no finite number");
  refuses("0 0 0\n", "line 1, column 4: x y z r are needed");
  refuses("0 0 0 0\n", "line 1, column 4: a radius that is not positive");
  refuses("0 0 nan 1\n", "line 1, column 3: \"nan\" is no finite number");
  refuses("##PERIODIC:: 1 1\n0 0 0 0.1\n", "line 1, column 1: three cell lengths");
  refuses("##PERIODIC:: 1 -1 1\n0 0 0 0.1\n", "line 1, column 2: a cell length that is not positive");
  refuses("# nothing\n", "holds no spheres");
  refuses("##PERIODIC:: 1 1 1\n0 0 0 0.3\n", "the largest grain");
  expect_error<DataError>([&] { import_spheres(path, -1); }, "a density that is not positive");
  expect_error<MissingInput>([&] { import_spheres(folder / "none", 2650); }, "no such file");
}

TEST_F(Spheres, come_back_exactly) {
  Snapshot state = test::example_state(50);
  state.cell.matrix = Vec3(1.0 / 3, 1, 0.9).asDiagonal();
  const Snapshot back = read(export_spheres(state));
  EXPECT_TRUE(test::same_bits(state.grains.position, back.grains.position));
  EXPECT_TRUE(test::same_bits(state.grains.radius, back.grains.radius));
  EXPECT_TRUE(test::same_bits(state.cell.matrix, back.cell.matrix));
  state.cell.matrix(0, 1) = 0.1;  // a tilted cell has no line of its own
  EXPECT_EQ(export_spheres(state).find("PERIODIC"), std::string::npos);
}

TEST_F(Spheres, of_other_programs_are_read) {
  const std::filesystem::path table = soilweave::test::reference_file("ch2/toyoura_rv_1000.csv");
  if (table.empty()) GTEST_SKIP() << "SOILWEAVE_REFERENCE is not set";
  const Snapshot state = import_spheres(table, 2640).state;
  EXPECT_EQ(state.grains.size(), 1000U);
  EXPECT_EQ(state.grains.radius[0], 0.00477857);
}

}  // namespace
}  // namespace soilweave::io
