// A bag of geotextile between two plates.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/tables/loading.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "analysis/measure/stress.h"
#include "analysis/measure/tessellation.h"
#include "analysis/tables/tables.h"

namespace soilweave::analysis {
namespace {

/// Makes the loading table of a bag from a run's series.
class LoadingTable {
 public:
  LoadingTable(const io::Series& run, const LoadedBag& bag)
      : run_(run), bag_(bag), reference_(reference_row(run, bag)), shear_(direction_of_shear()) {}

  io::Series table() {
    for (const char* name : {"step", "time", "stage"}) copy(name, name, run_.at(name).long_name);
    put_plates();
    put_stresses();
    put_soil();
    put_yarns();
    put_rest();
    return std::move(table_);
  }

 private:
  const std::vector<double>& of(const std::string& name) const { return run_.at(name).values; }
  const std::vector<double>& plate(const char* what, const std::string& name, char axis) const {
    return of(fmt::format("{}_{}_{}", what, name, axis));
  }

  void put(const std::string& name, const std::string& unit, const std::string& long_name,
           const std::function<double(std::size_t)>& value) {
    io::Column column{name, unit, long_name, {}};
    for (std::size_t i = 0; i < run_.rows(); ++i) column.values.push_back(value(i));
    table_.columns.push_back(std::move(column));
  }
  void copy(const std::string& source, const std::string& name, const std::string& long_name) {
    const io::Column& from = run_.at(source);
    table_.columns.push_back({name, from.unit, long_name, from.values});
  }
  const std::vector<double>& done(const char* name) const { return table_.at(name).values; }

  /// Returns the distance by which the plates have moved apart since the start of the run, m.
  double apart(std::size_t i) const {
    return plate("displacement", bag_.upper, 'z')[i] - plate("displacement", bag_.lower, 'z')[i];
  }
  /// Returns the horizontal displacement of the upper plate minus that of the lower one, m.
  Vec2 travel(std::size_t i) const {
    const auto along = [&](char axis) {
      return plate("displacement", bag_.upper, axis)[i] - plate("displacement", bag_.lower, axis)[i];
    };
    return {along('x'), along('y')};
  }
  /// Returns the horizontal direction in which the upper plate travels farthest relative to the lower one; x without
  /// travel.
  Vec2 direction_of_shear() const {
    Vec2 farthest(0, 0);
    for (std::size_t i = 0; i < run_.rows(); ++i)
      if (travel(i).norm() > farthest.norm()) farthest = travel(i);
    return farthest.norm() > 0 ? Vec2(farthest.normalized()) : Vec2(1, 0);
  }

  void put_plates() {
    put("settlement", "m", "approach of the plates since the reference row",
        [&](std::size_t i) { return apart(reference_) - apart(i); });
    put("strain_axial", "1", "settlement over the height of the bag as made",
        [&](std::size_t i) { return done("settlement")[i] / bag_.height; });
    put("shear_displacement", "m", "travel of the upper plate against the lower one since the reference row",
        [&](std::size_t i) { return shear_.dot(travel(i) - travel(reference_)); });
    const auto &above = plate("force", bag_.upper, 'z'), &below = plate("force", bag_.lower, 'z');
    put("plate_pressure", "Pa", "mean of both plates' forces over the nominal area of the bag",
        [&](std::size_t i) { return 0.5 * (std::abs(above[i]) + std::abs(below[i])) / bag_.area; });
    const auto& volume = of("soil_volume");
    // The mean stress of a body under two opposite forces is the force times its height over its volume.
    put("surcharge", "Pa", "mean vertical stress of soil and geotextile as one, which the plates balance",
        [&](std::size_t i) {
          return done("plate_pressure")[i] * bag_.area * (bag_.gap + apart(i)) / (volume[i] + bag_.fabric_volume);
        });
  }

