// Gmsh meshes as people have them: several groups, reversed orientation, partitions, slits, and refusals by name.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "core/error.h"
#include "fem/mesh/mesh.h"
#include "fem/run/scenario.h"
#include "support/same_state.h"

namespace soilweave::fem {
namespace {

const std::string head_2 = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n";
const std::string head_4 = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
const std::string names = "$PhysicalNames\n3\n1 1 \"bottom\"\n1 4 \"ends\"\n2 3 \"soil\"\n$EndPhysicalNames\n";

// Returns a file of format 2.2: nodes x y in a row, numbered from 1, and elements.
std::string file_2(const std::vector<Vec2>& nodes, const std::vector<std::string>& elements) {
  std::string text = head_2 + names + fmt::format("$Nodes\n{}\n", nodes.size());
  for (std::size_t k = 0; k < nodes.size(); ++k) text += fmt::format("{} {} {} 0\n", k + 1, nodes[k].x(), nodes[k].y());
  text += fmt::format("$EndNodes\n$Elements\n{}\n", elements.size());
  for (std::size_t k = 0; k < elements.size(); ++k) text += fmt::format("{} {}\n", k + 1, elements[k]);
  return text + "$EndElements\n";
}

const std::vector<Vec2> square = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
const std::vector<Vec2> square_8 = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 0}, {1, 0.5}, {0.5, 1}, {0, 0.5}};

double area_of(const Mesh& mesh) {
  double area = 0;
  for (Index e = 0; e < mesh.elements.size(); ++e)
    for (const IntegrationPoint& p : integration_points(mesh.shape, Integration::full))
      area += p.weight * gradients(mesh.shape, p.at, mesh.corners(e, mesh.nodes)).area;
  return area;
}

void refused(const std::string& text, const std::string& words) {
  io::test::expect_error<DataError>([&] { read_gmsh(text, "x.msh"); }, words);
}

TEST(Gmsh, AnElementOfSeveralGroupsCountsOnce) {
  const Mesh mesh = read_gmsh(file_2(square, {"1 2 1 1 1 2", "1 2 4 1 1 2", "1 2 4 3 3 4", "2 2 3 1 1 2 3",
                                              "2 2 3 1 1 3 4", "2 2 5 1 1 2 3", "2 2 5 1 3 4 1"}),
                              "x.msh");
  EXPECT_EQ(mesh.elements.size(), 2U);
  EXPECT_EQ(area_of(mesh), 1);
  EXPECT_EQ(mesh.boundary("bottom").ends.size(), 1U);
  EXPECT_EQ(mesh.boundary("ends").ends.size(), 2U);
  EXPECT_TRUE(mesh.doubts.empty()) << "that is how the format has it";
  const Mesh twice =
      read_gmsh(file_2(square, {"1 2 1 1 1 2", "1 2 1 1 2 1", "2 2 3 1 1 2 3", "2 2 3 1 3 1 2"}), "x.msh");
  EXPECT_EQ(twice.elements.size(), 1U);
  EXPECT_EQ(twice.boundary("bottom").ends.size(), 1U) << "a load on it would count twice";
  ASSERT_EQ(twice.doubts.size(), 2U);
  EXPECT_EQ(twice.doubts[0].sentence, "x.msh: 1 element is more than once in the file: counted once");
  EXPECT_EQ(twice.doubts[1].sentence, "x.msh: a node of no element left out: 4");
}

TEST(Gmsh, SurfacesThatPartTheElementsAreDoubtedByName) {
  const Mesh parted = read_gmsh(file_2(square, {"1 2 1 1 1 2", "2 2 3 1 1 2 3", "2 2 7 1 1 3 4"}), "x.msh");
  ASSERT_EQ(parted.doubts.size(), 1U);
  EXPECT_EQ(
      parted.doubts[0].sentence,
      "x.msh: all elements become one soil, which [soil] describes, although physical surfaces part them: \"soil\" (1 "
      "of 2), \"7\" (1 of 2); mesh only what is that soil");
  // Elements of no group are kept beside those of one.
  EXPECT_EQ(read_gmsh(file_2(square, {"2 2 3 1 1 2 3", "2 2 0 1 1 3 4"}), "x.msh").doubts.size(), 1U);
  EXPECT_TRUE(read_gmsh(file_2(square, {"2 2 3 1 1 2 3", "2 2 3 1 1 3 4"}), "x.msh").doubts.empty());
  EXPECT_TRUE(read_gmsh(file_2(square, {"2 2 0 1 1 2 3", "2 2 0 1 1 3 4"}), "x.msh").doubts.empty());
}

