// Doubts about materials that do not fit their grains.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/doubts/material_doubts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "analysis/doubts/loading_doubts.h"
#include "analysis/measure/parts.h"
#include "dem/contact/thesis_soil.h"
#include "dem/state/bodies.h"
#include "dem/sweep/contact_sweep.h"

namespace soilweave::analysis {
namespace {

// Largest factor between a stiffness and the thesis's, in either direction.
constexpr double far_off = 10;
// Largest range of adhesion between grains that touch, over the mean radius.
constexpr double longest_range = 0.1;
// Limits of the density of grains, kg/m3. Pumice floats on water; the densest metal, osmium, has 22,600.
constexpr double lightest = 500, heaviest = 20'000;
// Ratio of the greatest to the least density of grains of one material that is still one density.
constexpr double most_uneven = 1.01;
// Density of quartz, kg/m3, which sand has.
constexpr double quartz = 2650;

// Sums over the bodies of one kind.
struct Bodies {
  double count = 0, radius = 0, mass = 0, volume = 0;

  double mean_radius() const { return radius / count; }
  double density() const { return mass / volume; }
};

// Returns the sums over nodes or over soil, of one material; of all materials if `material` is below 0.
Bodies bodies(const io::Snapshot& state, bool of_nodes, std::int32_t material = -1) {
  const std::vector<bool> node = io::nodes(state);
  const io::GrainsRecord& g = state.grains;
  Bodies sum;
  for (std::size_t i = 0; i < g.size(); ++i) {
    if (node[i] != of_nodes || (material >= 0 && g.material_id[i] != material)) continue;
    sum.count += 1, sum.radius += g.radius[i], sum.mass += g.mass[i];
    sum.volume += dem::grain_volume(g.dimension, g.radius[i]);
  }
  return sum;
}

// Returns the least and the greatest density of grains of soil, kg/m3, in the material where they differ most.
std::pair<double, double> densities(const io::Snapshot& state) {
  const std::vector<bool> node = io::nodes(state);
  const io::GrainsRecord& g = state.grains;
  std::map<std::int32_t, std::pair<double, double>> of;
  for (std::size_t i = 0; i < g.size(); ++i) {
    if (node[i]) continue;
    const double density = g.mass[i] / dem::grain_volume(g.dimension, g.radius[i]);
    auto& [light, heavy] = of.try_emplace(g.material_id[i], density, density).first->second;
    light = std::min(light, density), heavy = std::max(heavy, density);
  }
  std::pair<double, double> most{1, 1};
  for (const auto& [material, both] : of)
    if (both.second * most.first > most.second * both.first) most = both;
  return most;
}

bool is_far_off(const dem::Resistance& resistance, double fit) {
  if (resistance.scale != dem::Resistance::Scale::absolute) return false;
  if (resistance.stiffness == 0 || resistance.limit == 0.0) return false;
  return resistance.stiffness > far_off * fit || resistance.stiffness < fit / far_off;
}

}  // namespace

std::vector<Doubt> stiffness_doubts(const io::Snapshot& state, const dem::Model& model) {
  std::vector<Doubt> doubts;
  for (std::size_t m = 0; m < model.materials.size(); ++m) {
    const Bodies grains = bodies(state, false, static_cast<std::int32_t>(m));
    if (grains.count == 0) continue;
    const dem::CommonMaterial material = model.materials.at(m);
    const double radius = grains.mean_radius();
    const double fit = dem::thesis_rotational_stiffness * std::pow(radius / dem::thesis_radius, 3) * material.modulus /
                       dem::thesis_modulus;
    const bool rolling = is_far_off(material.rolling, fit), twisting = is_far_off(material.twisting, fit);
    if (!rolling && !twisting) continue;
    const double found = rolling ? material.rolling.stiffness : material.twisting.stiffness;
    const bool both = rolling && twisting && material.twisting.stiffness == found;
    const std::string name = both ? "rolling and twisting" : rolling ? "rolling" : "twisting";
    doubts.push_back({m == 0 ? "stiffness" : fmt::format("stiffness-{}", m),
                      fmt::format("{} stiffness {:.3g} N m/rad is {:.2g} times what belongs to grains of {:.3g} mm "
                                  "mean radius{}: write {:.3g} N m/rad",
                                  name, found, found / fit, 1e3 * radius,
                                  m == 0 ? std::string() : fmt::format(" (material {})", m), fit)});
  }
  return doubts;
}

std::vector<Doubt> range_doubts(const io::Snapshot& state, const dem::Model& model) {
  const Bodies grains = bodies(state, false);
  if (grains.count == 0 || model.materials.size() == 0) return {};
  const double range = dem::make_contact_sweep(model)->range(), radius = grains.mean_radius();
  if (range <= longest_range * radius) return {};
  return {{"range", fmt::format("adhesion acts across gaps of up to {:.3g} mm, {:.2g} times the grains' mean radius of "
                                "{:.3g} mm: give an adhesion_range in m, of {:.2g} m at most",
                                1e3 * range, range / radius, 1e3 * radius, longest_range * radius)}};
}

std::vector<Doubt> weight_doubts(const io::Snapshot& state, const Vec3& gravity) {
  std::vector<Doubt> doubts;
  const Bodies grains = bodies(state, false), fabric = bodies(state, true);
  if (gravity.isZero(0)) {
    if (grains.count > 0 && grains.density() < lightest)
      doubts.push_back(
          {"density", fmt::format("grains have {:.3g} kg/m3, where sand has {:.0f} and scaled grains more: "
                                  "give the density in kg/m3, not in g/cm3 or kN/m3",
                                  grains.density(), quartz)});
    return doubts;
  }
  if (grains.count > 0 && (grains.density() < lightest || grains.density() > heaviest))
    doubts.push_back(
        {"weight", fmt::format("numerics.gravity acts, and grains have {:.3g} kg/m3, so that they weigh {:.3g} times "
                               "what sand of {:.0f} kg/m3 does: write grains.density = {:.0f}, or leave gravity out",
                               grains.density(), grains.density() / quartz, quartz, quartz)});
  if (fabric.count > 0 && fabric.density() > heaviest)
    doubts.push_back({"weight-of-nodes",
                      fmt::format("numerics.gravity acts, and nodes of the geotextile have {:.3g} kg/m3, more than any "
                                  "fabric: give the [[material]] of the nodes its own density, or leave gravity out",
                                  fabric.density())});
  if (doubts.empty()) {
    const auto [light, heavy] = densities(state);
    if (heavy > most_uneven * light)
      doubts.push_back(
          {"weights", fmt::format("numerics.gravity acts, and grains of one material have {:.4g} to {:.4g} kg/m3, as "
                                  "after grains.mass_scaling = \"equal-step\", which changes what they weigh: give "
                                  "their true density, as in grains.density = {:.0f}",
                                  light, heavy, quartz)});
  }
  return doubts;
}

std::vector<Doubt> material_doubts(const io::Snapshot& state, const dem::Model& model, const Vec3& gravity) {
  std::vector<Doubt> all = stiffness_doubts(state, model);
  std::vector<double> angles;
  for (std::size_t m = 0; m < model.materials.size(); ++m) angles.push_back(model.materials.at(m).friction_angle);
  for (const std::vector<Doubt>& more :
       {range_doubts(state, model), weight_doubts(state, gravity), radian_doubts(angles)})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace soilweave::analysis