  void put_stresses() {
    const auto &xx = of("soil_stress_xx"), &yy = of("soil_stress_yy");
    copy("soil_stress_zz", "axial_stress", "vertical stress of the soil");
    put("lateral_stress", "Pa", "mean horizontal stress of the soil",
        [&](std::size_t i) { return 0.5 * (xx[i] + yy[i]); });
    copy("soil_mean_stress", "mean_stress", "mean stress p of the soil");
    copy("soil_deviatoric_stress", "deviatoric_stress", "deviatoric stress q of the soil");
    copy("soil_obliquity", "obliquity", "q/p of the soil");
    const auto &xz = of("soil_stress_xz"), &yz = of("soil_stress_yz");
    const auto &along_x = plate("force", bag_.upper, 'x'), &along_y = plate("force", bag_.upper, 'y');
    const auto& above = plate("force", bag_.upper, 'z');
    // Along the travel, force and stress are negative: grains resist, and compression is positive. Both signs are
    // reversed.
    put("shear_stress", "Pa", "shear stress of the soil along the travel of the plates, x where they do not travel",
        [&](std::size_t i) { return 0.0 - shear_.dot(Vec2(xz[i], yz[i])); });
    const auto force = [&](std::size_t i) { return 0.0 - shear_.dot(Vec2(along_x[i], along_y[i])); };
    put("plate_shear", "Pa", "shear force on the upper plate over the nominal area, along its travel",
        [&](std::size_t i) { return force(i) / bag_.area; });
    put("plate_ratio", "1", "shear force over normal force of the upper plate",
        [&](std::size_t i) { return above[i] != 0 ? force(i) / std::abs(above[i]) : no_value; });
  }

  void put_soil() {
    const auto& e = of("soil_delaunay_void_ratio");
    put("strain_volumetric", "1", "lost share of the soil's Delaunay volume since the reference row",
        [&](std::size_t i) { return (e[reference_] - e[i]) / (1 + e[reference_]); });
    put("strain_deviatoric", "1", "axial strain less a third of the volumetric one",
        [&](std::size_t i) { return done("strain_axial")[i] - done("strain_volumetric")[i] / 3; });
    copy("soil_void_ratio", "void_ratio", "void ratio of the soil from its power cells");
    copy("soil_delaunay_void_ratio", "delaunay_void_ratio",
         "void ratio of the Delaunay tetrahedra of the soil's centres");
    copy("soil_coordination_number", "coordination_number", "contacts of the soil's grains over their number");
  }

  void put_yarns() {
    static constexpr std::array<std::array<const char*, 3>, 3> families = {{
        {"face", "face", "on the faces"},
        {"side_horizontal", "side_around", "around the sides"},
        {"side_vertical", "side_up", "up the sides"},
    }};
    for (std::size_t f = 0; f < families.size(); ++f) {
      const auto& tension = of(fmt::format("yarn_tension_{}", families[f][0]));
      put(fmt::format("tension_yarn_{}", families[f][1]), "N",
          fmt::format("mean tension of a whole yarn {}, of those that one stands for", families[f][2]),
          [&](std::size_t i) { return tension[i] / bag_.multiple[f]; });
    }
    for (const auto& [source, name, place] : families)
      copy(fmt::format("yarn_strain_{}", source), fmt::format("strain_yarn_{}", name),
           fmt::format("mean strain of the whole yarns {}", place));
    const double cut = bag_.face_yarns + bag_.side_yarns;
    put("tension_around", "N", "mean tension of the yarns that an upright plane in the middle cuts",
        [&](std::size_t i) {
          return (bag_.face_yarns * done("tension_yarn_face")[i] +
                  bag_.side_yarns * done("tension_yarn_side_around")[i]) /
                 cut;
        });
    copy("broken_yarns", "broken_yarns", "yarns broken so far");
    const double strain = first_break_strain(run_, bag_);
    put("first_break_strain", "1", "axial strain at which the first yarn broke, the same in all rows",
        [&](std::size_t) { return strain; });
  }

