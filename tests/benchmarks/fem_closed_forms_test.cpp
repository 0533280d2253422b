// The finite elements against closed forms: waves and bars with their order of convergence, a cantilever, the energy.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <numbers>

#include "fem/model/model.h"
#include "support/fem_parts.h"

namespace soilweave::fem {
namespace {

using std::numbers::pi;

constexpr double young = 4e6, density = 1600;

ModelSetup block(double length, double height, Index columns, Index rows, Shape shape, double poisson) {
  ModelSetup setup;
  setup.soil.mesh = rectangle(length, height, columns, rows, shape);
  setup.soil.density = density;
  setup.law = ContinuumLaw{young, poisson, {}, 0, 0, Vec3::Zero()};
  return setup;
}

// Returns the RMS error of a standing wave's displacement sin(k x) cos(w t) after most of a period, over its amplitude.
double wave_error(Index elements, Shape shape, bool fixed_both) {
  const double length = 1, amplitude = 1e-7, poisson = 0.25;
  ModelSetup setup = block(length, length / static_cast<double>(elements), elements, 1, shape, poisson);
  setup.soil.supports = {{"left", 0.0, {}, {}}, {"top", {}, 0.0, {}}, {"bottom", {}, 0.0, {}}};
  if (fixed_both) setup.soil.supports.push_back({"right", 0.0, {}, {}});
  const double speed = std::sqrt(young * (1 - poisson) / ((1 + poisson) * (1 - 2 * poisson)) / density);
  const double k = pi / length * (fixed_both ? 1 : 0.5), omega = k * speed, end = 0.8 * 2 * pi / omega;
  setup.interval = end;
  setup.safety = 0.5;
  Model model(std::move(setup));
  std::vector<Vec2> v;
  for (const Vec2& x : model.soil().positions())
    v.emplace_back(amplitude * omega * std::sin(k * x[0]) * std::cos(0.5 * omega * model.time_step()), 0);
  test::set_velocities(model.soil(), v);
  while (model.time() < end * (1 - 1e-9)) model.step();
  double sum = 0;
  const auto& nodes = model.soil().mesh().nodes;
  for (Index n = 0; n < nodes.size(); ++n) {
    const double exact = amplitude * std::sin(k * nodes[n][0]) * std::sin(omega * model.time());
    sum += std::pow(model.soil().displacements()[n][0] - exact, 2);
  }
  return std::sqrt(sum / static_cast<double>(nodes.size())) / amplitude;
}

TEST(FiniteElements, WavesAndVibratingBarsConvergeWithTheSecondOrder) {
  for (const bool fixed_both : {true, false})
    for (const Shape shape : {Shape::triangle3, Shape::quadrilateral8}) {
      const double coarse = wave_error(16, shape, fixed_both), fine = wave_error(32, shape, fixed_both);
      const double order = std::log2(coarse / fine);
      RecordProperty(std::string("order_") + (fixed_both ? "wave_" : "bar_") + name_of(shape), std::to_string(order));
      EXPECT_GT(order, 1.8) << name_of(shape) << ' ' << coarse << ' ' << fine;
      EXPECT_LT(fine, 0.02);
    }
}

// A slenderness of 1:8 without Poisson effect gives bending and shear of Timoshenko's beam.
TEST(FiniteElements, ACantileverBendsAsABeamDoes) {
  for (const Integration integration : {Integration::reduced, Integration::full}) {
    const double length = 2, height = 0.25, load = 2;  // along the end, Pa
    ModelSetup setup = block(length, height, 8, 1, Shape::quadrilateral8, 0);
    setup.soil.integration = integration;
    setup.soil.supports = {{"left", 0.0, 0.0, {}}};
    setup.soil.tractions = {{"right", Vec2(0, -load)}};
    const double inertia = std::pow(height, 3) / 12, force = load * height;
    const double omega = 3.516 * std::sqrt(young * inertia / (density * height)) / (length * length);
    setup.soil.damping = 2 * omega;  // critical in the first mode
    setup.safety = 0.8;
    Model model(std::move(setup));
    while (model.time() < 10 / omega) model.step();
    const double bending = force * std::pow(length, 3) / (3 * young * inertia),
                 shear = force * length / (5.0 / 6 * 0.5 * young * height);
    double tip = 0;
    for (Index n = 0; n < model.soil().positions().size(); ++n)
      if (model.soil().mesh().nodes[n] == Vec2(length, 0)) tip = -model.soil().displacements()[n][1];
    // The clamped end hinders the warping of its section a little; 10/omega leaves e^-10 (1 + 10) of the way.
    EXPECT_NEAR(tip / (bending + shear), 1, 0.01);
  }
}

TEST(FiniteElements, EnergyIsKeptAndAccountedFor) {
  ModelSetup setup = block(1, 1, 4, 4, Shape::triangle3, 0.25);
  setup.soil.damping = 0.5;
  setup.soil.supports = {{"bottom", 0.0, 0.0, {}}};
  setup.soil.tractions = {{"top", Vec2(300, -500)}};
  setup.safety = 0.5;
  Model model(std::move(setup));
  while (model.time() < 0.5) model.step();
  const Balance b = model.balance();
  EXPECT_GT(b.stored, 0.01 * b.external);
  // The stored energy comes from the points, the rest from the nodes, so the balance is no identity.
  EXPECT_LT(std::abs(b.error()), 2e-3 * b.external);
}

}  // namespace
}  // namespace soilweave::fem
