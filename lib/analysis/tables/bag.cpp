// Soil wrapped in geotextile as a whole.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/bag.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <future>
#include <limits>
#include <numbers>

#include "analysis/measure/stress.h"
#include "analysis/measure/tessellation.h"
#include "analysis/tables/tables.h"
#include "dem/state/bodies.h"

namespace soilweave::analysis {
namespace {

constexpr std::array<const char*, 3> families = {"face", "side_horizontal", "side_vertical"};

// Returns atan(tau/sigma) on the face normal to an axis, deg.
double face_friction(const Mat3& stress, int axis) {
  const Mat3 s = symmetric(stress);
  const double tau = std::hypot(s(axis, (axis + 1) % 3), s(axis, (axis + 2) % 3));
  return std::atan2(tau, s(axis, axis)) * 180 / std::numbers::pi;
}

void put_stresses(io::Series& table, const VolumeState& soil, const Mat3& quarter) {
  put(table, "soil_volume", "m3", "sum of the soil's power cells", soil.volume);
  put(table, "soil_void_ratio", "1", "void ratio of the soil from its power cells", soil.void_ratio);
  put(table, "soil_stress", "Pa", "Love-Weber stress of the soil over its power cells", symmetric(soil.stress), 3);
  const double p = mean(soil.stress), q = deviatoric_stress(soil.stress);
  put(table, "soil_mean_stress", "Pa", "mean stress p of the soil", p);
  put(table, "soil_deviatoric_stress", "Pa", "deviatoric stress q of the soil", q);
  put(table, "soil_obliquity", "1", "q/p of the soil", p != 0 ? q / p : no_value);
  for (int a = 0; a < 3; ++a)
    put(table, fmt::format("face_friction_{}", "xyz"[a]), "deg",
        "friction mobilised at the face across the axis, thesis Eq. 3.5, from a quarter of the soil",
        face_friction(quarter, a));
}

// A state, with the quantities to average over parts of it.
struct Averages {
  const io::Snapshot& state;
  std::vector<Mat3> dyads;           // N m
  const std::vector<double>& cells;  // m3

  VolumeState state_of(const Volume& volume) const { return volume_state(state, volume, dyads, cells); }
  double contacts_per_grain(const Volume& volume) const {
    std::vector<bool> in(state.grains.size(), false);
    for (const std::size_t i : volume.grains) in[i] = true;
    double ends = 0;
    for (const auto& pair : state.contacts.bodies)
      for (const std::int32_t b : pair) ends += b >= 0 && in[static_cast<std::size_t>(b)];
    return ends / static_cast<double>(volume.grains.size());
  }
};

// Appends the averages of the fill, and of the groups of soil.
void put_surroundings(io::Series& table, const Averages& averages, const Volume& all_fill) {
  const VolumeState fill = averages.state_of(all_fill);
  put(table, "fill_stress", "Pa", "Love-Weber stress of the fill over its power cells", symmetric(fill.stress), 3);
  put(table, "fill_void_ratio", "1", "void ratio of the fill from its power cells", fill.void_ratio);
  put(table, "fill_coordination_number", "1", "contacts of the fill's grains over their number",
      averages.contacts_per_grain(all_fill));
  for (const Volume& group : groups(averages.state)) {
    const Mat3 stress = averages.state_of(group).stress;
    const std::string name = "group_" + group.name.substr(1);
    put(table, name + "_mean_stress", "Pa", "mean stress p of the group of soil along x", mean(stress));
    put(table, name + "_deviatoric_stress", "Pa", "deviatoric stress q of the group of soil along x",
        deviatoric_stress(stress));
  }
}

void put_yarn_means(io::Series& table, const io::Snapshot& state) {
  const auto means = yarn_means(state);
  double broken = 0;
  for (std::size_t f = 0; f < families.size(); ++f) {
    put(table, fmt::format("yarn_tension_{}", families[f]), "N", "mean tension of the whole yarns", means[f].tension);
    put(table, fmt::format("yarn_strain_{}", families[f]), "1", "mean strain of the whole yarns", means[f].strain);
    broken += static_cast<double>(means[f].broken);
  }
  put(table, "broken_yarns", "1", "yarns broken so far", broken);
}

// Returns the middle of the reinforced soil. In an open assembly it is the origin. In a periodic cell it is the middle
// of the nodes, or of the soil if there is no geotextile.
Vec3 middle(const io::Snapshot& state) {
  if (!state.cell.periodic[0] && !state.cell.periodic[1]) return Vec3::Zero();
  const Part around = state.yarns.size() > 0 ? Part::node : Part::soil;
  const std::vector<Part> part = parts(state);
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t i = 0; i < part.size(); ++i)
    if (part[i] == around) low = low.cwiseMin(state.grains.position[i]), high = high.cwiseMax(state.grains.position[i]);
  return 0.5 * (low + high);
}

// Returns for each yarn how near its middle is to the seam between faces and sides: 0 in the middle, 1 at the outermost
// yarn. On a face it is the greater of |x| and |y| from the centre, each over the outermost yarn's. On a side it is |z|
// likewise.
std::vector<double> nearness_to_seams(const io::Snapshot& state) {
  const io::YarnsRecord& y = state.yarns;
  const auto at = [&](std::size_t k) -> Vec3 {
    return 0.5 * (state.grains.position[static_cast<std::size_t>(y.nodes[k][0])] +
                  state.grains.position[static_cast<std::size_t>(y.nodes[k][1])]);
  };
  // Bounds of faces and of sides.
  std::array<Vec3, 2> low, high;
  low.fill(Vec3::Constant(std::numeric_limits<double>::infinity()));
  high.fill(-low[0]);
  for (std::size_t k = 0; k < y.size(); ++k) {
    const std::size_t side = y.family[k] != 0;
    low[side] = low[side].cwiseMin(at(k)), high[side] = high[side].cwiseMax(at(k));
  }
  std::vector<double> nearness;
  for (std::size_t k = 0; k < y.size(); ++k) {
    const std::size_t side = y.family[k] != 0;
    const Vec3 half = 0.5 * (high[side] - low[side]), out = (at(k) - low[side] - half).cwiseAbs();
    const auto share = [&](int axis) { return half[axis] > 0 ? out[axis] / half[axis] : 0; };
    nearness.push_back(side ? share(2) : std::max(share(0), share(1)));
  }
  return nearness;
}

}  // namespace

