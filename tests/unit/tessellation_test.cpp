// Power cells and tetrahedra fill the cell; lattices have equal ones; affine motions give exact strains.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tessellation.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "analysis/strain.h"
#include "analysis/volume_of_interest.h"
#include "core/error.h"
#include "support/assembly.h"

namespace soilweave::analysis {
namespace {

using test::random_cell;
using test::simple_cubic;

// Moves an assembly, with its cell, by a homogeneous deformation and a translation.
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
