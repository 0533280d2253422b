// Time that loads take through the soil, against the duration of a run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace soilweave::fem {
namespace {

// The fastest vibration of an element takes about six steps, and a response takes several vibrations.
constexpr std::int64_t fewest_steps = 30;

Vec2 extent(const Mesh& mesh) {
  Vec2 low = mesh.nodes.front(), high = low;
  for (const Vec2& x : mesh.nodes) low = low.cwiseMin(x), high = high.cwiseMax(x);
  return high - low;
}

/// Returns the speed of a compression wave in the stiffest point, m/s.
double wave_speed(const Model& model) {
  double area = 0, modulus = 0;
  for (Index p = 0; p < model.points().size(); ++p) {
    area += model.soil().soil_point(p).area;
    const Mat3 tangent = model.points()[p]->tangent();
    modulus = std::max({modulus, tangent(0, 0), tangent(1, 1)});
  }
  const std::vector<double>& masses = model.soil().masses();
  return std::sqrt(modulus * area / std::reduce(masses.begin(), masses.end()));
}

}  // namespace

std::string extent_text(const Mesh& mesh) {
  const Vec2 size = extent(mesh);
  return fmt::format("{:.4g} m by {:.4g} m", size[0], size[1]);
}

std::vector<Doubt> timing_doubts(const Scenario& scenario, const Model& model, std::int64_t steps) {
  if (scenario.quasi_static) return {};
  std::vector<Doubt> doubts;
  const std::string remedy = "give a longer time.duration, or a mesh in m where its file is in another unit";
  const double way = extent(model.soil().mesh()).minCoeff(), speed = wave_speed(model);
  if (scenario.duration < way / speed)
    doubts.push_back(
        {"wave", fmt::format("the mesh is {}, and an elastic wave of {:.3g} m/s takes {:.3g} s along its shorter side, "
                             "but the run ends after {:.3g} s: no load gets through the soil; {}",
                             extent_text(model.soil().mesh()), speed, way / speed, scenario.duration, remedy)});
  if (steps < fewest_steps)
    doubts.push_back(
        {"few_steps", fmt::format("the run has {} step{} of {:.3g} s, fewer than {}: no response develops; "
                                  "{}",
                                  steps, steps == 1 ? "" : "s", model.time_step(), fewest_steps, remedy)});
  return doubts;
}

}  // namespace soilweave::fem