  void put_rest() {
    for (const char* name : {"face_friction_x", "face_friction_y", "face_friction_z", "kinetic_energy",
                             "unbalanced_force", "boundary_work", "energy_error"})
      copy(name, name, run_.at(name).long_name);
    put("nominal_area", "m2", "area that the plates' forces are spread over", [&](std::size_t) { return bag_.area; });
    put("reference_height", "m", "height of the bag as made", [&](std::size_t) { return bag_.height; });
  }

  const io::Series& run_;
  const LoadedBag& bag_;
  std::size_t reference_;
  Vec2 shear_;
  io::Series table_;
};

/// Returns p and q of each group in the states between two steps.
std::vector<std::array<std::vector<double>, 2>> stresses_of_groups(const std::vector<io::Snapshot>& states, double from,
                                                                   double to) {
  std::vector<std::array<std::vector<double>, 2>> stresses;
  for (const io::Snapshot& state : states) {
    const auto step = static_cast<double>(state.step);
    const std::vector<Volume> all = step < from || step > to ? std::vector<Volume>() : groups(state);
    if (all.empty()) continue;
    const std::vector<Mat3> dyads = grain_dyads(state);
    const std::vector<double> cells = power_cell_volumes(state);
    stresses.resize(std::max(stresses.size(), all.size()));
    for (std::size_t k = 0; k < all.size(); ++k) {
      const Mat3 stress = volume_state(state, all[k], dyads, cells).stress;
      stresses[k][0].push_back(mean(stress, 3));
      stresses[k][1].push_back(deviatoric_stress(stress, 3));
    }
  }
  return stresses;
}

void put_path(io::Series& table, double volume, const StressPath& path) {
  put(table, "volume_of_interest", "1", "number of the group along x, from 0; -1: the whole soil", volume);
  put(table, "points", "1", "rows or states on the path", static_cast<double>(path.points));
  put(table, "slope", "1", "q/p of the line through the origin that fits the path", path.slope);
  put(table, "deviation", "1", "greatest difference of q from that line, over the greatest q", path.deviation);
}

const Vec3& node(const io::Snapshot& state, std::int32_t n) {
  return state.grains.position[static_cast<std::size_t>(n)];
}

}  // namespace

std::size_t reference_row(const io::Series& run, const LoadedBag& bag) {
  if (!bag.preloaded) return 0;
  const std::vector<double>& stage = run.at("stage").values;
  std::size_t row = 0;
  while (row + 1 < stage.size() && stage[row + 1] == stage.front()) ++row;
  return row;
}

std::size_t first_broken_row(const io::Series& run) {
  const std::vector<double>& broken = run.at("broken_yarns").values;
  std::size_t row = 0;
  while (row + 1 < broken.size() && !(broken[row] > 0)) ++row;
  return row;
}

double first_break_strain(const io::Series& run, const LoadedBag& bag) {
  const std::vector<double>&time = run.at("time").values, &stage = run.at("stage").values;
  if (!bag.first_break || time.size() < 2 || *bag.first_break < time.front()) return no_value;
  const auto &up = run.at("displacement_" + bag.upper + "_z").values,
             &down = run.at("displacement_" + bag.lower + "_z").values;
  const std::size_t reference = reference_row(run, bag);
  const auto strain = [&](std::size_t i) { return (up[reference] - down[reference] - (up[i] - down[i])) / bag.height; };
  std::size_t after = 1;
  while (after + 1 < time.size() && time[after] < *bag.first_break) ++after;
  const double elapsed = *bag.first_break - time[after - 1], whole = strain(after) - strain(after - 1);
  const auto number = static_cast<std::size_t>(stage[after]);
  const std::optional<double> speed = number < bag.closing_speed.size() ? bag.closing_speed[number] : std::nullopt;
  const double share = elapsed / (time[after] - time[after - 1]);
  const double closed = speed ? *speed / bag.height * elapsed : std::abs(whole) * std::min(share, 1.0);
  return strain(after - 1) + std::copysign(std::min(closed, std::abs(whole)), whole);
}

io::Series loading(const io::Series& run, const LoadedBag& bag) { return LoadingTable(run, bag).table(); }

StressPath stress_path(const std::vector<double>& mean, const std::vector<double>& deviatoric) {
  StressPath path;
  double products = 0, squares = 0, greatest = 0, farthest = 0;
  path.points = mean.size();
  for (std::size_t i = 0; i < mean.size(); ++i) {
    products += mean[i] * deviatoric[i], squares += mean[i] * mean[i];
    greatest = std::max(greatest, deviatoric[i]);
  }
  path.slope = squares > 0 ? products / squares : no_value;
  for (std::size_t i = 0; i < mean.size(); ++i)
    farthest = std::max(farthest, std::abs(deviatoric[i] - path.slope * mean[i]));
  path.deviation = greatest > 0 ? farthest / greatest : no_value;
  return path;
}

io::Series stress_paths(const io::Series& run, const std::vector<io::Snapshot>& states, const LoadedBag& bag) {
  const std::size_t from = reference_row(run, bag), to = std::max(from, first_broken_row(run));
  const auto rows = [&](const char* name) {
    const auto begin = run.at(name).values.begin();
    return std::vector<double>(begin + static_cast<std::ptrdiff_t>(from), begin + static_cast<std::ptrdiff_t>(to) + 1);
  };
  io::Series table;
  put_path(table, -1, stress_path(rows("soil_mean_stress"), rows("soil_deviatoric_stress")));
  const std::vector<double>& step = run.at("step").values;
  double number = 0;
  for (const auto& [p, q] : stresses_of_groups(states, step[from], step[to]))
    put_path(table, number++, stress_path(p, q));
  return table;
}

std::array<double, 2> yarns_in_cut(const io::Snapshot& state, std::int32_t fabric) {
  const io::YarnsRecord& y = state.yarns;
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
  for (std::size_t k = 0; k < y.size(); ++k)
    if (y.fabric[k] == fabric)
      for (const std::int32_t n : y.nodes[k]) low = low.cwiseMin(node(state, n)), high = high.cwiseMax(node(state, n));
  const Vec3 middle = 0.5 * (low + high);
  std::array<double, 2> cut = {0, 0};
  for (std::size_t k = 0; k < y.size(); ++k) {
    if (y.fabric[k] != fabric || y.family[k] > 1) continue;
    const Vec3 &a = node(state, y.nodes[k][0]), &b = node(state, y.nodes[k][1]);
    for (int axis = 0; axis < 2; ++axis)
      cut[static_cast<std::size_t>(y.family[k])] += (a[axis] < middle[axis]) != (b[axis] < middle[axis]);
  }
  // Each of the two planes cuts two faces and two sides. Rims are listed as faces; a half of each goes to the side.
  return {0.25 * cut[0] - 1, 0.25 * cut[1] + 1};
}

double fabric_area(const io::Snapshot& state, std::int32_t fabric) {
  std::vector<std::vector<std::int32_t>> next(state.grains.size());
  for (std::size_t k = 0; k < state.yarns.size(); ++k) {
    if (state.yarns.fabric[k] != fabric) continue;
    const auto [a, b] = state.yarns.nodes[k];
    next[static_cast<std::size_t>(a)].push_back(b), next[static_cast<std::size_t>(b)].push_back(a);
  }
  double area = 0;
  std::set<std::array<std::int32_t, 4>> seen;
  for (std::int32_t a = 0; a < static_cast<std::int32_t>(next.size()); ++a)
    for (const std::int32_t b : next[static_cast<std::size_t>(a)])
      for (const std::int32_t c : next[static_cast<std::size_t>(a)])
        for (const std::int32_t d : next[static_cast<std::size_t>(b)]) {
          const auto& others = next[static_cast<std::size_t>(c)];
          if (b >= c || d == a || std::ranges::find(others, d) == others.end()) continue;
          std::array<std::int32_t, 4> corners = {a, b, c, d};
          std::ranges::sort(corners);
          if (!seen.insert(corners).second) continue;
          area += 0.5 * (node(state, d) - node(state, a)).cross(node(state, c) - node(state, b)).norm();
        }
  return area;
}

}  // namespace soilweave::analysis
