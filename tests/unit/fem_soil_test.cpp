// The finite elements alone: patch tests, masses, rotation, supports and tractions; the continuum laws.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <numeric>

#include "core/error.h"
#include "fem/material/continuum_laws.h"
#include "fem/model/soil.h"
#include "support/fem_parts.h"
#include "support/same_state.h"
#include "support/states.h"

namespace soilweave::fem {
namespace {

using std::numbers::pi;

struct Case {
  Shape shape;
  Integration integration;
};
const std::vector<Case> cases = {{Shape::triangle3, Integration::reduced},
                                 {Shape::quadrilateral8, Integration::reduced},
                                 {Shape::quadrilateral8, Integration::full}};

Mesh distorted(Shape shape) {
  Mesh mesh = rectangle(1.2, 0.9, 3, 3, shape);
  for (Index n = 0; n < mesh.nodes.size(); ++n) {
    Vec2& x = mesh.nodes[n];
    const double inside = std::sin(pi * x[0] / 1.2) * std::sin(pi * x[1] / 0.9);
    x += 0.06 * inside * Vec2(std::cos(7.0 * static_cast<double>(n)), std::sin(5.0 * static_cast<double>(n)));
  }
  return mesh;
}

Points elastic(const Soil& soil, const ContinuumLaw& law = {}) {
  Points points;
  for (Index p = 0; p < soil.points(); ++p) points.push_back(std::make_unique<ContinuumPoint>(law));
  return points;
}

std::vector<Mat2> stresses(const Points& points) {
  std::vector<Mat2> all;
  for (const auto& p : points) all.push_back(p->stress());
  return all;
}

std::vector<Vec2> none(const Soil& soil) { return std::vector<Vec2>(soil.positions().size(), Vec2::Zero()); }

TEST(Soil, PassesThePatchTestToRoundOff) {
  for (const Case& c : cases) {
    const Mat2 gradient = (Mat2() << 0.3, -0.2, 0.5, 0.1).finished();
    Soil soil({distorted(c.shape), c.integration, 2000, 0, {{"all", {}, {}, gradient}}, {}});
    const Points points = elastic(soil);
    const double dt = 1e-5;
    soil.step(stresses(points), none(soil), dt);
    for (Index p = 0; p < soil.points(); ++p) {
      points[p]->advance(soil.gradients()[p]);
      EXPECT_NEAR((soil.gradients()[p] - dt * gradient).norm(), 0, 4e-18);
      EXPECT_NEAR((points[p]->stress() - points[0]->stress()).norm() / points[0]->stress().norm(), 0, 1e-12);
    }
    const std::vector<Vec2> forces = soil.internal_forces(stresses(points));
    Vec2 sum = Vec2::Zero();
    double greatest = 0;
    for (const Vec2& f : forces) sum += f, greatest = std::max(greatest, f.norm());
    EXPECT_LT(sum.norm(), 1e-13 * greatest);
    for (Index n = 0; n < forces.size(); ++n) {
      const Vec2& x = soil.mesh().nodes[n];
      const bool edge = x[0] < 1e-9 || x[1] < 1e-9 || x[0] > 1.2 - 1e-9 || x[1] > 0.9 - 1e-9;
      if (!edge) {
        EXPECT_LT(forces[n].norm(), 1e-12 * greatest) << "node " << n;
      }
    }
  }
}

TEST(Soil, LumpsPositiveMassesThatSumToTheWhole) {
  for (const Case& c : cases) {
    const Soil soil({distorted(c.shape), c.integration, 2000, 0, {}, {}});
    EXPECT_NEAR(std::accumulate(soil.masses().begin(), soil.masses().end(), 0.0), 2000 * 1.2 * 0.9, 1e-9);
    for (const double m : soil.masses()) EXPECT_GT(m, 0);
  }
}

TEST(Soil, LumpsAnElementByTheDiagonalOfItsConsistentMass) {
  // Hinton, Rock & Zienkiewicz: the integral of N^2 over the square, scaled to the whole. Corners and middles of the
  // serendipity element are as 3 to 16, and 4 (3 + 16) = 76; the three nodes of a triangle are equal.
  const double density = 2000, area = 0.6 * 0.4;
  const Soil square({rectangle(0.6, 0.4, 1, 1, Shape::quadrilateral8), Integration::reduced, density, 0, {}, {}});
  const auto& nodes = square.mesh().elements[0];
  for (Index k = 0; k < 8; ++k)
    EXPECT_NEAR(square.masses()[nodes[k]] / (density * area), (k < 4 ? 3.0 : 16.0) / 76, 1e-14) << "node " << k;
  Mesh triangle;
  triangle.nodes = {{0, 0}, {0.6, 0}, {0.1, 0.8}};
  triangle.elements = {{0, 1, 2}};
  const Soil third({triangle, Integration::reduced, density, 0, {}, {}});
  for (const double m : third.masses()) EXPECT_NEAR(m / (density * 0.24), 1.0 / 3, 1e-14);
}

TEST(Soil, PointsOfIntegrationStandForTheirPartOfTheArea) {
  for (const Case& c : cases) {
    const Soil soil({distorted(c.shape), c.integration, 2000, 0, {}, {}});
    double area = 0;
    Vec2 moment = Vec2::Zero();
    for (Index p = 0; p < soil.points(); ++p)
      area += soil.soil_point(p).area, moment += soil.soil_point(p).area * soil.soil_point(p).position;
    EXPECT_NEAR(area, 1.2 * 0.9, 1e-14);
    // One or two points per side are exact only for straight sides.
    if (c.integration == Integration::full || c.shape == Shape::triangle3) {
      EXPECT_LT((moment / area - Vec2(0.6, 0.45)).norm(), 1e-3);
    }
  }
}

TEST(Soil, BoundsTheEigenvalueOfTheWholeMesh) {
  // With one element the bound is its own largest eigenvalue. A right triangle of unit legs, modulus and density
  // without shear stiffness has masses 1/6 and K = 1/2 g g^T with g = (-1,1,0) along x: eigenvalue 2 * (1/2)/(1/6).
  Mesh mesh;
  mesh.nodes = {{0, 0}, {1, 0}, {0, 1}};
  mesh.elements = {{0, 1, 2}};
  const Soil soil({mesh, Integration::reduced, 1, 0, {}, {}});
  Mat3 tangent = Mat3::Zero();
  tangent(0, 0) = 1;
  EXPECT_NEAR(soil.largest_eigenvalue([&](Index) { return tangent; }), 6, 1e-12);
}

TEST(Soil, ARigidRotationLeavesNoStress) {
  for (const Case& c : cases) {
    Soil soil({distorted(c.shape), c.integration, 2000, 0, {}, {}});
    const Points points = elastic(soil);
    // Large steps of a whole degree are rotated exactly.
    Mesh turned = soil.mesh();
    const double step = pi / 180;
    const Mat2 turn = (Mat2() << std::cos(step), -std::sin(step), std::sin(step), std::cos(step)).finished();
    for (int k = 0; k < 360; ++k)
      for (const auto& p : points) p->advance(turn - Mat2::Identity());
    for (const auto& p : points) EXPECT_LT(p->stress().norm(), 1e-12 * 1e7 * 360);
  }
  ContinuumLaw law;
  law.initial_stress = Vec3(-1e3, -3e3, -2e3);
  ContinuumPoint point(law);
  const double step = pi / 2 / 50;
  const Mat2 turn = (Mat2() << std::cos(step), -std::sin(step), std::sin(step), std::cos(step)).finished();
  for (int k = 0; k < 50; ++k) point.advance(turn - Mat2::Identity());
  EXPECT_NEAR((point.stress() - Mat2(Vec2(-3e3, -1e3).asDiagonal())).norm(), 0, 1e-5)
      << "stress turns with the material";
}

TEST(Soil, OneStepOfThirtyDegreesTurnsTheStressExactly) {
  // The gradient R - I has the midway spin 2 tan(15 deg), whose Cayley transform (Hughes & Winget) is R itself.
  ContinuumLaw law;
  law.initial_stress = Vec3(-1e3, -3e3, -2e3);
  ContinuumPoint point(law);
  const double c = std::sqrt(3.0) / 2, s = 0.5;
  const Mat2 turn = (Mat2() << c, -s, s, c).finished();
  point.advance(turn - Mat2::Identity());
  // R diag(a, b) R^T: xx = c^2 a + s^2 b, yy = s^2 a + c^2 b, xy = s c (a - b).
  const Mat2 expected = (Mat2() << -1500, 2000 * s * c, 2000 * s * c, -2500).finished();
  EXPECT_LT((point.stress() - expected).norm(), 1e-12 * 3e3);
  EXPECT_NEAR(test::out_of_plane_stress(point), -2e3, 1e-12 * 2e3);
}

TEST(Soil, AStretchStrainsByTheGradientOfTheConfigurationMidway) {
  // Stretch by 1.2 in one step: du/dx halfway is 0.2/1.1. The shear strain 2 eps_xy of u_x = 0.02 y is 0.02/1.1 too.
  ContinuumPoint point(ContinuumLaw{1e7, 0.25, {}, 0, 0, Vec3::Zero()});
  point.advance((Mat2() << 0.2, 0, 0, 0).finished());
  const double lame = 1e7 * 0.25 / (1.25 * 0.5), shear = 1e7 / 2.5, strain = 0.2 / 1.1;
  EXPECT_NEAR(point.stress()(0, 0) / ((lame + 2 * shear) * strain), 1, 1e-14);
  EXPECT_NEAR(point.stress()(1, 1) / (lame * strain), 1, 1e-14);
  EXPECT_NEAR(test::out_of_plane_stress(point) / (lame * strain), 1, 1e-14);
  // Stored: sigma : eps / 2, no strain out of the plane.
  EXPECT_NEAR(point.energy().stored / (0.5 * (lame + 2 * shear) * strain * strain), 1, 1e-14);
}

TEST(Soil, APressureOnABlockGoesToItsNodesByTheShapeFunctionsOfTheEdge) {
  // Without stress and damping the first step gives every node the velocity of its load: m v = f dt. An edge of length
  // 1 gives its two nodes half of its load each; with a node in between the shares are 1/6, 2/3, 1/6 (integrals of the
  // quadratic shape functions).
  const double dt = 1e-3, pressure = 70;
  for (const Case& c : cases) {
    Soil soil({rectangle(2, 1, 2, 1, c.shape), c.integration, 1000, 0, {}, {{"top", Vec2(0.3, -1) * pressure}}});
    soil.step(std::vector<Mat2>(soil.points(), Mat2::Zero()), none(soil), dt);
    Vec2 sum = Vec2::Zero();
    for (Index n = 0; n < soil.masses().size(); ++n) {
      const Vec2 force = soil.masses()[n] / dt * soil.velocities()[n], at = soil.mesh().nodes[n];
      const bool end = at[0] == 0 || at[0] == 2, middle = at[0] == 1;
      const double share = at[1] != 1                    ? 0
                           : c.shape == Shape::triangle3 ? (end ? 0.5 : 1)
                           : end                         ? 1.0 / 6
                           : middle                      ? 1.0 / 3
                                                         : 2.0 / 3;
      EXPECT_LT((force - share * pressure * Vec2(0.3, -1)).norm(), 1e-12 * pressure) << at.transpose();
      sum += force;
    }
    EXPECT_LT((sum - 2 * pressure * Vec2(0.3, -1)).norm(), 1e-12 * pressure);
  }
}

TEST(Soil, ABlockUnderTheTractionsOfItsUniformStressStaysAtRest) {
  // Internal forces of a uniform stress balance the consistent loads of its tractions at every node.
  const Mat2 stress = (Mat2() << -300, 120, 120, -500).finished();
  const auto side = [&](const std::string& name, const Vec2& outward) { return Traction{name, stress * outward}; };
  for (const Case& c : cases) {
    Soil soil({rectangle(1.2, 0.9, 3, 2, c.shape),
               c.integration,
               1000,
               0,
               {},
               {side("top", {0, 1}), side("bottom", {0, -1}), side("left", {-1, 0}), side("right", {1, 0})}});
    const double dt = 1e-3;
    soil.step(std::vector<Mat2>(soil.points(), stress), none(soil), dt);
    for (Index n = 0; n < soil.masses().size(); ++n)
      EXPECT_LT(soil.masses()[n] / dt * soil.velocities()[n].norm(), 1e-12 * 500) << "node " << n;
  }
}

TEST(Soil, TractionsAndViscosityMoveAFreeBlockAsOne) {
  for (const Case& c : cases) {
    const double c_viscous = 3, dt = 1e-4;
    Soil soil({rectangle(2, 1, 2, 1, c.shape),
               c.integration,
               1000,
               c_viscous,
               {},
               {{"top", Vec2(0, -50)}, {"bottom", Vec2(0, -50)}}});
    const Points points = elastic(soil, {1e12, 0.2, {}, 0, 0, Vec3::Zero()});
    const double force = -200, mass = 2000;
    double v = 0;
    Vec2 momentum = Vec2::Zero();
    for (int k = 0; k < 5; ++k) {
      soil.step(stresses(points), none(soil), dt);
      v = ((2 - c_viscous * dt) * v + 2 * dt * force / mass) / (2 + c_viscous * dt);  // thesis Eq. 6.2
      momentum.setZero();
      for (Index n = 0; n < soil.masses().size(); ++n) momentum += soil.masses()[n] * soil.velocities()[n];
    }
    EXPECT_NEAR(momentum[1] / mass, v, 1e-12 * std::abs(v));
    EXPECT_NEAR(momentum[0], 0, 1e-12);
    // Every term is multiplied by the mean velocity of a step, so nothing is left over.
    const SoilEnergies e = soil.energies();
    EXPECT_GT(e.viscous, 1e-4 * e.traction_work);
    EXPECT_LT(std::abs(e.error()), 1e-12 * e.traction_work);
  }
}

TEST(Soil, SupportsThatMoveACommonNodeDifferentlyAreRefused) {
  const Mesh mesh = rectangle(1, 1, 2, 2, Shape::triangle3);
  const auto refused = [&](const Support& first, const Support& second, const std::string& words) {
    io::test::expect_error<DataError>([&] { held_nodes(mesh, {first, second}); }, words);
    EXPECT_THROW(held_nodes(mesh, {second, first}), DataError) << "in either order";
  };
  const Mat2 shrinking = (Mat2() << -0.1, 0, 0, 0).finished();
  refused({"bottom", 0.0, 0.0, {}}, {"right", 0.1, {}, {}},
          "the supports on \"bottom\" and \"right\" move their common node at (1, 0) m differently along x: by 0 m/s "
          "and by "
          "0.1 m/s; give both one velocity");
  refused({"right", -0.1, {}, {}}, {"all", {}, {}, shrinking},
          "along x: by -0.1 m/s and by 0 m/s plus the gradient (-0.1, 0) 1/s");  // equal at the start alone
  const auto held = [&](const std::vector<Support>& supports) { return held_nodes(mesh, supports); };
  EXPECT_NO_THROW(held({{"bottom", {}, 0.0, {}}, {"right", 0.1, {}, {}}})) << "other axes";
  EXPECT_NO_THROW(held({{"bottom", 0.0, {}, {}}, {"top", 0.1, {}, {}}})) << "no common node";
  EXPECT_NO_THROW(held({{"right", 0.1, {}, {}}, {"all", 0.1, {}, {}}})) << "one velocity";
  EXPECT_NO_THROW(held({{"left", 0.0, {}, {}}, {"all", {}, {}, shrinking}})) << "the left side is at x = 0";
  const HeldNode corner = held({{"right", {}, 0.2, {}}, {"top", 0.3, {}, {}}}).back();
  EXPECT_EQ(corner[0]->constant, 0.3);
  EXPECT_EQ(corner[1]->constant, 0.2);
}

TEST(Soil, ACrushedElementIsNamed) {
  const Mat2 gradient = (Mat2() << 0, 0, 0, -1).finished();
  Soil soil({rectangle(1, 1, 1, 1, Shape::triangle3), Integration::reduced, 1000, 0, {{"all", {}, {}, gradient}}, {}});
  const Points points = elastic(soil);
  soil.step(stresses(points), none(soil), 1.5);
  io::test::expect_error<PhysicsError>([&] { soil.step(stresses(points), none(soil), 0.1); }, "element 0 has the area");
}

TEST(MohrCoulomb, ReturnsToTheSurfaceAndStaysInside) {
  io::test::Numbers any;
  const double bulk = 1e7, shear = 5e6, cohesion = 2e3;
  for (int k = 0; k < 2000; ++k) {
    const double f = std::sin((5 + 80 * (any() + 0.5)) * pi / 180), d = f * (any() + 0.5);
    Vec3 trial = 5e4 * any.vector();
    std::sort(trial.data(), trial.data() + 3, std::greater<>());
    const Vec3 s = mohr_coulomb_return(trial, bulk, shear, f, d, cohesion);
    const double limit = 2 * cohesion * std::sqrt(1 - f * f);
    const double yield = s[0] - s[2] + (s[0] + s[2]) * f - limit;
    EXPECT_GE(s[0] - s[1], -1e-6);
    EXPECT_GE(s[1] - s[2], -1e-6);
    EXPECT_LE(yield, 1e-6 * trial.norm());
    const double before = trial[0] - trial[2] + (trial[0] + trial[2]) * f - limit;
    if (before <= 0) {
      EXPECT_EQ(s, trial);
    } else {
      EXPECT_NEAR(yield, 0, 1e-6 * trial.norm());
    }
  }
}

TEST(MohrCoulomb, ShearedAtConstantVolumeCarriesPSinPhi) {
  ContinuumLaw law;
  law.friction_angle = 30 * pi / 180;
  law.initial_stress = Vec3::Constant(-1e4);
  ContinuumPoint point(law);
  for (int k = 0; k < 2000; ++k) point.advance((Mat2() << 1e-5, 0, 0, -1e-5).finished());
  const Mat2 s = point.stress();
  // Without dilation the mean stress in the plane is constant; at failure half the difference is p sin(phi). 2000 steps
  // of 1e-5 shrink the area by 2000 (1e-5)^2: 1.6 Pa.
  EXPECT_NEAR(0.5 * s.trace(), -1e4, 2);
  EXPECT_NEAR(0.5 * (s(0, 0) - s(1, 1)), 1e4 * 0.5, 2);
  // It yields at half a difference of 5 kPa, a strain of 5e3/(2 G) = 6.25e-4. From there on all work, 2 x 5 kPa times
  // the strain, is dissipated.
  const double plastic = 0.02 - 5e3 / (2 * 1e7 / 2.5);
  EXPECT_NEAR(point.energy().dissipated / (2 * 5e3 * plastic), 1, 1e-3);
}

}  // namespace
}  // namespace soilweave::fem
