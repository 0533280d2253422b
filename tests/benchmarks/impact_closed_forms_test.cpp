// Bouncing, stacked, rolling, spinning and colliding spheres through the engine against closed forms.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"
#include "support/impact.h"
#include "support/pair.h"
#include "support/worse.h"

namespace soilweave::dem::test {
namespace {

constexpr double g = 9.81, R = 0.01, density = 2650;

Linear::Material linear(double mu, std::optional<double> e = {}, Resistance rolling = {}, Resistance twisting = {}) {
  return {1e8, 0.8, std::atan(mu), e, rolling, twisting};
}
Model three(const Linear::Material& m) { return {std::vector<Linear::Material>{m, m, m}}; }

// Returns a sphere whose contact with the plane carries its weight from the start: kn = E R for equal materials.
Sphere resting(double vx = 0, const Vec3& spin = Vec3::Zero()) {
  Sphere s{R, density, Vec3(0.1, 0.1, R), Vec3(vx, 0, 0), spin};
  s.position.z() -= s.mass() * g / (1e8 * R);
  return s;
}

TEST(ClosedForms, FreeFallGainsWhatGravityGives) {
  const double dt = 1e-4;
  Simulation s(scene({{R, density, Vec3(0.1, 0.1, 0.15), Vec3::Zero()}}, true), three(linear(0)), undamped(dt, g));
  for (int i = 0; i < 1000; ++i) s.step();
  // Velocities live half a step behind positions: from rest at -dt/2 the n-th position is g dt2 n(n+1)/2 below.
  EXPECT_NEAR(s.snapshot().grains.position[0].z(), 0.15 - 0.5 * g * dt * dt * 1000 * 1001, 1e-12);
}

// Returns the heights of the first bounces over e^{2k} (h0 - r), minus 1.
std::vector<double> bounce_errors(double e, double young_modulus, double dt) {
  const double h0 = 0.06;
  const HertzMindlin::Material m{young_modulus, 0.2, 0, e, {}, {}};
  const Model model{std::vector<HertzMindlin::Material>{m, m, m}};
  Simulation s(scene({{R, density, Vec3(0.1, 0.1, h0), Vec3::Zero()}}, true), model, undamped(dt, g));
  std::vector<double> errors;
  bool rising = false;
  while (errors.size() < 2) {
    s.step();
    if (s.measures().contacts) rising = true;
    if (!rising || s.measures().contacts || s.steps() % 16) continue;
    const io::GrainsRecord now = s.snapshot().grains;
    if (now.velocity[0].z() > 0) continue;
    const double k = static_cast<double>(errors.size()) + 1;
    errors.push_back((now.position[0].z() - R) / (std::pow(e, 2 * k) * (h0 - R)) - 1);
    rising = false;
  }
  return errors;
}

TEST(ClosedForms, BounceHeightsFallWithTheSquareOfRestitution) {
  for (const double e : {0.5, 0.8}) {
    // The closed form assumes an instant contact. Here gravity acts during it too and adds g t_c of speed. So heights
    // are off in proportion to the contact time: six times less at a hundred times the stiffness (t_c ~ E^-0.4).
    const auto soft = bounce_errors(e, 5e7, 2e-6), stiff = bounce_errors(e, 5e9, 3e-7);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_LT(std::abs(soft[k]), 0.06) << e;
      EXPECT_LT(std::abs(stiff[k]), 0.01) << e;  // 2 g t_c/v: 0.9 % at the slowest, 0.5 m/s
      EXPECT_GT(soft[k] / stiff[k], 4) << e;
    }
  }
}

TEST(ClosedForms, ElasticStackOfTwoKeepsItsEnergy) {
  Sphere low{R, density, Vec3(0.1, 0.1, R), Vec3::Zero()}, high{R, density, Vec3(0.1, 0.1, 3 * R), Vec3::Zero()};
  Simulation s(scene({low, high}, true), three(linear(0.5)), undamped(2e-6, g));
  const double potential = low.mass() * g * 4 * R;
  double worst = 0;
  for (int i = 0; i < 50000; ++i) {
    s.step();
    worst = soilweave::test::worse(worst, std::abs(s.energies().error()));
  }
  EXPECT_LT(worst, 1e-6 * potential);
}

TEST(ClosedForms, SlidingTurnsIntoRollingAtFiveSeventhsOfTheSpeed) {
  const double u0 = 0.5, mu = 0.4;
  Simulation s(scene({resting(u0)}, true), three(linear(mu)), undamped(5e-6, g));
  const double rolling_at = 2 * u0 / (7 * mu * g);
  while (s.time() < 0.5 * rolling_at) s.step();
  EXPECT_NEAR(s.snapshot().grains.velocity[0].x(), u0 - mu * g * s.time(), 1e-3 * u0);
  double u = 0, w = 0;
  int n = 0;
  while (s.time() < 1.5 * rolling_at) {
    s.step();
    if (s.time() < 1.1 * rolling_at) continue;  // averaged over the shear spring's own small oscillation
    const io::Snapshot now = s.snapshot();
    u += now.grains.velocity[0].x(), w += now.grains.angular_velocity[0].y(), ++n;
  }
  EXPECT_NEAR(u / n, 5 * u0 / 7, 1e-3 * u0);
  EXPECT_NEAR(w / n * R, 5 * u0 / 7, 1e-3 * u0);
}

TEST(ClosedForms, SpinRunsDownUnderRollingAndTwistingLimits) {
  const double limit = 0.1, w0 = 30;
  const Resistance r{50.0, Resistance::Scale::absolute, limit, Resistance::Arm::mean_radius};
  for (const bool twist : {false, true}) {
    const Vec3 spin = twist ? Vec3(0, 0, w0) : Vec3(0, w0, 0);
    Simulation s(scene({resting(0, spin)}, true), three(linear(0, {}, r, r)), undamped(2e-6, g));
    const double duration = 0.8 * w0 * 2 * R / (5 * limit * g);
    while (s.time() < duration) s.step();
    const Vec3 now = s.snapshot().grains.angular_velocity[0];
    // M = limit R m g acts against I = 2/5 m R2.
    EXPECT_NEAR(twist ? now.z() : now.y(), w0 - 5 * limit * g * s.time() / (2 * R), 1e-3 * w0);
    const Energies e = s.energies();
    EXPECT_NEAR(e["rolling_plastic"] + e.kinetic() + e["elastic_rolling"] + e["elastic_twisting"],
                0.5 * 0.4 * resting().mass() * R * R * w0 * w0, 1e-3 * e["rolling_plastic"]);
  }
}

TEST(ClosedForms, UnequalSpheresKeepMomentumAndRestitution) {
  for (const bool hertz : {false, true}) {
    const double e = 0.7;
    const HertzMindlin::Material h{1e9, 0.25, 0.5, e, {}, {}};
    const Model model = hertz ? Model{std::vector<HertzMindlin::Material>{h, h}} : three(linear(0.5, e));
    Sphere a{R, density, Vec3(0.4, 0.4, 0.4), Vec3(0.3, 0, 1.5)},
        b{2 * R, 1000, Vec3(0.4, 0.4, 0.4 + 3 * R), Vec3(0, 0.2, -0.5)};
    const Impact impact = collide({a, b}, false, model, hertz ? 5e-9 : 2e-8);
    const Vec3 before = a.mass() * a.velocity + b.mass() * b.velocity;
    const Vec3 after = a.mass() * impact.after.velocity[0] + b.mass() * impact.after.velocity[1];
    EXPECT_LT((after - before).norm(), 1e-12 * before.norm());
    // The line of centres turns by the tangential speed times the contact time: 1e-3 of the normal speed at most.
    EXPECT_NEAR((impact.after.velocity[1] - impact.after.velocity[0]).z(), e * 2.0, 5e-3 * 2.0);
  }
}

TEST(ClosedForms, HertzPeakHoldsTheEnergyOfTheApproach) {
  const HertzMindlin::Material m{5e9, 0.2, 0, {}, {}, {}};
  Sphere a{R, density, Vec3(0.4, 0.4, 0.4), Vec3(0, 0, 1)}, b{R, density, Vec3(0.4, 0.4, 0.4 + 2 * R), Vec3(0, 0, -1)};
  const Impact impact = collide({a, b}, false, {std::vector<HertzMindlin::Material>{m, m}}, 2e-8);
  const double reduced = a.mass() / 2;
  EXPECT_NEAR(0.4 * impact.largest_force * impact.largest_overlap, 0.5 * reduced * 4, 1e-5 * 2 * reduced);
}

TEST(ClosedForms, SpinningSphereLeavesWithTheFrictionalImpulse) {
  const double mu = 0.2, e = 0.8, vn = 1, w = 400;  // far beyond sticking: 3.5 mu (1 + e) vn = 1.26 < w R = 4
  const HertzMindlin::Material m{5e9, 0.2, std::atan(mu), e, {}, {}};
  const Impact impact = collide({{R, density, Vec3(0.1, 0.1, R), Vec3(0, 0, -vn), Vec3(0, w, 0)}}, true,
                                {std::vector<HertzMindlin::Material>{m, m, m}}, 1e-8);
  const double impulse = mu * (1 + e) * vn;
  EXPECT_NEAR(impact.after.velocity[0].x(), impulse, 2e-3 * impulse);
  EXPECT_NEAR(impact.after.angular_velocity[0].y(), w - 2.5 * impulse / R, 2e-3 * 2.5 * impulse / R);
}

}  // namespace
}  // namespace soilweave::dem::test
