// One contact on prescribed paths, against closed forms and against paths recorded with another code (YADE).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"
#include "support/pair.h"
#include "support/worse.h"

namespace soilweave::dem::test {
namespace {

constexpr double dt = 1e-5;

// Parameters of the recorded tests (peer/two_sphere/meta.json), equal in all of them except for the limit.
HertzMindlin::MaterialPair hertz(std::optional<double> rolling_limit) {
  const Resistance rolling{0.13, Resistance::Scale::absolute, rolling_limit, Resistance::Arm::mean_radius};
  const Resistance twisting{
      0.13, Resistance::Scale::absolute, {}, Resistance::Arm::mean_radius};  // never limited there
  const HertzMindlin::Material m{4e9, 0.33, 29 * degree, {}, rolling, twisting};
  return HertzMindlin::mix(m, m);
}
Linear::MaterialPair linear(std::optional<double> limit) {
  const Resistance r{0.56393, Resistance::Scale::contact, limit, Resistance::Arm::smaller_radius};
  const Linear::Material m{5.449e8, 0.08032, 30.2028 * degree, {}, r, r};
  return Linear::mix(m, m);
}

// Formulas of the literature for these parameters, written independently.
struct Expected {
  double fn, kn, ks, mu, kr, rolling_cap, twisting_cap;
};
constexpr double unlimited = 1e300;

Expected expected_hertz(double r1, double r2, double overlap, double limit) {
  const double E = 4e9, nu = 0.33, R = r1 * r2 / (r1 + r2), G = E / (2 * (1 + nu));
  const double fn = 2 * E / (3 * (1 - nu * nu)) * std::sqrt(R) * std::pow(overlap, 1.5);
  return {fn,
          E / (1 - nu * nu) * std::sqrt(R * overlap),
          4 * G / (2 - nu) * std::sqrt(R * overlap),
          std::tan(29 * degree),
          0.13,
          limit * 0.5 * (r1 + r2) * fn,
          unlimited};
}
Expected expected_linear(double r1, double r2, double overlap, double limit) {
  const double kn = 2 * 5.449e8 * r1 * r2 / (r1 + r2), ks = 0.08032 * kn, cap = limit * std::min(r1, r2) * kn * overlap;
  return {kn * overlap, kn, ks, std::tan(30.2028 * degree), 0.56393 * ks * r1 * r2, cap, cap};
}

struct HertzCase {
  using Law = HertzMindlin;
  static constexpr double limit = 0.13;
  static constexpr const char* prefix = "hm_";
  static auto mixed(std::optional<double> limit) { return hertz(limit); }
  static constexpr auto expected = expected_hertz;
};
struct LinearCase {
  using Law = Linear;
  static constexpr double limit = 0.19357;
  static constexpr const char* prefix = "cl_";
  static auto mixed(std::optional<double> limit) { return linear(limit); }
  static constexpr auto expected = expected_linear;
};

template <class Case>
class TwoSpheres : public ::testing::Test {};
using Cases = ::testing::Types<HertzCase, LinearCase>;
TYPED_TEST_SUITE(TwoSpheres, Cases);

constexpr std::array<std::array<double, 2>, 3> radii = {{{3e-3, 3e-3}, {3e-3, 4.5e-3}, {8e-3, 2e-3}}};

template <class Case>
Pair<typename Case::Law> pair_of(const std::array<double, 2>& r, double overlap,
                                 std::optional<double> limit = Case::limit) {
  return touching_pair<typename Case::Law>(Case::mixed(limit), r[0], r[1], overlap);
}

// Returns a capped elastic force driven in one direction: the exact "play" of a closed form with reversals.
double capped(double force, double trial_increment, double cap) {
  return std::clamp(force + trial_increment, -cap, cap);
}

TYPED_TEST(TwoSpheres, LoadingAndUnloadingFollowTheClosedForm) {
  for (const auto& r : radii) {
    auto p = pair_of<TypeParam>(r, 1e-9);
    for (int i = 0; i < 600; ++i) {
      p.two.v = {0, 0, i < 300 ? -1e-2 : 1e-2};
      p.advance(dt);
      if (!p.touching) break;
      const double overlap =
          r[0] + r[1] - p.two.x.z;  // from the rounded positions, whose cancellation is not the law's
      const Expected e = TypeParam::expected(r[0], r[1], overlap, 1);
      EXPECT_NEAR(p.response.normal_force, e.fn, 1e-10 * e.fn);
      EXPECT_NEAR(p.response.normal_stiffness, e.kn, 1e-10 * e.kn);
      EXPECT_NEAR(p.response.shear_stiffness, e.ks, 1e-10 * e.ks);
    }
  }
}

TYPED_TEST(TwoSpheres, ShearAtConstantOverlapSlidesAndReturns) {
  const double overlap = 2e-5;
  for (const auto& r : radii) {
    auto p = pair_of<TypeParam>(r, overlap);
    const Expected e = TypeParam::expected(r[0], r[1], r[0] + r[1] - p.two.x.z, 1);
    const double step = e.mu * e.fn / e.ks / 30;  // slides after 30 steps
    double force = 0;
    for (int i = 0; i < 400; ++i) {
      const double sense = (i / 100) % 2 ? -1 : 1;
      p.one.w = p.two.w = {0, sense * step / ((r[0] + r[1]) * dt), 0};  // slip -x for +y spin, hence force +x
      p.advance(dt);
      force = capped(force, sense * e.ks * step, e.mu * e.fn);
      EXPECT_NEAR(p.history.shear.x, force, 1e-10 * e.mu * e.fn);
      EXPECT_NEAR(p.torque_on_one().y, -(r[0] - overlap / 2) * force, 1e-10 * r[0] * e.mu * e.fn);
      EXPECT_NEAR(p.torque_on_two().y, -(r[1] - overlap / 2) * force, 1e-10 * r[1] * e.mu * e.fn);
    }
  }
}

// Integrates the law in an ordinary loop in long double, without the library. Returns the force after `steps` steps.
template <class Case>
double sheared_at_changing_overlap(const std::array<double, 2>& r, int steps, double slip, long double& slid) {
  long double force = 0;
  slid = 0;
  for (int i = 1; i <= steps; ++i) {
    const double overlap = 2e-5 + 1e-5 * std::sin(2 * std::numbers::pi * 1.25 * i / steps);
    const Expected e = Case::expected(r[0], r[1], overlap, 1);
    const long double trial = force + static_cast<long double>(e.ks) * slip / steps, cap = e.mu * e.fn;
    force = std::min(trial, cap);
    slid += trial > cap;
  }
  return static_cast<double>(force);
}

TYPED_TEST(TwoSpheres, ShearAtChangingOverlapIntegratesTheSameLaw) {
  for (const auto& r : radii) {
    const Expected e = TypeParam::expected(r[0], r[1], 2e-5, 1);
    for (const double slip : {0.3 * e.mu * e.fn / e.ks, 6 * e.mu * e.fn / e.ks}) {  // without and with sliding
      const int steps = 2000;
      auto p = pair_of<TypeParam>(r, 2e-5);
      double from_x = 0;
      for (int i = 1; i <= steps; ++i) {
        const double overlap = 2e-5 + 1e-5 * std::sin(2 * std::numbers::pi * 1.25 * i / steps);
        p.two.x.z = r[0] + r[1] - overlap;
        p.one.w = p.two.w = {0, slip / steps / ((r[0] + r[1]) * dt), 0};
        p.update(dt);
        from_x += p.response.sliding;
      }
      long double slid;
      const double force = sheared_at_changing_overlap<TypeParam>(r, steps, slip, slid);
      // The overlap is the difference of two radii: 1e-5 of 1e-2 m keeps 13 digits.
      EXPECT_NEAR(p.history.shear.x, force, 1e-10 * e.mu * e.fn);
      EXPECT_EQ(from_x > 0, slip > e.mu * e.fn / e.ks);
      // The step is of first order against the differential law dFs = ks(t) ds; this measures the order.
      long double unused;
      const double fine = sheared_at_changing_overlap<TypeParam>(r, 64000, slip, unused);
      const double finer = sheared_at_changing_overlap<TypeParam>(r, 128000, slip, unused);
      const double exact = 2 * finer - fine;
      if (slid == 0 && std::is_same_v<TypeParam, HertzCase>) {
        const double coarse = sheared_at_changing_overlap<TypeParam>(r, 1000, slip, unused);
        EXPECT_NEAR((coarse - exact) / (force - exact), 2, 0.05);
      } else if (slid == 0) {
        EXPECT_NEAR(force, exact, 1e-10 * e.mu * e.fn);
      }
    }
  }
}

TYPED_TEST(TwoSpheres, RollingAndTwistingAreElasticUpToTheirLimits) {
  for (const auto& r : radii)
    for (const bool limited : {false, true}) {
      // One pair rolls and one twists, because in a single pair the rolling moment would turn with the spin.
      auto p = pair_of<TypeParam>(r, 2e-5, limited ? std::optional(TypeParam::limit) : std::nullopt);
      auto q = p;
      Expected e = TypeParam::expected(r[0], r[1], r[0] + r[1] - p.two.x.z, TypeParam::limit);
      if (!limited) e.rolling_cap = e.twisting_cap = unlimited;
      double roll = 0, twist = 0;
      const double rate = 40, span = rate * dt * 100 * e.kr;
      for (int i = 0; i < 600; ++i) {
        const double sense = (i / 150) % 2 ? -1 : 1;
        p.two.w = {sense * rate, 0, 0};
        p.one.w = {-sense * rate * r[1] / r[0], 0, 0};  // no slip
        q.two.w = {0, 0, sense * rate};
        p.advance(dt), q.advance(dt);
        roll = capped(roll, -e.kr * sense * rate * (1 + r[1] / r[0]) * dt, e.rolling_cap);
        twist = capped(twist, -e.kr * sense * rate * dt, e.twisting_cap);
        EXPECT_NEAR(p.history.rolling.x, roll, 1e-10 * span);
        EXPECT_NEAR(q.history.twisting, twist, 1e-10 * span);
        EXPECT_LT(norm(p.history.shear) + norm(q.history.shear), 1e-10 * e.fn);
      }
    }
}

// ---- Rigid rotations of the pair with its history.

V3<double> rotate(const V3<double>& v, double angle, const V3<double>& axis) {
  return from_eigen(Eigen::AngleAxisd(angle, to_eigen(axis).normalized()) * to_eigen(v));
}

TEST(Transport, TurnsWithTheNormalExactlyHoweverLargeTheStep) {
  const V3<double> n{0, 0, 1}, f{0.3, -0.8, 0}, axis{0.6, 0.8, 0};
  for (const double angle : {1e-9, 1e-3, 0.5, 2.0, 3.1}) {
    const V3<double> carried = transport(f, n, rotate(n, angle, axis), 0.0);
    EXPECT_LT(norm(carried - rotate(f, angle, axis)), 1e-13) << angle;
  }
}

TEST(Transport, SpinsAboutTheNormalWithoutChangingLength) {
  const V3<double> n{0, 0, 1}, f{0.3, -0.8, 0};
  for (const double angle : {1e-9, 1e-3, 0.1, 1.0}) {
    const V3<double> carried = transport(f, n, n, angle);
    EXPECT_NEAR(norm(carried), norm(f), 1e-15);
    // The tangent's series ends before angle^7 17/40320, and the angle is twice its arc.
    EXPECT_LT(norm(carried - rotate(f, angle, n)), 1e-15 + std::pow(angle, 7) * 17 / 20160);
  }
}

// The sweep takes the turn of the normal from the velocity of the pair, and the rotation from a series.
TEST(Transport, FromTheVelocityOfThePairIsOfThirdOrderInWhatItMoved) {
  const V3<double> normal{0.48, 0.64, 0.6}, velocity{0.3, -0.7, 0.5};
  const double distance = 6e-3, spin = 0.4;
  for (const double dt : {1e-5, 1e-4, 1e-3}) {
    const V3<double> before = distance * normal - dt * velocity;
    const V3<double> exact = between((1 / norm(before)) * before, normal);
    const V3<double> ours = between(velocity, dot(velocity, normal), 1 / distance, normal, dt);
    const double moved = dt * norm(velocity) / distance;
    EXPECT_LT(norm(ours - exact), moved * moved * moved + 1e-15) << dt;
    EXPECT_GT(norm(ours), 0.2 * moved);

    // Gibbs vectors up to a tenth leave an error of the eighth power of half the angle.
    const V3<double> f{0.8, -0.6, 0}, gibbs = then_spin(ours, normal, dt * spin / 1e-3);
    const double left = std::pow(norm2(gibbs), 4);
    EXPECT_LT(norm(Rotation<double>::by_small(gibbs)(f) - Rotation<double>(gibbs)(f)), 4 * left + 1e-15) << dt;
  }
}

TEST(Contact, LiesInThePlaneAsItDoesInSpace) {
  const V2<double> n{0.6, -0.8}, v{0.3, 0.7};
  const V3<double> normal{n.x, n.y, 0}, velocity{v.x, v.y, 0}, tangent{-n.y, n.x, 0};
  const double turn = 0.37, force = 2.5, share = -1.3;
  const auto expect_equal = [](const V3<double>& a, const V3<double>& b) { EXPECT_LT(norm(a - b), 1e-15); };
  expect_equal(along(n, v) * tangent, along(normal, velocity));
  expect_equal(turned(n, turn) * tangent, turned(normal, V3<double>{0, 0, turn}));
  expect_equal({0, 0, moment(n, share)}, moment(normal, share * tangent));
  const V2<double> whole = joined(force, n, share);
  expect_equal({whole.x, whole.y, 0}, joined(force, normal, share * tangent));
}

TEST(Transport, KeepsLengthOverAHundredThousandSteps) {
  V3<double> n{0, 0, 1}, f{0.6, -0.8, 0};
  const V3<double> axis{0.4, 0.5, 0.77};
  double cosine = 0;
  for (int i = 0; i < 100000; ++i) {
    V3<double> next = rotate(n, 3e-3, axis);
    next = (1 / norm(next)) * next;
    f = transport(f, n, next, 2e-3);
    n = next;
    cosine = std::max(cosine, std::abs(dot(f, n)));
  }
  EXPECT_NEAR(norm(f), 1,
              1e5 * 4e-16);  // rounding per step; a first-order rotation would double the length within 1e5 steps
  EXPECT_LT(cosine, 1e-11);
}

TEST(Transport, IsOfSecondOrderWhenTurnAndSpinGoTogether) {
  const V3<double> axis{0.48, 0.64, 0.6}, n0{0, 0, 1}, f0{0.6, -0.8, 0};
  std::array<double, 2> error{};
  for (int level = 0; level < 2; ++level) {
    const int steps = 100 << level;
    const double angle = 2.5 / steps;
    V3<double> n = n0, f = f0;
    for (int i = 0; i < steps; ++i) {
      const V3<double> next = rotate(n, angle, axis);
      f = transport(f, n, next, angle * dot(axis, next));
      n = next;
    }
    error[static_cast<std::size_t>(level)] = norm(f - rotate(f0, 2.5, axis));
  }
  EXPECT_LT(error[1], 1e-4);
  EXPECT_GT(std::log2(error[0] / error[1]), 1.9);
}

// YADE's rotation of the history (LAWS.md §1): f - f x (n_old x n) - f x (angle n_old), first order, not renormalised.
V3<double> first_order(const V3<double>& f, const V3<double>& old_normal, const V3<double>& normal, double angle) {
  const V3<double> turned = f - cross(f, cross(old_normal, normal));
  return turned - cross(turned, angle * old_normal);
}

TEST(Transport, ThePeersGrowthOverARigidRotationIsItsFirstOrderRotation) {
  const V3<double> axis{0, 1, 0};
  V3<double> n{0, 0, 1}, theirs{1, 0, 0}, ours = theirs, spun_theirs = theirs, spun_ours = theirs;
  for (int i = 0; i < 400; ++i) {
    const V3<double> next = rotate({0, 0, 1}, 1.25e-3 * (i + 1), axis);
    theirs = first_order(theirs, n, next, 0.0), ours = transport(ours, n, next, 0.0);
    n = next;
    const V3<double> z{0, 0, 1};
    spun_theirs = first_order(spun_theirs, z, z, 1.25e-3), spun_ours = transport(spun_ours, z, z, 1.25e-3);
  }
  // The recording notes 3.1e-4 over 0.5 rad in 400 steps (about the normal), and as much in its turning plane.
  EXPECT_NEAR(norm(spun_theirs) - 1, 3.1e-4, 0.05e-4);
  EXPECT_NEAR(norm(spun_ours), 1, 1e-13);
  EXPECT_NEAR(norm(ours), 1, 1e-13);
  EXPECT_LT(std::abs(norm(theirs) - 1), 4e-4);
  EXPECT_LT(norm(ours - rotate({1, 0, 0}, 0.5, axis)), 1e-12);
}

// ---- Recorded paths.

struct Recorded {
  std::vector<std::string> names;
  std::vector<std::vector<double>> rows;