TEST(Gmsh, ClockwiseElementsAreTurnedWithTheirSides) {
  const Mesh triangles = read_gmsh(file_2(square, {"1 2 1 1 2 1", "2 2 3 1 1 3 2", "2 2 3 1 1 3 4"}), "x.msh");
  EXPECT_EQ(area_of(triangles), 1);
  ASSERT_EQ(triangles.doubts.size(), 1U);
  EXPECT_EQ(triangles.doubts[0].sentence, "x.msh: 1 of 2 elements, element 2 the first, are clockwise: turned round");
  const auto [first, second] = triangles.boundary("bottom").ends.at(0);
  EXPECT_EQ(triangles.nodes[first], Vec2(0, 0)) << "the soil to its left";
  EXPECT_EQ(triangles.nodes[second], Vec2(1, 0));
  // The middle of a side stays between its ends.
  const Mesh upright = read_gmsh(file_2(square_8, {"8 2 1 1 1 2 5", "16 2 3 1 1 2 3 4 5 6 7 8"}), "x.msh");
  const Mesh turned = read_gmsh(file_2(square_8, {"8 2 1 1 1 2 5", "16 2 3 1 1 4 3 2 8 7 6 5"}), "x.msh");
  EXPECT_NEAR(area_of(turned), 1, 1e-15);
  for (Index k = 0; k < 8; ++k)
    EXPECT_EQ(turned.nodes[turned.elements[0][k]], upright.nodes[upright.elements[0][k]]) << "node " << k;
  EXPECT_EQ(turned.nodes[turned.boundary("bottom").middle.at(0)], Vec2(0.5, 0));
}

// Returns a square of two triangles in 4.1, with this physical number of its bottom curve, and further text.
std::string file_4(const std::string& bottom, const std::string& sections, const std::string& curve = "1",
                   const std::string& surface = "1") {
  return head_4 + names + "$Entities\n0 1 1 0\n1 0 0 0 1 0 0 1 " + bottom + " 0\n1 0 0 0 1 1 0 1 3 0\n$EndEntities\n" +
         sections +
         "$Nodes\n1 4 1 40\n2 1 0 4\n10\n20\n30\n40\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n$EndNodes\n"
         "$Elements\n2 3 1 3\n1 " +
         curve + " 1 1\n1 10 20\n2 " + surface + " 2 2\n2 10 20 30\n3 10 30 40\n$EndElements\n";
}

TEST(Gmsh, ASignIsASenseAndPartitionsKeepTheirGroups) {
  for (const std::string bottom : {"1", "-1"}) {
    const Mesh mesh = read_gmsh(file_4(bottom, ""), "x.msh");
    EXPECT_EQ(mesh.boundary("bottom").ends.size(), 1U) << bottom;
    EXPECT_EQ(mesh.boundaries.size(), 1U) << bottom;
  }
  // The curve between two parts has a surface as its parent, and is no part of the bottom.
  const std::string parts =
      "$PartitionedEntities\n2\n0\n0 2 1 0\n"
      "7 1 1 1 1 0 0 0 1 0 0 0 0\n8 2 1 2 1 2 0 0 0 1 1 0 0 0\n9 2 1 1 1 0 0 0 1 1 0 1 3 0\n$EndPartitionedEntities\n";
  const Mesh mesh = read_gmsh(file_4("1", parts, "7", "9"), "x.msh");
  EXPECT_EQ(mesh.boundary("bottom").ends.size(), 1U);
  EXPECT_TRUE(read_gmsh(file_4("1", parts, "8", "9"), "x.msh").boundaries.empty());
}

TEST(Gmsh, SectionsOfNoConcernAreSkipped) {
  const std::string text =
      "$Comments\nmade by hand: $Nodes\n$EndComments\n" + file_4("1", "") +
      "$Periodic\n1\n1 1 2\n0\n0\n$EndPeriodic\n$NodeData\n1\n\"p\"\n1\n0\n3\n0\n1\n0\n$EndNodeData\n";
  EXPECT_EQ(area_of(read_gmsh(text, "x.msh")), 1);
  std::string parametric = file_4("1", "");
  const std::string from = "2 1 0 4\n10\n20\n30\n40\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
  parametric.replace(parametric.find(from), from.size(),
                     "2 1 1 4\n10\n20\n30\n40\n0 0 0 0 0\n1 0 0 1 0\n1 1 0 1 1\n0 1 0 0 1\n");
  EXPECT_EQ(area_of(read_gmsh(parametric, "x.msh")), 1);
}

