// Laws that every contact law must obey, run over the list of laws: objectivity, reciprocity, potentials, limits,
// energy.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <cstdint>
#include <random>

#include "dem/contact/law_list.h"
#include "support/law_examples.h"
#include "support/vector_lanes.h"

namespace soilweave::dem::test {
namespace {

template <class List>
struct AsTypes;
template <class... L>
struct AsTypes<LawList<L...>> {
  using Types = ::testing::Types<L...>;
};

template <class Law>
class EveryLaw : public ::testing::Test {
 protected:
  std::mt19937_64 random_{7};

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  V3<double> vector(double size) { return {uniform(-size, size), uniform(-size, size), uniform(-size, size)}; }

  static typename Law::MaterialPair mixed(std::optional<double> limit = 0.1, std::optional<double> restitution = {}) {
    return Law::mix(example<Law>(0, limit, restitution), example<Law>(0, limit, restitution));
  }

  // Returns a contact somewhere in space, in motion, with a history within its limits.
  Pair<Law> any_pair(const typename Law::MaterialPair& c) {
    Pair<Law> p = touching_pair<Law>(c, uniform(2e-3, 5e-3), uniform(2e-3, 5e-3), uniform(5e-6, 4e-5), vector(1));
    const V3<double> centre = vector(1e-2);
    p.one.x = p.one.x + centre, p.two.x = p.two.x + centre;
    p.one.v = vector(0.3), p.two.v = vector(0.3);
    p.one.w = vector(60), p.two.w = vector(60);
    p.update(1e-5);
    p.one.v = vector(0.3), p.two.v = vector(0.3);
    p.one.w = vector(60), p.two.w = vector(60);
    return p;
  }
};
TYPED_TEST_SUITE(EveryLaw, AsTypes<Laws>::Types);

V3<double> rotated(const Mat3& R, const V3<double>& v) { return from_eigen(R * to_eigen(v)); }

void expect_near(const V3<double>& a, const V3<double>& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TYPED_TEST(EveryLaw, AnswersInARotatedFrameWithTheRotatedAnswer) {
  for (int trial = 0; trial < 50; ++trial) {
    Pair<TypeParam> p = this->any_pair(this->mixed(0.1, 0.6));
    const V3<double> axis = this->vector(1);
    const Mat3 R = Eigen::AngleAxisd(this->uniform(0, 3), to_eigen(axis).normalized()).toRotationMatrix();
    Pair<TypeParam> q = p;
    for (Body* b : {&q.one, &q.two}) b->x = rotated(R, b->x), b->v = rotated(R, b->v), b->w = rotated(R, b->w);
    q.history.shear = rotated(R, q.history.shear), q.history.rolling = rotated(R, q.history.rolling);
    q.normal = rotated(R, q.normal);
    p.advance(1e-5), q.advance(1e-5);
    // At positions of 1e-2 m an overlap of 1e-5 m has twelve digits: 1e-12 of the stiffness times a length.
    const double tolerance = 1e-11 * (std::abs(p.response.normal_force) + norm(p.history.shear)) + 1e-12;
    expect_near(q.force_on_two(), rotated(R, p.force_on_two()), tolerance);
    expect_near(q.torque_on_one(), rotated(R, p.torque_on_one()), 1e-2 * tolerance);
    expect_near(q.torque_on_two(), rotated(R, p.torque_on_two()), 1e-2 * tolerance);
  }
}

TYPED_TEST(EveryLaw, FlipsTheForceWhenTheBodiesAreSwapped) {
  const auto a = example<TypeParam>(0, 0.1, 0.7), b = example<TypeParam>(1, 0.05, 0.6);
  for (int trial = 0; trial < 50; ++trial) {
    Pair<TypeParam> p = this->any_pair(TypeParam::mix(a, b));
    Pair<TypeParam> q = p;
    q.mixed = TypeParam::mix(b, a);
    std::swap(q.one, q.two);
    q.history.shear = -1.0 * p.history.shear, q.history.rolling = -1.0 * p.history.rolling;
    q.normal = -1.0 * p.normal;
    p.advance(1e-5), q.advance(1e-5);
    const double tolerance = 1e-11 * norm(p.force_on_two()) + 1e-12;
    expect_near(q.force_on_two(), -1.0 * p.force_on_two(), tolerance);
    expect_near(q.torque_on_one(), p.torque_on_two(), 1e-2 * tolerance);
    expect_near(q.torque_on_two(), p.torque_on_one(), 1e-2 * tolerance);
    EXPECT_NEAR(q.energies.frictional, p.energies.frictional, 1e-10 * p.energies.elastic_shear + 1e-18);
  }
}

TYPED_TEST(EveryLaw, FeelsNothingOfARigidMotionOfThePair) {
  Pair<TypeParam> p = this->any_pair(this->mixed());
  p.update(0);
  const HistoryOf<TypeParam, double> before = p.history;
  const V3<double> normal = p.normal;
  const Vec3 w(3, -5, 2);
  const int steps = 4000;
  const double dt = 1e-3 / 6;  // 0.67 s at 6.2 rad/s: four radians in all
  const Mat3 R = Eigen::AngleAxisd(w.norm() * dt, w.normalized()).toRotationMatrix();
  double slip = 0, roll = 0;
  for (int i = 0; i < steps; ++i) {
    for (Body* b : {&p.one, &p.two}) {
      b->x = rotated(R, b->x);
      b->v = from_eigen(w.cross(to_eigen(b->x)));
      b->w = from_eigen(w);
    }
    p.update(dt);
    slip += norm(p.kinematics.slip), roll += norm(p.kinematics.roll) + std::abs(p.kinematics.twist);
  }
  const Mat3 whole = Eigen::AngleAxisd(w.norm() * dt * steps, w.normalized()).toRotationMatrix();
  EXPECT_LT(slip, 1e-13);
  EXPECT_LT(roll, 1e-12);
  expect_near(p.normal, rotated(whole, normal), 1e-10);
  EXPECT_NEAR(norm(p.history.shear), norm(before.shear), 1e-9 * norm(before.shear));
  // Turning and spinning do not commute: at 1e-3 rad per step the direction is off by the second order of the step.
  expect_near(p.history.shear, rotated(whole, before.shear), 3e-6 * norm(before.shear));
  expect_near(p.history.rolling, rotated(whole, before.rolling), 3e-6 * norm(before.rolling));
  EXPECT_DOUBLE_EQ(p.history.twisting, before.twisting);
}

TYPED_TEST(EveryLaw, NormalForceIsTheSlopeOfTheEnergyAndStiffnessThatOfTheForce) {
  for (const double overlap : {1e-7, 1e-6, 2e-5, 1e-4}) {
    const double h = 1e-4 * overlap;
    Kinematics<double> k = touching_pair<TypeParam>(this->mixed(), 3e-3, 4.5e-3, overlap).motion(0);
    const auto at = [&](double delta) {
      k.overlap = delta;
      HistoryOf<TypeParam, double> history{};
      ContactEnergies<double> energies;
      const auto r = TypeParam::respond(this->mixed(), k, 0.0, history, energies);
      return std::array{energies.elastic_normal, r.normal_force, r.normal_stiffness};
    };
    const auto low = at(overlap - h), here = at(overlap), high = at(overlap + h);
    EXPECT_NEAR((high[0] - low[0]) / (2 * h), here[1], 1e-8 * std::abs(here[1]));
    EXPECT_NEAR((high[1] - low[1]) / (2 * h), here[2], 1e-8 * here[2]);
  }
}

TYPED_TEST(EveryLaw, TangentStiffnessesAreTheSlopesOfTheAnswers) {
  Kinematics<double> k = touching_pair<TypeParam>(this->mixed(), 3e-3, 4.5e-3, 2e-5).motion(0);
  k.slip = {1e-9, 0, 0}, k.roll = {0, 1e-7, 0}, k.twist = -1e-7;
  HistoryOf<TypeParam, double> history{};
  ContactEnergies<double> energies;
  const auto r = TypeParam::respond(this->mixed(), k, 1e-6, history, energies);
  EXPECT_NEAR(-history.shear.x / 1e-9, r.shear_stiffness, 1e-12 * r.shear_stiffness);
  EXPECT_NEAR(-history.rolling.y / 1e-7, r.rolling_stiffness, 1e-12 * r.rolling_stiffness);
  EXPECT_NEAR(history.twisting / 1e-7, r.twisting_stiffness, 1e-12 * r.twisting_stiffness);
  EXPECT_FALSE(r.sliding);
}

TYPED_TEST(EveryLaw, HoldsShearAndMomentsWithinTheirLimits) {
  const auto c = this->mixed(0.02, 0.5);
  int sliding = 0;
  Pair<TypeParam> p = this->any_pair(c);
  for (int i = 0; i < 2000; ++i) {
    p.one.w = this->vector(1000), p.two.w = this->vector(1000);
    p.two.v = this->vector(0.05), p.one.v = p.two.v;
    p.advance(1e-5);
    const double pressing = p.response.pressing, ulp = 1 + 1e-14;
    EXPECT_LE(norm(p.history.shear), c.tangential.mu * pressing * ulp);
    const double longest = 0.02 * 0.5 * (p.one.radius + p.two.radius) * pressing;
    EXPECT_LE(norm(p.history.rolling), longest * ulp);
    EXPECT_LE(std::abs(p.history.twisting), longest * ulp);
    EXPECT_GE(p.energies.frictional, 0);
    EXPECT_GE(p.energies.viscous, 0);
    sliding += p.response.sliding;
  }
  EXPECT_GT(sliding, 100);  // else the limit was never tested
}

TYPED_TEST(EveryLaw, ResistsRollingAndTwisting) {
  Pair<TypeParam> p = touching_pair<TypeParam>(this->mixed(0.02), 3e-3, 4.5e-3, 2e-5);
  double work = 0, lost = 0;
  for (int i = 1; i <= 400; ++i) {
    // Counter-rolling and twisting go back and forth to their start, so all work is lost at the limit.
    const double sense = (i <= 100 || i > 300) ? 1 : -1;
    p.two.w = {40 * sense, 25 * sense, 30 * sense};
    p.one.w = (-p.two.radius / p.one.radius) * V3<double>{p.two.w.x, p.two.w.y, 0};
    const auto old = p.history;
    p.advance(1e-5);
    const auto& k = p.kinematics;
    work -= 0.5 * (dot(old.rolling + p.history.rolling, k.roll) + (old.twisting + p.history.twisting) * k.twist);
    if (i == 1) {
      EXPECT_LT(dot(p.history.rolling, k.roll), 0);
      EXPECT_LT(p.history.twisting * k.twist, 0);
    }
    EXPECT_GE(p.energies.rolling_plastic, 0);
    lost += p.energies.rolling_plastic;
  }
  EXPECT_GT(lost, 0.5 * work) << "the limits were hardly put to the test";
  // The rolling moment turns with the spin, 1.5e-4 rad per step, before it changes: the sum above misses the square.
  EXPECT_NEAR(work, lost + p.energies.elastic_rolling + p.energies.elastic_twisting, 3e-7 * work);
}

TYPED_TEST(EveryLaw, LimitNoneIsElasticAndLimitZeroIsNothing) {
  for (const auto limit : {std::optional<double>(), std::optional<double>(0.0)}) {
    Pair<TypeParam> p = touching_pair<TypeParam>(this->mixed(limit), 3e-3, 4.5e-3, 2e-5);
    p.two.w = {40, 25, 30};
    p.one.w = (-1.5) * V3<double>{40, 25, 0};
    double angle = 0;
    for (int i = 0; i < 300; ++i) p.advance(1e-5), angle += p.kinematics.twist;
    EXPECT_EQ(p.energies.rolling_plastic, 0);
    if (limit) {
      EXPECT_EQ(norm(p.history.rolling), 0);
      EXPECT_EQ(p.history.twisting, 0);
      EXPECT_EQ(p.response.rolling_stiffness, 0);
    } else {
      EXPECT_NEAR(p.history.twisting, -p.response.twisting_stiffness * angle, 1e-12 * std::abs(p.history.twisting));
    }
  }
}

// Returns the slip at which a contact at rest begins to slide, mu times the pressing force over ks.
template <class Law>
double first_slide(const typename Law::MaterialPair& c, const Kinematics<double>& k) {
  HistoryOf<Law, double> history{};
  ContactEnergies<double> energies;
  const auto r = Law::respond(c, k, 0.0, history, energies);
  return c.tangential.mu * r.pressing / r.shear_stiffness;
}

TYPED_TEST(EveryLaw, ASlipCycleAtConstantOverlapCreatesNoEnergy) {
  for (const double share : {0.5, 10.0}) {  // shares of the slip at which it slides: never slides; slides almost always
    Kinematics<double> k = touching_pair<TypeParam>(this->mixed(), 3e-3, 4.5e-3, 2e-5).motion(0);
    const double amplitude = share * first_slide<TypeParam>(this->mixed(), k);
    HistoryOf<TypeParam, double> history{};
    ContactEnergies<double> energies{};
    double work = 0, lost = 0, largest = 0;
    int sliding = 0;
    V3<double> place{0, 0, 0};
    const int steps = 1000;
    for (int i = 1; i <= 3 * steps; ++i) {
      const double t = 2 * std::numbers::pi * i / steps;
      const V3<double> next{amplitude * std::sin(t), amplitude * std::sin(2 * t), 0};  // a figure of eight, closed
      k.slip = next - place;
      place = next;
      const auto old = history;
      sliding += TypeParam::respond(this->mixed(), k, 1e-6, history, energies).sliding;
      work -= 0.5 * dot(old.shear + history.shear, k.slip);
      lost += energies.frictional;
      largest = std::max(largest, energies.elastic_shear);
      EXPECT_GE(energies.frictional, 0);
    }
    EXPECT_NEAR(work, lost + energies.elastic_shear, 1e-11 * (largest + lost));
    EXPECT_GE(work, -1e-12 * largest);
    if (share < 1) {
      EXPECT_EQ(sliding, 0);
      EXPECT_EQ(lost, 0);
    } else {
      EXPECT_GT(sliding, 2 * steps) << "it hardly ever slid: the cycle puts friction to no test";
      EXPECT_GT(lost, 10 * largest);
    }
  }
}

// A contact that slides straight dissipates its limit times the slip, once its spring is taut.
TYPED_TEST(EveryLaw, StraightSlidingDissipatesTheLimitTimesTheSlip) {
  const auto c = this->mixed();
  Kinematics<double> k = touching_pair<TypeParam>(c, 3e-3, 4.5e-3, 2e-5).motion(0);
  const double step = 0.25 * first_slide<TypeParam>(c, k);
  k.slip = {0.6 * step, -0.8 * step, 0};
  HistoryOf<TypeParam, double> history{};
  ContactEnergies<double> energies;
  for (int i = 0; i < 10; ++i) {
    const auto r = TypeParam::respond(c, k, 1e-6, history, energies);
    if (i < 4) continue;  // at the limit to rounding after four steps, beyond it after five
    EXPECT_TRUE(r.sliding);
    EXPECT_NEAR(energies.frictional, c.tangential.mu * r.pressing * step, 1e-12 * r.pressing * step);
  }
}

TYPED_TEST(EveryLaw, GivesNothingWithoutOverlapMotionAndMemory) {
  // The sweep relies on zero forces for pairs in its lanes that do not touch.
  const Pair<TypeParam> pair = touching_pair<TypeParam>(this->mixed(), 3e-3, 4.5e-3, 0);
  Kinematics<double> k = pair.motion(0);
  k.overlap = 0 - pair.range();
  HistoryOf<TypeParam, double> history{};
  ContactEnergies<double> energies;
  const auto r = TypeParam::respond(this->mixed(), k, 1e-6, history, energies);
  for (const double x : {r.normal_force, norm(history.shear), norm(history.rolling), history.twisting,
                         energies.elastic_normal, energies.elastic_shear, energies.elastic_rolling,
                         energies.elastic_twisting, energies.frictional, energies.rolling_plastic, energies.viscous})
    EXPECT_EQ(x, 0);
}

TYPED_TEST(EveryLaw, TheEnergyOfASlipCycleAtChangingOverlapIsMeasuredNotHidden) {
  // Slip s at overlap d1, fall to d2, slip back to zero force: 1/2 ks1 s^2 goes in and (ks1 s)^2/(2 ks2) comes out.
  const double d1 = 2e-5, d2 = 1e-5, s = 1e-7;
  Kinematics<double> k = touching_pair<TypeParam>(this->mixed(), 3e-3, 4.5e-3, d1).motion(0);
  HistoryOf<TypeParam, double> history{};
  ContactEnergies<double> energies;
  k.slip = {s, 0, 0};
  TypeParam::respond(this->mixed(), k, 1e-6, history, energies);
  const double put_in = energies.elastic_shear;
  k.overlap = d2;
  k.slip = {0, 0, 0};
  TypeParam::respond(this->mixed(), k, 1e-6, history, energies);
  const double created = energies.elastic_shear - put_in;
  ASSERT_EQ(energies.frictional, 0);
  const double ratio = shear_stiffness_ratio<TypeParam>(this->mixed(), k, d1, d2);
  k.slip = {-s * ratio, 0, 0};
  TypeParam::respond(this->mixed(), k, 1e-6, history, energies);
  EXPECT_NEAR(energies.elastic_shear, 0, 1e-20);
  EXPECT_NEAR(created / put_in, ratio - 1, 1e-12);
  this->RecordProperty("created_over_put_in", std::to_string(created / put_in));
}

// Compares four contacts in lanes with four single ones, bit by bit.
void expect_same_bits(double one, double four, const char* what) {
  EXPECT_EQ(std::bit_cast<std::uint64_t>(one), std::bit_cast<std::uint64_t>(four))
      << what << ": " << one << " and " << four;
}

TYPED_TEST(EveryLaw, GivesTheSameBitsInEveryLane) {
  const auto a = example<TypeParam>(0, 0.03, 0.7), b = example<TypeParam>(1, 0.02, 0.6);
  const auto c = TypeParam::mix(a, b);
  for (int trial = 0; trial < 500; ++trial) {
    std::array<Pair<TypeParam>, 4> p{this->any_pair(c), this->any_pair(c), this->any_pair(c), this->any_pair(c)};
    PairMotion<Lane4> m{};
    Kinematics<Lane4> rest{};
    HistoryOf<TypeParam, Lane4> history{};
    V3<Lane4> old_normal{};
    Lane4 overlap{};
    for (int i = 0; i < 4; ++i) {
      const Pair<TypeParam>& q = p[static_cast<std::size_t>(i)];
      Body one = q.one, two = q.two;
      one.x = one.x + 1e-5 * one.v, two.x = two.x + 1e-5 * two.v;
      const V3<double> d = two.x - one.x;
      set_lane(m.velocity, i, two.v - one.v), set_lane(m.spin_1, i, one.w), set_lane(m.spin_2, i, two.w);
      m.lever_1[i] = one.radius, m.lever_2[i] = two.radius, m.inverse_distance[i] = 1 / norm(d);
      set_lane(rest.normal, i, (1.0 / norm(d)) * d);
      overlap[i] = one.radius + two.radius - norm(d);
      rest.r1[i] = one.radius, rest.r2[i] = two.radius;
      rest.per_reach[i] = 1 / (one.radius + two.radius);
      rest.R_star[i] = one.radius * two.radius * rest.per_reach[i];
      rest.m1[i] = one.mass, rest.m2[i] = two.mass;
      set_lane(history.shear, i, q.history.shear), set_lane(history.rolling, i, q.history.rolling);
      history.twisting[i] = q.history.twisting;
      set_lane(old_normal, i, q.normal);
    }
    const Lane4 dt = broadcast<Lane4>(1e-5);
    Kinematics<Lane4> k{};
    k.normal = rest.normal;
    set_increments(m, dt, k);
    k.overlap = overlap, k.r1 = rest.r1, k.r2 = rest.r2, k.R_star = rest.R_star;
    k.per_reach = rest.per_reach, k.m1 = rest.m1, k.m2 = rest.m2;
    const Lane4 angle = 0.5 * dt * dot(k.normal, m.spin_1 + m.spin_2);
    history.shear = transport(history.shear, old_normal, k.normal, angle);
    history.rolling = transport(history.rolling, old_normal, k.normal, angle);
    ContactEnergies<Lane4> energies;
    const auto r = TypeParam::respond(c, k, dt, history, energies);
    for (int i = 0; i < 4; ++i) {
      Pair<TypeParam>& q = p[static_cast<std::size_t>(i)];
      q.advance(1e-5);
      if (!q.touching) continue;
      expect_same_bits(q.kinematics.slip.x, k.slip.x[i], "slip");
      expect_same_bits(q.response.normal_force, r.normal_force[i], "normal force");
      expect_same_bits(q.response.shear_stiffness, r.shear_stiffness[i], "shear stiffness");
      expect_same_bits(q.history.shear.x, history.shear.x[i], "shear x");
      expect_same_bits(q.history.shear.y, history.shear.y[i], "shear y");
      expect_same_bits(q.history.shear.z, history.shear.z[i], "shear z");
      expect_same_bits(q.history.rolling.x, history.rolling.x[i], "rolling x");
      expect_same_bits(q.history.twisting, history.twisting[i], "twisting");
      expect_same_bits(q.energies.frictional, energies.frictional[i], "frictional");
      expect_same_bits(q.energies.rolling_plastic, energies.rolling_plastic[i], "rolling plastic");
      expect_same_bits(q.energies.viscous, energies.viscous[i], "viscous");
      EXPECT_EQ(q.response.sliding, r.sliding[i] != 0);
    }
  }
}

}  // namespace
}  // namespace soilweave::dem::test
