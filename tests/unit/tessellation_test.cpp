// Power cells and tetrahedra fill the cell; lattices have equal ones; affine motions give exact strains.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/tessellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "analysis/measure/strain.h"
#include "analysis/measure/volume_of_interest.h"
#include "core/error.h"
#include "support/assembly.h"

namespace soilweave::analysis {
namespace {

using test::random_cell;
using test::simple_cubic;

// Returns an assembly moved with its cell by a homogeneous deformation and a translation.
io::Snapshot moved(const io::Snapshot& s, const Mat3& gradient, const Vec3& by) {
  io::Snapshot m = s;
  m.cell.matrix = gradient * s.cell.matrix;
  m.cell.deformation_gradient = gradient * s.cell.deformation_gradient;
  for (Vec3& x : m.grains.position) x = gradient * x + by;
  return m;
}

Mat3 some_gradient(int dimension) {
  Mat3 f;
  f << 0.97, 0.03, -0.01, 0.02, 1.01, 0.02, 0.01, 0, 0.95;
  if (dimension == 2) f << 0.97, 0.03, 0, 0.02, 1.01, 0, 0, 0, 1;
  return f;
}

TEST(PowerCells, OfALatticeAreEqual) {
  for (const int dimension : {2, 3})
    for (const double v : power_cell_volumes(simple_cubic(4, Vec3::Ones(), dimension))) EXPECT_NEAR(v, 1, 1e-12);
}

TEST(PowerCells, OfATurnedShearedLatticeAreEqual) {
  // Rounding leaves tetrahedra of almost no volume here.
  const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  const io::Snapshot s = moved(simple_cubic(4, Vec3::Ones()), turn, Vec3(0.1, 0.2, 0.3));
  for (const double v : power_cell_volumes(s)) EXPECT_NEAR(v, 1, 1e-10);
}

TEST(PowerCells, OfTwoSizesMeetOnTheRadicalPlane) {
  // Layers of radius a and b, 1 apart: the plane lies at (1 + a^2 - b^2) / 2 from the first.
  io::Snapshot s = simple_cubic(4, Vec3::Ones());
  for (std::size_t i = 0; i < s.grains.size(); ++i)
    s.grains.radius[i] = std::lround(s.grains.position[i].z()) % 2 ? 0.3 : 0.5;
  const double height = 1 + 0.25 - 0.09;
  const std::vector<double> volumes = power_cell_volumes(s);
  for (std::size_t i = 0; i < volumes.size(); ++i)
    EXPECT_NEAR(volumes[i], s.grains.radius[i] > 0.4 ? height : 2 - height, 1e-12);
}

TEST(PowerCells, AroundAMissingGrainShareItsPlace) {
  // The unit cube (square) of a lattice point without a grain falls to its 6 (4) nearest neighbours in equal pyramids.
  for (const int dimension : {2, 3}) {
    io::Snapshot s = simple_cubic(5, Vec3::Ones(), dimension);
    const auto missing = static_cast<std::ptrdiff_t>(dimension == 3 ? 2 + 5 * (2 + 5 * 2) : 2 + 5 * 2);
    const Vec3 hole = s.grains.position[static_cast<std::size_t>(missing)];
    s.grains.position.erase(s.grains.position.begin() + missing);
    s.grains.radius.erase(s.grains.radius.begin() + missing);
    s.grains.body_id.erase(s.grains.body_id.begin() + missing);
    s.contacts = {};
    const std::vector<double> volumes = power_cell_volumes(s);
    const double more = 1 + 0.5 / dimension;
    for (std::size_t i = 0; i < volumes.size(); ++i)
      EXPECT_NEAR(volumes[i], (s.grains.position[i] - hole).norm() < 1.1 ? 1 + (more - 1) : 1, 1e-12);
    // The void ratio of the block around it follows from 3^d places and one missing grain.
    const Volume block = box(s, hole - Vec3::Constant(1.5), hole + Vec3::Constant(1.5));
    const double solid = dimension == 3 ? std::numbers::pi / 6 : std::numbers::pi / 4, places = std::pow(3, dimension);
    EXPECT_EQ(block.grains.size(), static_cast<std::size_t>(places) - 1);
    EXPECT_NEAR(volume_state(s, block, std::vector<Mat3>(volumes.size(), Mat3::Zero()), volumes).void_ratio,
                places / ((places - 1) * solid) - 1, 1e-11);
  }
}

TEST(PowerCells, OfAnOpenLatticeAreThoseInsideUnlessMuchLargerThanTheirGrains) {
  // A cell over eight times its grain counts as reaching outside. For a unit cube the limit is a sphere with 8 * 4/3 pi
  // r^3 = 1, r = 0.3102. Grains on the outside have no cell.
  for (const double radius : {0.5, 0.312, 0.308}) {
    io::Snapshot s = simple_cubic(5, Vec3::Ones());
    s.cell.periodic = {false, false, false};
    for (double& r : s.grains.radius) r = radius;
    const std::vector<double> volumes = power_cell_volumes(s);
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      const Vec3& x = s.grains.position[i];
      const bool inside = x.minCoeff() > 0.5 && x.maxCoeff() < 3.5;
      EXPECT_NEAR(volumes[i], inside && radius > 0.31 ? 1 : 0, 1e-12) << x.transpose() << " radius " << radius;
    }
  }
}

TEST(PowerCells, FillAShearedCellAndHoldTheirGrains) {
  for (const int dimension : {2, 3}) {
    const io::Snapshot s = random_cell(200, dimension);
    const std::vector<double> volumes = power_cell_volumes(s);
    EXPECT_NEAR(std::accumulate(volumes.begin(), volumes.end(), 0.0) / cell_volume(s), 1, 1e-10);
    for (std::size_t i = 0; i < volumes.size(); ++i) {
      const double r = s.grains.radius[i];
      EXPECT_GT(volumes[i], std::numbers::pi * r * r * (dimension == 3 ? 4 * r / 3 : 1));
    }
  }
}

TEST(PowerCells, ScaleWithTheVolumeAndFollowTheGrains) {
  const io::Snapshot s = random_cell(60);
  io::Snapshot large = moved(s, 1e-3 * Mat3::Identity(), Vec3(1, -7, 0.5));
  for (double& r : large.grains.radius) r *= 1e-3;
  const std::vector<double> one = power_cell_volumes(s), other = power_cell_volumes(large);
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_NEAR(other[i], 1e-9 * one[i], 1e-20);
}

TEST(PowerCells, OfFewGrainsInALargeCell) {
  io::Snapshot s = random_cell(40);
  for (double& r : s.grains.radius) r *= 0.1;
  EXPECT_EQ(power_cell_volumes(s).size(), s.grains.size());
}

TEST(PowerCells, AreRefusedWithoutAPeriodicCellAndForHiddenGrains) {
  io::Snapshot s = simple_cubic(3, Vec3::Ones());
  s.cell.periodic[1] = false;
  EXPECT_THROW(power_cell_volumes(s), DataError);
  s.cell.periodic[1] = true;
  test::add_grain(s, Vec3(0.01, 0, 0), 0.05);
  EXPECT_THROW(power_cell_volumes(s), PhysicsError);
}

TEST(PowerCells, InsideAnOpenAssemblyAreThoseOfThePeriodicCell) {
  io::Snapshot s = random_cell(60);
  for (std::size_t g = 0; g < s.grains.size(); ++g) {
    const Vec3 reduced = s.cell.matrix.inverse() * s.grains.position[g];
    s.grains.position[g] = s.cell.matrix * (reduced - reduced.array().floor().matrix());
    s.grains.radius[g] = std::max(s.grains.radius[g], 0.38);  // a cell many times its grain counts as one at a hole
  }
  io::Snapshot open;
  open.grains.dimension = 3;
  for (int i = -1; i <= 1; ++i)
    for (int j = -1; j <= 1; ++j)
      for (int k = -1; k <= 1; ++k)
        for (std::size_t g = 0; g < s.grains.size(); ++g)
          test::add_grain(open, s.grains.position[g] + s.cell.matrix * Vec3(i, j, k), s.grains.radius[g]);
  open.cell.matrix = 3 * s.cell.matrix;
  open.cell.periodic = {false, false, false};
  const std::vector<double> inside = power_cell_volumes(open), periodic = power_cell_volumes(s);
  const std::size_t middle = 13 * s.grains.size();
  for (std::size_t g = 0; g < s.grains.size(); ++g)
    EXPECT_NEAR(inside[middle + g], periodic[g], 1e-12 * periodic[g]) << "grain " << g;
}

TEST(Delaunay, FillsTheCellOnce) {
  for (const int dimension : {2, 3}) {
    const io::Snapshot s = random_cell(150, dimension);
    EXPECT_NEAR(delaunay_volume(s) / cell_volume(s), 1, 1e-10);
    // Euler: a periodic triangulation of the plane has twice as many triangles as vertices.
    if (dimension == 2) {
      EXPECT_EQ(delaunay(s).size(), 2 * s.grains.size());
    }
  }
}

TEST(Delaunay, OfACubeWithoutPeriods) {
  io::Snapshot s = simple_cubic(3, Vec3::Ones());
  s.cell.periodic = {false, false, false};
  EXPECT_NEAR(delaunay_volume(s), 8, 1e-12);
}

TEST(Strain, OfAffineMotionIsExactOnEveryTetrahedron) {
  for (const int dimension : {2, 3}) {
    const io::Snapshot s = random_cell(100, dimension);
    const Mat3 f = some_gradient(dimension);
    const io::Snapshot m = moved(s, f, Vec3(0.3, -0.2, 0));
    const std::vector<Simplex> simplices = delaunay(s);
    const std::vector<Mat3> gradients = simplex_gradients(s, m, simplices);
    // Flat tetrahedra amplify rounding by their aspect.
    for (const Mat3& g : gradients) EXPECT_LT((g - f).norm(), 1e-9);
    for (const Mat3& g : grain_gradients(s, m, simplices, gradients)) EXPECT_LT((g - f).norm(), 1e-11);
    EXPECT_LT((best_fit_gradient(s, m, whole(s).grains) - f).norm(), 1e-12);
  }
}

TEST(Strain, FollowsBodiesNotTheirOrder) {
  const io::Snapshot s = random_cell(50);
  io::Snapshot m = moved(s, some_gradient(3), Vec3::Zero());
  std::swap(m.grains.body_id[3], m.grains.body_id[40]);
  std::swap(m.grains.position[3], m.grains.position[40]);
  for (const Mat3& g : simplex_gradients(s, m, delaunay(s))) EXPECT_LT((g - some_gradient(3)).norm(), 1e-9);
  EXPECT_LT((best_fit_gradient(s, m, whole(s).grains) - some_gradient(3)).norm(), 1e-12);
  m.grains.body_id[0] = 1000;
  EXPECT_THROW(simplex_gradients(s, m, delaunay(s)), DataError);
}

TEST(Strain, MeanOfTheTetrahedraIsTheCellsWhateverTheFluctuation) {
  const io::Snapshot s = random_cell(100);
  io::Snapshot m = moved(s, some_gradient(3), Vec3::Zero());
  std::mt19937 random(7);
  std::uniform_real_distribution<double> any(-0.05, 0.05);
  for (Vec3& x : m.grains.position) x += Vec3(any(random), any(random), any(random));
  const std::vector<Simplex> simplices = delaunay(s);
  const std::vector<Mat3> gradients = simplex_gradients(s, m, simplices);
  Mat3 mean_gradient = Mat3::Zero();
  for (std::size_t k = 0; k < simplices.size(); ++k)
    mean_gradient += simplices[k].volume * gradients[k] / cell_volume(s);
  EXPECT_LT((mean_gradient - some_gradient(3)).norm(), 1e-10);  // Gauss's theorem
}

// Four disks in two triangles: (0,0), (1,0), (0,1), and beyond them (3,3), which moves alone by (0.3, 0).
std::pair<io::Snapshot, io::Snapshot> four_disks() {
  io::Snapshot s;
  s.grains.dimension = 2;
  s.cell.matrix = 10 * Mat3::Identity();
  s.cell.periodic = {false, false, false};
  for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(3, 3, 0)}) test::add_grain(s, x, 0.1);
  io::Snapshot m = s;
  m.grains.position[3].x() += 0.3;
  return {s, m};
}

