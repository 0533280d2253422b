// Pictures of to-vtk: wrapping, contacts through periodic faces, grain stress, cell and planes, tables as points.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "display/display.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <string_view>

#include "analysis/measure/stress.h"
#include "core/error.h"
#include "display/display_multiscale.h"
#include "display/display_table.h"
#include "support/same_state.h"

namespace soilweave::io {
namespace {

constexpr double rounding = 1e-12;  // a few operations on numbers of order one

template <class Value>
const std::vector<Value>& values_of(const std::vector<VtkArray>& arrays, std::string_view name) {
  for (const VtkArray& array : arrays)
    if (array.name == name) return std::get<std::vector<Value>>(array.values);
  throw std::runtime_error("no array " + std::string(name));
}

void add_grain(Snapshot& state, const Vec3& position, double radius) {
  auto& grains = state.grains;
  grains.body_id.push_back(100 + static_cast<std::int64_t>(grains.size()));
  grains.position.push_back(position);
  grains.orientation.push_back({1, 0, 0, 0});
  grains.velocity.push_back({0, 0, 0});
  grains.angular_velocity.push_back({0, 0, 0});
  grains.radius.push_back(radius);
  grains.mass.push_back(1);
  grains.material_id.push_back(0);
  grains.copy_id.push_back(0);
}

/// Adds a contact with the given image of the second grain. A negative second body is a plane with the given branch.
void add_contact(Snapshot& state, int first, int second, const Vec3i& image, double normal_force, const Vec3& shear,
                 const Vec3& plane_branch = Vec3::Zero()) {
  const auto& grains = state.grains;
  const Vec3 branch =
      second < 0 ? plane_branch
                 : Vec3(grains.position[static_cast<std::size_t>(second)] + state.cell.matrix * image.cast<double>() -
                        grains.position[static_cast<std::size_t>(first)]);
  const double reach = grains.radius[static_cast<std::size_t>(first)] +
                       (second < 0 ? 0.0 : grains.radius[static_cast<std::size_t>(second)]);
  auto& contacts = state.contacts;
  contacts.bodies.push_back({first, second});
  contacts.image.push_back(image);
  contacts.normal.push_back(branch.normalized());
  contacts.branch_vector.push_back(branch);
  contacts.overlap.push_back(reach - branch.norm());
  contacts.normal_force.push_back(normal_force);
  contacts.shear_force.push_back(shear);
  contacts.rolling_moment.push_back({0, 0, 0});
  contacts.twisting_moment.push_back(0);
  contacts.sliding.push_back(0);
}

/// Returns 200 overlapping grains over several images of a sheared cell, with all contacts between nearest images.
Snapshot sheared_crowd() {
  Snapshot state;
  state.cell.matrix << 1.0, 0.45, -0.2, 0.0, 1.1, 0.3, 0.05, 0.0, 0.9;
  std::mt19937_64 engine(7);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine() >> 11) * 0x1p-53;
  };
  for (int g = 0; g < 200; ++g)
    add_grain(state, state.cell.matrix * Vec3(uniform(-2, 3), uniform(-2, 3), uniform(-2, 3)), uniform(0.05, 0.1));
  const Mat3 inverse = state.cell.matrix.inverse();
  for (int i = 0; i < 200; ++i)
    for (int j = i + 1; j < 200; ++j) {
      const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
      const Vec3 offset = inverse * (state.grains.position[a] - state.grains.position[b]);
      const Vec3i image(static_cast<int>(std::lround(offset[0])), static_cast<int>(std::lround(offset[1])),
                        static_cast<int>(std::lround(offset[2])));
      const Vec3 branch =
          state.grains.position[b] + state.cell.matrix * image.cast<double>() - state.grains.position[a];
      if (branch.norm() < state.grains.radius[a] + state.grains.radius[b])
        add_contact(state, i, j, image, uniform(0, 5), Vec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
    }
  return state;
}

Column column(const std::string& name, std::vector<double> values) { return {name, "1", name, std::move(values)}; }

TEST(Display, GrainsLieInsideTheShearedCellAndAWholeNumberOfCellVectorsAway) {
  const Snapshot state = sheared_crowd();
  const Mat3 inverse = state.cell.matrix.inverse();
  const VtkPicture picture = show_grains(state, {}, false);
  ASSERT_EQ(picture.points.size(), state.grains.size());
  for (std::size_t g = 0; g < picture.points.size(); ++g) {
    const Vec3 fraction = inverse * picture.points[g];
    EXPECT_GE(fraction.minCoeff(), -rounding);
    EXPECT_LE(fraction.maxCoeff(), 1 + rounding);
    const Vec3 cells = inverse * (state.grains.position[g] - picture.points[g]);
    EXPECT_LT((cells - cells.array().round().matrix()).norm(), rounding);
  }
  EXPECT_EQ(show_grains(state, {}, true).points, state.grains.position);
}

TEST(Display, AxesThatAreNotPeriodicAreNotWrapped) {
  Snapshot state;
  state.cell.periodic = {true, false, true};
  EXPECT_EQ(cell_index(state.cell, {-0.25, -7.5, 3.5}, Vec3::Zero()), Vec3i(-1, 0, 3));
}

TEST(Display, TheCellIsDrawnAroundItsGeotextile) {
  Snapshot state;
  state.cell.matrix = Vec3(2, 4, 3).asDiagonal();
  state.cell.periodic = {true, true, false};
  // A yarn about the corner of the cell, a grain beside it within the face, and one half a cell away.
  for (const Vec3& at : {Vec3(-0.1, 0.2, 0), Vec3(0.1, 0.2, 0), Vec3(-0.2, 0.2, 0), Vec3(1.2, 2.1, 0)})
    add_grain(state, at, 0.1);
  state.yarns.nodes = {{0, 1}};
  const VtkPicture grains = show_grains(state, {}, false);
  EXPECT_LT((grains.points[2] - Vec3(-0.2, 0.2, 0)).norm(), rounding);
  EXPECT_LT((grains.points[3] - Vec3(-0.8, 2.1, 0)).norm(), rounding);
  const VtkPicture cell = show_cell(state);
  EXPECT_LT((cell.points[0] - Vec3(-1, -1.8, -0.1)).norm(), rounding);
  EXPECT_LT((cell.points[6] - Vec3(1, 2.2, 0.1)).norm(), rounding);
}

TEST(Display, EveryContactLineStartsOrEndsAtAShownGrainAndHasTheBranchVectorsLength) {
  const Snapshot state = sheared_crowd();
  const VtkPicture grains = show_grains(state, {}, false);
  const VtkPicture lines = show_contacts(state, false, 1.0);
  const auto& contact = values_of<std::int64_t>(lines.cell_data, "contact");
  const auto& copies = values_of<std::uint8_t>(lines.cell_data, "copies");
  ASSERT_EQ(lines.points.size(), 2 * contact.size());

  std::vector<int> drawn(state.contacts.size(), 0), expected(state.contacts.size(), 0);
  std::size_t split = 0;
  for (std::size_t l = 0; l < contact.size(); ++l) {
    const auto c = static_cast<std::size_t>(contact[l]);
    const Vec3 line = lines.points[2 * l + 1] - lines.points[2 * l];
    EXPECT_LT((line - state.contacts.branch_vector[c]).norm(), rounding);
    const auto first = static_cast<std::size_t>(state.contacts.bodies[c][0]);
    const auto second = static_cast<std::size_t>(state.contacts.bodies[c][1]);
    const bool at_first = (lines.points[2 * l] - grains.points[first]).norm() < rounding;
    const bool at_second = (lines.points[2 * l + 1] - grains.points[second]).norm() < rounding;
    EXPECT_EQ(int(at_first) + int(at_second), copies[l] == 1 ? 2 : 1);
    split += copies[l] == 2;
    ++drawn[c];
    expected[c] = copies[l];
  }
  EXPECT_EQ(drawn, expected);
  EXPECT_GT(split, 20u) << "the crowd must reach through the faces for this test to say anything";
}

TEST(Display, TubeRadiusIsTheForceScaleTimesTheCompressiveForce) {
  Snapshot state;
  add_grain(state, {0.4, 0.5, 0.5}, 0.06);
  add_grain(state, {0.5, 0.5, 0.5}, 0.06);
  add_contact(state, 0, 1, {0, 0, 0}, 3.0, {0, 0.5, -1.2});
  const VtkPicture lines = show_contacts(state, false, 0.01);
  EXPECT_EQ(values_of<double>(lines.point_data, "tube_radius"), (std::vector<double>{0.03, 0.03}));
  EXPECT_DOUBLE_EQ(values_of<double>(lines.cell_data, "shear_force_magnitude")[0], 1.3);
  EXPECT_EQ(values_of<std::int64_t>(lines.cell_data, "body_id_2")[0], 101);
  EXPECT_DOUBLE_EQ(fitting_force_scale({&state}), 0.5 * 0.06 / 3.0);
  state.contacts.normal_force[0] = -1.0;  // a viscous contact that comes apart
  EXPECT_EQ(values_of<double>(show_contacts(state, false, 0.01).point_data, "tube_radius")[0], 0.0);
  EXPECT_EQ(fitting_force_scale({&state}), 1.0);
}

TEST(Display, AGrainPressedFromSixSidesCarriesPrincipalStressesAlongTheAxes) {
  // Pairs of planes press with f along x, 2f along y, 3f along z: sum of f l^T over six levers = 2 r diag(f, 2f, 3f).
  Snapshot state;
  state.cell.periodic = {false, false, false};
  add_grain(state, {0, 0, 0}, 0.5);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0})
      add_contact(state, 0, -1 - axis, {0, 0, 0}, 2.0 * (1 + axis), {0, 0, 0}, 0.5 * side * Vec3::Unit(axis));
  const VtkPicture grains = show_grains(state, analysis::grain_dyads(state), false);
  EXPECT_EQ(values_of<std::int32_t>(grains.point_data, "coordination")[0], 6);
  const double unit = 2 * 2.0 * 0.5 / (4.0 / 3.0 * std::numbers::pi * 0.125);
  const auto& stress = values_of<double>(grains.point_data, "stress");
  const auto& principal = values_of<double>(grains.point_data, "principal_stress");
  for (std::size_t axis = 0; axis < 3; ++axis) {
    EXPECT_NEAR(stress[4 * axis], unit * static_cast<double>(1 + axis), rounding);
    EXPECT_NEAR(principal[axis], unit * static_cast<double>(3 - axis), rounding);
  }
  EXPECT_EQ(values_of<double>(grains.point_data, "major_direction"), (std::vector<double>{0, 0, 1}));
}

