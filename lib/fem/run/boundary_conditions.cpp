// Supports and tractions of a two-scale scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/boundary_conditions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "core/error.h"
#include "core/linear_algebra.h"
#include "dem/contact/laws/linear_adhesion.h"
#include "fem/model/guides.h"

namespace soilweave::fem {
namespace {

// Returns whether the key is sound and a check throws no DataError. Notes the error as a mistake about the key.
template <class Check>
bool accepted(Settings& table, std::string_view key, const Check& check) {
  if (!key.empty() && !table.sound(key)) return false;
  try {
    check();
    return true;
  } catch (const DataError& error) {
    table.mistake(key, error.what());
    return false;
  }
}

void read_support(Settings& table, SoilSetup& soil) {
  static constexpr Parameter speed_x{"x", "m/s", -1e3, 1e3, false, "prescribed velocity along x; 0 fixes the nodes"},
      speed_y{"y", "m/s", -1e3, 1e3, false, "prescribed velocity along y; 0 fixes the nodes"};
  static constexpr Parameter gradient{"gradient", "1/s", -1e6, 1e6, false, "velocity gradient xx, xy, yx, yy"};
  Support s{table.text({"on", "name of a boundary, or all for every node"}), {}, {}, {}};
  if (table.has("x")) s.x = table.number(speed_x);
  if (table.has("y")) s.y = table.number(speed_y);
  if (table.has("gradient")) {
    const std::vector<double> g = table.numbers(gradient);
    if (g.size() != 4) table.mistake("gradient", "has not four numbers: xx, xy, yx, yy");
    if (g.size() == 4) s.gradient = (Mat2() << g[0], g[1], g[2], g[3]).finished();
  }
  if (s.gradient && (s.x || s.y))
    table.mistake("gradient", "is given beside x or y, and moves the nodes along both: leave one of the two out");
  if (!s.x && !s.y && !s.gradient) table.mistake("", "holds nothing: give x, y or gradient");
  if (!accepted(table, "on", [&] { soil.mesh.nodes_on(s.boundary); })) return;
  soil.supports.push_back(std::move(s));
  if (!accepted(table, "", [&] { held_nodes(soil.mesh, soil.supports); })) soil.supports.pop_back();
}

void read_traction(Settings& table, SoilSetup& soil) {
  static constexpr Parameter pressure_x{"x", "Pa", -1e9, 1e9, false, "traction along x"},
      pressure_y{"y", "Pa", -1e9, 1e9, false, "traction along y"};
  Traction t{table.text({"on", "name of a boundary with edges"})};
  t.value[0] = table.number(pressure_x, 0);
  t.value[1] = table.number(pressure_y, 0);
  if (!table.has("x") && !table.has("y")) table.mistake("", "loads nothing: give x or y");
  if (accepted(table, "on", [&] { soil.mesh.boundary_with_edges(t.boundary); })) soil.tractions.push_back(std::move(t));
}

// Returns the velocities of a point of a rigid piece, one column per motion: along x, along y and around its middle.
Eigen::Matrix<double, 2, 3> rigid_motions(const Vec2& from_middle) {
  return (Eigen::Matrix<double, 2, 3>() << 1, 0, -from_middle[1], 0, 1, from_middle[0]).finished();
}

// Returns the sum of the nodal forces on a piece if they move or turn it as a whole, because no support resists them.
std::optional<Vec2> unbalanced(const Mesh& mesh, const Mesh::Piece& piece, const std::vector<HeldNode>& held,
                               const std::vector<Vec2>& forces) {
  double size = 0;
  for (const Index n : piece.nodes) size = std::max(size, (mesh.nodes[n] - piece.middle).norm());
  Mat3 holding = Mat3::Zero();
  Vec3 load = Vec3::Zero();
  double turned_over = 0;
  for (const Index n : piece.nodes) {
    const Eigen::Matrix<double, 2, 3> motions = rigid_motions((mesh.nodes[n] - piece.middle) / size);
    for (const Eigen::Index axis : {0, 1})
      if (held[n][static_cast<std::size_t>(axis)]) holding += motions.row(axis).transpose() * motions.row(axis);
    load += motions.transpose() * forces[n];
    turned_over += forces[n].norm();
  }
  // Eigenvectors with eigenvalue 0 are the motions that no support resists.
  const Eigensystem<Mat3> motions = eigensystem(holding);
  Vec3 free = Vec3::Zero();
  for (const Eigen::Index k : {0, 1, 2})
    if (motions.values[k] < 1e-9) free += motions.vectors.col(k) * motions.vectors.col(k).dot(load);
  if (!(free.norm() > 1e-6 * turned_over)) return std::nullopt;
  return load.head<2>();
}

void doubt_carried(const SoilSetup& soil, const std::vector<HeldNode>& held, std::vector<Doubt>& doubts) {
  std::vector<std::string> carried;
  for (const Traction& t : soil.tractions)
    for (const std::size_t axis : {0, 1}) {
      const std::vector<Index>& nodes = soil.mesh.boundary(t.boundary).nodes;
      if (t.value[static_cast<Eigen::Index>(axis)] != 0 &&
          std::all_of(nodes.begin(), nodes.end(), [&](Index n) { return held[n][axis].has_value(); }))
        carried.push_back(fmt::format("on \"{}\" along {}", t.boundary, "xy"[axis]));
    }
  if (!carried.empty())
    doubts.push_back(
        {"traction_carried", fmt::format("the traction {} loads no soil, since supports hold all nodes there; "
                                         "leave it out, or take it to a boundary that is free",
                                         fmt::join(carried, " and "))});
}

void doubt_free(const SoilSetup& soil, const std::vector<HeldNode>& held, std::vector<Doubt>& doubts) {
  const std::vector<Vec2> forces = traction_forces(soil.mesh, soil.mesh.nodes, soil.tractions);
  const std::vector<Mesh::Piece> pieces = soil.mesh.pieces();
  for (const Mesh::Piece& piece : pieces)
    if (const std::optional<Vec2> sum = unbalanced(soil.mesh, piece, held, forces)) {
      const std::string place =
          pieces.size() == 1 ? "" : fmt::format(" around ({:.4g}, {:.4g}) m", piece.middle[0], piece.middle[1]);
      doubts.push_back(
          {"soil_free", fmt::format("no support holds the soil{} against its tractions, {:.4g} N/m along x and "
                                    "{:.4g} N/m along y in all: they move or turn it as a whole; hold it by a "
                                    "[[support]]",
                                    place, (*sum)[0], (*sum)[1])});
      return;
    }
}

/// Returns the isotropic tension that the soil bears, Pa; none if the scenario does not define it.
std::optional<double> tensile_strength(const ModelSetup& setup) {
  if (setup.law) {
    if (!setup.law->friction_angle) return std::nullopt;
    return setup.law->cohesion / std::tan(*setup.law->friction_angle);
  }
  if (setup.grains.model.materials.are<dem::LinearAdhesion::Material>()) return std::nullopt;
  return 0;
}

using Edge = std::array<Index, 2>;

// Returns the tractions of edges, Pa. They add up, also from boundaries that overlap.
std::map<Edge, Vec2> tractions_of_edges(const SoilSetup& soil) {
  std::map<Edge, Vec2> of_edge;
  for (const Traction& t : soil.tractions)
    for (const Edge& edge : soil.mesh.boundary_with_edges(t.boundary).ends)
      of_edge.try_emplace(edge, Vec2::Zero()).first->second += t.value;
  return of_edge;
}

// Returns the outward normal of an edge, as long as the edge. The soil lies to the left of its boundary.
Vec2 outward_of(const Edge& edge, const Mesh& mesh) {
  const Vec2 along = mesh.nodes[edge[1]] - mesh.nodes[edge[0]];
  return {along[1], -along[0]};
}

void doubt_pulled(const ModelSetup& setup, std::vector<Doubt>& doubts) {
  const std::optional<double> strength = tensile_strength(setup);
  if (!strength) return;
  const SoilSetup& soil = setup.soil;
  const std::map<Edge, Vec2> of_edge = tractions_of_edges(soil);
  for (const Traction& t : soil.tractions) {
    double pull = 0, length = 0;
    for (const Edge& edge : soil.mesh.boundary_with_edges(t.boundary).ends) {
      const Vec2 outward = outward_of(edge, soil.mesh);
      pull += of_edge.at(edge).dot(outward);
      length += outward.norm();
    }
    // On a closed boundary, the mean pull of a constant traction is zero but for rounding.
    if (!(pull / length > *strength + 1e-9 * t.value.norm())) continue;
    doubts.push_back(
        {"traction_pulls", fmt::format("the traction on \"{}\" pulls the soil by {:.4g} kPa, and it bears {:.4g} kPa: "
                                       "it is torn apart; change the sign where a pressure is meant",
                                       t.boundary, pull / length / 1e3, *strength / 1e3)});
    return;
  }
}

// Largest share of a load by which the initial stress may miss it, and the ratio of the two beyond which a missing unit
// is likelier: a stress in kPa read as Pa is a thousandth.
constexpr double largest_miss = 0.1, unit_ratio = 50;

// A load of the scenario on a boundary.
struct Load {
  std::string name, boundary;
  Vec2 given = Vec2::Zero();  // Pa
};

// The worst edge of a boundary along one axis: its traction and the one that balances the stress of the soil, Pa.
struct Miss {
  double given = 0, balanced = 0;
  double outward = 0;  // component of the normal
};

// Returns the worst edge, if the initial stress misses the tractions of a boundary's free edges along an axis.
std::optional<Miss> miss_of(const Boundary& boundary, std::size_t along, const Mesh& mesh,
                            const std::vector<HeldNode>& held, const std::map<Edge, Vec2>& of_edge,
                            const std::vector<Mat2>& stress) {
  const auto axis = static_cast<Eigen::Index>(along);
  Miss worst;
  double missed = 0, greatest = 0;
  for (const Edge& edge : boundary.ends) {
    if (held[edge[0]][along] && held[edge[1]][along]) continue;
    const Vec2 outward = outward_of(edge, mesh), normal = outward.normalized();
    const Vec2& given = of_edge.at(edge);
    const Vec2 balanced = 0.5 * (stress[edge[0]] + stress[edge[1]]) * normal;
    // An upright cell keeps a shear stress that no loading takes from its grains.
    if (std::abs(normal[axis]) < 1e-9 && given[axis] == 0) continue;
    missed += std::abs(given[axis] - balanced[axis]) * outward.norm();
    greatest += std::max(given.norm(), balanced.norm()) * outward.norm();
    if (std::abs(given[axis] - balanced[axis]) > std::abs(worst.given - worst.balanced))
      worst = {given[axis], balanced[axis], normal[axis]};
  }
  if (!(missed > largest_miss * greatest)) return std::nullopt;
  return worst;
}

std::string balance_remedy(double given, const Miss& miss, bool of_law) {
  if (given != 0 && std::abs(miss.balanced) > unit_ratio * std::abs(miss.given))
    return fmt::format("if {0:.4g} kPa is meant, write \"{0:.4g} kPa\"", given);
  if (of_law && miss.balanced != 0 && std::abs(miss.given) > unit_ratio * std::abs(miss.balanced))
    return fmt::format("if an initial stress of {0:.4g} kPa is meant, write \"{0:.4g} kPa\"",
                       std::copysign(miss.balanced, -miss.balanced * miss.outward));
  return fmt::format("make the two equal{}, unless a sudden load is meant",
                     of_law ? "" : ", as by run-dem on the packings");
}

}  // namespace

void read_boundary_conditions(Settings& document, SoilSetup& soil) {
  for (Settings table : document.tables("support")) read_support(table, soil);
  for (Settings table : document.tables("traction")) read_traction(table, soil);
}

bool is_driven(const ModelSetup& setup) {
  const auto moves = [](const Support& s) {
    return s.x.value_or(0) != 0 || s.y.value_or(0) != 0 || (s.gradient && !s.gradient->isZero(0));
  };
  const auto pulls = [](const ChainEnd& end) { return end.x.value_or(0) != 0 || end.y.value_or(0) != 0; };
  const std::vector<Support>& supports = setup.soil.supports;
  return std::any_of(supports.begin(), supports.end(), moves) ||
         (setup.bars && (pulls(setup.bars->start) || pulls(setup.bars->end)));
}

std::vector<Doubt> loading_doubts(const ModelSetup& setup) {
  const SoilSetup& soil = setup.soil;
  const std::vector<HeldNode> held = held_nodes(soil.mesh, soil.supports);
  std::vector<Doubt> doubts;
  doubt_carried(soil, held, doubts);
  doubt_pulled(setup, doubts);
  if (setup.bars) return doubts;  // the chain or its guides may hold and load the soil
  doubt_free(soil, held, doubts);
  const auto zero = [](const Traction& t) { return t.value.isZero(0); };
  if (setup.law && setup.law->initial_stress.isZero(0) && !is_driven(setup) &&
      std::all_of(soil.tractions.begin(), soil.tractions.end(), zero))
    doubts.push_back({"soil_unloaded",
                      "nothing loads the soil: every stress stays 0; give it a [[traction]], a [[support]] "
                      "that moves, or soil.initial_stress"});
  return doubts;
}

std::vector<Doubt> balance_doubts(const ModelSetup& setup, const Model& model) {
  const SoilSetup& soil = setup.soil;
  std::vector<Mat2> stresses;
  for (const auto& point : model.points()) stresses.push_back(point->stress());
  if (std::all_of(stresses.begin(), stresses.end(), [](const Mat2& s) { return s.isZero(0); })) return {};
  std::map<Edge, Vec2> of_edge = tractions_of_edges(soil);
  std::vector<Load> loads;
  for (const Traction& t : soil.tractions) loads.push_back({"the traction", t.boundary, t.value});
  for (const std::string& name : setup.seat_pressure > 0 ? setup.along : std::vector<std::string>()) {
    for (const Edge& edge : soil.mesh.boundary_with_edges(name).ends)
      of_edge.try_emplace(edge, Vec2::Zero()).first->second[1] +=
          setup.seat_pressure * std::abs(outward_of(edge, soil.mesh).normalized()[1]);
    loads.push_back({"the seat pressure", name, Vec2(0, setup.seat_pressure)});
  }
  const std::vector<HeldNode> held = held_nodes(soil.mesh, soil.supports);
  const std::vector<Mat2> stress = model.soil().at_nodes(stresses);
  for (const Load& load : loads)
    for (const std::size_t axis : {0, 1}) {
      const std::optional<Miss> found =
          miss_of(soil.mesh.boundary(load.boundary), axis, soil.mesh, held, of_edge, stress);
      if (!found) continue;
      const Miss& miss = *found;
      const double written = load.given[static_cast<Eigen::Index>(axis)];
      return {
          {"load_unbalanced",
           fmt::format("{} on \"{}\" is {:.4g} kPa along {}, and the soil's stress at the start balances {:.4g} kPa "
                       "there: the soil would oscillate; {}",
                       load.name, load.boundary, miss.given / 1e3, "xy"[axis], miss.balanced / 1e3,
                       balance_remedy(written, miss, setup.law.has_value()))}};
    }
  return {};
}

std::vector<Doubt> guide_doubts(const Model& model) {
  const ModelSetup& setup = model.setup();
  if (!setup.bars || !(setup.seat_pressure > 0)) return {};
  const std::vector<std::size_t> uncarried = uncarried_bars(*setup.bars);
  if (uncarried.empty()) return {};
  return {{"uncarried", "the geosynthetic bears its seat pressure as a hanging chain, since " +
                            uncarried_text(*setup.bars, uncarried)}};
}

}  // namespace soilweave::fem