TEST(Gmsh, ElementsAreRefusedByWhatTheyAre) {
  refused(file_2(square, {"3 2 3 1 1 2 3 4"}),
          "x.msh:19: the mesh has, as element 1, a 4-node quadrilateral; taken are 3-node triangles and 8-node "
          "quadrilaterals");
  refused(file_2(square_8, {"9 2 3 1 1 2 3 5 6 7"}), "a 6-node triangle");
  refused(file_2(square_8, {"10 2 3 1 1 2 3 4 5 6 7 8 8"}), "Mesh.SecondOrderIncomplete = 1");
  refused(file_2(square, {"4 2 3 1 1 2 3 4"}), "a 4-node tetrahedron");
  refused(file_2(square, {"99 2 3 1 1 2 3 4"}), "one of a type unknown here, number 99");
  refused(file_2(square, {"1 2 1 1 1 2"}), "holds no plane elements among its 1");
  refused(file_2(square_8, {"2 2 3 1 1 2 3", "16 2 3 1 1 2 3 4 5 6 7 8"}),
          "element 2 is a 8-node quadrilateral, element 1 before it a 3-node triangle");
}

TEST(Gmsh, ElementsWithoutAreaAreRefusedByTheirNumber) {
  refused(file_2({{0, 0}, {0.1, 0.1}, {0.3, 0.3}}, {"2 2 3 1 1 2 3"}),
          "x.msh:18: element 1 has no area: its corners 1 2 3");
  refused(file_2(square, {"2 2 3 1 1 2 2"}), "names a node twice: 1 2 2");
  refused(file_2(square, {"2 2 3 1 1 2 7"}), "names the node 7, which is none");
  refused(file_2(square_8, {"16 2 3 1 1 3 2 4 5 6 7 8"}), "element 1 crosses itself: its corners 1 3 2 4");
  std::vector<Vec2> hollow = square_8;
  hollow[2] = {0.2, 0.2}, hollow[5] = {0.6, 0.1}, hollow[6] = {0.1, 0.6};
  refused(file_2(hollow, {"16 2 3 1 1 2 3 4 5 6 7 8"}), "element 1 is folded");
  refused(file_2({{0, 0}, {1, 0}, {1, 1}, {0.5, 0.4}}, {"2 2 3 1 1 2 3", "2 2 3 1 1 2 4"}),
          "element 2 and element 1 lie on the same side of the edge from node 1 to node 2: they overlap");
}

TEST(Gmsh, NodesAndBoundariesAreRefusedByTheirNumbers) {
  const auto with_node = [](const std::string& line) {
    return head_2 + "$Nodes\n4\n1 0 0 0\n2 1 0 0\n3 1 1 0\n" + line +
           "\n$EndNodes\n$Elements\n2\n1 2 2 3 1 1 2 3\n2 2 2 3 1 1 3 4\n$EndElements\n";
  };
  EXPECT_EQ(area_of(read_gmsh(with_node("4 0 1 0"), "x.msh")), 1);
  refused(with_node("4 0 1 0.5"), "x.msh:9: the mesh is not in the plane z = 0: node 4 is at z = 0.5");
  refused(with_node("4 0 nan 0"), "has node 4 at nan");
  refused(with_node("2 0 1 0"), "has node 2 in two places, here and in line 7");
  refused(with_node("4 0 1"), "has $EndNodes where a number belongs: its section holds less than it counts");
  refused(file_2(square, {"15 2 1 1 4", "2 2 3 1 1 2 3"}),
          "boundary \"1\" has node 4, which belongs to no plane element");
  refused(file_2(square_8, {"1 2 1 1 1 2", "16 2 3 1 1 2 3 4 5 6 7 8"}), "boundary \"bottom\" has a 2-node line");
  refused(file_2(square_8, {"8 2 1 1 1 2 6", "16 2 3 1 1 2 3 4 5 6 7 8"}), "has node 6 in the middle of an edge");
  refused("$NOD\n1\n1 0 0 0\n$ENDNOD\n", "is in Gmsh's format 1");
  refused("Point(1) = {0,0,0};\n", "seems to be a geometry of Gmsh");
}

