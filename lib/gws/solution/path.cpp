// The soil's path by adaptive Runge-Kutta steps.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/path.h"

#include <algorithm>
#include <array>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <cmath>

namespace soilweave::gws {
namespace {

constexpr double share_of_step = 0.01;    // share of the whole path's tolerance for one step
constexpr double smallest_strain = 1e-2;  // percent; below it errors are absolute
constexpr double longest_step = 0.5;      // step in ln p
constexpr double first_step = 1e-3;       // step in axial strain, percent
constexpr double smallest_step = 1e-9;    // step in axial strain, percent; the path ends where it is reached

using Stepper = boost::numeric::odeint::runge_kutta_dopri5<Plastic>;

/// Right-hand side d plastic / d ln p. At a state that does not exist it returns zero and stores the reason in `end`.
struct Rates {
  const Soil& soil;
  double E;
  End& end;

  void operator()(const Plastic& plastic, Plastic& rate, double x) const {
    const SoilState state = soil_state(soil, E, std::exp(x), plastic);
    if (state.end != End::none && end == End::none) end = state.end;
    rate = state.end == End::none ? Plastic{state.plastic_rate, state.plastic_ratio * state.plastic_rate} : Plastic{};
  }
};

}  // namespace

Path::Path(const Soil& soil, double E, double tolerance) : soil_(soil), E_(E), tolerance_(tolerance) {
  nodes_.push_back({std::log(soil.p_0), {}});
  end_ = soil_state(soil_, E_, soil_.p_0, {}).end;
}

bool Path::advance() {
  while (end_ == End::none) {
    const Node& from = nodes_.back();
    End cause = End::none;
    Stepper stepper;
    Plastic to{}, error{};
    stepper.do_step(Rates{soil_, E_, cause}, from.plastic, from.x, to, step_, error);
    double worst = 0;
    for (std::size_t i = 0; i < to.size(); ++i) {
      const double scale = std::max({std::abs(from.plastic[i]), std::abs(to[i]), smallest_strain});
      worst = std::max(worst, std::abs(error[i]) / (share_of_step * tolerance_ * scale));
    }
    if (cause == End::none) cause = soil_state(soil_, E_, std::exp(from.x + step_), to).end;
    const double tried = step_;
    if (cause != End::none || !std::isfinite(worst)) {
      step_ = tried / 4;
      if (step_ < resolution) end_ = cause != End::none ? cause : End::resolution;
      continue;
    }
    step_ = std::min(longest_step, tried * std::clamp(0.9 * std::pow(worst, -0.2), 0.2, 4.0));
    if (worst <= 1) {
      nodes_.push_back({from.x + tried, to});
      return true;
    }
    if (step_ < resolution) end_ = End::resolution;
  }
  return false;
}

Plastic Path::stepped(const Node& from, double x) const {
  End cause = End::none;
  Plastic to{};
  Stepper().do_step(Rates{soil_, E_, cause}, from.plastic, from.x, to, x - from.x);
  return to;
}

SoilState Path::at(double x) const {
  const auto after =
      std::upper_bound(nodes_.begin(), nodes_.end(), x, [](double value, const Node& n) { return value < n.x; });
  const Node& from = after == nodes_.begin() ? nodes_.front() : *(after - 1);
  return soil_state(soil_, E_, std::exp(x), x > from.x ? stepped(from, x) : from.plastic);
}

std::vector<SoilState> states_at(const Soil& soil, double E, const std::vector<double>& strains, double tolerance) {
  using Unknown = std::array<double, 3>;  // ln p, plastic axial and radial strain, as functions of the axial strain
  End cause = End::none;
  const auto state = [&](const Unknown& y) { return soil_state(soil, E, std::exp(y[0]), {y[1], y[2]}); };
  const auto rates = [&](const Unknown& y, Unknown& rate, double) {
    const SoilState now = state(y);
    if (now.end != End::none) cause = now.end;
    rate = {};
    if (now.end == End::none && now.axial_rate > 0)
      rate = {1 / now.axial_rate, now.plastic_rate / now.axial_rate,
              now.plastic_ratio * now.plastic_rate / now.axial_rate};
  };
  auto stepper = boost::numeric::odeint::make_controlled<boost::numeric::odeint::runge_kutta_dopri5<Unknown>>(
      tolerance, tolerance);
  std::vector<SoilState> states;
  Unknown y{std::log(soil.p_0), 0, 0};
  double strain = 0, step = first_step;
  for (const double next : strains) {
    while (strain < next) {
      double tried = std::min(step, next - strain);
      const bool last = tried < step;
      const Unknown before = y;
      const double from = strain;
      cause = End::none;
      const bool done = stepper.try_step(rates, y, strain, tried) == boost::numeric::odeint::success;
      if (cause != End::none) {
        y = before, strain = from, stepper.reset();
        step = std::min(step, next - from) / 4;
        if (step < smallest_step) return states;
        continue;
      }
      if (!done || !last) step = tried;
    }
    states.push_back(state(y));
    if (states.back().end != End::none) {
      states.pop_back();
      return states;
    }
  }
  return states;
}

}  // namespace soilweave::gws
