// Work and energy of moving planes, clamps, cells and sliding grains against closed forms: their values, and the half
// step to which they belong.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"
#include "support/assemblies.h"
#include "support/impact.h"
#include "support/pair.h"

namespace soilweave::dem {
namespace {

using test::scene;
using test::Sphere;
using test::undamped;

constexpr double g = 9.81, R = 0.01, density = 2650, E = 1e8;

Linear::Material linear(double mu, Resistance rolling = {}, Resistance twisting = {}) {
  return {E, 0.8, std::atan(mu), {}, rolling, twisting};
}
Model three(const Linear::Material& m) { return {std::vector<Linear::Material>{m, m, m}}; }

Sphere touching_the_plane() { return {R, density, Vec3(0.1, 0.1, R), Vec3::Zero()}; }

const double mass = touching_the_plane().mass();
// Two equal radii of one modulus, or a radius and a plane, have kn = 2 E r E r/(2 E r).
const double stiffness = E * R, frequency = std::sqrt(stiffness / mass);

// Expects the ratio of the errors of two steps, one half the other: 4 for a quantity at the right time, 2 for one that
// is off by half a step.
void expect_second_order(const std::function<double(double dt)>& error, double coarse, double scale) {
  const double at_coarse = error(coarse), at_fine = error(coarse / 2);
  EXPECT_NEAR(at_coarse / at_fine, 4, 0.1) << at_coarse << " and " << at_fine;
  EXPECT_LT(std::abs(at_fine), 1e-3 * scale);
}

// A sphere released at an overlap A on its spring follows A cos(wt) as long as it presses, so its kinetic energy is
// (m/2) (A w sin wt)^2. Velocities are given half a step before the positions.
TEST(Energies, KineticEnergyIsThatOfThePositionsTime) {
  const double overlap = 1e-5, most = 0.5 * mass * std::pow(overlap * frequency, 2);
  const auto error = [&](double dt) {
    Sphere s = touching_the_plane();
    s.position.z() -= overlap;
    s.velocity.z() = -overlap * frequency * std::sin(0.5 * frequency * dt);
    Simulation simulation(scene({s}, true), three(linear(0)), undamped(dt));
    while (simulation.time() < (1 - 1e-9) / frequency) simulation.step();
    return simulation.energies().kinetic() - most * std::pow(std::sin(frequency * simulation.time()), 2);
  };
  expect_second_order(error, 1 / frequency / 50, most);
}

// A sphere that carries its weight and twists on an elastic spring k has the spin w0 cos(Wt), W^2 = k/I.
TEST(Energies, EnergyOfRotationIsThatOfThePositionsTime) {
  const double spin = 1, k = 50, inertia = 0.4 * mass * R * R, rate = std::sqrt(k / inertia);
  const Resistance twisting{k, Resistance::Scale::absolute, {}, Resistance::Arm::mean_radius};
  const auto error = [&](double dt) {
    Sphere s = touching_the_plane();
    s.position.z() -= mass * g / stiffness;
    s.spin.z() = spin * std::cos(0.5 * rate * dt);
    Simulation simulation(scene({s}, true), three(linear(0, {}, twisting)), undamped(dt, g));
    while (simulation.time() < (1 - 1e-9) / rate) simulation.step();
    const double now = spin * std::cos(rate * simulation.time());
    return simulation.energies().kinetic() - 0.5 * inertia * now * now;
  };
  expect_second_order(error, 1 / rate / 50, 0.5 * inertia * spin * spin);
}

// A sphere and a body that moves at V: seen from the body, the sphere meets its spring at V. It is pressed by (V/w) sin
// wt, moves at V (1 - cos wt), and has taken the body's work m V^2 (1 - cos wt).
struct Pushed {
  double speed = 1e-2, angle = 2;  // m/s; wt at the end, before they part at pi
  double work() const { return mass * speed * speed * (1 - std::cos(angle)); }
  double kinetic() const { return 0.5 * mass * std::pow(speed * (1 - std::cos(angle)), 2); }
  double coarse() const { return angle / frequency / 100; }
  bool under_way(const Simulation& simulation) const { return simulation.time() < (1 - 1e-9) * angle / frequency; }
};

TEST(Energies, WorkOfAMovingPlaneIsOfSecondOrder) {
  const Pushed pushed;
  const auto after = [&](double dt) {
    io::Snapshot start = scene({touching_the_plane()}, true);
    start.planes.velocity = {Vec3(0, 0, pushed.speed)};
    Simulation simulation(start, three(linear(0)), undamped(dt));
    while (pushed.under_way(simulation)) simulation.step();
    return simulation.energies();
  };
  expect_second_order([&](double dt) { return after(dt)["boundary_work"] - pushed.work(); }, pushed.coarse(),
                      pushed.work());
  expect_second_order([&](double dt) { return after(dt).kinetic() - pushed.kinetic(); }, pushed.coarse(),
                      pushed.kinetic());
}

// A plane from afar hits a grain at rest, which leaves at twice its speed.
TEST(Energies, APlaneMovingIntoAGrainAtRestGivesItTwiceItsSpeed) {
  const double speed = 0.1;
  io::Snapshot start = scene({touching_the_plane()}, true);
  start.planes.point = {Vec3(0, 0, -0.3 * R)};
  start.planes.velocity = {Vec3(0, 0, speed)};
  Simulation simulation(start, three(linear(0)), undamped(0.02 / frequency));
  while (simulation.time() < 0.3 * R / speed + 4 / frequency) simulation.step();
  ASSERT_EQ(simulation.measures().contacts, 0);
  EXPECT_NEAR(simulation.snapshot().grains.velocity[0].z(), 2 * speed, 1e-3 * speed);
  EXPECT_NEAR(simulation.energies()["boundary_work"], 2 * mass * speed * speed, 1e-3 * mass * speed * speed);
}

TEST(Energies, WorkOfAClampIsOfSecondOrder) {
  const Pushed pushed;
  const Sphere low = touching_the_plane(), high{R, density, Vec3(0.1, 0.1, 3 * R), Vec3::Zero()};
  const auto error = [&](double dt) {
    Numerics numerics = undamped(dt);
    numerics.clamps = {{0}};
    Simulation simulation(scene({low, high}, false), three(linear(0)), numerics);
    simulation.set_clamp_velocity(0, Vec3(0, 0, pushed.speed));
    const double given = simulation.energies()["boundary_work"];
    while (pushed.under_way(simulation)) simulation.step();
    return simulation.energies()["boundary_work"] - given - pushed.work();
  };
  expect_second_order(error, pushed.coarse(), pushed.work());
}

// The work on a clamp equals the growth of its kinetic energy, faster or slower.
TEST(Energies, AClampTakesUpTheKineticEnergyOfItsGrains) {
  Numerics numerics = undamped(1e-6);
  numerics.clamps = {{0}};
  Simulation simulation(scene({touching_the_plane()}, false), three(linear(0)), numerics);
  for (const Vec3& v : {Vec3(0, 3, 0), Vec3(4, 3, 0), Vec3(0, 0, -1), Vec3(0, 0, 0)}) {
    simulation.set_clamp_velocity(0, v);
    simulation.step();
    const double kinetic = 0.5 * mass * v.squaredNorm();
    EXPECT_NEAR(simulation.energies().kinetic(), kinetic, 1e-12 * mass);
    EXPECT_NEAR(simulation.energies()["boundary_work"], kinetic, 1e-12 * mass);
  }
}

// Four spheres fill a periodic cell along x. Strained, they stay in balance, and the cell's work equals the energy of
// their four contacts, (k/2) (2 R - L/4)^2 each. A step takes the branch at both its ends, which its strain sets apart,
// so the work is off by no more than that strain.
TEST(Energies, WorkOfTheCellIsWhatItsContactsStore) {
  const int steps = 100;
  const double rate = 10, dt = 1e-6, length = 8 * R, strain = rate * dt;
  std::vector<Sphere> row;
  for (int k = 0; k < 4; ++k) row.push_back({R, density, Vec3((2 * k + 1) * R, 0.1, 0.1), Vec3::Zero()});
  io::Snapshot start = scene(row, false);
  start.cell.periodic = {true, true, true};
  start.cell.matrix(0, 0) = length;
  start.grains.material_id.assign(4, 0);
  Simulation simulation(start, three(linear(0)), undamped(dt));
  Mat3 gradient = Mat3::Zero();
  gradient(0, 0) = -rate;
  simulation.set_velocity_gradient(gradient);
  for (int k = 0; k < steps; ++k) simulation.step();
  ASSERT_EQ(simulation.measures().contacts, 4);
  const double stored = 4 * 0.5 * stiffness * std::pow(2 * R - 0.25 * length * std::pow(1 - strain, steps), 2);
  EXPECT_NEAR(simulation.energies()["elastic_normal"], stored, 1e-9 * stored);
  EXPECT_NEAR(simulation.energies()["boundary_work"], stored, strain * stored);
}

// By momentum and by the work of friction, a sphere drawn along by a plane ends at 2/7 of its speed V. The plane does
// the work (2/7) m V^2, one half of which becomes motion, the other heat.
TEST(Energies, APlaneThatDrawsASphereAlongFeelsItAndHeatsIt) {
  const double speed = 0.5, mu = 0.4, dt = 5e-6;
  Sphere s = touching_the_plane();
  s.position.z() -= mass * g / stiffness;
  io::Snapshot start = scene({s}, true);
  start.planes.velocity = {Vec3(speed, 0, 0)};
  Simulation simulation(start, three(linear(mu)), undamped(dt, g));
  for (int k = 0; k < 100; ++k) simulation.step();
  const Vec3 before = simulation.snapshot().grains.velocity[0], on_plane = simulation.plate_loads()[0].force;
  simulation.step();
  const Vec3 gained = mass * (simulation.snapshot().grains.velocity[0] - before) / dt;
  EXPECT_NEAR(on_plane.x(), -gained.x(), 1e-9 * mass * g);
  EXPECT_NEAR(on_plane.x(), -mu * mass * g, 1e-3 * mass * g) << "against the plane's way";
  EXPECT_NEAR(on_plane.z(), -mass * g - gained.z(), 1e-9 * mass * g);
  while (simulation.time() < 1.5 * 2 * speed / (7 * mu * g)) simulation.step();
  const Energies e = simulation.energies();
  const double heat = mass * speed * speed / 7;
  // The energy of the shear spring at the limit, (mu m g)^2/(2 ks), swings on as motion: 2e-5 of the heat.
  EXPECT_NEAR(e["boundary_work"], 2 * heat, 1e-3 * heat);
  EXPECT_NEAR(e["frictional"], heat, 1e-3 * heat);
  EXPECT_NEAR(e.kinetic(), heat, 1e-3 * heat);
  EXPECT_NEAR(e["law"], 0, 1e-6 * heat) << "at constant overlap the law keeps energy";
}

// Two spheres meet off their line of centres at slip speed u and part still sliding. The impulse is J = mu 2 m* v, the
// slip falls by (7/2) J/m*, and friction takes the impulse times the mean slip. No term of the balance is used.
template <class Material>
void expect_heat_of_oblique_impact(const Material& m, double dt) {
  const double mu = 0.2, normal = 1, slip = 6;
  const Sphere a{R, density, Vec3(0.4, 0.4, 0.4), Vec3(0, 0, 0)};
  const Sphere b{2 * R, 1000, Vec3(0.4, 0.4, 0.4 + 3 * R), Vec3(slip, 0, -normal)};
  const double reduced = a.mass() * b.mass() / (a.mass() + b.mass());
  const double impulse = mu * 2 * reduced * normal, left = slip - 3.5 * impulse / reduced;
  ASSERT_GT(left, 0);
  Simulation simulation(scene({a, b}, false), {std::vector<Material>{m, m}}, undamped(dt));
  const double start = simulation.energies().kinetic();
  do simulation.step();
  while (simulation.measures().contacts > 0);
  const Energies e = simulation.energies();
  const double heat = 0.5 * impulse * (slip + left);
  // The line of centres turns during contact, by u times the contact time over their distance: 1e-3.
  EXPECT_NEAR(e["frictional"], heat, 3e-3 * heat);
  EXPECT_NEAR(start - e.kinetic(), heat, 3e-3 * heat);
  EXPECT_NEAR(e["frictional"], start - e.kinetic(), 1e-3 * heat);
}

TEST(Energies, FrictionTakesItsImpulseTimesTheMeanSlip) {
  expect_heat_of_oblique_impact(Linear::Material{1e12, 0.8, std::atan(0.2), {}, {}, {}}, 1e-9);
  expect_heat_of_oblique_impact(HertzMindlin::Material{1e14, 0.2, std::atan(0.2), {}, {}, {}}, 1e-10);
}

// Head on, at speed v with restitution e, the dashpot takes (m*/2) v^2 (1 - e^2).
TEST(Energies, TheDashpotTakesWhatRestitutionLeaves) {
  const double e = 0.6, v = 2;
  const HertzMindlin::Material hertz{1e9, 0.2, 0, e, {}, {}};
  const Linear::Material m{1e9, 0.5, 0, e, {}, {}};
  for (const Model& model : {Model{std::vector<HertzMindlin::Material>{hertz, hertz}}, three(m)}) {
    const Sphere a{R, density, Vec3(0.4, 0.4, 0.4), Vec3(0, 0, v / 2)},
        b{R, density, Vec3(0.4, 0.4, 0.4 + 2 * R), Vec3(0, 0, -v / 2)};
    Simulation simulation(scene({a, b}, false), model, undamped(1e-8));
    do simulation.step();
    while (simulation.measures().contacts > 0);
    const double taken = 0.25 * mass * v * v * (1 - e * e);
    EXPECT_NEAR(simulation.energies()["viscous"], taken, 1e-3 * taken);
    EXPECT_NEAR(simulation.energies().kinetic(), 0.25 * mass * v * v * e * e, 1e-3 * taken);
  }
}

// The mass of a grain that grows at constant density follows its radius: cubed for spheres, squared for disks.
TEST(Energies, MassOfScaledGrainsFollowsTheirVolume) {
  for (const int dimension : {3, 2}) {
    Simulation s(support::packed(support::sand(), 1e5, 60, dimension), support::sand(), {});
    const double before = s.mass(), solids = s.solid_volume();
    s.scale_radii(1.0005);
    EXPECT_NEAR(s.mass() / before, std::pow(1.0005, dimension), 1e-12);
    EXPECT_NEAR(s.mass() / s.solid_volume(), before / solids, 1e-12 * before / solids);
  }
}

}  // namespace
}  // namespace soilweave::dem
