// A plan of filter-expand, and the assembly before growth.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/plan.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/memory.h"
#include "core/text/named_file.h"
#include "dem/run/geotextile.h"
#include "dem/run/scenario.h"
#include "dem/state/bodies.h"
#include "packing/expand/lay_fabrics.h"
#include "packing/expand/tile.h"
#include "packing/generate/spatial_order.h"

namespace soilweave::packing {
namespace {

std::array<int, 3> whole_triple(Settings& table, const Parameter& parameter) {
  const Vec3 v = table.vector(parameter);
  for (int a = 0; a < 3; ++a)
    if (v[a] != std::round(v[a])) table.mistake(parameter.name, "has a part that is no whole number");
  return {static_cast<int>(v[0]), static_cast<int>(v[1]), static_cast<int>(v[2])};
}

void read_container(Settings& document, const NamedFiles& files, Plan& plan) {
  static constexpr Parameter copies{"copies", "1", 1, 1e4, false, "copies of the representative volume, by axis"};
  Settings table = document.table("container");
  std::vector<std::string> known = shapes();
  known.emplace_back("none");
  PlanFiles named{files, plan.sources};
  plan.container = packing::read_container(table.kind({"shape", "shape of the container"}, known), table, &named);
  if (table.has("copies")) plan.copies = whole_triple(table, copies);
}

// Adds a mistake for nodes with a radius of a quarter of the container or more. Their unit is probably wrong, and such
// nodes would not hold the soil.
void demand_small_nodes(Settings& table, const NodeRecipe& nodes, const Container& container) {
  const double extent = (container.high() - container.low()).minCoeff();
  // Invalid lengths have been refused already.
  if (!(extent > 0 && nodes.radius >= 0.25 * extent)) return;
  table.mistake("node_radius", fmt::format("is {:.4g} m where the container is {:.4g} m across: lengths are in m: give "
                                           "the one in mm its unit, as in \"2.5 mm\" (container.scale of a surface)",
                                           nodes.radius, extent));
}

// Adds a mistake for a length of a fabric that is larger than the container, as one in another unit.
void demand_fitting(Settings& table, const char* key, double value, double excess, const Container& container) {
  const double extent = (container.high() - container.low()).maxCoeff();
  if (table.sound(key) && extent > 0 && excess > extent)
    table.mistake(key,
                  fmt::format("is {:.4g} m where the container is {:.4g} m across: lengths are in m: give the one in "
                              "mm its unit, as in \"5 mm\" (container.scale of a surface)",
                              value, extent));
}

Plan::Sheet read_sheet(Settings& table, const Parameter& cells, const Parameter& spacing, const Container* container) {
  static constexpr Parameter height{"height", "m", -1e3, 1e3, false, "height z of a sheet"};
  Plan::Sheet sheet;
  const std::array<int, 3> n = whole_triple(table, cells);
  if (n[2] != 1) table.mistake("cells", fmt::format("has {} cells along z, and a sheet is flat: give 1 there", n[2]));
  sheet.cells = {n[0], n[1]};
  sheet.spacing = table.number(spacing, 0.005), sheet.height = table.number(height, 0.0);
  sheet.nodes = NodeRecipe::read(table);
  if (container) {
    const double from_middle = 0.5 * (container->high().z() - container->low().z());
    const double middle = 0.5 * (container->high().z() + container->low().z());
    demand_fitting(table, "height", sheet.height, std::abs(sheet.height - middle) - from_middle, *container);
    demand_fitting(table, "spacing", sheet.spacing, sheet.spacing, *container);
    demand_fitting(table, "node_radius", sheet.nodes.radius, sheet.nodes.radius, *container);
  }
  return sheet;
}

void read_fabrics(Settings& document, Plan& plan) {
  static constexpr Parameter cells{"cells", "1", 1, 1e4, false, "cells of the mesh along x, y and, of a bag, z"};
  static constexpr Parameter spacing{"spacing", "m", 0, 1e3, true, "distance between neighbouring yarns"};
  if (document.has("geotextile_mesh")) {
    Settings table = document.table("geotextile_mesh");
    const Laid laid = read_laid(table);
    plan.nodes = laid.nodes, plan.outside = laid.outside;
    const bool by_cells = table.has("cells"), by_spacing = table.has("spacing");
    const double apart = by_spacing ? table.number(spacing) : 0;
    const std::array<int, 3> given = by_cells || !by_spacing ? whole_triple(table, cells) : std::array<int, 3>{1, 1, 1};
    plan.even =
        table.flag({"even", "whether yarns are equally long; false: each face is divided by itself"}, plan.even);
    if (by_cells && by_spacing) table.mistake("cells", "are given beside spacing: leave one of the two out");
    if (plan.container) {
      demand_small_nodes(table, plan.nodes, *plan.container);
      demand_fitting(table, "spacing", apart, apart, *plan.container);
      plan.wrapping = apart > 0 ? cells_of(*plan.container, apart, plan.outside) : given;
    } else if (document.table("container").text("shape", "none") == "none") {
      table.mistake("", "has no container to wrap; use [[sheet]] for a flat one");
    }
  }
  for (Settings table : document.tables("sheet"))
    plan.sheets.push_back(read_sheet(table, cells, spacing, plan.container.get()));
}

void read_surround(Settings& document, const NamedFiles& files, Plan& plan) {
  for (const char* other : {"container", "geotextile_mesh", "sheet", "growth"})
    if (document.has(other))
      document.mistake(
          other,
          "is given beside [surround], which takes a file that has its geotextile already: leave one of the two out");
  Settings table = document.table("surround");
  plan.surround = Surround::read(table, files, plan.sources);
}

// Checks that the fill has its own material, whose friction can be lowered.
void demand_fill(Settings& document, Plan& plan) {
  Settings table = document.table("surround");
  Recipe& recipe = plan.surround->recipe;
  const std::int32_t material = plan.surround->material;
  const auto known = static_cast<std::int32_t>(plan.model.materials.size());
  if (material >= known)
    return table.mistake("material",
                         fmt::format("is {}, but the plan describes {}: give the fill a [[material]] of its "
                                     "own, 0 is [contact], 1 the first [[material]]",
                                     material, known));
  const double friction = dem::friction(plan.model, {material});
  if (recipe.void_ratio && friction < dem::lowest_friction)
    table.mistake("void_ratio",
                  fmt::format("cannot be reached by lowering friction: material {}, the fill's, has none; "
                              "give it a friction_angle, or leave void_ratio out",
                              material));
  if (table.has("first_friction_angle") && recipe.first_friction > friction)
    table.mistake("first_friction_angle", fmt::format("is larger than the fill's own, that of material {}", material));
  recipe.first_friction = std::min(recipe.first_friction, friction);
}

// Returns how far soil reaches from the origin along an axis, m.
double reach_of_soil(const Plan& plan, int axis) {
  return std::max(plan.container->high()[axis], -plan.container->low()[axis]) - plan.soil_depth();
}

// Returns how many copies, centred on the origin, cover the soil's part of the container. The numbers are real, since a
// container in a wrong unit of length would overflow integers.
Vec3 covering(const io::Snapshot& volume, const Plan& plan) {
  Vec3 n;
  for (int a = 0; a < 3; ++a) {
    const double reach = 2 * reach_of_soil(plan, a);
    n[a] = std::max(1.0, std::ceil(reach / volume.cell.matrix(a, a) * (1 - 1e-9)));
  }
  return n;
}

// Returns the memory for tiling the copies, bytes: grains once, contacts twice, in lists that grow by halves.
double bytes_of_copies(const io::Snapshot& volume, double copies) {
  constexpr double grain = 3 * sizeof(Vec3) + sizeof(Vec4) + 3 * sizeof(double) + 2 * sizeof(std::int32_t);
  constexpr double contact = 4 * sizeof(Vec3) + sizeof(Vec3i) + 4 * sizeof(double);
  return 1.5 * copies *
         (grain * static_cast<double>(volume.grains.size()) +
          2 * contact * static_cast<double>(volume.contacts.size()));
}

// Returns the numbers of copies. Throws DataError if their grains exceed the memory.
std::array<int, 3> copies_in(const io::Snapshot& volume, const Plan& plan) {
  Vec3 n = covering(volume, plan);
  if (plan.copies) n = Vec3((*plan.copies)[0], (*plan.copies)[1], (*plan.copies)[2]);
  const std::string lack = lack_of_memory(bytes_of_copies(volume, n.prod()));
  if (lack.empty()) return {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2])};
  const Vec3 size = plan.container->high() - plan.container->low();
  throw DataError(
      fmt::format("the container of {:.4g} x {:.4g} x {:.4g} m is covered by {:.3g} grains ({:.3g} copies of the "
                  "representative volume), which {}; lengths are in m: are these millimetres? give container.scale = "
                  "0.001 for a surface, a unit (\"40 mm\") for others; or take coarser grains (grains.scale)",
                  size.x(), size.y(), size.z(), n.prod() * static_cast<double>(volume.grains.size()), n.prod(), lack));
}

