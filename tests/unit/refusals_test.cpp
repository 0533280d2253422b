// Numbers that do not fit together are refused before anything moves, each with its reason.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "analysis/doubts/plane_doubts.h"
#include "calibration/ensemble.h"
#include "core/error.h"
#include "core/text/text.h"
#include "dem/engine/described.h"
#include "dem/run/forecast.h"
#include "dem/run/prepare.h"
#include "dem/run/run.h"
#include "fem/run/scenario.h"
#include "support/assembly.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::dem {
namespace {

using analysis::test::simple_cubic;
using io::test::expect_error;

const std::string contact =
    "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = 1e9\npoisson_ratio = 0.3\nfriction_angle = 30\n";
const std::string triaxial =
    "[[stage]]\npath = \"triaxial\"\nconfining_pressure = 1e5\naxial_strain = 0.004\nincrement = 0.001\n";
const std::string pressed = "[[stage]]\npath = \"isotropic\"\npressure = 1e5\n";

Scenario scenario(const std::string& text) { return read_scenario(contact + text, "test.toml", {}); }

io::Snapshot grains() { return simple_cubic(3, Vec3(1, 1, 1)); }

io::Snapshot with_yarn(io::Snapshot state) {
  io::YarnsRecord& y = state.yarns;
  y.nodes = {{0, 1}}, y.fabric = {0}, y.geotextile_id = {0}, y.family = {0}, y.rest_length = {1};
  y.largest_strain = {0}, y.tension = {0}, y.broken = {0}, y.break_time = {0}, y.break_position = {Vec3::Zero()};
  return state;
}

TEST(Refused, MaterialsThatNothingDescribes) {
  const Model model = scenario(pressed).model;
  for (const std::int32_t id : {1, -1, 2000000000}) {
    io::Snapshot state = grains();
    state.grains.material_id[5] = id;
    // Every tool that steps grains makes a Simulation of them.
    expect_error<DataError>([&] { Simulation(state, model, {}); }, "add [[material]] tables");
    expect_error<DataError>([&] { prepare(state, scenario(pressed)); }, "add [[material]] tables");
    io::Snapshot planes = grains();
    planes.planes = {{Vec3(0, 0, -9)}, {Vec3::UnitZ()}, {Vec3::Zero()}, {id}, {0}};
    expect_error<DataError>([&] { described(planes, model); }, "planes of material");
  }
  expect_error<DataError>([&] { described(with_yarn(grains()), model); }, "add [[geotextile]] tables");
  EXPECT_NO_THROW(described(grains(), model));
}

TEST(Refused, YarnsThroughAPeriodicFace) {
  const Scenario plan = scenario("[[geotextile]]\nyarn_strain = [0.1]\nyarn_tension = [10]\n" + pressed);
  EXPECT_NO_THROW(prepare(with_yarn(grains()), plan));
  // The third grain of a row is nearer to the image of the first than to the first itself.
  io::Snapshot through = with_yarn(grains());
  through.yarns.nodes = {{0, 2}};
  expect_error<DataError>([&] { prepare(through, plan); }, "yarn 0 of 1 m passes through the periodic face along x");
  through.cell.periodic[0] = false;
  EXPECT_NO_THROW(described(through, plan.model));
}

TEST(Refused, GravityWithNothingToPressOn) {
  const io::Snapshot closed = grains();
  expect_error<DataError>([&] { demand_footing(closed, Vec3(0, 0, -9.81)); }, "fall for ever");
  EXPECT_NO_THROW(demand_footing(closed, Vec3::Zero()));
  io::Snapshot open = closed;
  open.cell.periodic[2] = false;
  expect_error<DataError>([&] { demand_footing(open, Vec3(0, 0, -9.81)); }, "no plane stops the grains");
  expect_error<DataError>([&] { demand_footing(open, Vec3(1, 0, 0)); }, "along x");
  EXPECT_NO_THROW(demand_footing(open, Vec3(1, 0, -9.81), true));
  io::Snapshot floor = closed;
  floor.planes = {{Vec3(0, 0, -9)}, {Vec3::UnitZ()}, {Vec3::Zero()}, {0}, {0}};
  EXPECT_NO_THROW(demand_footing(floor, Vec3(0, 0, -9.81)));
  expect_error<DataError>([&] { demand_footing(floor, Vec3(0, 0, 9.81)); }, "fall for ever");
}

TEST(Refused, ATimeStepOverTheStableOne) {
  io::Snapshot state = grains();
  for (std::size_t i = 0; i < state.grains.size(); ++i) state.grains.position[i] *= 0.999;
  state.cell.matrix *= 0.999;
  state.contacts = {};
  Simulation simulation(state, scenario(pressed).model, {});
  const double limit = simulation.stability_limit();
  const std::string over = "[numerics]\ntime_step = " + number_text(1.1 * limit) + "\n";
  const Scenario plan = scenario(over + pressed);
  expect_error<DataError>([&] { forecast(state, plan); }, "is over the stable one");
  expect_error<DataError>([&] { run(state, plan, {}); }, "or leave it out");
  const Scenario under = scenario("[numerics]\ntime_step = " + number_text(0.9 * limit) + "\n" + pressed);
  EXPECT_NO_THROW(demand_stable(simulation, under.numerics));
}

TEST(Refused, StrainsThatMeetNoStation) {
  const auto recorded = [](const std::string& strains, const std::string& stages) {
    return scenario("[record]\nsnapshots = \"list\"\nstrains = " + strains + "\n" + stages);
  };
  const std::string from_zero = pressed + triaxial + "reset_strain = true\n";
  expect_error<DataError>([&] { prepare(grains(), recorded("[0.001, 0.0015, -1]", from_zero)); },
                          "record.strains: 0.0015 (the nearest is 0.001), -1 (the nearest is 0.001): no station");
  EXPECT_NO_THROW(prepare(grains(), recorded("[0.001, 0.004]", from_zero)));
  EXPECT_NO_THROW(prepare(grains(), recorded("[0.004, 0.006]", triaxial + triaxial.substr(0, triaxial.find("incre")) +
                                                                   "increment = 0.002\n")));
  // Where a pressing stage ends is known only once it has been pressed, so that strains count from the start of a
  // stage.
  EXPECT_NO_THROW(prepare(grains(), recorded("[0.002]", pressed + triaxial)));
  expect_error<DataError>([&] { prepare(grains(), recorded("[0.0123]", pressed + triaxial)); },
                          "record.strains: 0.0123 (the nearest is 0.004): no station");
  expect_error<DataError>([&] { prepare(grains(), recorded("[0.01]", pressed)); }, "leave the list out");
  expect_error<DataError>([&] { recorded("[]", from_zero); }, "strains: is an empty list");
}

const std::string plate_material = "[[material]]\nyoung_modulus = 1e9\npoisson_ratio = 0.3\nfriction_angle = 30\n";

std::string plane(const std::string& name, const std::string& normal, int material = 1) {
  return "[[plane]]\nname = \"" + name + "\"\npoint = \"touch\"\nnormal = " + normal +
         "\nmaterial = " + std::to_string(material) + "\n";
}

// Plates below and above the grains, along z.
std::string plates(int material = 1) {
  return plate_material + plane("bottom", "[0, 0, 1]", material) + plane("top", "[0, 0, -1]", material);
}

io::Snapshot between_plates() {
  io::Snapshot state = grains();
  state.cell.periodic = {false, false, false};
  return state;
}

TEST(Refused, AFrictionOfPlatesThatOthersShareOrNobodyHas) {
  const std::string smooth = "[[stage]]\nname = \"s\"\npath = \"free\"\nplate_friction_angle = 0\n";
  EXPECT_NO_THROW(prepare(between_plates(), scenario(plates() + smooth)));
  expect_error<DataError>([&] { prepare(between_plates(), scenario(plates(0) + smooth)); },
                          "stage \"s\": plate_friction_angle would change the friction among grains too: planes share "
                          "material 0 with the grains");
  expect_error<DataError>([&] { prepare(between_plates(), scenario(plate_material + smooth)); },
                          "plate_friction_angle is given, but there are no planes");
  // Planes of the input are planes too.
  io::Snapshot inherited = between_plates();
  inherited.planes = {{Vec3(0, 0, -9)}, {Vec3::UnitZ()}, {Vec3::Zero()}, {1}, {0}};
  EXPECT_NO_THROW(prepare(inherited, scenario(plate_material + smooth)));
}

TEST(Refused, CompressionBetweenPlatesThatDoNotFaceEachOther) {
  const auto compressed = [](const std::string& keys) {
    return "[[stage]]\nname = \"c\"\npath = \"uniaxial\"\nheight = 3\nstrain = 0.01\n" + keys;
  };
  EXPECT_NO_THROW(prepare(between_plates(), scenario(plates() + compressed(""))));
  expect_error<DataError>(
      [&] { prepare(between_plates(), scenario(plates() + compressed("lower = \"top\"\nupper = \"bottom\"\n"))); },
      "stage \"c\" moves \"top\" up and \"bottom\" down, but these planes do not face each other along z");
  const std::string sideways = plate_material + plane("bottom", "[1, 0, 0]") + plane("top", "[-1, 0, 0]");
  expect_error<DataError>([&] { prepare(between_plates(), scenario(sideways + compressed(""))); }, "along z");
  expect_error<DataError>(
      [&] { prepare(between_plates(), scenario(plates() + compressed("moving = \"upper\"\nlower = \"floor\"\n"))); },
      "no [[plane]] or [[clamp]] is called \"floor\"");
  const Scenario tenfold = scenario(plates() + "[[stage]]\npath = \"uniaxial\"\nheight = 30\nstrain = 0.01\n");
  ASSERT_EQ(plate_doubts(prepare(between_plates(), tenfold), tenfold).size(), 1U);
  EXPECT_EQ(plate_doubts(prepare(between_plates(), tenfold), tenfold)[0].key, "height");
  const Scenario fit = scenario(plates() + compressed(""));
  EXPECT_TRUE(plate_doubts(prepare(between_plates(), fit), fit).empty());
}

// The lid of an earlier run presses on the uppermost grains by 0.005.
TEST(Doubted, PlanesThatStandElsewhereThanTheInputsOnWhichGrainsPress) {
  io::Snapshot before = between_plates();
  before.planes = {{Vec3(0, 0, 2.495)}, {-Vec3::UnitZ()}, {Vec3::Zero()}, {0}, {0}};
  const auto said = [&](const std::string& point) {
    const Scenario plan =
        scenario("[[plane]]\nname = \"top\"\nnormal = [0, 0, -1]\npoint = " + point + "\n[[stage]]\npath = \"free\"\n");
    const std::vector<Doubt> doubts = analysis::moved_plane_doubts(before, prepare(before, plan), plan);
    return doubts.empty() ? "" : doubts[0].key + ": " + doubts[0].sentence;
  };
  EXPECT_EQ(said("[0, 0, 3]"), "") << "nothing pressed on it";
  for (const std::int32_t grain : {8, 17, 26}) {
    io::ContactsRecord lid = before.contacts;
    before.contacts.append(lid, 0);
    before.contacts.bodies.back() = {grain, -1};
  }
  EXPECT_EQ(
      said("[0, 0, 3]"),
      "moved-plane-0: plane \"top\" starts 0.505 m behind its place at the end of the input, where grains press on "
      "it: it lets them go; give it point = [0, 0, 2.495]");
  EXPECT_NE(said("[0, 0, 2.493]").find("starts 0.002 m ahead of its place"), std::string::npos)
      << said("[0, 0, 2.493]");
  EXPECT_EQ(said("[7, 0, 2.495]"), "") << "a point elsewhere on the same plane";
  EXPECT_EQ(said("\"touch\""), "") << "a plane that is asked to touch";
}

TEST(Refused, FacingPlanesThatMeet) {
  const std::string planes =
      "[[plane]]\nname = \"bottom\"\npoint = [0, 0, -0.5]\nnormal = [0, 0, 1]\n"
      "[[plane]]\nname = \"top\"\npoint = [0, 0, 2.5]\nnormal = [0, 0, -1]\n";
  const auto moved = [&](const std::string& part, const std::string& along, const std::string& distance) {
    return "[[stage]]\npath = \"drive\"\n[[stage.move]]\npart = \"" + part + "\"\nalong = [0, 0, " + along +
           "]\ndistance = " + distance + "\nspeed = 1\n";
  };
  const auto demand = [&](const std::string& stages) {  // the grains are 1 m wide
    const Scenario plan = scenario(planes + stages);
    io::Snapshot state = grains();
    state.planes = plan.planes;
    demand_apart(state, plan);
  };
  const std::string meets = "3 m apart at the start, to a distance of 0.9 m at station 1, and the";
  expect_error<DataError>([&] { demand(moved("top", "-1", "2.1")); }, meets);
  expect_error<DataError>([&] { demand(moved("bottom", "1", "2.1")); }, meets);
  expect_error<DataError>([&] { demand(moved("top", "-1", "1") + moved("bottom", "1", "1.1")); }, meets);
  expect_error<DataError>([&] { demand(moved("top", "1", "-5")); }, "to a distance of -2 m");
  EXPECT_NO_THROW(demand(moved("top", "-1", "1.9")));
  EXPECT_NO_THROW(demand(moved("top", "-1", "1") + moved("top", "1", "1") + moved("top", "-1", "1.9")));
}

TEST(Refused, ADirectionOutOfRangeIsOneMistake) {
  const std::string planes = "[[plane]]\nname = \"top\"\npoint = [0, 0, 0]\nnormal = [0, 0, -2]\n";
  try {
    scenario(planes +
             "[[stage]]\npath = \"drive\"\n[[stage.move]]\npart = \"top\"\nalong = [0, 0, -2]\ndistance = 1\n"
             "speed = 1\n");
    FAIL();
  } catch (const DataError& error) {
    EXPECT_EQ(std::string(error.what()).find("is zero"), std::string::npos) << error.what();
  }
}

TEST(Refused, ZInThePlaneOfDisks) {
  io::Snapshot disks = between_plates();
  disks.grains.dimension = 2;
  for (Vec3& x : disks.grains.position) x.z() = 0;
  const std::string held = "[[stage]]\npath = \"free\"\n[stage.z]\nstrain = 0\n";
  const std::string floor = "[[plane]]\npoint = [0, -9, 0]\nnormal = [0, 1, 0]\n";
  EXPECT_NO_THROW(prepare(disks, scenario("[numerics]\ngravity = [0, -9.81, 0]\n" + floor + held)));
  expect_error<DataError>([&] { prepare(disks, scenario("[numerics]\ngravity = [0, 0, -9.81]\n" + held)); },
                          "numerics.gravity acts along z, and the packing is of disks");
  expect_error<DataError>([&] { prepare(disks, scenario(held.substr(0, held.size() - 2) + "0.1\n")); },
                          "stage \"free\" loads along z");
  expect_error<DataError>(
      [&] { prepare(disks, scenario("[[plane]]\npoint = [0, -9, 0]\nnormal = [0, 1, 1]\n" + held)); },
      "plane 0: its normal has a part along z");
  const std::string up =
      "[[stage]]\npath = \"drive\"\n[[stage.move]]\npart = \"b\"\nalong = [0, 0, 1]\ndistance = 1\n"
      "speed = 1\n";
  expect_error<DataError>([&] { prepare(disks, scenario(plate_material + plane("b", "[0, 1, 0]") + up)); },
                          "stage \"drive\" loads along z");
}

TEST(Refused, OrdersThatOnePlateCannotFollow) {
  const auto order = [](const std::string& kind, const std::string& along, double value) {
    const bool load = kind == "load";
    return "[[stage." + kind + "]]\npart = \"top\"\nalong = " + along + "\n" + (load ? "force" : "distance") + " = " +
           number_text(value) + "\nspeed = 0.1\n";
  };
  const std::string drive = plates() + "[[stage]]\npath = \"drive\"\n", down = "[0, 0, -1]", aside = "[1, 0, 0]";
  EXPECT_NO_THROW(scenario(drive + order("load", down, 1) + order("move", aside, 1)));
  EXPECT_NO_THROW(scenario(drive + order("move", down, 1) + order("move", aside, 1)));
  expect_error<DataError>([&] { scenario(drive + order("load", down, 1) + order("move", "[0, 0, 1]", 1)); },
                          "moves \"top\" along its load");
  expect_error<DataError>([&] { scenario(drive + order("move", down, 1) + order("move", down, 2)); },
                          "moves \"top\" twice along one direction");
  expect_error<DataError>([&] { scenario(drive + order("load", down, 1) + order("load", aside, 2)); },
                          "loads \"top\" twice");
  expect_error<DataError>([&] { scenario(plane("top", down + "\nvelocity = [0, 0, -1]", 0) + pressed); },
                          "velocity: is given beside a name");
  const Scenario pulled = scenario(drive + order("load", "[0, 0, 1]", 1));
  ASSERT_EQ(plate_doubts(prepare(between_plates(), pulled), pulled).size(), 1U);
  EXPECT_EQ(plate_doubts(prepare(between_plates(), pulled), pulled)[0].key, "pull");
}

TEST(Refused, NamesThatAreEmptyOrTaken) {
  const std::string clamp = "[[clamp]]\nname = \"top\"\nlow = [0, 0, 0]\nhigh = [1, 1, 1]\n";
  const std::string top = plane("top", "[0, 0, -1]", 0), held = "[[stage]]\npath = \"free\"\n";
  EXPECT_NO_THROW(scenario(top + held));
  for (const std::string& both : {top + top, top + clamp})
    expect_error<DataError>([&] { scenario(both + held); }, "\"top\" is another plane's or clamp's already");
  expect_error<DataError>([&] { scenario(plane("", "[0, 0, -1]", 0) + held); }, "name: is empty");
}

TEST(Refused, KeysThatTakeEachOthersPlace) {
  expect_error<DataError>([&] { scenario(triaxial.substr(0, triaxial.find("incre")) + "stations = [0.001]\n"); },
                          "axial_strain: is given beside stations: leave one of the two out");
  expect_error<DataError>([&] { scenario("[[stage]]\npath = \"free\"\n[stage.x]\nstress = 1e5\nstrain = 0.1\n"); },
                          "strain: is given beside stress: leave one of the two out");
  expect_error<DataError>([&] { scenario("[[geotextile]]\ncurve = \"PE\"\nyarn_strain = [0.1]\n" + pressed); },
                          "yarn_strain: is given beside curve: leave one of the two out");
}

TEST(Refused, ALimitOfStepsThatEndsTheRunIsForecast) {
  const Scenario plan = scenario("[equilibrium]\nsteps = 100\n" + triaxial);
  EXPECT_NE(forecast(grains(), plan).text().find("equilibrium.steps = 100 would end the run"), std::string::npos);
}

TEST(Prepare, DensityOfGrainsLeavesNodesAlone) {
  const std::string curve = "[[geotextile]]\nyarn_strain = [0.1]\nyarn_tension = [10]\n";
  const io::Snapshot state = with_yarn(grains());  // grains 0 and 1 are nodes
  const io::Snapshot heavy = prepare(state, scenario(curve + "[grains]\ndensity = 2650\n" + pressed));
  EXPECT_EQ(heavy.grains.mass[1], state.grains.mass[1]);
  EXPECT_NE(heavy.grains.mass[2], state.grains.mass[2]);
}

TEST(Refused, MoreStationsThanAreRecorded) {
  expect_error<DataError>(
      [] { scenario(pressed + triaxial.substr(0, triaxial.find("incre")) + "increment = 1e-12\n"); },
      "increment: makes 4e+09 stations, and at most 1000000 are recorded: give at least 4e-09");
  const std::string plates =
      "[[plane]]\nname = \"bottom\"\npoint = [0, 0, 0]\nnormal = [0, 0, 1]\n"
      "[[plane]]\nname = \"top\"\npoint = [0, 0, 1]\nnormal = [0, 0, -1]\n";
  const std::string loaded = "[[stage]]\npath = \"uniaxial\"\nheight = 1\nstrain = 0.01\nincrement = 1e-12\n";
  expect_error<DataError>([&] { scenario(plates + loaded); }, "increment: makes 1e+10 stations");
}

TEST(Refused, StagesWithoutContent) {
  expect_error<DataError>([] { read_scenario("stage = []\n" + contact, "test.toml", {}); },
                          "stage: is not a list of tables");
  expect_error<DataError>([] { scenario(""); }, "stage: is missing");
  for (const std::string path : {"triaxial\"\nconfining_pressure = 1e5\nstations = []", "k0\"\naxial_stress = []",
                                 "constant-volume\"\nstations = []"})
    expect_error<DataError>([&] { scenario("[[stage]]\npath = \"" + path + "\n"); }, "has no stations");
}

TEST(Plane, ThatIsToTouchTouchesTheOutermostGrain) {
  io::Snapshot state = grains();
  state.cell.periodic = {false, false, false};
  state.grains.position[4].z() -= 0.125;
  const std::string held = "[[stage]]\npath = \"free\"\n";
  const Scenario plan = scenario(
      "[[plane]]\nname = \"floor\"\npoint = \"touch\"\nnormal = [0, 0, 1]\n"
      "[[plane]]\nname = \"top\"\npoint = \"touch\"\nnormal = [0, 0, -1]\n" +
      held);
  const io::Snapshot ready = prepare(state, plan);
  ASSERT_EQ(ready.planes.point.size(), 2U);
  EXPECT_NEAR(ready.planes.point[0].z(), -0.625, 1e-12);
  EXPECT_NEAR(ready.planes.point[1].z(), 2.5, 1e-12);
  expect_error<DataError>(
      [&] {
        prepare(state, scenario("[[plane]]\npoint = \"touch\"\nnormal = [0, 0, 1]\n"
                                "partners = \"geotextile\"\n" +
                                held));
      },
      "no grain is its partner");
  expect_error<DataError>([&] { scenario("[[plane]]\npoint = \"tuch\"\nnormal = [0, 0, 1]\n" + held); },
                          "is neither a vector nor \"touch\"");
}

TEST(Plane, InsideTheGrainsNamesTheDeepestAndHowDeep) {
  io::Snapshot state = grains();
  state.cell.periodic = {false, false, false};
  state.grains.position[4].z() -= 0.125;
  const std::string start = "[[plane]]\nname = \"floor\"\nnormal = [0, 0, 1]\npoint = ",
                    held = "\n[[stage]]\npath = \"free\"\n";
  expect_error<DataError>([&] { prepare(state, scenario(start + "[0, 0, -0.45]" + held)); },
                          "9 of them reach beyond it, the deepest, grain 4, by 0.175 m");
  // The remedy works.
  EXPECT_NO_THROW(prepare(state, scenario(start + "[0, 0, -0.625]" + held)));
}

}  // namespace
}  // namespace soilweave::dem

