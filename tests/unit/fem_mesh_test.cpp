// Meshes: the generator, both formats of Gmsh, what is refused, and the author's own meshes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "core/error.h"
#include "fem/mesh/mesh.h"
#include "support/reference.h"
#include "support/same_state.h"

namespace soilweave::fem {
namespace {

double area_of(const Mesh& mesh) {
  double area = 0;
  for (Index e = 0; e < mesh.elements.size(); ++e)
    for (const IntegrationPoint& p : integration_points(mesh.shape, Integration::full))
      area += p.weight * gradients(mesh.shape, p.at, mesh.corners(e, mesh.nodes)).area;
  return area;
}

TEST(Mesh, RectanglesFillTheirAreaAndNameTheirSides) {
  for (const Shape shape : {Shape::triangle3, Shape::quadrilateral8}) {
    const Mesh mesh = rectangle(1.2, 0.8, 4, 3, shape);
    mesh.check("a rectangle");
    EXPECT_NEAR(area_of(mesh), 0.96, 1e-15);
    EXPECT_EQ(mesh.elements.size(), shape == Shape::triangle3 ? 24U : 12U);
    EXPECT_EQ(mesh.nodes.size(), shape == Shape::triangle3 ? 20U : 51U);
    EXPECT_EQ(mesh.boundary("top").ends.size(), 4U);
    for (const Index n : mesh.boundary("right").nodes) EXPECT_EQ(mesh.nodes[n][0], 1.2);
    const std::vector<Index> line = mesh.line({"right", "top", "left"});
    ASSERT_EQ(line.size(), 11U);
    EXPECT_EQ(mesh.nodes[line.front()], Vec2(1.2, 0));
    EXPECT_EQ(mesh.nodes[line.back()], Vec2(0, 0));
  }
}

TEST(Mesh, ShapeFunctionsAreOneAtTheirNodeAndSumToOne) {
  for (const Shape shape : {Shape::triangle3, Shape::quadrilateral8}) {
    const Vec2 at(0.31, 0.17);
    EXPECT_NEAR(shape_functions(shape, at).sum(), 1, 1e-15);
    EXPECT_NEAR(reference_gradients(shape, at).rowwise().sum().norm(), 0, 1e-15);
  }
  const Vec2 middle(0, -1);
  EXPECT_EQ(shape_functions(Shape::quadrilateral8, middle)[4], 1);
  EXPECT_NEAR(shape_functions(Shape::quadrilateral8, middle).cwiseAbs().sum(), 1, 1e-15);
}

TEST(Mesh, IsThatOfTheThesis) {
  for (const auto& [number, squares] : std::vector<std::pair<std::string, Index>>{{"3", 6}, {"4", 8}, {"5", 10}}) {
    const auto nodes = test::reference_table("ch6/mesh" + number + "_nodes.csv");
    auto triangles = test::reference_table("ch6/mesh" + number + "_triangles.csv");
    if (nodes.empty()) GTEST_SKIP() << "SOILWEAVE_REFERENCE is not set";
    const Mesh mesh = rectangle(1.2, 1.2, squares, squares, Shape::triangle3);
    const std::vector<double>&x = nodes.at("x_m"), &y = nodes.at("y_m");
    ASSERT_EQ(x.size(), mesh.nodes.size());
    // Triangles are compared as sets of places, because numbering differs between codes.
    const auto key = [](const std::array<Vec2, 3>& corners) {
      std::array<std::pair<long, long>, 3> k;
      for (std::size_t i = 0; i < 3; ++i) k[i] = {std::lround(corners[i][0] * 1e6), std::lround(corners[i][1] * 1e6)};
      std::sort(k.begin(), k.end());
      return k;
    };
    std::set<std::array<std::pair<long, long>, 3>> ours, theirs;
    for (const auto& e : mesh.elements) ours.insert(key({mesh.nodes[e[0]], mesh.nodes[e[1]], mesh.nodes[e[2]]}));
    const std::array corner = {triangles.at("node1"), triangles.at("node2"), triangles.at("node3")};
    ASSERT_EQ(corner[0].size(), mesh.elements.size());
    for (Index t = 0; t < corner[0].size(); ++t) {
      std::array<Vec2, 3> places;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto n = static_cast<std::size_t>(corner[k][t]) - 1;
        places[k] = Vec2(x.at(n), y.at(n));
      }
      theirs.insert(key(places));
    }
    EXPECT_EQ(ours, theirs) << "mesh " << number;
  }
}

const std::string two_triangles_2 = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "floor"
0 5 "nail"
2 2 "soil"
$EndPhysicalNames
$Nodes
5
1 0 0 0
2 1 0 0
3 1 2 0
4 0 2 0
9 7 7 0
$EndNodes
$Elements
4
1 15 2 5 1 1
2 1 2 1 1 2 1
3 2 2 2 1 1 2 4
4 2 2 2 1 2 3 4
$EndElements
)";
const std::string two_triangles_4 = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
1 1 "floor"
0 5 "nail"
2 2 "soil"
$EndPhysicalNames
$Entities
1 1 1 0
1 0 0 0 1 5
1 0 0 0 1 0 0 1 1 2 1 -2
1 0 0 0 1 2 0 1 2 1 1
$EndEntities
$Nodes
1 5 1 9
2 1 0 5
1
2
3
4
9
0 0 0
1 0 0
1 2 0
0 2 0
7 7 0
$EndNodes
$Elements
3 4 1 4
0 1 15 1
1 1
1 1 1 1
2 2 1
2 1 2 2
3 1 2 4
4 2 3 4
$EndElements
)";