  double at(std::size_t row, const std::string& name) const {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw std::runtime_error("no column " + name);
    return rows[row][static_cast<std::size_t>(found - names.begin())];
  }
  V3<double> vector(std::size_t row, const std::string& name) const {
    return {at(row, name + "x"), at(row, name + "y"), at(row, name + "z")};
  }
};

Recorded read_recorded(const std::string& path) {
  std::ifstream file(path);
  Recorded data;
  std::string line, field;
  std::getline(file, line);
  for (std::stringstream s(line); std::getline(s, field, ',');) data.names.push_back(field);
  while (std::getline(file, line)) {
    data.rows.emplace_back();
    for (std::stringstream s(line); std::getline(s, field, ',');) data.rows.back().push_back(std::stod(field));
  }
  return data;
}

// Largest difference over the largest value of the whole path.
struct Difference {
  double largest = 0, scale = 0;
  void add(const V3<double>& ours, const V3<double>& theirs) {
    largest = soilweave::test::worse(largest, norm(ours - theirs));
    scale = std::max(scale, norm(theirs));
  }
  double relative() const { return scale > 0 ? largest / scale : largest; }
};

template <class Case>
double replay(const Recorded& data, const std::array<double, 2>& r, double overlap, std::optional<double> limit) {
  auto p = pair_of<Case>(r, overlap, limit);
  p.update(0);
  Difference fn, fs, mb, mt, t1, t2;
  for (std::size_t row = 0; row < data.rows.size(); ++row) {
    if (row > 0) {
      p.one.v = data.vector(row, "v1"), p.two.v = data.vector(row, "v2");
      p.one.w = data.vector(row, "w1"), p.two.w = data.vector(row, "w2");
      p.advance(dt);
    }
    if (data.at(row, "un") < 0 || !p.touching) continue;
    fn.add(p.response.normal_force * p.normal, data.vector(row, "Fn"));
    fs.add(p.history.shear, data.vector(row, "Fs"));
    mb.add(p.history.rolling, data.vector(row, "Mb"));
    mt.add(p.history.twisting * p.normal, data.vector(row, "Mt"));
    t1.add(p.torque_on_one(), data.vector(row, "T1"));
    t2.add(p.torque_on_two(), data.vector(row, "T2"));
  }
  EXPECT_GT(fn.scale, 0);
  return std::max({fn.relative(), fs.relative(), mb.relative(), mt.relative(), t1.relative(), t2.relative()});
}

TYPED_TEST(TwoSpheres, FollowsThePeersRecordedPaths) {
  const char* reference = std::getenv("SOILWEAVE_REFERENCE");
  if (!reference) GTEST_SKIP() << "SOILWEAVE_REFERENCE is not set";
  const std::string folder = std::string(reference) + "/peer/two_sphere/" + TypeParam::prefix;
  double worst = 0;
  int paths = 0;
  for (const std::string size : {"r3_r3", "r3_r45"})
    for (const std::string path : {"a_normal", "b_shear_cyclic", "b2_shear_cyclic_elastic", "d_roll_noplast",
                                   "d_roll_eta", "d_roll_etazero", "e_twist_noplast", "e_twist_eta"}) {
      if (path == "d_roll_etazero" && std::is_same_v<TypeParam, HertzCase>) continue;  // no such path was recorded
      const Recorded data = read_recorded(fmt::format("{}{}_{}.csv", folder, path, size));
      ASSERT_GT(data.rows.size(), 100u) << folder << path;
      std::optional<double> limit = TypeParam::limit;
      if (path.ends_with("noplast")) limit.reset();
      if (path.ends_with("etazero")) limit = 0.0;
      const std::array<double, 2> r = {3e-3, size == "r3_r3" ? 3e-3 : 4.5e-3};
      const double difference = replay<TypeParam>(data, r, path == "a_normal" ? 1e-9 : 2e-5, limit);
      EXPECT_LT(difference, 1e-6) << path << ' ' << size;
      worst = std::max(worst, difference);
      ++paths;
    }
  this->RecordProperty("paths", paths);
  this->RecordProperty("largest_relative_difference", std::to_string(worst * 1e9) + "e-9");
}

}  // namespace
}  // namespace soilweave::dem::test