TEST(Display, TensorsAreRowMajor) {
  Snapshot state;
  add_grain(state, {0.5, 0.5, 0.5}, 0.5);
  Mat3 dyad;
  dyad << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  const auto picture = show_grains(state, {dyad}, false);
  const auto& stress = values_of<double>(picture.point_data, "stress");
  for (std::size_t k = 0; k < 9; ++k) EXPECT_NEAR(stress[k] / stress[0], static_cast<double>(k + 1), rounding);
}

TEST(Display, CellCornersSpanTheCellMatrix) {
  const Snapshot state = sheared_crowd();
  const VtkPicture picture = show_cell(state);
  ASSERT_EQ(picture.shape, VtkShape::hexahedron);
  EXPECT_EQ(picture.points[1] - picture.points[0], state.cell.matrix.col(0));
  EXPECT_EQ(picture.points[3] - picture.points[0], state.cell.matrix.col(1));
  EXPECT_EQ(picture.points[4] - picture.points[0], state.cell.matrix.col(2));
  EXPECT_LT((picture.points[6] - state.cell.matrix * Vec3(1, 1, 1)).norm(), rounding);
  EXPECT_NEAR(values_of<double>(picture.cell_data, "volume")[0], state.cell.matrix.determinant(), rounding);
}

TEST(Display, TheCellOfDisksIsAQuadAndReachesToTheGrainsWhereNotPeriodic) {
  Snapshot state;
  state.grains.dimension = 2;
  state.cell.matrix = Vec3(2, 1, 0).asDiagonal();  // no third vector at all
  state.cell.periodic = {true, false, false};
  add_grain(state, {2.5, 3, 0}, 0.25);
  add_grain(state, {0.5, 5, 0}, 0.5);
  const VtkPicture picture = show_cell(state);
  ASSERT_EQ(picture.shape, VtkShape::quad);
  EXPECT_EQ(picture.points, (std::vector<Vec3>{{0, 2.75, 0}, {2, 2.75, 0}, {2, 5.5, 0}, {0, 5.5, 0}}));
  EXPECT_DOUBLE_EQ(values_of<double>(picture.cell_data, "volume")[0], 5.5);
  EXPECT_EQ(show_grains(state, {}, false).points[0], Vec3(0.5, 3, 0));
}