TEST(Gmsh, ANameOfSeveralGroupsIsRefusedWhereItIsUsed) {
  const std::vector<std::string> soil = {"2 2 3 1 1 2 3", "2 2 3 1 1 3 4"};
  const auto with = [&](std::vector<std::string> items) {
    items.insert(items.end(), soil.begin(), soil.end());
    return file_2(square, items);
  };
  const auto shared = [](const std::string& text, const std::string& name, const std::string& words) {
    const Mesh mesh = read_gmsh(text, "x.msh");
    for (const auto& use : std::vector<std::function<void()>>{
             [&] { mesh.boundary(name); }, [&] { mesh.nodes_on(name); }, [&] { mesh.boundary_with_edges(name); }})
      io::test::expect_error<DataError>(use, words);
    return mesh;
  };
  const std::string remedy = " of the mesh alike; give each a name of its own in Gmsh, as Physical ";
  const Mesh mesh =
      shared(with({"15 2 7 1 4", "1 2 7 1 1 2", "1 2 8 1 3 4"}), "7",
             "the name \"7\" means physical point 7 and physical curve 7" + remedy + "Point(\"point-7\", 7) = {1};");
  EXPECT_EQ(mesh.boundary("8").nodes.size(), 2U) << "the other names remain";
  const auto named = [&](std::string text, const std::string& name) {
    return text.replace(text.find("1 4 \"ends\""), 10, name);
  };
  shared(named(with({"15 2 7 1 4", "1 2 1 1 1 2"}), "0 7 \"bottom\""), "bottom",
         "physical point 7 and physical curve 1");
  shared(named(with({"1 2 2 1 3 4", "1 2 4 1 1 2"}), "1 4 \"2\""), "2",
         "physical curve 2 and physical curve 4" + remedy + "Curve(\"curve-2\", 2) = {1};");
  EXPECT_EQ(read_gmsh(named(with({"15 2 7 1 4", "1 2 7 1 1 2"}), "0 7 \"point-7\""), "x.msh").boundaries.size(), 2U)
      << "the remedy";
  const std::string four = "$Entities\n1 1 1 0\n1 0 0 0 1 5\n1 0 0 0 1 0 0 1 5 0\n1 0 0 0 1 1 0 1 3 0\n$EndEntities\n";
  shared(head_4 + four +
             "$Nodes\n1 3 1 3\n2 1 0 3\n1\n2\n3\n0 0 0\n1 0 0\n1 1 0\n$EndNodes\n"
             "$Elements\n3 3 1 3\n0 1 15 1\n1 1\n1 1 1 1\n2 1 2\n2 1 2 1\n3 1 2 3\n$EndElements\n",
         "5", "physical point 5 and physical curve 5");
  const Mesh all = read_gmsh(named(with({"1 2 4 1 3 4"}), "1 4 \"all\""), "x.msh");
  EXPECT_EQ(all.boundary("all").ends.size(), 1U);
  io::test::expect_error<DataError>([&] { all.nodes_on("all"); }, "\"all\" means every node, and a boundary");
  EXPECT_EQ(mesh.nodes_on("all").size(), 4U);
}

// Two adjacent squares share no node.
const std::string unmerged =
    file_2({{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 1}, {1, 1}, {1, 2}, {0, 2}},
           {"1 2 1 1 1 2", "2 2 3 1 1 2 3", "2 2 3 1 1 3 4", "2 2 3 2 5 6 7", "2 2 3 2 5 7 8"});

TEST(Gmsh, PiecesAndSlitsAreTakenWhereTheyAreMeant) {
  const Mesh mesh = read_gmsh(unmerged, "x.msh");
  EXPECT_EQ(mesh.coincident(), (std::vector<std::array<Index, 2>>{{2, 5}, {3, 4}}));
  ASSERT_EQ(mesh.pieces().size(), 2U);
  EXPECT_EQ(mesh.pieces()[1].middle, Vec2(0.5, 1.5));
  const auto read = [&](const std::string& keys, const Mesh& of) {
    return read_scenario(
        "[mesh]\n" + keys +
            "[soil]\nmaterial = \"elastic\"\ndensity = 2000\nyoung_modulus = 1e7\npoisson_ratio = 0.25\n"
            "[time]\nduration = 1\noutput_interval = 1\n",
        "x.toml", {}, of);
  };
  const auto wrong = [&](const std::string& keys, const Mesh& of, const std::string& words) {
    io::test::expect_error<DataError>([&] { read(keys, of); }, words);
  };
  wrong("", mesh, "2 of its nodes lie on another one, as node 6 on 3 at (1, 1), and the mesh falls into 2 pieces");
  wrong("coincident_nodes = \"keep\"\n", mesh,
        "falls into 2 pieces that share no node: 2 elements around (0.5, 0.5), 2 elements around (0.5, 1.5)");
  // This is the remedy of the first message.
  EXPECT_EQ(read("coincident_nodes = \"keep\"\npieces = 2\n", mesh).model.soil.mesh.elements.size(), 4U);
  const Mesh whole = read_gmsh(file_2(square, {"2 2 3 1 1 2 3", "2 2 3 1 1 3 4"}), "x.msh");
  wrong("pieces = 2\n", whole, "is one piece");
  wrong("element = \"quadrilateral8\"\n", whole, "the file of the mesh decides: it has 3-node triangles");
  wrong("width = 2\n", whole, "--mesh names a file");
  wrong("integration = \"full\"\n", whole, "is of quadrilaterals");
  EXPECT_EQ(read("element = \"triangle3\"\n", whole).model.soil.mesh.elements.size(), 2U);
}

