// Estimate of how long the stations of a run wait for rest.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/rest.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "dem/engine/homogeneous.h"

namespace soilweave::dem {
namespace {

// Fewest steps of a wait: the servo takes so many to settle.
constexpr double settling = 20;
// Unbalanced force on arrival: unbalanced_scale I^unbalanced_power. It fits nine triaxial tests of 1000 and 500 grains
// within 30 %, at 10 kPa to 0.2 MPa and I from 2e-4 to 1e-2. At 1 MPa the measured force is half of this.
constexpr double unbalanced_scale = 0.43, unbalanced_power = 0.6, most_unbalanced = 0.1;
// Inertial times per e-fold of the unbalanced force: fold_over_damping over the damping. Sheared grains take at least
// least_fold, because they rearrange, and creep under more damping. The same tests had damping of 0.05 to 0.9.
constexpr double fold_over_damping = 0.14, least_fold = 0.45;
// Mean wait of a test over the wait in its first per cents of strain: 1.5 to 2. Dilated soil rearranges more slowly.
constexpr double dilated = 1.7;
// Steps of a wait between plates without drag, per grain across and per e-fold, times the damping. The shear box of
// chapter 3 takes 4.5, the thesis's bag of 69,000 grains in PP takes 10 (319,000 steps for 21 stations).
constexpr double swaying = 6;
// Wait under a new load over the wait under a held one: 8,000 to 10,000 steps for the bags of chapter 3.
constexpr double first_load = 4.5;
// Frequency of a bag's swing over the affine frequency. It follows from the drags that stopped the bags of chapter 3.
constexpr double swing_share = 0.5;
// Share of a homogeneous field's kinetic energy that is left after its removal: bags of chapter 3 at 10 %/s.
constexpr double left_of_field = 0.012;
// Void ratio of soil between plates, for its mean stress.
constexpr double usual_void_ratio = 0.65;
// Mean time step of sheared, wrapped soil over the time step at its start: 0.5 to 0.85 for the bags and cells of
// chapters 3 and 4.
constexpr double stiffened = 0.57, least_stiffened = 0.85;
// Factors between an estimated wait and the ends of its range, after shear and after a load or stress alone. The ranges
// contain all stages of the runs from which the numbers above come.
constexpr double range_of_shear = 2, range_of_loads = 3;
// Least change of the pressure in the tried steps, as a logarithm, from which power_ is estimated.
constexpr double telling = 0.3;
// Greatest value of power_, for contacts whose stiffness grows as the force.
constexpr double greatest_power = 0.5;

}  // namespace

RestEstimate::RestEstimate(const Simulation& simulation, const Scenario& scenario)
    : scenario_(scenario), dt_(simulation.time_step()), unbalanced_(simulation.unbalanced_force()) {
  const Bodies& bodies = simulation.bodies();
  across_ = std::pow(static_cast<double>(bodies.size()), 1.0 / bodies.dimension);
  double grains = 0, mass = 0, solid = 0;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    if (bodies.is_node(i)) continue;
    diameter_ += 2 * bodies.radius(i), ++grains;
    mass += bodies.mass(i), solid += grain_volume(bodies.dimension, bodies.radius(i));
    const Vec3 x = vector_of(bodies.grains[i].position);
    low = low.cwiseMin(x), high = high.cwiseMax(x);
  }
  if (grains > 0) {
    diameter_ /= grains, density_ = mass / solid;
    volume_ = scenario.parts.empty() ? simulation.volume() : solid * (1 + usual_void_ratio);
    extent_ = (high - low).array() + diameter_;
  }
  pressure_ = pressure_of(simulation);
  wrapped_ = grains > 0 && grains < static_cast<double>(bodies.size());
  swing_ = swing_share * slowest_swing(simulation);
  moments_ = HomogeneousField(simulation).second_moments();
}

double RestEstimate::pressure_of(const Simulation& simulation) const {
  const int dimension = simulation.bodies().dimension;
  return volume_ > 0 ? mean(simulation.measures().stress, dimension) * simulation.volume() / volume_ : 0;
}

double RestEstimate::pressure_of(double force, const Vec3& direction) const {
  return volume_ > 0 ? std::abs(force) * extent_.dot(direction.cwiseAbs()) / volume_ : 0;
}

void RestEstimate::learn(const Simulation& tried) {
  const double pressure = pressure_of(tried);
  if (!(pressure > 0 && pressure_ > 0)) return;
  const double change = std::log(pressure / pressure_);
  if (std::abs(change) < telling) return;
  power_ = std::clamp(std::log(dt_ / tried.time_step()) / change, 0.0, greatest_power);
}