TEST(Display, PlanesAreDrawnInThePlaneAndCoverTheGrains) {
  Snapshot state;
  add_grain(state, {1, 2, 3}, 0.5);
  add_grain(state, {3, 2, 3}, 0.5);
  const Vec3 normal = Vec3(1, 2, -2) / 3;
  state.planes = {{{0, 0, 1}}, {normal}, {Vec3(0, 0, 0)}, {1}};
  const VtkPicture picture = show_planes(state);
  ASSERT_EQ(picture.points.size(), 4u);
  for (const Vec3& corner : picture.points) EXPECT_NEAR((corner - Vec3(0, 0, 1)).dot(normal), 0, rounding);
  EXPECT_GT((picture.points[2] - picture.points[0]).norm(), 3.0) << "shorter than the assembly";
}

TEST(Display, WholeYarnsAreLinesAndBrokenOnesPointsWhereTheyBroke) {
  Snapshot state;
  for (const double x : {0.0, 1.0, 3.0}) add_grain(state, {x, 0, 0}, 0.1);
  YarnsRecord& y = state.yarns;
  y.nodes = {{0, 1}, {1, 2}};
  y.fabric = {0, 0}, y.geotextile_id = {0, 0}, y.family = {0, 2};
  y.rest_length = {1, 1}, y.largest_strain = {0, 1}, y.tension = {7, 0}, y.broken = {0, 0};
  y.break_time = {0, 0}, y.break_position = {Vec3::Zero(), Vec3::Zero()};
  EXPECT_EQ(show_yarns(state).points.size(), 4u);
  EXPECT_TRUE(show_broken(state).points.empty());
  EXPECT_EQ(show_broken(state).point_data.size(), 3u) << "arrays without values: states differ in nothing else";
  y.broken = {0, 1}, y.break_time = {0, 0.5}, y.break_position[1] = {1.9, 0, 0};
  EXPECT_EQ(values_of<double>(show_yarns(state).cell_data, "tension"), (std::vector<double>{7}));
  const VtkPicture broken = show_broken(state);
  EXPECT_EQ(broken.points, (std::vector<Vec3>{{1.9, 0, 0}}));
  EXPECT_EQ(values_of<std::int64_t>(broken.point_data, "yarn"), (std::vector<std::int64_t>{1}));
  EXPECT_EQ(values_of<std::int32_t>(broken.point_data, "family"), (std::vector<std::int32_t>{2}));
  EXPECT_EQ(values_of<double>(broken.point_data, "break_time"), (std::vector<double>{0.5}));
}

