// The loading of a bag between plates: a box of nodes with known area, layer and cuts, and a series made by hand.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/tables/bag.h"
#include "analysis/tables/interface.h"
#include "analysis/tables/loading.h"
#include "core/error.h"
#include "core/text/text.h"
#include "gws/identification/bag_runs.h"
#include "packing/container/geotextile.h"
#include "packing/container/shapes/box.h"
#include "packing/expand/loaded_bag.h"
#include "support/states.h"

namespace soilweave {
namespace {

constexpr double r = 0.002;  // m, of the nodes

const std::string mesh = "[geotextile_mesh]\ncells = [4, 3, 2]\noffset = 0\nnode_radius = \"2 mm\"\n";
const std::string box = "[container]\nshape = \"box\"\nlow = [-0.05, -0.03, 0]\nhigh = [0.05, 0.03, 0.04]\n" + mesh;
const std::string geotextile = "[[geotextile]]\nyarn_strain = [0.02, 0.1]\nyarn_tension = [10, 40]\nmultiple = 2\n";
const std::string planes = "[[plane]]\nname = \"floor\"\n[[plane]]\nname = \"top\"\n[[plane]]\nname = \"bottom\"\n";
const std::string preload =
    "[[stage]]\npath = \"drive\"\n[[stage.load]]\npart = \"top\"\nalong = [0, 0, -1]\nforce = 1\nspeed = 1\n";
const std::string compression =
    "[[stage]]\npath = \"uniaxial\"\nheight = 0.04\nstrain = 0.04\nincrement = 0.01\nrate = 0.1\n";

io::Series series() {
  io::Series s;
  const auto put = [&](const std::string& name, std::vector<double> values, const std::string& unit = "1") {
    s.columns.push_back({name, unit, "made by hand", std::move(values)});
  };
  put("step", {0, 10, 20, 30, 40, 50}), put("time", {0, 1, 2, 3, 4, 5}, "s"), put("stage", {0, 0, 1, 1, 1, 1});
  // The plates approach by 0.2 mm in the preload, then by 1 % of 40 mm per station; the upper one travels by 3 and -4.
  put("displacement_top_z", {0, -1e-4, -3e-4, -5e-4, -7e-4, -9e-4}),
      put("displacement_bottom_z", {0, 1e-4, 3e-4, 5e-4, 7e-4, 9e-4});
  put("displacement_top_x", {0, 0, 0, 0, 0, 3e-4}), put("displacement_top_y", {0, 0, 0, 0, 0, -4e-4});
  put("displacement_bottom_x", {0, 0, 0, 0, 0, 0}), put("displacement_bottom_y", {0, 0, 0, 0, 0, 0});
  put("force_top_z", {0, 5, 10, 20, 30, 40}), put("force_bottom_z", {0, -7, -10, -20, -30, -40});
  put("force_top_x", {0, 0, 0, 0, 0, -6}), put("force_top_y", {0, 0, 0, 0, 0, 8});
  put("soil_volume", {2e-4, 2e-4, 2e-4, 2e-4, 2e-4, 2e-4}, "m3");
  put("soil_stress_xx", {1, 2, 3, 4, 5, 6}, "Pa"), put("soil_stress_yy", {3, 4, 5, 6, 7, 8}, "Pa");
  put("soil_stress_zz", {10, 20, 30, 40, 50, 60}, "Pa"), put("soil_stress_xz", {0, 0, 0, 0, 0, -3}, "Pa"),
      put("soil_stress_yz", {0, 0, 0, 0, 0, 4}, "Pa");
  put("soil_mean_stress", {4, 8, 12, 16, 20, 24}, "Pa"), put("soil_deviatoric_stress", {4, 8, 12, 20, 20, 24}, "Pa"),
      put("soil_obliquity", {1, 1, 1, 1.25, 1, 1});
  put("soil_void_ratio", {0.7, 0.7, 0.7, 0.7, 0.7, 0.7}),
      put("soil_delaunay_void_ratio", {0.62, 0.6, 0.592, 0.584, 0.6, 0.616});
  put("soil_coordination_number", {4, 4, 4, 4, 4, 4});
  put("yarn_tension_face", {0, 2, 4, 6, 8, 10}, "N"), put("yarn_tension_side_horizontal", {0, 1, 2, 3, 4, 5}, "N"),
      put("yarn_tension_side_vertical", {0, 1, 1, 1, 1, 1}, "N");
  put("yarn_strain_face", {0, 0, 0, 0, 0, 0.01}), put("yarn_strain_side_horizontal", {0, 0, 0, 0, 0, 0.02}),
      put("yarn_strain_side_vertical", {0, 0, 0, 0, 0, 0.03});
  put("broken_yarns", {0, 0, 0, 0, 0, 2});
  for (const char* name : {"face_friction_x", "face_friction_y", "face_friction_z"})
    put(name, {1, 1, 1, 1, 1, 1}, "deg");
  for (const char* name : {"kinetic_energy", "boundary_work", "energy_error"}) put(name, {0, 0, 0, 0, 0, 0}, "J");
  put("unbalanced_force", {0, 0, 0, 0, 0, 0});
  return s;
}

/// Returns a box of 100 x 60 x 40 mm in a mesh of 4 x 3 x 2 cells, between plates on its nodes; two yarns break.
io::RunFile run(const std::string& plan = box,
                const std::string& scenario = geotextile + planes + preload + compression) {
  io::RunFile file;
  io::Snapshot& state = file.snapshots.emplace_back();
  packing::Box container;
  container.lower = {-0.05, -0.03, 0}, container.upper = {0.05, 0.03, 0.04};
  packing::add(packing::wrap(container, {4, 3, 2}, 0, false), {r, 444e3, 1, 0}, state);
  state.planes.point = {Vec3(0, 0, -1), Vec3(0, 0, 0.042), Vec3(0, 0, -0.002)};
  state.planes.normal = {Vec3(0, 0, 1), Vec3(0, 0, -1), Vec3(0, 0, 1)};
  io::Snapshot last = state;
  last.step = 50;
  last.yarns.broken[3] = last.yarns.broken[7] = 1;
  last.yarns.break_time[3] = 4.5, last.yarns.break_time[7] = 4.02;
  file.snapshots.push_back(last);
  file.series = series();
  file.scenario = scenario;
  file.source.history = {{"filter-expand", "1", "filter-expand", plan, 0, {}},
                         {"run-dem", "1", "run-dem", scenario, 0, {}}};
  return file;
}

io::Series table(const io::RunFile& file) {
  return analysis::loading(file.series, packing::loaded_bag(file, "run.h5"));
}

void expect(const io::Series& table, const char* name, const std::vector<double>& wanted) {
  const std::vector<double>& values = table.at(name).values;
  ASSERT_EQ(values.size(), wanted.size()) << name;
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_NEAR(values[i], wanted[i], 1e-12 * (1 + std::abs(wanted[i]))) << name << ", row " << i;
}

TEST(BagLoading, HasItsSizeFromThePlanAndItsNumbersFromTheSeries) {
  const io::Series t = table(run());
  expect(t, "nominal_area", std::vector<double>(6, 0.006));
  expect(t, "reference_height", std::vector<double>(6, 0.04));
  expect(t, "settlement", {-2e-4, 0, 4e-4, 8e-4, 12e-4, 16e-4});
  expect(t, "strain_axial", {-0.005, 0, 0.01, 0.02, 0.03, 0.04});
  expect(t, "plate_pressure", {0, 1000, 10 / 0.006, 20 / 0.006, 30 / 0.006, 40 / 0.006});
  const double layer =
      (0.1 + 2 * r) * (0.06 + 2 * r) * (0.04 + 2 * r) - (0.1 - 2 * r) * (0.06 - 2 * r) * (0.04 - 2 * r);
  EXPECT_NEAR(t.at("surcharge").values[3], 20 * (0.044 - 1e-3) / (2e-4 + layer), 1e-9);
  expect(t, "lateral_stress", {2, 3, 4, 5, 6, 7});
  expect(t, "axial_stress", {10, 20, 30, 40, 50, 60});
  expect(t, "strain_volumetric", {-0.0125, 0, 0.005, 0.01, 0, -0.01});
  expect(t, "strain_deviatoric", {-0.005 + 0.0125 / 3, 0, 0.01 - 0.005 / 3, 0.02 - 0.01 / 3, 0.03, 0.04 + 0.01 / 3});
}

TEST(BagLoading, ShearsAlongTheTravelOfItsPlates) {
  const io::Series t = table(run());
  // Along (0.6, -0.8) the grains hold the plate back by 6 * 0.6 + 8 * 0.8 = 10 N, the soil by 3 * 0.6 + 4 * 0.8 = 5 Pa.
  expect(t, "shear_displacement", {0, 0, 0, 0, 0, 5e-4});
  EXPECT_NEAR(t.at("plate_shear").values[5], 10 / 0.006, 1e-9);
  EXPECT_NEAR(t.at("plate_ratio").values[5], 0.25, 1e-12);
  EXPECT_NEAR(t.at("shear_stress").values[5], 5, 1e-12);
  EXPECT_TRUE(std::isnan(t.at("plate_ratio").values[0])) << "no force, no ratio";
}

TEST(BagLoading, CountsYarnsThatStandForSeveralAndThoseThatAPlaneCuts) {
  const io::Series t = table(run());
  expect(t, "tension_yarn_face", {0, 1, 2, 3, 4, 5});
  expect(t, "tension_yarn_side_around", {0, 0.5, 1, 1.5, 2, 2.5});
  EXPECT_EQ(t.at("strain_yarn_side_up").values[5], 0.03);
  // A plane across x cuts 3 spacings of each face, one across y 4, and both 2 of each side.
  EXPECT_NEAR(t.at("tension_around").values[5], (3.5 * 5 + 2 * 2.5) / 5.5, 1e-12);
}

TEST(BagLoading, BreaksWhileItsPlatesMoveAndNotWhileTheyWait) {
  // From 3 % at 4 s on, plates close at 10 %/s: 3.2 % at 4.02 s. Under a load the strain is interpolated in time.
  expect(table(run()), "first_break_strain", std::vector<double>(6, 0.032));
  const std::string slow =
      "[[stage]]\npath = \"drive\"\n[[stage.load]]\npart = \"top\"\nalong = [0, 0, -1]\nforce = 1\nspeed = 1\n";
  expect(table(run(box, geotextile + planes + preload + slow)), "first_break_strain", std::vector<double>(6, 0.0302));
  io::RunFile waiting = run();
  waiting.snapshots.back().yarns.break_time[7] = 4.4;
  expect(table(waiting), "first_break_strain", std::vector<double>(6, 0.04));
  waiting.snapshots.back().yarns.broken.assign(waiting.snapshots.back().yarns.size(), 0);
  EXPECT_TRUE(std::isnan(table(waiting).at("first_break_strain").values[5]));
}

TEST(BagLoading, StrainsCountFromTheStartWhereNothingPrecedesTheCompression) {
  expect(table(run(box, geotextile + planes + compression)), "settlement", {0, 2e-4, 6e-4, 10e-4, 14e-4, 18e-4});
  expect(table(run(box, geotextile + planes + compression + preload)), "settlement",
         {0, 2e-4, 6e-4, 10e-4, 14e-4, 18e-4});
}

TEST(BagLoading, MeasuresContainersThatThePlanDoesNot) {
  // The nodes span the box of the plan above; between surfaces r outside and inside lies its area times 2 r, and more.
  const std::string surface = "[container]\nshape = \"surface\"\nfile = \"gone.stl\"\n" + mesh;
  const analysis::LoadedBag bag = packing::loaded_bag(run(surface), "run.h5");
  EXPECT_NEAR(bag.area, 0.006, 1e-15);
  EXPECT_NEAR(bag.height, 0.04, 1e-15);
  const double area = 2 * (0.1 * 0.06 + 0.06 * 0.04 + 0.04 * 0.1);
  EXPECT_NEAR(bag.fabric_volume, 2 * r * area + 8 * std::numbers::pi / 3 * r * r * r, 1e-15);
  const std::string cushion = "[container]\nshape = \"cushion\"\nwidth = \"100 mm\"\nhalf_height = \"15 mm\"\n" + mesh;
  const analysis::LoadedBag square = packing::loaded_bag(run(cushion), "run.h5");
  EXPECT_NEAR(square.area, 0.01, 1e-15);
  EXPECT_NEAR(square.height, 0.03, 1e-15);
}

TEST(BagLoading, PathsOfStressEndWithTheRowOfTheFirstBreak) {
  const io::RunFile file = run();
  const io::Series paths = analysis::stress_paths(file.series, {}, packing::loaded_bag(file, "run.h5"));
  ASSERT_EQ(paths.rows(), 1U);
  const double slope = (64 + 144 + 320 + 400 + 576) / (64.0 + 144 + 256 + 400 + 576);
  EXPECT_EQ(paths.at("points").values[0], 5);
  EXPECT_NEAR(paths.at("slope").values[0], slope, 1e-14);
  EXPECT_NEAR(paths.at("deviation").values[0], (20 - 16 * slope) / 24, 1e-14);
  EXPECT_TRUE(std::isnan(analysis::stress_path({}, {}).slope));
}

std::string refusal(const io::RunFile& file) {
  try {
    table(file);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(BagLoading, RefusesARunByWhatItLacks) {
  const auto says = [](const io::RunFile& file, const std::string& words) {
    const std::string what = refusal(file);
    EXPECT_TRUE(what.starts_with("run.h5: ") && what.find(words) != std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos) << what;
  };
  io::RunFile packing = run(), bare = run(), unknown = run(), early = run(), sideways = run();
  packing.series = {};
  says(packing, "is a packing, not a run");
  bare.snapshots.front().yarns = {};
  says(bare, "has no geotextile");
  unknown.source.history.erase(unknown.source.history.begin());
  says(unknown, "no plan of filter-expand");
  says(run("[container]\nshape = \"none\"\n"), "lies flat and wraps no soil");
  says(run(box, geotextile + "[[plane]]\nname = \"lid\"\n" + preload + compression),
       "no plane named \"top\" (its named ones: lid)");
  sideways.snapshots.front().planes.normal[2] = {1, 0, 0};
  says(sideways, "\"bottom\" does not face the bag along z");
  std::erase_if(early.series.columns, [](const io::Column& c) { return c.name == "soil_volume"; });
  says(early, "soil_volume");
}

TEST(BagLoading, NamesItsPlatesAsItsStageDoes) {
  std::string words = geotextile + planes + preload + compression + "upper = \"lid\"\n";
  for (std::size_t at = 0; (at = words.find("\"top\"")) != std::string::npos;) words.replace(at, 5, "\"lid\"");
  io::RunFile file = run(box, words);
  for (io::Column& column : file.series.columns)
    if (const std::size_t at = column.name.find("_top_"); at != std::string::npos) column.name.replace(at, 5, "_lid_");
  expect(table(file), "settlement", {-2e-4, 0, 4e-4, 8e-4, 12e-4, 16e-4});
}

TEST(Yarns, AreAsNearTheSeamAsTheirMiddles) {
  io::Series yarns;
  analysis::put_yarns(yarns, run().snapshots.front());
  const auto value = [&](const char* name, std::size_t k) { return yarns.at(name).values[k]; };
  double most = 0;
  for (std::size_t k = 0; k < yarns.rows(); ++k) {
    // Faces of 100 x 60 mm end with the rims; 40 mm of side end with the middles of the outermost upright yarns.
    const double x = std::abs(value("position_x", k)) / 0.05, y = std::abs(value("position_y", k)) / 0.03;
    const double z = std::abs(value("position_z", k) - 0.02) / 0.01;
    EXPECT_NEAR(value("seam", k), value("family", k) == 0 ? std::max(x, y) : z, 1e-12) << k;
    most = std::max(most, value("seam", k));
  }
  EXPECT_EQ(most, 1);
}

io::RunFile shear_box() {
  io::RunFile file = run();
  file.scenario.clear();
  for (const char* name : {"lid", "left", "right", "back"})
    file.scenario += fmt::format("[[plane]]\nname = \"{}\"\npartners = \"soil\"\n", name);
  file.scenario += "[[plane]]\nname = \"frame\"\n";
  io::PlanesRecord& of = file.snapshots.front().planes;
  of.point.assign(5, Vec3::Zero());
  of.normal = {Vec3(0, 0, -1), Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, -1)};
  of.partners = {1, 1, 1, 1, 0};
  file.series = {};
  for (const char* name : {"step", "time", "stage"}) file.series.columns.push_back({name, "1", "made by hand", {0, 1}});
  for (const char* name : {"lid", "left", "right", "back", "frame"})
    for (const char axis : {'x', 'y', 'z'}) {
      const std::string part = fmt::format("{}_{}", name, axis);
      const double way = part == "left_y" || part == "right_y" ? -0.002 : 0;
      const double force = part == "left_y"    ? 50
                           : part == "right_y" ? -20
                           : part == "lid_z"   ? 40
                           : part == "back_x"  ? 7
                                               : 0;
      file.series.columns.push_back({"displacement_" + part, "m", "made by hand", {0, way}});
      file.series.columns.push_back({"force_" + part, "N", "made by hand", {0, part == "frame_z" ? 1000 : force}});
    }
  return file;
}

TEST(Interface, IsWhatTheWallsPushAlongTheirWayUnderTheLid) {
  const io::RunFile file = shear_box();
  const io::Series t = analysis::interface(file.series, analysis::shear_box(file, "run.h5"));
  expect(t, "travel", {0, 0.002});
  expect(t, "shear_force", {0, 30});
  expect(t, "normal_force", {0, 40});
  const double angle = std::atan(0.75) * 180 / std::numbers::pi;
  EXPECT_TRUE(std::isnan(t.at("friction_angle").values[0])) << "nothing presses against the lid";
  EXPECT_NEAR(t.at("friction_angle").values[1], angle, 1e-12);
  io::RunFile back = file;
  for (io::Column& column : back.series.columns)
    if (column.name.starts_with("displacement_")) column.values[1] = -column.values[1];
  const io::Series driven = analysis::interface(back.series, analysis::shear_box(back, "run.h5"));
  EXPECT_NEAR(driven.at("friction_angle").values[1], -angle, 1e-12) << "the soil drives the walls";
  EXPECT_THROW(analysis::shear_box(run(), "run.h5"), DataError) << "its planes touch nodes, too";
}

TEST(BagLoading, IsListedColumnByColumnOnThePage) {
  const std::string page = io::test::bytes_of("lib/files/FORMAT.md");
  if (page.empty()) GTEST_SKIP() << "not run in the root of the source tree";
  const std::size_t begin = page.find("## A bag between plates"), end = page.find("## Text", begin);
  ASSERT_TRUE(begin != std::string::npos);
  const std::string section = page.substr(begin, end - begin);
  const io::RunFile file = run();
  const io::RunFile sheared = shear_box();
  for (const io::Series& t : {table(file), analysis::stress_paths(file.series, {}, packing::loaded_bag(file, "run.h5")),
                              analysis::interface(sheared.series, analysis::shear_box(sheared, "run.h5"))})
    for (const io::Column& column : t.columns)
      EXPECT_NE(section.find("`" + column.name + "`"), std::string::npos) << column.name;
}

TEST(BagRuns, CountFromTheReferenceRowToTheLastWithoutABrokenYarn) {
  const gws::BagSeries bag = gws::bag_of_run(run(), "run.h5", std::nullopt);
  EXPECT_EQ(bag.size(), 4U) << "rows 2 to 5";
  EXPECT_EQ(bag.row.front(), 1U);
  EXPECT_NEAR(bag.strain_axial.back(), 0.03, 1e-12);
  EXPECT_NEAR(bag.strain_volumetric[1], 0.005, 1e-12);
  // 40 N at 10 % and yarns of 25 and 20 mm: their mean on the faces is (16 * 25 + 15 * 20) / 31.
  EXPECT_NEAR(bag.stiffness, 2 * 400 / (0.7 / 31), 1e-6 * bag.stiffness);
  EXPECT_NE(bag.note.find("rows 2 to 5 of 6, up to the first broken yarn"), std::string::npos) << bag.note;
  gws::Geotextile given;
  given.name = "X", given.stiffness = 5e4;
  EXPECT_EQ(gws::bag_of_run(run(), "run.h5", given).stiffness, 5e4);
}

TEST(BagRuns, TakeTheStatedStiffnessOfANamedGeotextileWhoseFileIsTheSame) {
  const auto named = [](const std::string& curve, const std::string& multiple = "4.5") {
    return run(box, "[[geotextile]]\ncurve = \"" + curve + "\"\nmultiple = " + multiple + "\n" + planes + preload +
                        compression);
  };
  const auto refused = [](const io::RunFile& file) -> std::string {
    try {
      gws::bag_of_run(file, "run.h5", std::nullopt);
    } catch (const DataError& error) {
      return error.what();
    }
    return "";
  };
  io::RunFile file = named("3PP");
  EXPECT_NE(refused(file).find("3PP is not the one of data/geotextiles any more"), std::string::npos);
  file.source.history.back().inputs.push_back(
      {"geotextile", io::sha256(io::test::bytes_of("data/geotextiles/PP.toml")), -1});
  EXPECT_EQ(gws::bag_of_run(file, "run.h5", std::nullopt).stiffness, 3 * 232e3);
  io::RunFile thin = named("3PP", "2");
  thin.source = file.source;
  EXPECT_NE(refused(thin).find("with multiple = 2, and its fabric has 0.44 times the strength of 3PP"),
            std::string::npos);
  EXPECT_NE(refused(named("my/yarn.toml")).find("give --geotextile FILE"), std::string::npos);
  io::RunFile soon = named("PP");
  soon.series.columns.back().values.resize(6);
  for (io::Column& column : soon.series.columns)
    if (column.name == "broken_yarns") column.values = {0, 0, 0, 1, 1, 1};
  soon.source = file.source;
  EXPECT_NE(refused(soon).find("2 rows from the reference row up to the first broken yarn; at least 3"),
            std::string::npos);
}

}  // namespace
}  // namespace soilweave
