// Compaction of a loose cell around reinforced soil.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/surround_compaction.h"

#include <fmt/format.h>

#include <cmath>

#include "analysis/measure/stress.h"
#include "analysis/measure/tessellation.h"
#include "analysis/measure/volume_of_interest.h"
#include "analysis/tables/bag.h"
#include "analysis/tables/tables.h"
#include "core/error.h"
#include "dem/state/bodies.h"

namespace soilweave::packing {
namespace {

double mean_stress_of(const std::vector<Mat3>& dyads, const std::vector<double>& cells, const std::vector<bool>& of) {
  double sum = 0, volume = 0;
  for (std::size_t i = 0; i < of.size(); ++i)
    if (of[i]) sum += dyads[i].trace() / 3, volume += cells[i];
  return volume > 0 ? sum / volume : 0;
}

// Returns the distance of the faces, m: the difference of the mean heights of face nodes above and below the middle.
double height(const io::Snapshot& state) {
  std::vector<bool> face(state.grains.size(), false);
  for (std::size_t y = 0; y < state.yarns.size(); ++y)
    if (state.yarns.family[y] == 0)
      for (const std::int32_t end : state.yarns.nodes[y]) face[static_cast<std::size_t>(end)] = true;
  double middle = 0, nodes = 0;
  for (std::size_t i = 0; i < face.size(); ++i)
    if (face[i]) middle += state.grains.position[i].z(), nodes += 1;
  middle /= nodes;
  double above = 0, below = 0, up = 0, down = 0;
  for (std::size_t i = 0; i < face.size(); ++i) {
    if (!face[i]) continue;
    const double z = state.grains.position[i].z() - middle;
    (z > 0 ? above : below) += z, (z > 0 ? up : down) += 1;
  }
  return (up > 0 ? above / up : 0) - (down > 0 ? below / down : 0);
}

double yarn_length(const io::Snapshot& state) {
  double sum = 0, number = 0;
  for (std::size_t y = 0; y < state.yarns.size(); ++y) {
    if (state.yarns.family[y] != 0 || state.yarns.broken[y]) continue;
    const auto& ends = state.yarns.nodes[y];
    sum += (state.grains.position[static_cast<std::size_t>(ends[1])] -
            state.grains.position[static_cast<std::size_t>(ends[0])])
               .norm() /
           state.yarns.rest_length[y];
    number += 1;
  }
  return number > 0 ? sum / number : 1;
}

// Returns the void ratio of the reinforced part alone, without its cell.
double void_ratio_of_soil(const io::Snapshot& state, const std::vector<bool>& fill, const std::vector<bool>& node) {
  io::Snapshot open = state;
  open.cell.periodic = {false, false, false};
  std::vector<bool> apart = node;
  for (std::size_t i = 0; i < fill.size(); ++i) apart[i] = apart[i] || fill[i];
  std::size_t soil = 0;
  for (const bool a : apart) soil += !a;
  return soil > 4 ? analysis::delaunay_fill(open, apart).void_ratio() : 0;
}

// Returns the strain rate, 1/s, at which opposite faces of the cell approach each other at v = sqrt(0.004 p/density) or
// less. The impact of the fill, density v^2, is then 0.4 % of the pressure p.
double gentle_rate(const Surrounded& cell, double pressure) {
  constexpr double impact = 0.004;
  double mass = 0, volume = 0;
  const io::GrainsRecord& g = cell.state.grains;
  for (std::size_t i = 0; i < cell.fill.size(); ++i)
    if (cell.fill[i]) mass += g.mass[i], volume += dem::grain_volume(3, g.radius[i]);
  return std::sqrt(impact * pressure * volume / mass) / cell.state.cell.matrix.diagonal().minCoeff();
}

// Returns the tolerance, to three digits, that accepts a relative deviation.
double accepting(double deviation) { return std::ceil(1e3 * std::abs(deviation) + 1e-6) / 1e3; }

void judge(const Surround& how, CompactedCell& cell) {
  const Shape &a = cell.before, &b = cell.after;
  const double p = how.recipe.pressure;
  const auto miss = [&](const char* key, const std::string& sentence) { cell.missed.push_back({key, sentence}); };
  if (cell.result.unheld) miss("void-ratio", *cell.result.unheld);
  // A NaN counts as a miss.
  if (a.height > 0 && !(std::abs(b.height / a.height - 1) <= how.height_tolerance))
    miss("height",
         fmt::format("the reinforced part is {:.4g} m high, {:+.2g} % from the {:.4g} m that it had, more than "
                     "surround.height_tolerance: lower surround.pressure, or set the tolerance to {:.3f} to accept it",
                     b.height, 100 * (b.height / a.height - 1), a.height, accepting(b.height / a.height - 1)));
  if (!(b.yarn_length >= (1 - how.height_tolerance) * a.yarn_length))
    miss("crumpled",
         fmt::format(
             "the geotextile is crumpled: the ends of its yarns are {:.3g} of their length apart, {:.3g} before: lower "
             "surround.pressure, or set surround.height_tolerance to {:.3f} to accept it",
             b.yarn_length, a.yarn_length, accepting(b.yarn_length / a.yarn_length - 1)));
  if (!(std::abs(b.fill_stress / p - 1) <= how.stress_tolerance))
    miss("fill-stress",
         fmt::format("the mean stress of the fill is {:.4g} Pa under a pressure of {:.4g} Pa, {:+.2g} %, beyond "
                     "surround.stress_tolerance; that of the reinforced soil is {:.4g} Pa: ask for another "
                     "surround.void_ratio, or set the tolerance to {:.3f} to accept it",
                     b.fill_stress, p, 100 * (b.fill_stress / p - 1), b.soil_stress, accepting(b.fill_stress / p - 1)));
}

}  // namespace

std::string Shape::text() const {
  return fmt::format(
      "e {:.4f}, reinforced {:.4f}, height {:.5g} m, yarns {:.4f} of their length, fill {:.4g} Pa, Z {:.2f}, "
      "reinforced soil {:.4g} Pa",
      void_ratio, soil_void_ratio, height, yarn_length, fill_stress, fill_coordination, soil_stress);
}

Shape shape(const io::Snapshot& state, const std::vector<bool>& fill) {
  const std::vector<bool> node = io::nodes(state);
  const std::vector<Mat3> dyads = analysis::grain_dyads(state);
  const std::vector<double> cells = analysis::power_cell_volumes(state);
  std::vector<bool> soil(fill.size());
  double number = 0, ends = 0;
  for (std::size_t i = 0; i < fill.size(); ++i) soil[i] = !fill[i] && !node[i], number += fill[i];
  for (const auto& bodies : state.contacts.bodies)
    for (const std::int32_t body : bodies) ends += body >= 0 && fill[static_cast<std::size_t>(body)];
  Shape s;
  s.void_ratio = analysis::void_ratio(state);
  s.height = height(state), s.yarn_length = yarn_length(state);
  s.soil_void_ratio = void_ratio_of_soil(state, fill, node);
  s.fill_stress = mean_stress_of(dyads, cells, fill), s.soil_stress = mean_stress_of(dyads, cells, soil);
  s.fill_coordination = ends / number;
  return s;
}

io::Series table(const CompactedCell& cell) {
  io::Series rows;
  using analysis::put;
  for (const Shape* s : {&cell.before, &cell.after}) {
    put(rows, "void_ratio", "1", "void ratio of all spheres", s->void_ratio);
    put(rows, "soil_void_ratio", "1", "void ratio of the reinforced soil by its tetrahedra", s->soil_void_ratio);
    put(rows, "height", "m", "between the faces of the geotextiles", s->height);
    put(rows, "yarn_length", "1", "mean distance of the ends of the faces' yarns over their length", s->yarn_length);
    put(rows, "fill_stress", "Pa", "mean stress of the fill", s->fill_stress);
    put(rows, "soil_stress", "Pa", "mean stress of the reinforced soil", s->soil_stress);
    put(rows, "fill_coordination_number", "1", "2 Nc/N of the fill", s->fill_coordination);
  }
  return rows;
}

CompactedCell compact_around(const Surrounded& cell, const Surround& how, const dem::Model& model,
                             const dem::Numerics& numerics, const ProgressReport& report,
                             const dem::Safekeeping& safekeeping) {
  Recipe recipe = how.recipe;
  recipe.rate_shares = cell.shares;
  if (!how.max_rate) recipe.max_rate = gentle_rate(cell, recipe.pressure);
  // The reinforced part does not follow the strain of the loose cell. That strain would crumple the yarns, which bear
  // no compression.
  for (std::size_t i = 0; i < cell.fill.size(); ++i)
    if (!cell.fill[i]) recipe.apart.push_back(static_cast<std::int32_t>(i));
  CompactedCell done{compact(cell.state, model, numerics, recipe, report, safekeeping), {}, {}, {}};
  done.before = shape(cell.state, cell.fill), done.after = shape(done.result.state, cell.fill);
  judge(how, done);
  return done;
}

}  // namespace soilweave::packing