TEST(DisplayTable, RowsWithADirectionAndALengthAreLinesAboutTheirPlaces) {
  Series table;
  table.columns = {column("step", {4, 4}),        column("position_x", {1, 2}),  column("position_y", {3, 4}),
                   column("position_z", {5, 6}),  column("direction_x", {1, 0}), column("direction_y", {0, 0}),
                   column("direction_z", {0, 1}), column("length", {2, 4}),      column("tension", {7, 8})};
  const VtkPicture picture = show_rows(table, states_of(table)[0]);
  EXPECT_EQ(picture.shape, VtkShape::line);
  EXPECT_EQ(picture.points, (std::vector<Vec3>{{0, 3, 5}, {2, 3, 5}, {2, 4, 4}, {2, 4, 8}}));
  EXPECT_TRUE(picture.point_data.empty());
  EXPECT_EQ(values_of<double>(picture.cell_data, "tension"), (std::vector<double>{7, 8}));
}

// The zero across the plane of disks is no principal stress of theirs: it would be the greatest one of a disk in
// tension.
TEST(Display, DisksHaveTwoPrincipalStresses) {
  Snapshot state;
  state.grains.dimension = 2;
  state.cell.periodic = {false, false, false};
  add_grain(state, {0, 0, 0}, 0.5);
  for (const double side : {-1.0, 1.0}) {
    add_contact(state, 0, -1, {0, 0, 0}, -2.0, {0, 0, 0}, 0.5 * side * Vec3::UnitX());
    add_contact(state, 0, -2, {0, 0, 0}, -6.0, {0, 0, 0}, 0.5 * side * Vec3::UnitY());
  }
  const VtkPicture grains = show_grains(state, analysis::grain_dyads(state), false);
  const double unit = 2 * 2.0 * 0.5 / (std::numbers::pi * 0.25);
  const auto& principal = values_of<double>(grains.point_data, "principal_stress");
  ASSERT_EQ(principal.size(), 2u);
  EXPECT_NEAR(principal[0], -unit, rounding);
  EXPECT_NEAR(principal[1], -3 * unit, rounding);
  EXPECT_EQ(values_of<double>(grains.point_data, "major_direction"), (std::vector<double>{1, 0, 0}));
}

