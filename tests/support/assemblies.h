// Small assemblies for tests of the engine, made fast by the product's own generator.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"
#include "dem/loading/control.h"
#include "packing/generate/cloud.h"
#include "packing/generate/generate.h"
#include "packing/generate/grading.h"

namespace soilweave::support {

constexpr double degree = 3.14159265358979323846 / 180;

/// Returns soil of thesis Table 3.1.
inline dem::Model sand(double friction_angle = 29 * degree) {
  const dem::Resistance moment{0.13, dem::Resistance::Scale::absolute, {}, dem::Resistance::Arm::mean_radius};
  return {std::vector<dem::HertzMindlin::Material>{{4e9, 0.33, friction_angle, {}, moment, moment}}};
}

/// Returns the linear law with limited moments of thesis chapter 2.
inline dem::Model linear_sand() {
  const dem::Resistance moment{0.564, dem::Resistance::Scale::contact, 0.194, dem::Resistance::Arm::smaller_radius};
  return {std::vector<dem::Linear::Material>{{5.449e8, 0.0803, 30.2 * degree, {}, moment, moment}}};
}

/// Returns grains of 3 mm mean radius at rest under a pressure, as dense as full friction makes them.
inline io::Snapshot packed(const dem::Model& model, double pressure, std::size_t grains = 150, int dimension = 3,
                           std::uint64_t seed = 1) {
  std::vector<double> radii = packing::Grading::toyoura().radii(grains, dimension);
  for (double& r : radii) r *= 0.58;
  packing::Recipe recipe;
  recipe.pressure = pressure;
  const io::Snapshot cloud = packing::cloud(radii, 2.0, {1, 1, 1}, dimension, 2650e3, seed);
  io::Snapshot state = packing::compact(cloud, model, {}, recipe).state;
  state.step = 0;
  state.time = 0;
  return state;
}

}  // namespace soilweave::support
