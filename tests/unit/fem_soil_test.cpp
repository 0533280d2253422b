// The finite elements alone: patch tests, masses, rotation, supports and tractions; the laws of the continuum.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>
#include <numeric>

#include "core/error.h"
#include "fem/continuum_laws.h"
#include "fem/soil.h"
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

TEST(Soil, passes_the_patch_test_to_round_off) {
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

TEST(Soil, lumps_positive_masses_that_sum_to_the_whole) {
  for (const Case& c : cases) {
    const Soil soil({distorted(c.shape), c.integration, 2000, 0, {}, {}});
    EXPECT_NEAR(std::accumulate(soil.masses().begin(), soil.masses().end(), 0.0), 2000 * 1.2 * 0.9, 1e-9);
    for (const double m : soil.masses()) EXPECT_GT(m, 0);
  }
}

TEST(Soil, bounds_the_eigenvalue_of_the_whole_mesh) {
  // One element is the whole mesh: the bound is its own largest eigenvalue. A right triangle of unit legs, unit modulus
  // and density, no shear stiffness: masses 1/6, K = 1/2 g g^T with g = (-1,1,0) along x: eigenvalue 2 * (1/2)/(1/6).
  Mesh mesh;
  mesh.nodes = {{0, 0}, {1, 0}, {0, 1}};
  mesh.elements = {{0, 1, 2}};
  const Soil soil({mesh, Integration::reduced, 1, 0, {}, {}});
  Mat3 tangent = Mat3::Zero();
  tangent(0, 0) = 1;
  EXPECT_NEAR(soil.largest_eigenvalue([&](Index) { return tangent; }), 6, 1e-12);
}

TEST(Soil, a_rigid_rotation_leaves_no_stress) {
  for (const Case& c : cases) {
    Soil soil({distorted(c.shape), c.integration, 2000, 0, {}, {}});
    const Points points = elastic(soil);
    // Large steps of a whole degree, exactly rotated.
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

TEST(Soil, tractions_and_viscosity_move_a_free_block_as_one) {
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
  }
}

TEST(Soil, a_crushed_element_is_named) {
  const Mat2 gradient = (Mat2() << 0, 0, 0, -1).finished();
  Soil soil({rectangle(1, 1, 1, 1, Shape::triangle3), Integration::reduced, 1000, 0, {{"all", {}, {}, gradient}}, {}});
  const Points points = elastic(soil);
  soil.step(stresses(points), none(soil), 1.5);
  io::test::expect_error<PhysicsError>([&] { soil.step(stresses(points), none(soil), 0.1); }, "element 0 has the area");
}

TEST(MohrCoulomb, returns_to_the_surface_and_stays_inside) {
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

TEST(MohrCoulomb, sheared_at_constant_volume_carries_p_sin_phi) {
  ContinuumLaw law;
  law.friction_angle = 30 * pi / 180;
  law.initial_stress = Vec3::Constant(-1e4);
  ContinuumPoint point(law);
  for (int k = 0; k < 2000; ++k) point.advance((Mat2() << 1e-5, 0, 0, -1e-5).finished());
  const Mat2 s = point.stress();
  // Without dilation the mean stress in the plane stays; at failure the half difference is p sin(phi).
  // 2000 steps of 1e-5 shrink the area by 2000 (1e-5)^2: 1.6 Pa.
  EXPECT_NEAR(0.5 * s.trace(), -1e4, 2);
  EXPECT_NEAR(0.5 * (s(0, 0) - s(1, 1)), 1e4 * 0.5, 2);
  EXPECT_NEAR(point.energy().dissipated / (2e-5 * 5e3 * 2000), 1, 0.1) << "most of the work is dissipated";
}

}  // namespace
}  // namespace soilweave::fem
