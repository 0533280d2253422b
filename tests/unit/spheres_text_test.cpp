// Sphere packings as text: YADE's form, comma-separated tables, and back.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/spheres_text.h"

#include <gtest/gtest.h>

#include <numbers>
#include <optional>

#include "core/error.h"
#include "support/reference.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::io {
namespace {

using test::expect_error;

class Spheres : public testing::Test {
 protected:
  ImportedSpheres import(const std::string& text, std::optional<int> dimension = {},
                         const std::optional<CellRecord>& cell = {}) {
    test::put_bytes(path, text);
    return import_spheres(path, {2650, cell, dimension});
  }
  Snapshot read(const std::string& text, const std::optional<CellRecord>& cell = {}) {
    return import(text, {}, cell).state;
  }
  void refuses(const std::string& text, const std::string& words, std::optional<int> dimension = {}) {
    expect_error<DataError>([&] { import(text, dimension); }, path.string() + ": ");
    expect_error<DataError>([&] { import(text, dimension); }, words);
  }
  /// Expects that the text holds (1, 2, 3) with a radius of 0.25 and (4, 5, 6) with one of 0.5, in m.
  void reads(const std::string& text) {
    const GrainsRecord g = read(text).grains;
    ASSERT_EQ(g.size(), 2U) << text;
    EXPECT_EQ(g.position[0], Vec3(1, 2, 3)) << text;
    EXPECT_EQ(g.position[1], Vec3(4, 5, 6)) << text;
    EXPECT_EQ(g.radius, (std::vector<double>{0.25, 0.5})) << text;
  }
  test::Folder folder;
  std::filesystem::path path = folder / "spheres.txt";
};

TEST_F(Spheres, PeriodicTextGivesCellAndMasses) {
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

TEST_F(Spheres, TableWithAHeaderTakesTheCallersCell) {
  CellRecord cell;
  cell.matrix = Mat3::Identity() * 0.5;
  const Snapshot state = read("x_m,y_m,z_m,radius_m\n0.1,0.2,0.3,0.05\n", cell);
  EXPECT_EQ(state.grains.position[0], Vec3(0.1, 0.2, 0.3));
  EXPECT_EQ(state.cell.matrix, cell.matrix);
  EXPECT_TRUE(state.cell.periodic[2]);
}

TEST_F(Spheres, WithoutACellNothingIsPeriodic) {
  const Snapshot state = read("0.1 0.2 -0.3 0.05\n");
  EXPECT_EQ(state.cell.periodic, (std::array<bool, 3>{false, false, false}));
  EXPECT_NEAR(state.cell.matrix(0, 0), 0.15, 1e-15);
  EXPECT_NEAR(state.cell.matrix(2, 2), 0.35, 1e-15);
}

TEST_F(Spheres, ErrorsTellLineAndColumn) {
  refuses("0 0 0 1\n0 0 x 1\n", "line 2, column 3: \"x\" is no finite number");
  refuses("0 0 0\n", "line 1: 3 numbers; without a header a line is x y z r (disks: x y r, with --dimension 2)");
  refuses("0 0 0 1\n0 0 0\n", "line 2, column 4: 3 values where 4 belong, separated by blanks");
  refuses("0 0 0 1\n0 0 0 1 2\n", "line 2, column 5: 5 values where 4 belong");
  refuses("0 0 0 0\n", "line 1, column 4: a radius that is not positive");
  refuses("0 0 nan 1\n", "line 1, column 3: \"nan\" is no finite number");
  refuses("##PERIODIC:: 1\n0 0 0 0.1\n", "line 1, column 1: three cell lengths");
  refuses("##PERIODIC:: 1 -1 1\n0 0 0 0.1\n", "line 1, column 2: a cell length that is not positive");
  refuses("# nothing\n", "holds no spheres");
  refuses("##PERIODIC:: 1 1 1\n0 0 0 0.3\n", "the largest grain");
  expect_error<DataError>([&] { import_spheres(path, {-1, {}, {}}); }, "a density that is not positive");
  expect_error<MissingInput>([&] { import_spheres(folder / "none", {2650, {}, {}}); }, "no such file");
}

TEST_F(Spheres, FirstLinesAreNumbersHeadersOrErrors) {
  refuses("nan 1 1 0.5\n3 1 1 0.5\n", "line 1, column 1: \"nan\" is no finite number");
  refuses("1.0D+00 1 1 0.5\n3 1 1 0.5\n", "line 1, column 1: \"1.0D+00\" is no finite number: write 1.0e+00");
  refuses("##PERIODIC:: 4 4 4\n1.0O 1 1 0.5\n", "line 2, column 1: \"1.0O\" is no finite number");
  refuses("1e999 1 1 0.5\n", "line 1, column 1: \"1e999\" is no finite number: it is beyond the range");
  refuses("spheres of the packing\n1 1 1 0.5\n", "line 1: neither numbers nor a header of x y z r: no column x among");
  refuses("x y z\n1 1 1\n", "no column r, radius or diameter among x, y, z");
  refuses("x y z r\nx y z r\n1 1 1 1\n", "line 2, column 1: \"x\" is no finite number");
  refuses("x y z r d\n1 1 1 1 2\n", "columns r and d say the same: leave one of them out");
  refuses("1 1 1 0.5 7\n", "line 1: 5 numbers; without a header");
  refuses("x,y,z,r,\n1,1,1,0.5,7\n", "column 5 has no name");
}

TEST_F(Spheres, ColumnsGoByTheirNames) {
  reads("x y z r\n1 2 3 0.25\n4 5 6 0.5\n");
  reads("R\tZ\tY\tX\n0.25\t3\t2\t1\n0.5\t6\t5\t4\n");
  reads("x\ty\tz\tr\tmass [g]\n1\t2\t3\t0.25\t\n4\t5\t6\t0.5\t7\n");
  reads("id x y z diameter type\n7 1 2 3 0.5 A\n8 4 5 6 1 B\n");
  reads("x [mm] y [mm] z [mm] Radius [mm]\n1000 2000 3000 250\n4000 5000 6000 500\n");
  reads("x (mm);y (mm);z (mm);d (mm)\n1000;2000;3000;500\n4000;5000;6000;1000\n");
  reads("x_cm,y_cm,z_cm,radius_cm\n100,200,300,25\n400,500,600,50\n");
  reads("\"radius\",\"Points:0\",\"Points:1\",\"Points:2\"\n0.25,1,2,3\n0.5,4,5,6\n");
  reads("\xef\xbb\xbfx,y,z,r\r\n1, 2, 3, 0.25\r\n4, 5, 6, 0.5");
  reads("1\u00a02\u202f3 0.25\r4 5 6 0.5\r");
  reads("#format x_y_z_r\n1 2 3 0.25\n4 5 6 0.5\n");
  reads("#format id_x_y_z_r_matId\n0\t1\t2\t3\t0.25\t0\n1\t4\t5\t6\t0.5\t0\n");
  reads("# id x y z r\n0 1 2 3 0.25\n1 4 5 6 0.5\n");
  reads("# r x y z\n0.25 1 2 3\n0.5 4 5 6\n");
  reads("# packing of x and y\n1 2 3 0.25\n4 5 6 0.5\n");
  refuses("#format x_y_z_r_attrs\n1 1 1 1 1\n", "line 1: the #format line has \"attrs\", which is unknown");
  refuses("x [mm] y [mm] z [mm] r\n1 1 1 1\n", "column x is in mm, column r in no unit: write one unit");
  refuses("x [KM] y [KM] z [KM] r [KM]\n1 1 1 1\n", "'KM' is not a known unit; did you mean 'km'?");
  const ImportedSpheres left = import("id x y z r matId\n0 1 2 3 0.25 7\n");
  ASSERT_EQ(left.notes.size(), 1U);
  EXPECT_NE(left.notes[0].find("columns left out: id, matId"), std::string::npos) << left.notes[0];
  EXPECT_TRUE(import("x y z r\n1 2 3 0.25\n").notes.empty());
}

TEST_F(Spheres, CommentsAboveTheGrainsAreObeyedOrRefused) {
  reads("# Particle data: x y z d\n1 2 3 0.5\n4 5 6 1\n");
  reads("# columns: x, y, z, diameter\n1 2 3 0.5\n4 5 6 1\n");
  reads("# x [mm] y [mm] z [mm] d [mm]\n# made by hand\n1000 2000 3000 500\n4000 5000 6000 1000\n");
  reads("# units: mm\nx y z r\n1000 2000 3000 250\n4000 5000 6000 500\n");
  reads("# all lengths in mm\n1000 2000 3000 250\n4000 5000 6000 500\n");
  reads("# resolution in um\nx [mm] y [mm] z [mm] r [mm]\n1000 2000 3000 250\n4000 5000 6000 500\n");
  reads("# mean radius 375 mm, 2 grains in all\n1 2 3 0.25\n4 5 6 0.5\n");
  const std::string row = "\n1 2 3 0.25\n";
  refuses("# x y z r [mm]" + row, "line 1: columns in a comment that is not understood: column x is in no unit");
  refuses("# x y z diameter (mm)" + row, "column diameter in mm: write one unit");
  refuses("# columns: x, y, z, diameter (all in mm)" + row, "line 1: columns in a comment that is not understood");
  refuses("# made by hand\n#x y z radius mm\n" + row, "line 2: the comment names 5 columns, and lines have 4");
  refuses("# 9\n# id x y z r\n# 1" + row, "line 2: the comment names 5 columns");
  refuses("##PERIODIC:: 4 4 4\n# id x y r" + row, "line 2: a comment that names no column z");
  refuses("# x, y, z, diameter (all in mm)\nx y z d" + row, "line 1: whether lengths are in mm is not clear here");
  refuses("# resolution in mm" + row, "line 1: whether lengths are in mm is not clear here");
  refuses("# units: mm\nx [m] y [m] z [m] r [m]" + row, "line 1: the comment gives lengths in mm");
  refuses("#format x_y_z_r\n#x_mm y_mm z_mm d_mm" + row, "line 2: the comment names other columns or units");
}

TEST_F(Spheres, CommentsGiveUnitsThatAreKnownOrAreRefused) {
  const std::string row = "\n1000 2000 3000 250\n4000 5000 6000 500\n", metres = "\n1 2 3 0.25\n4 5 6 0.5\n";
  for (const char* said : {"# [mm]", "# mm", "# unit=mm", "# x/mm y/mm z/mm r/mm"}) reads(said + row);
  for (const char* said : {"# units: SI", "# all lengths in metres", "# d50 = 375 mm", "# sieves of 250 to 500 mm",
                           "# packing of a unit test"})
    reads(said + metres);
  refuses("# units: millimeter" + row,
          "line 1: the comment gives a unit of length: 'millimeter' is not a known unit; did you mean 'mm'?");
  refuses("# UNITS: MM" + row, "did you mean 'mm'?");
  refuses("# units: cgs" + row, "'cgs' is not a known unit");
  refuses("# all lengths in centimetres" + row, "did you mean 'cm'?");
  refuses("# lengths in inches" + row, "'inches' is not a known unit");
  refuses("# scale: mm" + row, "whether lengths are in mm is not clear here");
}

TEST_F(Spheres, CommentsThatSeemToNameColumnsAreRefused) {
  reads("# xpos ypos zpos dia\n1 2 3 0.5\n4 5 6 1\n");
  refuses("# x y z size\n1 2 3 0.5\n", "line 1: the comment seems to name the columns, and is not understood");
  refuses("# size of x y\n1 2 3 0.5\n", "seems to name the columns");
  refuses("# position and diameter of grains\n1 2 3 0.5\n", "line 1: the comment speaks of diameters");
}

TEST_F(Spheres, CommentsBelowTheFirstGrainChangeNothing) {
  const std::string rows = "1 2 3 0.25\n4 5 6 0.5\n";
  reads(rows + "# the end, 2 grains, of at most 500 mm\n");
  reads(rows + "# units: m\n");
  for (const char* said : {"#format x_y_z_r", "# x y z r", "# x y z d", "# box 9 9 9"})
    refuses(rows + said + "\n7 8 9 0.25\n", "line 3: a comment below the first grain names columns or a cell");
  refuses(rows + "# units: mm\n", "line 3: the comment gives lengths in mm, the columns another unit");
}

TEST_F(Spheres, ACellInAnotherSpellingIsRefused) {
  const std::string row = "\n1 2 3 0.25\n4 5 6 0.5\n";
  for (const char* said :
       {"##PERIODIC 9 9 9", "# periodic: 9 9 9", "# periodic 9 9", "# Box size: 9, 9, 9", "# cell 0 9 0 9 0 9"})
    refuses(said + row, "line 1: write ##PERIODIC:: Lx Ly Lz (disks: Lx Ly), as it stands here");
  for (const char* said : {"# periodic cell, 0.2 MPa", "# sizes 0.25 0.5", "# 2 grains"}) reads(said + row);
  CellRecord cell;
  cell.matrix = Mat3::Identity() * 9;
  EXPECT_EQ(read("# box 9 9 9" + row, cell).cell.matrix, cell.matrix);
}

TEST_F(Spheres, AGrainOfAnotherTimeStepIsRefused) {
  refuses("id x y z r\n1 0 0 0 1\n2 4 0 0 1\n1 0 4 0 1\n", "line 4, column 1: the number 1 again, which line 2 has");
  refuses("#format id_x_y_z_r\n0 0 0 0 1\n0 4 0 0 1\n", "line 3, column 1: the number 0 again");
  refuses("TimeStep,x,y,z,r\n0,0,0,0,1\n1,0,4,0,1\n", "line 3, column 1: 1 below 0: are these two time steps");
  reads("step id x y z r\n7 1 1 2 3 0.25\n7 2 4 5 6 0.5\n");
}

TEST_F(Spheres, AMarkWithinAWordBeginsNoComment) {
  refuses("x y z r\n0 0 0 1.#QNAN\n", "line 2, column 4: \"1.#QNAN\" is no finite number");
  refuses("r x y z\n1 0 0 -1.#IND\n", "line 2, column 4: \"-1.#IND\" is no finite number");
  reads("1,2,3,0.25 #a\n4,5,6,0.5\t# b\n");
}

TEST_F(Spheres, TheCellHasTheUnitOfTheColumns) {
  for (const char* names : {"x [mm],y [mm],z [mm],r [mm]\n", "# x [mm],y [mm],z [mm],r [mm]\n", "# units: mm\n"}) {
    const Snapshot state = read(std::string("##PERIODIC:: 46 46 92\n") + names + "10,10,10,3\n30,30,40,4\n");
    EXPECT_TRUE(state.cell.matrix.isApprox(Vec3(0.046, 0.046, 0.092).asDiagonal().toDenseMatrix(), 1e-15)) << names;
    EXPECT_EQ(state.grains.radius[1], 0.004);
  }
  const Snapshot disks = read("##PERIODIC:: 46 92\nx_mm y_mm r_mm\n10 10 3\n30 30 4\n");
  EXPECT_TRUE(disks.cell.matrix.isApprox(Vec3(0.046, 0.092, 1).asDiagonal().toDenseMatrix(), 1e-15));
}

TEST_F(Spheres, SeparatorsAreNotGuessed) {
  refuses("10,5\t20,5\t30,5\t5,0\n",
          "line 1, column 1: \"10,5\" is no finite number: write 10.5, with a decimal point");
  refuses("10,5 20,5 30,5 5,0\n", "line 1, column 1: \"10,5\" is no finite number: write 10.5");
  refuses("10,5;20,5;30,5;5,0\n", "line 1, column 1: \"10,5\" is no finite number: write 10.5");
  refuses("x,y,z,r\n10,5,20,5,30,5,5,0\n", "8 values where 4 belong, separated by commas; with decimal commas among");
  refuses("x y z r\n1, 2, 3, 0.5\n", "line 2, column 1: \"1,\" is no finite number: columns are separated by blanks");
  refuses("x,y,z,r\n1 2 3 0.5\n", "line 2, column 2: 1 values where 4 belong, separated by commas");
  refuses("x\ty\tz\tr\n1 2 3 0.5\n", "line 2, column 2: 1 values where 4 belong, separated by tabs");
  refuses("1;2;3;0.5\n1 2 3 0.5\n", "line 2, column 2: 1 values where 4 belong, separated by semicolons");
}

TEST_F(Spheres, PeriodsAreToldWholeAndOnce) {
  refuses("## PERIODIC: 1 1 1\n0 0 0 0.1\n", "line 1: write ##PERIODIC:: Lx Ly Lz (disks: Lx Ly), as it stands here");
  refuses("##periodic:: 1 1 1\n0 0 0 0.1\n", "line 1: write ##PERIODIC:: Lx Ly Lz");
  refuses("##PERIODIC:: 1 1 1\n##PERIODIC:: 1 1 1\n0 0 0 0.1\n", "line 2: a second ##PERIODIC:: line");
  refuses("0 0 0 0.1\n##PERIODIC:: 1 1 1\n", "line 2: ##PERIODIC:: belongs before the first grain");
  refuses("##PERIODIC:: 1,5 1,5 1,5\n0 0 0 0.1\n", "line 1, column 1: \"1,5\" is no finite number: write 1.5");
  const CellRecord cell = periodic_cell("1 m, 20 cm,300mm", "--cell");
  EXPECT_TRUE(cell.matrix.isApprox(Vec3(1, 0.2, 0.3).asDiagonal().toDenseMatrix(), 1e-15));
  expect_error<DataError>([&] { import("##PERIODIC:: 1 1 1\n0 0 0 0.1\n", {}, cell); }, "no other cell can be given");
  for (const char* wrong : {"1", "1,1,1,1", "1,x,1", "1,-1,1", "1,nan,1", "1,inf,1", ""})
    expect_error<UsageError>([&] { periodic_cell(wrong, "--cell"); }, "give three positive lengths, of disks two");
}

TEST_F(Spheres, DisksAreReadFromText) {
  const Snapshot state = read("##PERIODIC:: 0.5 0.25\n0.1 0.2 0.01\n0.2 0.1 0.02\n");
  EXPECT_EQ(state.grains.dimension, 2);
  EXPECT_EQ(state.cell.periodic, (std::array<bool, 3>{true, true, false}));
  EXPECT_EQ(state.cell.matrix, Vec3(0.5, 0.25, 1).asDiagonal().toDenseMatrix());
  EXPECT_EQ(state.grains.position[1], Vec3(0.2, 0.1, 0));
  EXPECT_NEAR(state.grains.mass[1], 2650 * std::numbers::pi * 4e-4, 1e-12);
  EXPECT_EQ(read("x,y,r\n0.1,0.2,0.01\n").grains.dimension, 2);
  const ImportedSpheres rods =
      import("x_m,y_m,z_m,radius_m\n0.1,0.2,0.05,0.01\n0.2,0.1,0.05,0.02\n", 2, periodic_cell("0.5,0.25", "--cell"));
  EXPECT_EQ(rods.state.grains.position[0], Vec3(0.1, 0.2, 0));
  EXPECT_NE(rods.notes.at(0).find("read as disks, their common z left out"), std::string::npos) << rods.notes[0];
  refuses("x y z r\n0 0 0 0.1\n0 1 1 0.1\n", "disks lie in a plane, but z goes from 0 to 1", 2);
  refuses("0 0 0 0.1\n", "line 1: 4 numbers; without a header a line is x y r", 2);
  refuses("##PERIODIC:: 1 1 1\n0 0 0.1\n", "line 1: the ##PERIODIC:: line has 3 lengths where disks are read", 2);
  refuses("##PERIODIC:: 1 1 1\nx y r\n0 0 0.1\n", "no column z, which spheres need");
  expect_error<DataError>([&] { import("x y r\n0 0 0.1\n", {}, periodic_cell("1,1,1", "--cell")); },
                          "holds disks, whose cell has 2 lengths");
}

TEST_F(Spheres, FormatsOfOtherProgramsAreNamedWithAWayToConvertThem) {
  refuses("ITEM: TIMESTEP\n0\nITEM: ATOMS id type x y z radius\n1 1 1 1 1 0.5\n",
          "a dump of LAMMPS or LIGGGHTS; take its first step by: awk ");
  const auto box = [&](const std::string& bounds, const std::string& words) {
    refuses("ITEM: TIMESTEP\n0\nITEM: BOX BOUNDS" + bounds + "\nITEM: ATOMS x y z radius\n1 1 1 0.5\n",
            "> NEW; " + words);
  };
  box(" pp pp pp\n0 4\n1 4\n0 5", "give its box by --cell 4,3,5");
  box("\n0 4\n1 4\n0 5", "if its box is periodic, give it by --cell 4,3,5");
  box(" ff ff ff\n0 4\n1 4\n0 5", "its box is not periodic, so give no --cell");
  box(" pp pp ff\n0 4\n1 4\n0 5", "its box is not periodic along all axes");
  box(" xy xz yz pp pp pp\n0 4 0\n1 4 0\n0 5 1", "its box is tilted");
  refuses("ITEM: TIMESTEP\n0\nITEM: ATOMS id type xs ys zs\n1 1 1 1 1\n",
          "a dump of LAMMPS or LIGGGHTS without columns");
  refuses("1\nLattice=\"4 0 0\" Properties=species:S:1:pos:R:3:radius:R:1\nA 1 1 1 0.5\n",
          "an XYZ file; name the columns of its first step by: (echo 'species x y z radius'; sed -n '3,3p' FILE) > "
          "NEW; if its Lattice");
  refuses("1\ncomment\nA 1 1 1\n", "an XYZ file without radii");
  refuses("2\n1 1 1 0.5\n3 1 1 0.5\n", "a list below the number of its grains; leave the first line out");
  refuses("1 0 0 0.01 0 1 1 1\n0.2 0.2 0.2 0.1 0 0 0.05 0 0 0 0 0 0 0\n",
          "a .data file of MercuryDPM; name the columns of its first step by: (echo 'x y z vx vy vz r");
  refuses("# vtk DataFile Version 3.0\n", "a VTK file; write it from ParaView as CSV");
  refuses("$MeshFormat\n2.2 0 8\n", "a Gmsh mesh");
  refuses("LAMMPS data file\n", "a data file of LAMMPS");
  refuses("made by hand\n\n2 atoms\n1 atom types\n", "a data file of LAMMPS");
  refuses("LSMGeometry 1.2\nBoundingBox 0 0 0 4 4 4\n", "a geometry of ESyS-Particle; take its grains by: (echo");
  refuses("Begin Nodes\n1 1 1 1\nEnd Nodes\n", "a model of Kratos");
  refuses("[contact]\nlaw = \"linear\"\n", "a TOML, JSON or similar file");
}

TEST_F(Spheres, DisksComeBackExactly) {
  for (const char* cell : {"##PERIODIC:: 0.3333333333333333 0.7\n", ""}) {
    const Snapshot state = read(std::string(cell) + "x y r\n0.1 0.20000000000000004 0.01\n0.2 0.1 0.02\n");
    const Snapshot back = read(export_spheres(state, "state").text);
    EXPECT_EQ(back.grains.dimension, 2);
    EXPECT_TRUE(test::same_bits(state.grains.position, back.grains.position));
    EXPECT_TRUE(test::same_bits(state.grains.radius, back.grains.radius));
    EXPECT_TRUE(test::same_bits(state.cell.matrix, back.cell.matrix));
    EXPECT_EQ(state.cell.periodic, back.cell.periodic);
  }
}

TEST_F(Spheres, ComeBackExactly) {
  Snapshot state = test::example_state(50);
  state.cell.matrix = Vec3(1.0 / 3, 1, 0.9).asDiagonal();
  const Snapshot back = read(export_spheres(state, "state").text);
  EXPECT_TRUE(test::same_bits(state.grains.position, back.grains.position));
  EXPECT_TRUE(test::same_bits(state.grains.radius, back.grains.radius));
  EXPECT_TRUE(test::same_bits(state.cell.matrix, back.cell.matrix));
  state.cell.matrix(0, 1) = 0.1;  // a tilted cell has no line of its own
  EXPECT_EQ(export_spheres(state, "state").text.find("PERIODIC"), std::string::npos);
}

// Three grains in a row. The last two are joined by a yarn.
TEST_F(Spheres, LeaveOutNodesAndTellWhatATextLacks) {
  Snapshot state = read("1 1 1 0.5\n2 1 1 0.5\n3 1 1 0.5\n");
  EXPECT_EQ(export_spheres(state, "state").left_out, "");
  state.yarns.nodes = {{1, 2}};
  state.planes.point = {Vec3::Zero()};
  state.cell.periodic = {true, false, false};
  const ExportedSpheres text = export_spheres(state, "state");
  EXPECT_EQ(text.text, "1 1 1 0.5\n");
  EXPECT_EQ(text.left_out,
            "2 nodes and 1 yarn of geotextiles, 1 plane, the cell, which is tilted or not periodic along all axes");
  state.yarns.nodes = {{0, 1}, {1, 2}};
  expect_error<DataError>([&] { export_spheres(state, "state"); },
                          "state: holds nodes of geotextiles alone, which are no grains");
}

TEST_F(Spheres, OfOtherProgramsAreRead) {
  const std::filesystem::path table = soilweave::test::reference_file("ch2/toyoura_rv_1000.csv");
  if (table.empty()) GTEST_SKIP() << "SOILWEAVE_REFERENCE is not set";
  const Snapshot state = import_spheres(table, {2640, {}, {}}).state;
  EXPECT_EQ(state.grains.size(), 1000U);
  EXPECT_EQ(state.grains.radius[0], 0.00477857);
}

}  // namespace
}  // namespace soilweave::io