TEST(Gmsh, BothFormatsGiveTheSameMesh) {
  for (const std::string& text : {two_triangles_2, two_triangles_4}) {
    const Mesh mesh = read_gmsh(text, "two.msh");
    EXPECT_EQ(mesh.elements.size(), 2U);
    EXPECT_EQ(mesh.nodes.size(), 4U) << "the node of no element is left out";
    EXPECT_EQ(area_of(mesh), 2);
    ASSERT_EQ(mesh.boundary("floor").ends.size(), 1U);
    const auto [first, second] = mesh.boundary("floor").ends[0];
    EXPECT_EQ(mesh.nodes[first], Vec2(0, 0)) << "turned so that the soil lies to its left";
    EXPECT_EQ(mesh.nodes[second], Vec2(1, 0));
    EXPECT_EQ(mesh.boundary("nail").nodes.size(), 1U);
  }
}

TEST(Gmsh, RefusesWithTheLineAndTheRemedy) {
  const auto refused = [](const std::string& from, const std::string& to, const std::string& words) {
    std::string text = two_triangles_2;
    text.replace(text.find(from), from.size(), to);
    io::test::expect_error<DataError>([&] { read_gmsh(text, "two.msh"); }, words);
  };
  refused("2.2 0 8", "2.2 1 8", "two.msh:2: the mesh is binary");
  refused("2.2 0 8", "3.0 0 8", "has the format 3");
  refused("4 0 2 0\n", "4 0 2 1\n", "is not in the plane z = 0");
  refused("3 2 2 2 1 1 2 4", "3 3 2 2 1 1 2 4 4", "two.msh:22: the mesh has, as element 3, a 4-node quadrilateral");
  refused("3 2 2 2 1 1 2 4", "3 2 2 2 1 1 2 2", "two.msh:22: element 3 names a node twice");
  refused("3 2 2 2 1 1 2 4", "3 2 2 2 1 1 2 8", "names the node 8");
  refused("2 1 2 1 1 2 1", "2 1 2 1 1 3 1", "an edge that is no side of an element");
  refused("$EndElements", "", "ends too early");
  io::test::expect_error<DataError>([] { read_gmsh("solid", "x.msh"); }, "does not begin with $MeshFormat");
}

TEST(Mesh, NamesTheNearestBoundary) {
  const Mesh mesh = rectangle(1, 1, 1, 1, Shape::triangle3);
  io::test::expect_error<DataError>([&] { mesh.boundary("botom"); }, "did you mean 'bottom'");
  EXPECT_EQ(&mesh.boundary_with_edges("top"), &mesh.boundary("top"));
  io::test::expect_error<DataError>([&] { mesh.boundary_with_edges("bottom-corners"); },
                                    "boundary \"bottom-corners\" has points alone and no length: name one with edges: "
                                    "bottom, left, right, top");
  io::test::expect_error<DataError>([&] { mesh.boundary_with_edges("loadpoint"); },
                                    "; known: bottom, left, right, top");
  io::test::expect_error<DataError>([&] { mesh.line({"bottom-corners"}); }, "has points alone");
  io::test::expect_error<DataError>([&] { mesh.line({"left", "right"}); }, "not connected to one line");
  io::test::expect_error<DataError>([&] { mesh.line({"bottom", "right", "top", "left"}); }, "no line with two ends");
}

}  // namespace
}  // namespace soilweave::fem
