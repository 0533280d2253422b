// Scenarios from TOML.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/text/units.h"
#include "dem/contact/laws.h"
#include "dem/loading/plates.h"
#include "dem/run/geotextile.h"

namespace soilweave::dem {
namespace {

constexpr Parameter density_parameter{"density",
                                      "kg/m3",
                                      0,
                                      1e12,
                                      true,
                                      "density of the grains, scaling included",
                                      "grains without mass cannot be moved"};

Tolerances read_tolerances(Settings& document, std::int64_t& largest_station) {
  static constexpr Parameter unbalanced{
      "unbalanced_force", "1", 0, 1, true, "mean resultant on grains over mean contact force, at every recorded state"};
  static constexpr Parameter stress{
      "stress_tolerance", "1", 0, 1, true, "relative deviation of stresses from their goals"};
  static constexpr Parameter steps{"steps", "1", 1, 1e12, false, "steps after which a station counts as unreachable"};
  Settings table = document.table("equilibrium");
  largest_station = table.integer(steps, 2'000'000);
  static constexpr Parameter kinetic{"kinetic_energy", "J", 0, 1e300, true, "limit at every recorded state"};
  const double force = table.number(unbalanced, 1e-3);
  Tolerances tolerances{table.number(stress, 1e-3), force};
  if (table.has("kinetic_energy")) tolerances.kinetic_energy = table.number(kinetic);
  return tolerances;
}

ServoRule read_servo(Settings& document) {
  static constexpr Parameter damping{
      "damping", "1", 0, 0.999, false, "damping of the cell's strain rate", "at 1 the cell would not move"};
  Settings table = document.table("servo");
  const std::string kind = table.choice({"kind", "property of the packing that the servo's gains follow"},
                                        {"stiffness", "inertia"}, "stiffness");
  ServoRule rule;
  if (kind == "stiffness") return rule;
  rule.kind = ServoRule::Kind::inertia, rule.damping = table.number(damping, rule.damping);
  return rule;
}

SnapshotRule read_snapshots(Settings& document) {
  static constexpr Parameter strains{"strains", "1", -2, 2, false, "axial strains whose stations get a snapshot"};
  Settings table = document.table("record");
  SnapshotRule rule;
  const std::string which =
      table.choice({"snapshots", "which recorded states get a snapshot"}, {"ends", "stations", "list"}, "ends");
  if (which == "stations") rule.which = SnapshotRule::Which::stations;
  if (which == "list") {
    rule.which = SnapshotRule::Which::list;
    rule.strains = table.numbers(strains);
    if (rule.strains.empty()) table.mistake("strains", "is an empty list; give strains, or snapshots = \"ends\"");
  }
  return rule;
}

// Returns the name of a plate or clamp, by which paths call it.
std::string part_name(Settings& table, std::string_view sentence, const std::vector<PartSetting>& parts) {
  std::string name = table.text({"name", sentence});
  if (table.has("name") && name.empty()) table.mistake("name", "is empty: give one, for paths");
  if (std::any_of(parts.begin(), parts.end(), [&](const PartSetting& p) { return p.part.name == name; }))
    table.mistake("name",
                  fmt::format("\"{}\" is another plane's or clamp's already: give each a name of its own", name));
  return name;
}

constexpr Parameter part_mass{"mass", "kg", 0, 1e15, false, "mass of a plate or clamp; 0: carried by its contacts"};

void read_clamps(Settings& document, std::vector<PartSetting>& parts) {
  static constexpr Parameter low{"low", "m", -1e6, 1e6, false, "lower corner of the box whose nodes are held"};
  static constexpr Parameter high{"high", "m", -1e6, 1e6, false, "upper corner"};
  std::size_t number = 0;
  for (Settings table : document.tables("clamp")) {
    PartSetting p{
        {part_name(table, "name of the clamp, for paths", parts), true, number++, table.number(part_mass, 1.0)}};
    if (p.part.mass == 0) table.mistake("mass", "is zero: a clamp has no contacts that could carry it");
    p.low = table.vector(low), p.high = table.vector(high);
    parts.push_back(p);
  }
}

Stage read_stage(Settings table, const std::vector<PartSetting>& parts) {
  static constexpr Parameter friction{
      "friction_angle", "deg", 0, 89.9, false, "friction angle of all materials from this stage on"};
  static constexpr Parameter damping{"damping", "1", 0, 0.999, false, "local non-viscous damping during this stage"};
  static constexpr Parameter rest{"rest_damping", "1",   0,
                                  0.999,          false, "local non-viscous damping while a station waits for rest"};
  static constexpr Parameter drag{
      "rest_drag", "1/s", 0, 1e9, false, "drag coefficient over mass, for all motion while a station waits for rest"};
  static constexpr Parameter on_the_way{
      "way_unbalanced_force", "1", 0, 1, false, "limit of the unbalanced force, which slows the loading; 0: no limit"};
  Stage stage;
  const std::string path = table.kind({"path", "loading path of the stage"}, path_names());
  stage.name = table.text({"name", "name of the stage, for messages and the series"}, path);
  stage.reset_strain =
      table.flag({"reset_strain", "whether the state at its start becomes the reference of the strains"}, false);
  if (table.has("friction_angle")) stage.friction = table.number(friction) * degree;
  static constexpr Parameter plates{"plate_friction_angle",
                                    "deg",
                                    0,
                                    89.9,
                                    false,
                                    "friction angle between the planes and all that touches them, from this stage on"};
  if (table.has("plate_friction_angle")) stage.plate_friction = table.number(plates) * degree;
  if (table.has("damping")) stage.damping = table.number(damping);
  if (table.has("rest_damping")) stage.rest_damping = table.number(rest);
  stage.way_unbalanced_force = table.number(on_the_way, 0);
  if (table.has("rest_drag")) {
    const std::optional<double> number = table.number_or(drag, "critical");
    stage.rest_drag = number.value_or(0), stage.critical_drag = !number;
  }
  stage.homogeneous_start =
      table.flag({"homogeneous_start", "whether loading begins and ends with a homogeneous velocity field"}, false);
  stage.path = read_path(path, table);
  if (stage.path && stage.path->stations() == 0)
    table.mistake("", "has no stations: its list is empty; name one at least, or leave the stage out");
  if (stage.path && stage.path->stations() > 0) {
    if (const std::string why = contradiction(stage.path->drives(0)); !why.empty()) table.mistake("", why);
    for (const DriveGoal& goal : stage.path->drives(0))
      if (std::none_of(parts.begin(), parts.end(), [&](const PartSetting& p) { return p.part.name == goal.part; }))
        table.mistake("", "moves \"" + goal.part + "\", but no [[plane]] or [[clamp]] is called so");
  }
  return stage;
}

io::PlanesRecord read_planes(Settings& document, std::size_t materials, std::vector<PartSetting>& parts,
                             std::vector<std::size_t>& touching) {
  static constexpr Parameter point{"point", "m", -1e6, 1e6, false, "a point of the plane"};
  static constexpr Parameter normal{"normal", "1", -1, 1, false, "normal towards the grains"};
  static constexpr Parameter velocity{"velocity", "m/s", -1e6, 1e6, false, "constant velocity of the plane"};
  static constexpr Parameter material{"material", "1",   0,
                                      1e3,        false, "0: [contact], 1 and on: the [[material]] tables"};
  io::PlanesRecord planes;
  for (Settings table : document.tables("plane")) {
    const std::optional<Vec3> at = table.vector_or(point, "touch");
    if (!at) touching.push_back(planes.point.size());
    planes.point.push_back(at.value_or(Vec3::Zero()));
    planes.normal.push_back(table.vector(normal));
    if (planes.normal.back().norm() == 0) table.mistake("normal", "is zero: give the direction towards the grains");
    planes.velocity.push_back(table.vector(velocity, Vec3::Zero()));
    planes.material_id.push_back(static_cast<std::int32_t>(table.integer(material, 0)));
    if (planes.material_id.back() >= static_cast<std::int32_t>(materials))
      table.mistake("material", "names no material: 0 is [contact], 1 the first [[material]]");
    const std::string partners =
        table.choice({"partners", "which bodies touch the plane"}, {"all", "soil", "geotextile"}, "all");
    planes.partners.push_back(partners == "all" ? 0 : (partners == "soil" ? 1 : 2));
    if (!table.has("name")) continue;
    parts.push_back({{part_name(table, "name of the plane, for paths", parts), false, planes.point.size() - 1,
                      table.number(part_mass, 0.0)}});
    if (planes.velocity.back() != Vec3::Zero())
      table.mistake("velocity",
                    "is given beside a name, and stages alone move planes with a name: leave one of the two "
                    "out, or give a [[stage.move]]");
  }
  return planes;
}

// Returns whether the list names the material; an empty list names all.
bool is_among(const std::vector<std::int32_t>& materials, std::size_t material) {
  return materials.empty() ||
         std::find(materials.begin(), materials.end(), static_cast<std::int32_t>(material)) != materials.end();
}

}  // namespace

std::vector<RigPart> parts_of(const Scenario& scenario) {
  std::vector<RigPart> parts;
  for (const PartSetting& p : scenario.parts) parts.push_back(p.part);
  return parts;
}

Model read_model(Settings& document) {
  Settings contact = document.table("contact");
  const std::string law = contact.kind({"law", "contact law"}, law_names());
  std::vector<Settings> tables = {contact};
  for (const Settings& table : document.tables("material")) tables.push_back(table);
  return {read_materials(law, tables)};
}

double read_density(Settings& document) {
  Settings grains = document.table("grains");
  return grains.has("density") ? grains.number(density_parameter) : 0.0;
}

Limits read_limits(Settings& document) {
  static constexpr Parameter overlap{
      "overlap", "1", 0, 2, true, "overlap of two grains over the smaller radius, above which a run stops"};
  static constexpr Parameter energy{
      "energy_error", "1",  0,
      1e300,          true, "error of the energy balance over all energy converted, above which a run stops"};
  static constexpr Parameter escape{
      "escape", "1",  0,
      1e300,    true, "distance that grains may go beyond an open side, over the initial extent of grains and planes"};
  Settings table = document.table("guards");
  Limits limits;
  limits.overlap = table.number(overlap, limits.overlap);
  limits.energy_error = table.number(energy, limits.energy_error);
  limits.escape = table.number(escape, limits.escape);
  return limits;
}

Numerics read_numerics(Settings& document) {
  static constexpr Parameter damping{
      "damping", "1", 0, 0.999, false, "Cundall's local non-viscous damping", "at 1 nothing would move"};
  static constexpr Parameter safety{
      "time_step_safety", "1", 0, 1, true, "fraction of the stable time step", "beyond 1 the integration is unstable"};
  static constexpr Parameter step{"time_step", "s", 0, 1e6, true, "fixed time step instead of the stiffness-based one"};
  static constexpr Parameter gravity{"gravity", "m/s2", -1e4, 1e4, false, "acceleration of gravity"};
  Settings table = document.table("numerics");
  Numerics n;
  n.damping = table.number(damping, n.damping);
  n.time_step_safety = table.number(safety, n.time_step_safety);
  if (table.has("time_step")) n.time_step = table.number(step);
  n.gravity = table.vector(gravity, n.gravity);
  n.limits = read_limits(document);
  return n;
}

Scenario read_scenario(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
  Settings document = Settings::parse(text, name);
  for (const std::string& assignment : overrides) document.set(assignment);
  return read_scenario(document, {name, overrides});
}

std::vector<Key> scenario_keys() {
  return keys_of([](Settings& document) { read_scenario(document, {"-", {}}); });
}

Scenario read_scenario(Settings& document, const NamedFiles& files) {
  Scenario s;
  s.model = read_model(document);
  s.grain_density = read_density(document);
  s.density.emplace_back();
  s.equal_steps = document.table("grains").choice({"mass_scaling", "masses of the equations of motion"},
                                                  {"none", "equal-step"}, "none") == "equal-step";
  for (Settings table : document.tables("material"))
    s.density.push_back(table.has("density") ? std::optional(table.number(density_parameter)) : std::nullopt);
  for (Settings table : document.tables("geotextile")) {
    const std::string key = fmt::format("geotextile.{}", s.model.geotextiles.size());
    s.model.geotextiles.push_back(read_geotextile(table, key, files, s.sources));
  }
  s.numerics = read_numerics(document);
  s.tolerances = read_tolerances(document, s.largest_station);
  s.servo = read_servo(document);
  s.servo.share_of_frequency = std::min(1.0, s.numerics.time_step_safety / Numerics().time_step_safety);
  s.snapshots = read_snapshots(document);
  s.planes = read_planes(document, s.model.materials.size(), s.parts, s.touching);
  read_clamps(document, s.parts);
  for (const Settings& table : document.tables("stage")) s.stages.push_back(read_stage(table, s.parts));
  if (s.stages.empty() && !document.has("stage"))
    document.mistake("stage", "is missing: a scenario has at least one [[stage]] with a path");
  document.finish();
  for (BareNumber& stress : document.bare("Pa"))
    if (stress.key.starts_with("stage.")) s.bare_stresses.push_back(std::move(stress));
  s.resolved = document.resolved();
  return s;
}

bool is_at(const std::vector<double>& strains, double strain) {
  return std::any_of(strains.begin(), strains.end(),
                     [&](double s) { return std::abs(s - strain) < station_tolerance; });
}

Model with_friction(const Model& model, double angle, const std::vector<std::int32_t>& materials) {
  Model changed = model;
  for (std::size_t k = 0; k < changed.materials.size(); ++k) {
    if (!is_among(materials, k)) continue;
    CommonMaterial m = changed.materials.at(k);
    m.friction_angle = angle;
    changed.materials.set(k, m);
  }
  return changed;
}

Model with_friction_against(const Model& model, double angle, const std::vector<std::int32_t>& materials) {
  Model changed = model;
  for (const std::int32_t material : materials) {
    const auto k = static_cast<std::size_t>(material);
    CommonMaterial m = changed.materials.at(k);
    m.friction_angle = angle, m.friction_decides = true;
    changed.materials.set(k, m);
  }
  return changed;
}

Model with_friction_times(double factor, const Model& model) {
  Model changed = model;
  for (std::size_t k = 0; k < changed.materials.size(); ++k) {
    CommonMaterial m = changed.materials.at(k);
    m.friction_angle *= factor;
    changed.materials.set(k, m);
  }
  return changed;
}

double friction(const Model& model, const std::vector<std::int32_t>& materials) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < model.materials.size(); ++k)
    if (is_among(materials, k)) least = std::min(least, model.materials.at(k).friction_angle);
  return least;
}

}  // namespace soilweave::dem
