// Forecast of a compaction before its first step.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/ahead.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "core/text/text.h"
#include "dem/sweep/contact_sweep.h"

namespace soilweave::packing {
namespace {

// Contacts per grain times the solid share of the volume.
constexpr double contacts_in_solid = 3;
// Ratio of the deepest overlap of a few hundred contacts to the mean. Measured: 0.52 radii at an expected mean of 0.34.
constexpr double deepest_over_mean = 2;
// Void ratios at which compressed grains begin to touch one another all around.
constexpr double touching_spheres = 0.8, touching_disks = 0.25;
// Steps in which a cloud should close, for remedies.
constexpr double good_steps = 50'000;
constexpr double largest_rate = 1e3;  // upper limit of --max-rate, 1/s

// Returns the normal force of two equal grains of the first material, N.
double normal_force(const dem::Model& model, double radius, double overlap) {
  return dem::make_contact_sweep(model)->normal_force(radius, overlap);
}

void demand_stiff(const dem::Model& model, const Recipe& recipe, double radius, int dimension, double largest) {
  const double mean = expected_overlap(model, radius, recipe.pressure, dimension);
  if (deepest_over_mean * mean <= largest) return;
  const double bearable = pressure_at_overlap(model, radius, 0.9 * largest / deepest_over_mean, dimension);
  throw DataError(fmt::format(
      "at {:.4g} Pa grains of this stiffness would overlap by about {:.2g} of their radius on average, where "
      "the deepest contact may have {:.2g} (guards.overlap): lower the pressure to {:.2g} Pa, or take grains "
      "with {:.2g} times the Young's modulus ({})",
      recipe.pressure, mean, largest, bearable, rounded_up(recipe.pressure / bearable), recipe.remedies.material));
}

void demand_closing(const dem::Simulation& cloud, const Recipe& recipe, int dimension) {
  if (cloud.measures().contacts > 0) return;
  const double touching = dimension == 2 ? touching_disks : touching_spheres;
  const double strain = std::log((1 + cloud.void_ratio()) / (1 + recipe.void_ratio.value_or(touching))) / dimension;
  const double steps = strain / (recipe.max_rate * cloud.time_step());
  if (!(steps > 0.5 * static_cast<double>(recipe.largest_stage))) return;
  const double faster = rounded_up(steps / good_steps), rate = recipe.max_rate * faster;
  const std::string raise =
      rate < largest_rate ? fmt::format("raise the rate to {:.4g} 1/s ({}), or ", rate, recipe.remedies.max_rate) : "";
  throw DataError(
      fmt::format("grains of this size and density would take about {:.2g} steps to come together from a void ratio of "
                  "{:.3g} at {:.4g} 1/s (time step {:.2g} s), and {} are taken at most: {}scale the density by {:.2g} "
                  "({})",
                  steps, cloud.void_ratio(), recipe.max_rate, cloud.time_step(), recipe.largest_stage, raise,
                  rounded_up(faster * faster), recipe.remedies.density));
}

}  // namespace

double expected_overlap(const dem::Model& model, double radius, double pressure, int dimension) {
  const double area = dimension == 2 ? 2 * std::numbers::pi * radius : 4 * std::numbers::pi * radius * radius;
  const double force = pressure * area / contacts_in_solid;
  double low = 0, high = 1;
  if (normal_force(model, radius, high * radius) <= force) return high;
  while (high - low > 1e-4 * high && high > 1e-15) {
    const double middle = 0.5 * (low + high);
    (normal_force(model, radius, middle * radius) < force ? low : high) = middle;
  }
  return high;
}

double pressure_at_overlap(const dem::Model& model, double radius, double overlap, int dimension) {
  const double area = dimension == 2 ? 2 * std::numbers::pi * radius : 4 * std::numbers::pi * radius * radius;
  return contacts_in_solid * normal_force(model, radius, overlap * radius) / area;
}

void demand_feasible(const dem::Simulation& cloud, const dem::Model& model, const Recipe& recipe, double mean_radius,
                     int dimension, double largest) {
  demand_stiff(model, recipe, mean_radius, dimension, largest);
  demand_closing(cloud, recipe, dimension);
}

}  // namespace soilweave::packing
