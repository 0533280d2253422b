// The geosynthetic alone: tension, catenary, friction between flat sides, breakage, energy, and forces read without a
// step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/error.h"
#include "fem/model/guides.h"
#include "support/same_state.h"

namespace soilweave::fem {
namespace {

constexpr double degree = std::numbers::pi / 180;

BarsSetup sheet() {
  BarsSetup b;
  b.interface = {{0, 10}, {1, 10}};  // far away
  b.radius = 5e-3;
  b.stiffness = 222.8e3;
  b.areal_density = 0.35;
  b.damping = 0.4;
  b.touch = {1.4e9, 0.33, 21 * degree};
  return b;
}

std::vector<Vec2> straight(double length, std::size_t bars, double y = 0) {
  std::vector<Vec2> nodes;
  for (std::size_t k = 0; k <= bars; ++k)
    nodes.emplace_back(length * static_cast<double>(k) / static_cast<double>(bars), y);
  return nodes;
}

TEST(Bars, APulledChainBearsItsStiffnessTimesItsStrain) {
  BarsSetup setup = sheet();
  setup.chain = straight(1, 20);
  setup.start = {0, 0};
  setup.end = {0.01, 0};
  Bars bars(setup);
  bars.advance(setup.interface, 0.5);
  bars.hold(true);
  bars.advance(setup.interface, 0.2);
  for (std::size_t b = 0; b < bars.bars(); ++b) EXPECT_NEAR(bars.tension(b) / (222.8e3 * 0.005), 1, 1e-9);
  EXPECT_NEAR(bars.end_force(true)[0] / (222.8e3 * 0.005), 1, 1e-9);
  const BarEnergies e = bars.energies();
  EXPECT_NEAR(e.elastic / (0.5 * 222.8e3 * 0.005 * 0.005), 1, 1e-9);
  EXPECT_LT(std::abs(e.error()), 1e-8 * e.end_work) << "leap-frog leaves 1e-9";
}

TEST(Bars, CompressionIsBorneByChoice) {
  for (const bool compression : {true, false}) {
    BarsSetup setup = sheet();
    setup.chain = straight(1, 4);
    setup.compression = compression;
    setup.start = {0, 0};
    setup.end = {-0.01, 0};
    Bars bars(setup);
    bars.advance(setup.interface, 0.1);
    bars.hold(true);
    bars.advance(setup.interface, 0.1);
    EXPECT_NEAR(bars.end_force(true)[0], compression ? -222.8 : 0, 1e-3);
  }
}

// A nearly inextensible chain 1.2 m long between supports 1 m apart follows y = a cosh(x/a), 2 a sinh(1/(2a)) = 1.2.
TEST(Bars, HangsInACatenary) {
  const std::size_t n = 40;
  BarsSetup setup = sheet();
  setup.stiffness = 1e5;
  setup.damping = 0.3;
  setup.gravity = Vec2(0, -9.81);
  setup.start = setup.end = {0, 0};
  // It starts from a symmetric V of the right length.
  const double depth = std::sqrt(0.36 - 0.25);
  for (std::size_t k = 0; k <= n; ++k) {
    const double s = static_cast<double>(k) / static_cast<double>(n);
    setup.chain.emplace_back(s, -depth * (s < 0.5 ? 2 * s : 2 - 2 * s));
  }
  Bars bars(setup);
  bars.hold(false, 0.3);
  for (int k = 0; k < 40; ++k) bars.advance(setup.interface, 0.1);
  double a = 0.5;
  for (int k = 0; k < 100; ++k) {
    const double u = 0.5 / a, f = 2 * a * std::sinh(u) - 1.2, slope = 2 * std::sinh(u) - std::cosh(u) / a;
    a -= f / slope;
  }
  const double sag = a * std::cosh(0.5 / a) - a;
  EXPECT_NEAR(-bars.nodes()[n / 2][1] / sag, 1, 1e-3);
  // The horizontal part of the tension is w a everywhere, with the weight w per length.
  const double weight = 0.35 * 9.81;
  for (const std::size_t b : {std::size_t{0}, n / 4, n / 2}) {
    const Vec2 bar = (bars.nodes()[b + 1] - bars.nodes()[b]).normalized();
    EXPECT_NEAR(bars.tension(b) * bar[0] / (weight * a), 1, 2e-3);
  }
}

// A chain pressed on a smooth guide by 20 kPa through a flat side of three edges costs mu N when pulled out, also while
// its disks pass from one edge to the next.
TEST(Bars, PullsOutOfFlatSidesAtMuTimesTheLoad) {
  BarsSetup setup = sheet();
  const double r = setup.radius, pressure = 20e3, length = 0.6;
  setup.interface = {{0, 0}, {0.2, 0}, {0.4, 0}, {0.6, 0}};
  setup.chain = chain_beside(setup.interface, r, 0.01, 0.2);
  ASSERT_EQ(setup.chain.size(), 81U);
  EXPECT_NEAR((setup.chain[20] - Vec2(0, -2 * r)).norm(), 0, 1e-15);
  setup.guides = {{{-1, -4 * r}, {2, -4 * r}, true}};
  setup.end = {0.1, {}};
  Bars bars(setup);
  bars.seat({0.1 * -pressure, 0.2 * -pressure, 0.2 * -pressure, 0.1 * -pressure});
  // It comes to rest to 1e-7 of the load.
  EXPECT_NEAR(bars.contact_sum()[0], pressure * length, 1e-7 * pressure * length);
  const std::vector<Vec2> before = bars.interface_forces();
  EXPECT_EQ(before, bars.interface_forces()) << "reading moves nothing";
  EXPECT_NEAR(before[1][1], 0.2 * pressure, 1e-7 * pressure);
  const double mu = std::tan(21 * degree);
  for (int k = 0; k < 60; ++k) bars.advance(setup.interface, 2e-3);  // 12 mm: every disk has passed a whole bar
  for (int k = 0; k < 10; ++k) {
    bars.advance(setup.interface, 1e-3);
    const Vec2 sum = bars.contact_sum();
    EXPECT_NEAR(-sum[1] / (mu * sum[0]), 1, 1e-12) << "every disk slides";
    EXPECT_NEAR(sum[0] / (pressure * length), 1, 1e-4) << "bars tilt as disks pass from edge to edge";
    Vec2 on_soil = Vec2::Zero();
    for (const Vec2& f : bars.interface_forces()) on_soil += f;
    EXPECT_NEAR(on_soil[0] / (mu * pressure * length), 1, 1e-4);
  }
  const BarEnergies e = bars.energies();
  EXPECT_LT(std::abs(e.error()), 1e-4 * e.end_work) << "in proportion to the step; 3.3e-5 of it here";
  EXPECT_NEAR((e.friction + e.elastic + e.damping) / e.end_work, 1, 2e-3) << "contacts and motion store the rest";
}

TEST(Bars, BreakAtTheirStrengthAndSaySo) {
  BarsSetup setup = sheet();
  setup.chain = straight(1, 4);
  setup.strength = 500;
  setup.start = {0, 0};
  setup.end = {0.1, 0};
  Bars stopped(setup);
  io::test::expect_error<PhysicsError>([&] { stopped.advance(setup.interface, 0.1); },
                                       "of the geosynthetic broke: its tension of");
  setup.stop_when_broken = false;
  Bars bars(setup);
  bars.advance(setup.interface, 0.1);
  EXPECT_EQ(bars.broken_bars(), 1U);
}

TEST(Bars, AreCarriedByGuidesTwoRadiiBelow) {
  BarsSetup setup = sheet();
  setup.interface = {{0, 0}, {0.3, 0}};
  setup.chain = chain_beside(setup.interface, setup.radius, 0.1, 0.1);
  ASSERT_EQ(setup.chain.size(), 5U);
  const double r = setup.radius;
  const auto uncarried = [&](double from, double to, double y) {
    setup.guides = {{{from, y}, {to, y}, false}};
    return uncarried_bars(setup);
  };
  using List = std::vector<std::size_t>;
  EXPECT_EQ(uncarried(0, 0.3, -4 * r), List{}) << "the bar that hangs over is not pressed";
  EXPECT_EQ(uncarried(0.3, -0.1, -4.5 * r), List{}) << "in either direction";
  EXPECT_EQ(uncarried(0, 0.2, -4 * r), List{3});
  EXPECT_EQ(uncarried(0, 0.3, -10 * r), (List{1, 2, 3})) << "too far below";
  EXPECT_EQ(uncarried(0, 0.3, 0), (List{1, 2, 3})) << "above";
  setup.guides = {{{0, -1}, {0, 1}, false}};
  EXPECT_EQ(uncarried_bars(setup), (List{1, 2, 3})) << "upright";
  EXPECT_NE(uncarried_text(setup, {3}).find(fmt::format("from = [-0.1, {0:.4g}], to = [0.3, {0:.4g}]", -4 * r)),
            std::string::npos)
      << uncarried_text(setup, {3});
}

TEST(Bars, GoesOnBitByBit) {
  BarsSetup setup = sheet();
  setup.interface = {{0, 0}, {0.3, 0}};
  setup.chain = chain_beside(setup.interface, setup.radius, 0.01, 0);
  setup.guides = {{{-1, -0.02}, {2, -0.02}, true}};
  setup.end = {0.05, 0.01};
  Bars one(setup), other(setup);
  one.seat({-3000, -3000});
  const std::vector<Vec2> moved = {{1e-6, -2e-6}, {0.3, -1e-6}};
  one.advance(moved, 1e-3);
  Archive kept;
  one.archive(kept);
  Archive given(kept.numbers(), "memory");
  other.archive(given);
  for (Bars* b : {&one, &other}) b->advance(setup.interface, 1e-3);
  EXPECT_EQ(one.nodes(), other.nodes());
  EXPECT_EQ(one.interface_forces(), other.interface_forces());
  EXPECT_EQ(one.energies().friction, other.energies().friction);
}

TEST(Bars, ChainsLieADiameterOutsideWithCornersOnTheBisector) {
  const std::vector<Vec2> line = {{1, 0}, {1, 1}, {0, 1}};
  const std::vector<Vec2> chain = chain_beside(line, 5e-3, 0.1, 0);
  EXPECT_THROW(chain_beside(line, 5e-3, 1e-9, 0), DataError);
  ASSERT_EQ(chain.size(), 21U);
  EXPECT_NEAR((chain.front() - Vec2(1.01, 0)).norm(), 0, 1e-15);
  EXPECT_NEAR((chain[10] - Vec2(1.01, 1.01)).norm(), 0, 1e-15);
  EXPECT_NEAR((chain.back() - Vec2(0, 1.01)).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace soilweave::fem