TEST(Strain, OfAMotionThatIsNotAffineIsThatOfEachTriangleAndItsMeanByArea) {
  const auto [s, m] = four_disks();
  const std::vector<Simplex> simplices = delaunay(s);
  ASSERT_EQ(simplices.size(), 2U);
  const std::vector<Mat3> gradients = simplex_gradients(s, m, simplices);
  // The far triangle's F maps its side (-1,1) onto itself and (2,3) onto (2.3,3): F = I + 0.3 e_x (1/5, 1/5)^T.
  Mat3 far = Mat3::Identity();
  far(0, 0) += 0.06, far(0, 1) += 0.06;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool near = simplices[k].volume < 1;
    EXPECT_NEAR(simplices[k].volume, near ? 0.5 : 2.5, 1e-15);
    EXPECT_LT((gradients[k] - (near ? Mat3(Mat3::Identity()) : far)).norm(), 1e-14);
  }
  // Disks of both triangles take 1/6 of the near one and 5/6 of the far one.
  const std::vector<Mat3> grains = grain_gradients(s, m, simplices, gradients);
  const Mat3 shared = (Mat3::Identity() + 5 * far) / 6;
  EXPECT_LT((grains[0] - Mat3::Identity()).norm(), 1e-14);
  EXPECT_LT((grains[1] - shared).norm() + (grains[2] - shared).norm(), 1e-14);
  EXPECT_LT((grains[3] - far).norm(), 1e-14);
}