// Returns whether a grain neither stands in a sheet's nodes nor lies through its openings. A grain may touch the nodes.
bool clears_sheets(const Vec3& position, double radius, const Plan& plan) {
  constexpr double touching = 1 - 1e-9;
  return std::ranges::none_of(plan.sheets, [&](const Plan::Sheet& s) {
    const double reach = radius + s.nodes.radius;
    return std::abs(position.x()) < 0.5 * s.cells[0] * s.spacing + reach &&
           std::abs(position.y()) < 0.5 * s.cells[1] * s.spacing + reach &&
           std::abs(position.z() - s.height) < touching * reach;
  });
}

std::string nothing_fits(const io::Snapshot& block, const Plan& plan) {
  const Vec3 size = plan.container->high() - plan.container->low();
  return fmt::format(
      "no grain of the representative volume fits into the container of {:.4g} x {:.4g} x {:.4g} m: the smallest is "
      "{:.4g} m across; check the units of the container (container.scale of a surface), or take finer grains "
      "(grains.scale)",
      size.x(), size.y(), size.z(), 2 * *std::min_element(block.grains.radius.begin(), block.grains.radius.end()));
}

void demand_room_for_nodes(const Plan& plan) {
  double nodes = 0;
  if (plan.wrapping) {
    const Vec3 n((*plan.wrapping)[0], (*plan.wrapping)[1], (*plan.wrapping)[2]);
    nodes = 2 * (n.x() * n.y() + n.y() * n.z() + n.z() * n.x());
  }
  for (const Plan::Sheet& s : plan.sheets) nodes += (s.cells[0] + 1.0) * (s.cells[1] + 1.0);
  constexpr double of_node = 450;  // bytes, with two yarns and its place in the mesh
  demand_memory(of_node * nodes, fmt::format("the {:.3g} nodes of the geotextile", nodes),
                "give it fewer cells, or a wider spacing");
}