double RestEstimate::step_share(const Arrival& arrival) const {
  if (wrapped_) return arrival.sheared ? stiffened : 1;
  return arrival.pressure > 0 && pressure_ > 0 ? std::pow(pressure_ / arrival.pressure, power_) : 1;
}

double RestEstimate::fewest(const Arrival& arrival, double moving, double waiting) const {
  // A stress is reached sooner than forecast, because contacts get stiffer on the way.
  if (!arrival.sheared) return (moving + waiting) / range_of_loads;
  return (wrapped_ ? stiffened / least_stiffened : 1) * moving + waiting / range_of_shear;
}

double RestEstimate::most(const Arrival& arrival, double moving, double waiting) const {
  return moving + waiting * (arrival.sheared ? range_of_shear : range_of_loads);
}

double RestEstimate::steps(const Stage& stage, const Arrival& arrival) const {
  const double half = stage.critical_drag ? swing_ : 0.5 * stage.rest_drag;
  const double damping =
      std::max(0.05, stage.rest_damping.value_or(stage.damping.value_or(scenario_.numerics.damping)));
  const double steps = half > 0 && swing_ > 0    ? under_drag(stage, arrival, half)
                       : scenario_.parts.empty() ? in_cell(stage, arrival, damping)
                                                 : between_plates(arrival, damping);
  return std::max(settling, steps);
}

double RestEstimate::inertial_time(double pressure) const {
  const double p = pressure > 0 ? pressure : pressure_;
  return p > 0 ? diameter_ * std::sqrt(density_ / p) : 0;
}

double RestEstimate::unbalanced_at_arrival(const Stage& stage, const Arrival& arrival) const {
  const double inertia = arrival.gradient.norm() * inertial_time(arrival.pressure);
  double u = std::min(most_unbalanced, unbalanced_scale * std::pow(inertia, unbalanced_power));
  if (stage.way_unbalanced_force > 0) u = std::min(u, stage.way_unbalanced_force);
  return arrival.first ? std::max(u, unbalanced_) : u;
}

double RestEstimate::in_cell(const Stage& stage, const Arrival& arrival, double damping) const {
  // Unloaded grains spring back in the inertial time of the greater stress before.
  const double time = inertial_time(arrival.sheared ? arrival.pressure : std::max(arrival.pressure, pressure_));
  // Without contacts or stress there is no inertial time. Waves across the assembly then determine the wait.
  if (!(time > 0)) return across_ * -std::log(scenario_.tolerances.unbalanced_force) / damping;
  const double folds = std::log(unbalanced_at_arrival(stage, arrival) / scenario_.tolerances.unbalanced_force);
  const double share = std::max(fold_over_damping / damping, arrival.sheared ? least_fold : 0.0);
  const double fold = share * time / (dt_ * step_share(arrival));
  return std::max(0.0, folds) * fold * (arrival.sheared ? dilated : 1);
}

double RestEstimate::between_plates(const Arrival& arrival, double damping) const {
  const double folds = -std::log(std::min(0.5, scenario_.tolerances.unbalanced_force));
  return std::max(settling, swaying * across_) * folds / damping * (arrival.new_load ? first_load : 1);
}

// A swing of frequency w under a drag c decays as exp(-c t/2), or if it creeps as exp(-(c/2 - sqrt(c^2/4 - w^2)) t).
// Its energy falls twice as fast. The unbalanced force belongs to swings of all frequencies. It falls at c/2, or if the
// slowest swing creeps at w, the geometric mean of its rates c/2 -+ sqrt(c^2/4 - w^2).
double RestEstimate::under_drag(const Stage& stage, const Arrival& arrival, double half) const {
  const double slow = half - std::sqrt(std::max(0.0, half * half - swing_ * swing_));
  const Tolerances& tolerances = scenario_.tolerances;
  const double unbalanced = stage.homogeneous_start ? unbalanced_at_arrival(stage, arrival) : 1;
  double time = std::log(unbalanced / tolerances.unbalanced_force) / std::min(swing_, half);
  if (std::isfinite(tolerances.kinetic_energy)) {
    // The field v = L x has the energy sum m (L x)^2 / 2.
    const double field = 0.5 * arrival.gradient.cwiseAbs2().colwise().sum().dot(moments_.transpose());
    const double energy = stage.homogeneous_start ? left_of_field * field : field;
    time = std::max(time, 0.5 * std::log(energy / tolerances.kinetic_energy) / slow);
  }
  return time / (dt_ * step_share(arrival));
}

}  // namespace soilweave::dem