TEST(Strain, BestFitOfAMotionThatIsNotAffineIsTheLeastSquaresOne) {
  // About their middle, sum x x^T = diag(2, 2). One of four disks moves by (0.2, 0.1), so the mean moves by a quarter
  // of it and leaves the sums of x u^T: 0.2 and 0.1 at the place (1, 0), half of each in F. Disks recorded whole cells
  // away count where they lie in the cell.
  io::Snapshot s;
  s.grains.dimension = 2;
  s.cell.matrix = 10 * Mat3::Identity();
  s.cell.periodic = {true, true, false};
  for (const Vec3& x : {Vec3(6, 5, 0), Vec3(4 - 20, 5, 0), Vec3(5, 6 + 10, 0), Vec3(5, 4, 0)})
    test::add_grain(s, x, 0.1);
  io::Snapshot m = s;
  m.grains.position[0] += Vec3(0.2, 0.1, 0);
  Mat3 expected = Mat3::Identity();
  expected(0, 0) += 0.1, expected(1, 0) += 0.05;
  EXPECT_LT((best_fit_gradient(s, m, whole(s).grains) - expected).norm(), 1e-14);
}

TEST(Strain, IsNaturalAndCompressionPositive) {
  io::CellRecord cell;
  cell.deformation_gradient = Vec3(1.1, 0.9, 0.8).asDiagonal();
  const Mat3 strain = cell_strain(cell);
  EXPECT_LT((strain - Mat3(Vec3(-std::log(1.1), -std::log(0.9), -std::log(0.8)).asDiagonal())).norm(), 1e-15);
  EXPECT_NEAR(volumetric_strain(strain, 3), -std::log(1.1 * 0.9 * 0.8), 1e-15);
  // Triaxial: the deviatoric strain is 2/3 of the difference of the principal strains; in the plane the difference.
  const Mat3 triaxial = Vec3(-0.01, -0.01, 0.05).asDiagonal();
  EXPECT_NEAR(deviatoric_strain(triaxial, 3), 2.0 / 3 * 0.06, 1e-15);
  const Mat3 biaxial = Vec3(-0.01, 0.05, 0).asDiagonal();
  EXPECT_NEAR(deviatoric_strain(biaxial, 2), 0.06, 1e-15);
  // A rotation after the stretch turns the strain and adds none.
  const Mat3 turn = Eigen::AngleAxisd(0.5, Vec3(0, 0, 1)).toRotationMatrix();
  EXPECT_LT((natural_strain(turn * cell.deformation_gradient) - turn * strain * turn.transpose()).norm(), 1e-14);
}

TEST(Strain, OfTooFewOrFlatGrainsIsRefused) {
  const io::Snapshot s = simple_cubic(4, Vec3::Ones());
  EXPECT_THROW(best_fit_gradient(s, s, {0, 1, 4}), DataError);
  EXPECT_THROW(best_fit_gradient(s, s, {0, 1, 4, 5, 6}), DataError);
}

}  // namespace
}  // namespace soilweave::analysis