void demand_cover(const io::Snapshot& block, const Plan& plan) {
  for (int a = 0; a < 3; ++a) {
    const double half = 0.5 * block.cell.matrix(a, a);
    const double reach = reach_of_soil(plan, a);
    // The surface may stand out of the block by less than a grain, since grains grow.
    const double slack = *std::max_element(block.grains.radius.begin(), block.grains.radius.end());
    if (half + slack < reach)
      throw DataError(
          fmt::format("the copies of the representative volume reach to {} = {:.4g} m, soil in the container to "
                      "{:.4g} m: raise container.copies",
                      "xyz"[a], half, reach));
  }
}

// Returns the exponent of length with which a field scales at constant strains and stresses. Throws DataError for an
// unknown unit.
int power_of_length(const io::OwnHistory& field) {
  for (const auto& [unit, power] : {std::pair("1", 0), std::pair("rad", 0), std::pair("Pa", 0), std::pair("m", 1),
                                    std::pair("N", 2), std::pair("m2", 2), std::pair("N m", 3), std::pair("J", 3)})
    if (field.unit == unit) return power;
  throw DataError(
      fmt::format("grains.scale: the contacts keep {} in {}, and how that scales with the size of the "
                  "grains is not known; leave grains.scale out",
                  field.name, field.unit));
}