// Returns the mistakes of an elastic scenario with these keys of [mesh] on this mesh; empty if it is taken.
std::string mistakes_on(const Mesh& mesh, const std::string& keys = "") {
  try {
    read_scenario("[mesh]\n" + keys +
                      "[soil]\nmaterial = \"elastic\"\ndensity = 2000\nyoung_modulus = 1e7\npoisson_ratio = 0.25\n"
                      "[time]\nduration = 1\noutput_interval = 1\n",
                  "x.toml", {}, mesh);
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(Gmsh, NodesThatHangOnASideAreRefused) {
  // The upper square has a node in the middle of the lower square's side; turned and far from the origin, too.
  for (const double turn : {0.0, 0.4}) {
    std::vector<Vec2> nodes = {{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0.5, 1}, {1, 2}, {0, 2}};
    for (Vec2& x : nodes)
      x = 100 * Vec2(std::cos(turn) * x.x() - std::sin(turn) * x.y(), std::sin(turn) * x.x() + std::cos(turn) * x.y());
    const Mesh gaping = read_gmsh(
        file_2(nodes, {"2 2 3 1 1 2 3", "2 2 3 1 1 3 4", "2 2 3 1 4 5 7", "2 2 3 1 5 6 7", "2 2 3 1 5 3 6"}), "x.msh");
    ASSERT_EQ(gaping.hanging().size(), 1U);
    EXPECT_NE(
        mistakes_on(gaping).find("mesh.coincident_nodes: node 5 lies on the side 3-4 of element 2, which does not "
                                 "have it: the mesh would gape there; divide that side at the node"),
        std::string::npos)
        << mistakes_on(gaping);
    EXPECT_EQ(mistakes_on(gaping, "coincident_nodes = \"keep\"\n"), "") << "the remedy";
    const Mesh whole = read_gmsh(file_2(nodes, {"2 2 3 1 1 2 3", "2 2 3 1 1 3 5", "2 2 3 1 1 5 4", "2 2 3 1 4 5 7",
                                                "2 2 3 1 5 6 7", "2 2 3 1 5 3 6"}),
                                 "x.msh");
    EXPECT_EQ(mistakes_on(whole), "") << "the other remedy";
  }
}

TEST(Gmsh, NodesThatHangOnACurvedSideAreFound) {
  Mesh mesh = rectangle(1, 1, 1, 1, Shape::quadrilateral8);
  const Mesh small = rectangle(0.5, 0.5, 2, 1, Shape::quadrilateral8);
  EXPECT_TRUE(small.hanging().empty());
  EXPECT_TRUE(rectangle(3, 1e-3, 40, 3, Shape::triangle3).hanging().empty()) << "flat elements";
  // Two small squares stand on the large one, whose top is bent.
  const auto bent = [](const Vec2& x) { return Vec2(x.x(), x.y() + 0.4 * x.x() * (1 - x.x()) * x.y()); };
  const Index before = mesh.nodes.size();
  for (const Vec2& x : small.nodes) mesh.nodes.emplace_back(2 * x.x(), 1 + x.y());
  for (auto e : small.elements) {
    for (Index& n : e) n += before;
    mesh.elements.push_back(e);
  }
  for (Vec2& x : mesh.nodes) x = bent(x);
  const std::vector<Mesh::Hanging> found = mesh.hanging();
  ASSERT_EQ(found.size(), 3U) << "a node at an end of the side does not hang";
  for (const Mesh::Hanging& h : found) EXPECT_EQ(h.element, 0U);
}

}  // namespace
}  // namespace soilweave::fem