bool is_reinforced(const io::Snapshot& state) {
  return state.grains.dimension == 3 && (state.yarns.size() > 0 || has_fill(state));
}

io::Snapshot soil_contacts(const io::Snapshot& state, bool alone) {
  const std::vector<bool> soil = those(parts(state), Part::soil);
  io::Snapshot left = state;
  const io::ContactsRecord& c = state.contacts;
  left.contacts = {};
  for (std::size_t k = 0; k < c.size(); ++k) {
    const auto [first, second] = c.bodies[k];
    const bool from_soil = soil[static_cast<std::size_t>(first)];
    const bool to_soil = second >= 0 && soil[static_cast<std::size_t>(second)];
    if (alone ? !from_soil || !to_soil : !from_soil && !to_soil) continue;
    left.contacts.append(c, k);
  }
  return left;
}

DelaunayFill delaunay_fill(const io::Snapshot& state, const std::vector<bool>& left_out) {
  DelaunayFill fill;
  io::Snapshot centres;
  centres.cell = state.cell;
  centres.cell.periodic = {false, false, false};
  centres.grains.dimension = state.grains.dimension;
  for (std::size_t i = 0; i < left_out.size(); ++i) {
    if (left_out[i]) continue;
    centres.grains.position.push_back(state.grains.position[i]);
    centres.grains.radius.push_back(state.grains.radius[i]);
    centres.grains.body_id.push_back(state.grains.body_id[i]);
    fill.solids += dem::grain_volume(state.grains.dimension, state.grains.radius[i]);
  }
  if (fill.solids > 0) fill.volume = delaunay_volume(centres);
  return fill;
}

BagRoom bag_room(const io::Snapshot& state, const std::vector<bool>& left_out, int threads) {
  const auto how = threads > 1 ? std::launch::async : std::launch::deferred;
  std::future<DelaunayFill> soil = std::async(how, [&] { return delaunay_fill(state, left_out); });
  std::vector<double> cells = power_cell_volumes(state);
  return {std::move(cells), soil.get()};
}

std::array<YarnMean, 3> yarn_means(const io::Snapshot& state) {
  const io::YarnsRecord& y = state.yarns;
  std::array<YarnMean, 3> means;
  for (std::size_t k = 0; k < y.size(); ++k) {
    YarnMean& m = means[static_cast<std::size_t>(std::min(2, y.family[k]))];
    if (y.broken[k]) {
      ++m.broken;
      continue;
    }
    const Vec3 reach = state.grains.position[static_cast<std::size_t>(y.nodes[k][1])] -
                       state.grains.position[static_cast<std::size_t>(y.nodes[k][0])];
    m.tension += y.tension[k], m.strain += reach.norm() / y.rest_length[k] - 1;
    ++m.whole;
  }
  for (YarnMean& m : means)
    if (m.whole)
      m.tension /= static_cast<double>(m.whole), m.strain /= static_cast<double>(m.whole);
    else
      m.tension = m.strain = no_value;
  return means;
}