TEST(DisplayTable, ComponentsBecomeVectorsAndTensors) {
  Series table;
  table.columns = {column("step", {4, 4}),      column("time", {0.5, 0.5}),
                   column("x", {1, 2}),         column("y", {3, 4}),
                   column("u_x", {5, 6}),       column("u_y", {7, 8}),
                   column("stress_xx", {1, 2}), column("stress_xy", {3, 4}),
                   column("stress_yy", {5, 6}), column("void_ratio", {.6, .7}),
                   column("rate_zz", {1, 1})};
  const auto states = states_of(table);
  ASSERT_EQ(states.size(), 1u);
  const VtkPicture picture = show_rows(table, states[0]);
  EXPECT_EQ(picture.time, 0.5);
  EXPECT_EQ(picture.step, 4);
  EXPECT_EQ(picture.points, (std::vector<Vec3>{{1, 3, 0}, {2, 4, 0}}));
  EXPECT_EQ(picture.point_data.size(), 6u) << "with the principal stresses and their major direction";
  EXPECT_EQ(values_of<double>(picture.point_data, "u"), (std::vector<double>{5, 7, 0, 6, 8, 0}));
  EXPECT_EQ(values_of<double>(picture.point_data, "stress"),
            (std::vector<double>{1, 3, 0, 3, 5, 0, 0, 0, 0, 2, 4, 0, 4, 6, 0, 0, 0, 0}));
  EXPECT_EQ(values_of<double>(picture.point_data, "principal_stress").size(), 4u) << "two in each row of the plane";
  EXPECT_EQ(values_of<double>(picture.point_data, "rate_zz"), (std::vector<double>{1, 1}));
}

// Two volumes of 8 m3 in the first state and one in the second, whose stress is the greatest of all.
Series volumes() {
  Series table;
  table.columns = {column("step", {1, 1, 2}),          column("centre_x", {10, 20, 30}),
                   column("centre_y", {0, 0, 0}),      column("centre_z", {0, 0, 5}),
                   column("volume", {8, 8, 8}),        column("principal_1", {50, 20, 100}),
                   column("principal_2", {10, 20, 0}), column("principal_3", {-10, std::nan(""), 0})};
  const char* axes = "zxy";  // the axis of the greatest stress, and so on
  for (int k = 0; k < 3; ++k)
    for (const char axis : {'x', 'y', 'z'}) {
      const double along = axes[k] == axis ? 1 : 0;
      table.columns.push_back(column("direction_" + std::to_string(k + 1) + axis, {along, along, along}));
    }
  return table;
}

TEST(DisplayTable, PrincipalAxesAreLinesInProportionToTheStress) {
  const Series table = volumes();
  const auto states = states_of(table);
  const auto first = show_axes(table, states[0]), last = show_axes(table, states[1]);
  ASSERT_TRUE(first && last);
  EXPECT_EQ(first->shape, VtkShape::line);
  EXPECT_EQ(last->points[0], Vec3(30, 0, 4)) << "2 m, the edge of the mean volume, for the greatest of all states";
  EXPECT_EQ(last->points[1], Vec3(30, 0, 6));
  EXPECT_EQ(first->points[1] - first->points[0], Vec3(0, 0, 1));
  EXPECT_NEAR((first->points[3] - first->points[2] - Vec3(0.2, 0, 0)).norm(), 0, rounding);
  EXPECT_NEAR((first->points[5] - first->points[4] - Vec3(0, 0.2, 0)).norm(), 0, rounding) << "as long in tension";
  EXPECT_EQ(values_of<std::int32_t>(first->cell_data, "principal"), (std::vector<std::int32_t>{1, 2, 3, 1, 2}))
      << "no line where there is no stress";
  EXPECT_EQ(values_of<double>(first->cell_data, "principal_stress"), (std::vector<double>{50, 10, -10, 20, 20}));
}