namespace soilweave {
namespace {

TEST(Refused, GravityAndFractionsOfPointsInTwoScales) {
  const std::string text =
      "[mesh]\nwidth = 1\nheight = 1\ncolumns = 1\nrows = 1\n[soil]\nmaterial = \"grains\"\n"
      "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = 1e9\npoisson_ratio = 0.3\nfriction_angle = 30\n"
      "[[support]]\non = \"all\"\nx = 0\n[time]\nduration = 1\noutput_interval = 1\n";
  const auto read = [&](const std::string& more) { fem::read_scenario(text + more, "test.toml", {}, std::nullopt); };
  EXPECT_NO_THROW(read(""));
  EXPECT_NO_THROW(read("[numerics]\ngravity = [0, 0, 0]\n"));
  io::test::expect_error<DataError>([&] { read("[numerics]\ngravity = [0, -9.81, 0]\n"); },
                                    "numerics.gravity: has nowhere");
  io::test::expect_error<DataError>([&] { read("[record]\npoints = [1.5]\n"); }, "1.5 is no number of a point");
  io::test::expect_error<DataError>(
      [&] { fem::read_scenario(text, "test.toml", {"time.output_interval=1e-12"}, std::nullopt); },
      "time.output_interval: makes 1e+12 outputs, and at most 1000000 are recorded");
}

TEST(Refused, WeightsThatAreNone) {
  const io::test::Folder folder;
  const auto read = [&](const std::string& weights) {
    io::test::put_bytes(folder / "sets.tsv", "id\ta\tweight\n" + weights);
    std::vector<io::Source> sources;
    calibration::read_ensemble(folder / "sets.tsv", {}, sources);
  };
  EXPECT_NO_THROW(read("0\t1\t0.25\n1\t2\t0.75\n"));
  io::test::expect_error<DataError>([&] { read("0\t1\t1.5\n1\t2\t-0.5\n"); }, "row 2: -0.5 is negative");
  // Assimilation may return all zeros; its file must be readable for another error model.
  EXPECT_NO_THROW(read("0\t1\t0\n1\t2\t0\n"));
  io::test::expect_error<DataError>([&] { read("0\t1\tnan\n1\t2\t1\n"); }, "weight: holds nan");
}

}  // namespace
}  // namespace soilweave