void put_bag(io::Series& table, const io::Snapshot& state, int threads) {
  const std::vector<Part> part = parts(state);
  std::vector<bool> left_out = those(part, Part::soil);
  left_out.flip();
  const BagRoom room = bag_room(state, left_out, threads);
  const Averages averages{state, grain_dyads(state), room.cells};
  const Vec3 origin = middle(state);
  Volume soil, quarter, fill;
  double outside = 0;
  for (std::size_t i = 0; i < part.size(); ++i) {
    if (part[i] == Part::fill) fill.grains.push_back(i);
    if (part[i] != Part::soil) continue;
    soil.grains.push_back(i);
    outside += room.cells[i] == 0;
    if (state.grains.position[i].x() > origin.x() && state.grains.position[i].y() > origin.y())
      quarter.grains.push_back(i);
  }
  put_stresses(table, averages.state_of(soil), averages.state_of(quarter).stress);
  put(table, "soil_delaunay_void_ratio", "1", "void ratio of the Delaunay tetrahedra of the soil's centres",
      room.soil.void_ratio());
  put(table, "soil_outside", "1", "soil grains whose power cell reaches outside", outside);
  put(table, "soil_coordination_number", "1", "contacts of the soil's grains over their number",
      averages.contacts_per_grain(soil));
  put_yarn_means(table, state);
  if (state.cell.periodic[0] || state.cell.periodic[1] || state.cell.periodic[2])
    put(table, "yarn_stress", "Pa", "the yarns' part of the cell's stress", yarn_stress(state), 3);
  if (!fill.grains.empty()) put_surroundings(table, averages, fill);
}

void put_yarns(io::Series& table, const io::Snapshot& state) {
  const io::YarnsRecord& y = state.yarns;
  const std::vector<double> seam = nearness_to_seams(state);
  for (std::size_t k = 0; k < y.size(); ++k) {
    const Vec3& first = state.grains.position[static_cast<std::size_t>(y.nodes[k][0])];
    const Vec3& second = state.grains.position[static_cast<std::size_t>(y.nodes[k][1])];
    const double length = (second - first).norm();
    put_step(table, state);
    put(table, "family", "1", "0: faces, 1: sides, in plane, 2: sides, from face to face", y.family[k]);
    for (int a = 0; a < 3; ++a)
      put(table, fmt::format("position_{}", "xyz"[a]), "m", "middle of the yarn", 0.5 * (first[a] + second[a]));
    for (int a = 0; a < 3; ++a)
      put(table, fmt::format("direction_{}", "xyz"[a]), "1", "unit direction", (second[a] - first[a]) / length);
    put(table, "length", "m", "present length", length);
    put(table, "tension", "N", "tension", y.tension[k]);
    put(table, "strain", "1", "length over that at rest, less 1", length / y.rest_length[k] - 1);
    put(table, "broken", "1", "1 where it is broken", y.broken[k]);
    put(table, "seam", "1", "nearness to the seam: 0 in the middle of its face or side, 1 where the outermost yarn is",
        seam[k]);
  }
}

void put_broken(io::Series& table, const io::Snapshot& state) {
  const io::YarnsRecord& y = state.yarns;
  std::vector<std::size_t> broken;
  for (std::size_t k = 0; k < y.size(); ++k)
    if (y.broken[k]) broken.push_back(k);
  std::ranges::stable_sort(broken, {}, [&y](std::size_t k) { return y.break_time[k]; });
  put_step(table, state, broken.size());
  put_rows(table, "yarn", "1", "number of the yarn", broken, [](std::size_t k) { return static_cast<double>(k); });
  put_rows(table, "family", "1", "0: faces, 1: sides, in plane, 2: sides, from face to face", broken,
           [&y](std::size_t k) { return static_cast<double>(y.family[k]); });
  put_rows(table, "break_time", "s", "time at which the yarn broke", broken,
           [&y](std::size_t k) { return y.break_time[k]; });
  for (int a = 0; a < 3; ++a)
    put_rows(table, fmt::format("position_{}", "xyz"[a]), "m", "position at which the yarn broke", broken,
             [&y, a](std::size_t k) { return y.break_position[k][a]; });
}

}  // namespace soilweave::analysis