TEST(DisplayTable, RowsWithoutPlaceVolumeOrDirectionHaveNoAxes) {
  for (const std::string name : {"centre_x", "volume", "principal_1", "direction_3y"}) {
    Series table = volumes();
    std::erase_if(table.columns, [&](const Column& c) { return c.name == name; });
    EXPECT_FALSE(show_axes(table, states_of(table)[0])) << name;
  }
}

TEST(DisplayTable, StatesAreStretchesOfOneStepAndWithoutTimesTheStepTellsThemApart) {
  Series table;
  table.columns = {column("step", {10, 10, 30}), column("x", {0, 1, 2}), column("y", {0, 0, 0})};
  const auto states = states_of(table);
  ASSERT_EQ(states.size(), 2u);
  EXPECT_EQ(states[0].rows, (std::vector<std::size_t>{0, 1}));
  EXPECT_EQ(states[1].step, 30);
  EXPECT_EQ(states[1].time, 30);
  table.columns.erase(table.columns.begin());
  EXPECT_EQ(states_of(table).size(), 1u);
}

TEST(DisplayTable, RowsJoinTheGrainsOfTheirStepByBodyId) {
  Snapshot state;
  state.step = 20;
  for (int g = 0; g < 3; ++g) add_grain(state, {0.3 * g, 0.5, 0.5}, 0.1);
  Series table;
  table.columns = {column("step", {10, 20, 20}), column("body_id", {100, 102, 100}),
                   column("void_ratio", {0.9, 0.7, 0.5})};
  VtkPicture grains = show_grains(state, {}, false);
  join_grains(grains, state, table);
  const auto& joined = values_of<double>(grains.point_data, "void_ratio");
  EXPECT_EQ(joined[0], 0.5);
  EXPECT_TRUE(std::isnan(joined[1]));
  EXPECT_EQ(joined[2], 0.7);
  grains.step = 30;
  EXPECT_THROW(join_grains(grains, state, table), DataError);
  grains.step = 20;
  table.columns.push_back(column("radius", {1, 0.1, 7}));
  test::expect_error<DataError>([&] { join_grains(grains, state, table); },
                                "of another packing: grain 100 has a radius of 7 m there");
  table.columns.back() = column("radius", {1, 0.1, 0.1});
  // The second grain that the table has lies a cell away, and so at its place.
  state.cell.matrix = Vec3(2, 2, 2).asDiagonal();
  state.cell.periodic = {true, true, true};
  table.columns.push_back(column("position_x", {0, 0.6 + 2, 0}));
  table.columns.push_back(column("position_y", {0, 0.5, 0.5}));
  table.columns.push_back(column("position_z", {0, 0.5, 0.5}));
  join_grains(grains, state, table);
  table.columns[4].values[2] = 0.01;
  test::expect_error<DataError>(
      [&] { join_grains(grains, state, table); },
      "of another run: at step 20 grain 100 lies at (0.01, 0.5, 0.5) m there, and at (0, 0.5, "
      "0.5) m here; make it from this file");
  table.columns[1].values = {5, 6, 7};
  test::expect_error<DataError>([&] { join_grains(grains, state, table); }, "has a row for none of these grains");
}

TEST(DisplayTable, CsvHasAHeaderAndShortestExactNumbers) {
  Series table;
  table.columns = {column("a", {0.1, 2}), column("b", {1e-9, -3})};
  EXPECT_EQ(to_csv(table), "a,b\n0.1,1e-09\n2,-3\n");
}

TEST(Display, AMeshWhoseNumbersNameNothingIsRefused) {
  const auto column = [](const std::string& name, const std::vector<double>& values) {
    return Column{name, "1", name, values};
  };
  const auto file = [&](double node, double element) {
    MultiscaleFile run;
    run.groups = {{"elements", "", {{column("node_0", {0}), column("node_1", {1}), column("node_2", {node})}}},
                  {"nodes", "", {{column("x", {0, 1, 0}), column("y", {0, 0, 1}), column("u", {1, 2, 3})}}},
                  {"points", "", {{column("element", {element}), column("p", {5})}}}};
    return run;
  };
  EXPECT_EQ(show_mesh(file(2, 0)).size(), 1U);
  for (const double wrong : {-1.0, 3.0, 0.5, std::nan("")}) {
    EXPECT_THROW(show_mesh(file(wrong, 0)), DataError) << "node " << wrong;
    EXPECT_THROW(show_mesh(file(2, wrong)), DataError) << "element " << wrong;
  }
}

}  // namespace
}  // namespace soilweave::io
