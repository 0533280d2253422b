// Reference series for wrapped soil, and the thesis's own scheme of equal surcharge increments to compare the path
// with.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "gws/solution/respond.h"
#include "support/reference.h"

namespace soilweave::test {

inline gws::Case bag_of(double stiffness, double strength, double failure_strain) {
  gws::Case bag;
  bag.geotextile = {"test", stiffness, strength, failure_strain};
  return bag;
}
/// Returns the bag with one of the six geotextiles of thesis Fig. 5.15 or 5PP, by the reference's table of inputs.
inline gws::Case bag_of(const std::string& name) {
  if (name == "PE") return bag_of(53e3, 9.531e3, 0.17035);
  const double layers = name == "PP" ? 1 : std::strtod(name.c_str(), nullptr);
  return bag_of(layers * 232e3, layers * 31.754e3, 0.1425);
}

/// Returns the settlement in percent at a surcharge by n equal increments, each with everything but dp frozen at its
/// beginning: the thesis's procedure (section 5.3.4), written independently of the path.
inline double settlement_by_increments(const gws::Case& bag, double to, int n) {
  const gws::Soil& s = bag.soil;
  const double E = s.young_modulus(bag.geotextile.stiffness), nu = s.poisson_ratio, h = bag.bag.height / bag.bag.width;
  const double factor = 2 * (1 + nu) / (9 * (1 - 2 * nu));
  const auto elastic = [&](double p) { return s.C_t * (std::pow(p / s.p_a, s.m) - std::pow(s.p_0 / s.p_a, s.m)); };
  const auto obliquity = [&](double p, double strain) {
    return s.M * std::pow(p / s.p_c, -s.n) - s.kappa / (strain + s.lambda) + s.xi;
  };
  double p = s.p_0, deviatoric = 0, axial_p = 0, radial_p = 0, slope = obliquity(p, 0), q = p * slope, axial = 0;
  const auto load = [&](double mean, double eta, double a, double r) {
    const double lateral = mean * (3 - eta) / 3;
    return mean * (3 + 2 * eta) / 3 - 2 * lateral * h * (1 - a / 100) / ((1 + h) * (1 - r / 100));
  };
  const double from = load(p, slope, 0, 0);
  for (int i = 1; i <= n; ++i) {
    const double eta = obliquity(p, deviatoric), failure = s.M * std::pow(p / s.p_c, -s.n);
    const double X = -((failure - s.M) - (s.p_1 * (failure - eta) - s.p_2));
    const double flow = (2 * X - 3) / (2 * X + 6), ratio = (3 + 2 * slope) / (3 - slope);
    const double c = 100 / E * (2 + flow * ratio - 2 * nu * (1 + flow + ratio)) / (flow * (ratio + 2));
    const auto total = [&](double dp) {
      const double e = elastic(p + dp), d = factor * eta * e;
      return std::pair{e / 3 + d + axial_p + c * dp, e / 3 - d / 2 + radial_p + flow * c * dp};
    };
    const auto excess = [&](double dp) {
      const auto [a, r] = total(dp);
      return load(p + dp, eta, a, r) - (from + (to - from) * i / n);
    };
    std::uintmax_t evaluations = 200;
    const double dp = boost::math::tools::toms748_solve(excess, -p / 2, 2 * p + (to - from) / n,
                                                        boost::math::tools::eps_tolerance<double>(), evaluations)
                          .first;
    const auto [a, r] = total(dp);
    axial_p += c * dp;
    radial_p += flow * c * dp;
    p += dp;
    axial = a;
    deviatoric = 2.0 / 3.0 * (a - r);
    const double now = p * obliquity(p, deviatoric);
    slope = (now - q) / dp;
    q = now;
  }
  return axial;
}

}  // namespace soilweave::test