void scale(io::Snapshot& volume, double factor) {
  if (factor == 1) return;
  volume.cell.matrix *= factor;
  for (Vec3& x : volume.grains.position) x *= factor;
  for (double& r : volume.grains.radius) r *= factor;
  for (double& m : volume.grains.mass) m *= factor * factor * factor;
  for (Vec3& v : volume.grains.velocity) v *= factor;
  io::ContactsRecord& c = volume.contacts;
  for (std::size_t k = 0; k < c.size(); ++k) {
    // Strains and stresses stay: forces scale with the square of lengths, moments with the cube.
    c.branch_vector[k] *= factor, c.overlap[k] *= factor;
    c.normal_force[k] *= factor * factor, c.shear_force[k] *= factor * factor;
    c.rolling_moment[k] *= factor * factor * factor, c.twisting_moment[k] *= factor * factor * factor;
  }
  for (io::OwnHistory& field : c.own)
    for (double& x : field.values) x *= std::pow(factor, power_of_length(field));
}

// Returns the number of geotextiles that yarns of the plan name.
std::size_t geotextiles_of(const Plan& plan) {
  std::int32_t last = plan.nodes.geotextile;
  for (const Plan::Sheet& s : plan.sheets) last = std::max(last, s.nodes.geotextile);
  return static_cast<std::size_t>(last) + 1;
}

// Adds a mistake for each given key that has no effect beside other keys of the plan.
void demand_used(Settings& document, const Plan& plan) {
  const auto refuse = [&](const char* table, const char* key, const char* why) {
    if (Settings found = document.table(table); found.has(key)) found.mistake(key, why);
  };
  if (plan.surround)
    refuse("grains", "scale", "is given beside [surround], which has a scale of its own: give surround.scale");
  if (plan.growth)
    refuse("numerics", "damping", "is given beside [growth], which has a damping of its own: give growth.damping");
  // A container that could not be read is a mistake already.
  if (plan.container || document.table("container").text("shape", "unknown") != "none") return;
  constexpr const char* no_soil = "is given beside container.shape = \"none\", which takes no soil: leave it out";
  refuse("container", "copies", no_soil);
  refuse("grains", "scale", no_soil);
  refuse("grains", "density", no_soil);
}

}  // namespace

Laid read_laid(Settings& table) {
  static constexpr Parameter offset{"offset", "m",   0,
                                    1e3,      false, "distance of the nodes beyond the container's surface"};
  Laid laid{NodeRecipe::read(table), 0};
  laid.outside = table.number(offset, laid.nodes.radius);
  if (laid.outside > laid.nodes.radius)
    table.mistake("offset", "is more than node_radius: the soil would fill more than the container");
  return laid;
}

Plan read_plan(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
  Settings document = Settings::parse(text, name);
  for (const std::string& assignment : overrides) document.set(assignment);
  return read_plan(document, {name, overrides});
}

std::vector<Key> plan_keys() {
  return keys_of([](Settings& document) { read_plan(document, {"-", {}}); });
}

