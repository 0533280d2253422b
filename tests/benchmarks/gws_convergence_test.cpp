// The path against the thesis's own increments, orders of convergence, and the time of ten thousand random bags.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/numeric/odeint/integrate/integrate_n_steps.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>
#include <ctime>
#include <random>

#include "core/error.h"
#include "gws/solution/respond.h"
#include "support/gws_reference.h"

namespace soilweave::gws {
namespace {

TEST(GwsConvergence, IncrementsOfTheThesisTendToThePathWithTheFirstOrder) {
  Case bag = test::bag_of("PP");
  bag.tolerance = 1e-9;
  const double surcharge = 1414.3e3;
  const double exact = 100 * Response(bag).at_surcharge(surcharge).settlement();
  EXPECT_NEAR(exact, 10.7003, 5e-5);  // the reference's converged value
  double before = 0;
  for (const int n : {500, 1000, 2000, 4000, 8000}) {
    const double error = std::abs(test::settlement_by_increments(bag, surcharge, n) - exact);
    if (before > 0) {
      const double order = std::log2(before / error);
      RecordProperty("order_" + std::to_string(n), std::to_string(order));
      EXPECT_NEAR(order, 1, 0.15) << n;
    }
    before = error;
  }
  EXPECT_LT(before, 5e-4);
}

TEST(GwsConvergence, FixedStepsOfThePathHaveTheFifthOrder) {
  const Soil soil;
  const double E = soil.young_modulus(232e3), from = std::log(soil.p_0), to = std::log(800e3);
  const auto rates = [&](const Plastic& y, Plastic& rate, double x) {
    const SoilState s = soil_state(soil, E, std::exp(x), y);
    rate = {s.plastic_rate, s.plastic_ratio * s.plastic_rate};
  };
  const auto strain = [&](int n) {
    Plastic y{};
    boost::numeric::odeint::integrate_n_steps(boost::numeric::odeint::runge_kutta_dopri5<Plastic>(), rates, y, from,
                                              (to - from) / n, static_cast<std::size_t>(n));
    return y[0];
  };
  const double exact = strain(640);
  double before = 0;
  for (const int n : {10, 20, 40}) {
    const double error = std::abs(strain(n) - exact);
    if (before > 0) {
      EXPECT_GT(std::log2(before / error), 4.5) << n;
      EXPECT_LT(std::log2(before / error), 6) << n;
    }
    before = error;
  }
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Returns a bag of anything from soft as clay to rockfill, in a net or a steel mat.
Case random_bag(std::mt19937_64& random) {
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  const auto decades = [&](double low, double high) { return std::exp(between(std::log(low), std::log(high))); };
  Case bag;
  Soil& s = bag.soil;
  s.C_t = between(0.1, 5);
  s.m = between(0.1, 1);
  s.p_0 = decades(1e3, 30e3);
  s.M = between(0.8, 1.8);
  s.n = between(0, 0.12);
  s.p_c = decades(0.5e6, 10e6);
  s.lambda = between(0.3, 4);
  s.kappa = s.lambda * between(0, 1.2);  // q/p at the beginning is M_f - kappa/lambda + xi
  s.xi = between(-0.1, 0.2);
  s.p_1 = between(0.5, 2.5);
  s.p_2 = between(0, 0.6);
  s.alpha = decades(3e6, 300e6);
  s.beta = between(0, 1.2);
  s.poisson_ratio = between(0, 0.45);
  const double J = decades(5e3, 5e6);
  bag.geotextile = {"random", J, J * between(0.02, 0.3), between(0.02, 0.5)};
  bag.bag = {decades(0.1, 2), decades(0.02, 1)};
  bag.strength_fraction = between(0.2, 0.99);
  if (between(0, 1) < 0.5) bag.lateral = LateralStress::constant(decades(1e2, 200e3));
  return bag;
}

/// Returns how the bag's response ends, or why it is refused. Checks that every number is finite.
std::string outcome(const Case& bag) {
  try {
    const Response response(bag);
    for (const Point& p : response.points(5))
      for (const double v :
           {p.surcharge, p.settlement(), p.hoop_strain, p.soil.p, p.soil.obliquity, p.soil.strain_radial})
        EXPECT_TRUE(std::isfinite(v));
    EXPECT_NE(response.end(), End::none);
    return std::string(reason(response.end()));
  } catch (const DataError& error) {
    const std::string what = error.what(), cause = what.substr(what.rfind(':') + 2);
    return "refused: " + cause.substr(0, cause.find(", at"));
  }
}

TEST(GwsConvergence, TenThousandRandomBagsEndWithAReasonAndInTime) {
  std::mt19937_64 random(5);
  std::map<std::string, int> ends;
  double longest = 0;
  const double begin = processor_seconds();
  for (int i = 0; i < 10000; ++i) {
    const Case bag = random_bag(random);
    const auto timed = [&] {
      const double before = processor_seconds();
      const std::string why = outcome(bag);
      return std::pair{processor_seconds() - before, why};
    };
    auto [seconds, why] = timed();
    if (seconds > longest)
      seconds = std::min(seconds, timed().first);  // time that the machine took for other work does not repeat
    longest = std::max(longest, seconds);
    EXPECT_FALSE(why.empty());
    ++ends[why];
  }
  const double whole = processor_seconds() - begin;
  for (const auto& [why, count] : ends) std::printf("[   info   ] %5d %s\n", count, why.c_str());
  std::printf("[   info   ] %.3f s in all, the longest %.3f ms\n", whole, 1e3 * longest);
  EXPECT_LT(whole, 10);
  EXPECT_LT(longest, 2e-3);
  EXPECT_GT(ends[std::string(reason(End::strength))], 3000);  // many are ordinary bags
}

}  // namespace
}  // namespace soilweave::gws