Plan read_plan(Settings& document, const NamedFiles& files) {
  static constexpr Parameter size{"scale", "1", 0, 1e3, true, "factor on the representative volume's lengths"};
  Plan plan;
  if (document.has("surround")) {
    read_surround(document, files, plan);
  } else {
    read_container(document, files, plan);
    read_fabrics(document, plan);
  }
  Settings grains = document.table("grains");
  plan.scale = grains.number(size, 1.0);
  plan.density = dem::read_density(document);
  plan.model = dem::read_model(document);
  plan.numerics = dem::read_numerics(document);
  for (Settings table : document.tables("geotextile"))
    plan.model.geotextiles.push_back(
        dem::read_geotextile(table, fmt::format("geotextile.{}", plan.model.geotextiles.size()), files, plan.sources));
  if (document.has("growth")) {
    Settings table = document.table("growth");
    plan.growth = Growth::read(table);
    if (!plan.wrapping && !plan.surround)
      table.mistake("", "needs a geotextile to grow against: give [geotextile_mesh]");
  }
  if (plan.surround) demand_fill(document, plan);
  demand_used(document, plan);
  document.finish();
  for (BareNumber& stress : document.bare("Pa"))
    if (stress.key.starts_with("surround.")) plan.bare_stresses.push_back(std::move(stress));
  plan.resolved = document.resolved();
  // Yarns have no tension while grains grow, so that a plan need not describe them.
  if (!plan.surround && plan.model.geotextiles.empty())
    plan.model.geotextiles = resting_geotextiles(geotextiles_of(plan));
  return plan;
}

io::Snapshot assemble(const io::Snapshot& representative_volume, const Plan& plan,
                      const std::function<void(double)>& laid) {
  io::Snapshot state;
  demand_room_for_nodes(plan);
  if (plan.container) {
    io::Snapshot volume = representative_volume;
    scale(volume, plan.scale);
    const io::Snapshot block = tile(volume, copies_in(volume, plan));
    demand_cover(block, plan);
    state = in_spatial_order(filter(block, [&](std::size_t i) {
      const Vec3& x = block.grains.position[i];
      const double r = block.grains.radius[i];
      return plan.container->depth(x) >= r + plan.soil_depth() && clears_sheets(x, r, plan);
    }));
    if (state.grains.size() == 0) throw DataError(nothing_fits(block, plan));
    if (plan.density > 0)
      for (std::size_t i = 0; i < state.grains.size(); ++i)
        state.grains.mass[i] = plan.density * dem::grain_volume(3, state.grains.radius[i]);
  }
  state.cell = {};
  state.cell.periodic = {false, false, false};
  lay_fabrics(plan, laid, state);
  if (state.grains.size() == 0) throw DataError("the plan has neither container nor geotextile: nothing to make");
  // The aperiodic cell only records the extent of the bodies.
  for (int a = 0; a < 3; ++a) {
    double low = 0, high = 0;
    for (std::size_t i = 0; i < state.grains.size(); ++i) {
      const double x = state.grains.position[i][a], r = state.grains.radius[i];
      low = i ? std::min(low, x - r) : x - r, high = i ? std::max(high, x + r) : x + r;
    }
    state.cell.matrix(a, a) = high - low;
  }
  return state;
}

void aim(Growth& growth, const io::Snapshot& assembled, double void_ratio, const Container& container,
         double outermost) {
  double filled = 0;
  for (std::size_t i = 0; i < assembled.grains.size(); ++i)
    if (assembled.grains.copy_id[i] >= 0) filled += (1 + void_ratio) * dem::grain_volume(3, assembled.grains.radius[i]);
  // The volume falls with the depth: bisection to rounding.
  const Vec3 half = 0.5 * (container.high() - container.low()) - Vec3::Constant(outermost);
  double low = 0, high = half.minCoeff();
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (container.volume(outermost + middle) > filled ? low : high) = middle;
  }
  const Vec3 stretch = half.cwiseQuotient(half - Vec3::Constant(low));
  growth.filling = std::cbrt(stretch.prod());
  growth.stretch = stretch.array().pow(growth.stretch_share).matrix();
}

}  // namespace soilweave::packing
