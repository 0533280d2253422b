// Two-scale scenarios from TOML.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "analysis/doubts/loading_doubts.h"
#include "core/error.h"
#include "core/text/units.h"
#include "dem/run/scenario.h"
#include "fem/run/boundary_conditions.h"
#include "fem/run/chain_check.h"
#include "fem/run/scenario_mesh.h"

namespace soilweave::fem {
namespace {

/// Notes a mistake if the initial stress of a Mohr-Coulomb soil lies outside of its failure surface.
void check_initial_stress(Settings& soil, const ContinuumLaw& law) {
  if (!(*law.friction_angle > 0)) return;  // a mistake already
  const Vec3 pressure = -law.initial_stress;
  const double least = pressure.minCoeff(), greatest = pressure.maxCoeff(), sine = std::sin(*law.friction_angle);
  const double ratio = (1 + sine) / (1 - sine), tension = law.cohesion / std::tan(*law.friction_angle);
  const double borne = ratio * least + 2 * law.cohesion * std::sqrt(ratio);
  const double slack = 1e-6 * pressure.cwiseAbs().maxCoeff();  // of stresses on the surface, given in few digits
  const std::string strength = fmt::format("a friction angle of {:.4g} deg and a cohesion of {:.4g} kPa",
                                           *law.friction_angle / degree, law.cohesion / 1e3);
  if (least < -tension - slack)
    soil.mistake("initial_stress", fmt::format("has a tension of {:.4g} kPa, and {} bear {:.4g} kPa; compression is "
                                               "positive: give stresses that the soil bears, or more cohesion",
                                               -least / 1e3, strength, tension / 1e3));
  else if (greatest > borne + slack)
    soil.mistake(
        "initial_stress",
        fmt::format("has {:.4g} kPa beside {:.4g} kPa, outside of the failure surface: {} bear {:.4g} kPa there; "
                    "give stresses closer to each other, or a stronger soil",
                    greatest / 1e3, least / 1e3, strength, borne / 1e3));
}

ContinuumLaw read_law(Settings& soil, bool limited) {
  static constexpr Parameter young{"young_modulus", "Pa", 0, 1e13, true, "Young's modulus of the soil"};
  static constexpr Parameter poisson{"poisson_ratio",
                                     "1",
                                     -1,
                                     0.499,
                                     true,
                                     "Poisson's ratio of the soil",
                                     "an incompressible soil has no stable time step"};
  static constexpr Parameter stress{
      "initial_stress", "Pa", -1e9, 1e9, false, "stress xx, yy and zz at the start, compression positive"};
  static constexpr Parameter friction{"friction_angle", "deg", 0, 89, true, "friction angle of the soil"};
  static constexpr Parameter cohesion{"cohesion", "Pa", 0, 1e9, false, "cohesion of the soil"};
  static constexpr Parameter dilation{"dilation_angle", "deg", 0, 89, false, "dilation angle of the soil"};
  ContinuumLaw law;
  law.young_modulus = soil.number(young);
  law.poisson_ratio = soil.number(poisson);
  law.initial_stress = -soil.vector(stress, Vec3::Zero());
  if (!limited) return law;
  law.friction_angle = soil.number(friction) * degree;
  law.cohesion = soil.number(cohesion, 0);
  law.dilation_angle = soil.number(dilation, 0) * degree;
  if (law.dilation_angle > *law.friction_angle)
    soil.mistake("dilation_angle", "is above friction_angle: the soil would create energy");
  check_initial_stress(soil, law);
  return law;
}

// Reads the numerics of grains within a material point, which may also replace a continuum later.
dem::Numerics read_grain_numerics(Settings& document) {
  const dem::Numerics numerics = dem::read_numerics(document);
  if (numerics.gravity != Vec3::Zero())
    document.table("numerics")
        .mistake("gravity", "has nowhere to act: a material point is a periodic cell without weight; leave it out");
  return numerics;
}

void read_soil(Settings& document, ModelSetup& m) {
  static constexpr Parameter density{"density", "kg/m3", 0,
                                     1e9,       true,    "mass of the soil over its volume, pores included"};
  static constexpr Parameter damping{"damping", "1/s", 0, 1e6, false, "viscous coefficient c of thesis Eq. 6.2"};
  Settings soil = document.table("soil");
  const std::string material =
      soil.kind({"material", "material at the integration points"}, {"grains", "elastic", "mohr-coulomb"});
  m.soil.damping = soil.number(damping, 0.2);
  if (material == "grains") {
    m.soil.density = soil.has("density") ? soil.number(density) : 0;
    m.grains = {dem::read_model(document), read_grain_numerics(document), dem::read_density(document)};
    return;
  }
  m.soil.density = soil.number(density);
  m.law = read_law(soil, material == "mohr-coulomb");
  // Users set up a problem with a continuum and switch to grains later, so tables of grains may exist already.
  if (document.has("contact")) dem::read_model(document);
  if (document.has("grains")) dem::read_density(document);
  if (document.has("numerics") || document.has("guards")) read_grain_numerics(document);
}

ChainEnd read_end(Settings table) {
  static constexpr Parameter x{"x", "m/s", -1e3, 1e3, false, "velocity that drives this end along x"},
      y{"y", "m/s", -1e3, 1e3, false, "velocity that drives this end along y"};
  ChainEnd end;
  if (table.has("x")) end.x = table.number(x);
  if (table.has("y")) end.y = table.number(y);
  return end;
}

Vec2 read_place(Settings& table, const Parameter& parameter) {
  const std::vector<double> place = table.numbers(parameter);
  if (place.size() == 2) return {place[0], place[1]};
  table.mistake(parameter.name, "has not two numbers: x, y");
  return Vec2::Zero();
}

void read_touch(Settings table, Touch& touch) {
  static constexpr Parameter normal{
      "normal_stiffness", "N/m3", 0, 1e15, true, "normal stiffness of the contact, per area"};
  static constexpr Parameter ratio{"shear_ratio", "1", 0, 10, false, "shear stiffness over normal stiffness"};
  static constexpr Parameter friction{
      "friction_angle", "deg", 0, 89.9, false, "friction angle between soil and geosynthetic"};
  touch = {table.number(normal), table.number(ratio, 0.33), table.number(friction) * degree};
}

std::vector<std::string> read_along(Settings& table) {
  std::vector<std::string> names;
  const std::string all = table.text({"along", "boundaries that the chain follows, separated by blanks"});
  for (std::size_t at = 0; at < all.size();) {
    const std::size_t end = std::min(all.find(' ', at), all.size());
    if (end > at) names.push_back(all.substr(at, end - at));
    at = end + 1;
  }
  return names;
}

void read_guides(Settings& table, std::vector<Guide>& guides) {
  static constexpr Parameter from{"from", "m", -1e6, 1e6, false, "x, y of the guide's start"},
      to{"to", "m", -1e6, 1e6, false, "x, y of the guide's end"};
  for (Settings guide : table.tables("guide"))
    guides.push_back({read_place(guide, from), read_place(guide, to),
                      guide.flag({"holds_soil", "whether the guide holds the soil too"}, false)});
}

void read_geosynthetic(Settings& document, ModelSetup& m) {
  static constexpr Parameter radius{"radius", "m", 0, 10, true, "radius of the virtual disks"};
  static constexpr Parameter spacing{"spacing", "m", 0, 1e3, true, "largest length of a bar"};
  static constexpr Parameter overhang{"overhang", "m", 0, 1e3, false, "length of the chain before its start"};
  static constexpr Parameter stiffness{"stiffness", "N/m", 0, 1e12, true, "axial stiffness J"};
  static constexpr Parameter strength{"strength", "N/m", 0, 1e12, true, "tension at which a bar breaks"};
  static constexpr Parameter density{"areal_density", "kg/m2", 0, 1e6, true, "mass of the geosynthetic per area"};
  static constexpr Parameter damping{"damping", "1", 0, 0.999, false, "local non-viscous damping of the chain"};
  static constexpr Parameter safety{"time_step_safety", "1", 0, 0.95, true, "fraction of the chain's stable time step"};
  static constexpr Parameter seat{
      "seat_pressure", "Pa", 0, 1e9, false, "pressure along y that chain and guides carry before the start"};
  if (!document.has("geosynthetic")) return;
  Settings table = document.table("geosynthetic");
  BarsSetup b;
  m.along = read_along(table);
  b.radius = table.number(radius);
  m.spacing = table.number(spacing, 2 * b.radius);
  m.overhang = table.number(overhang, 0);
  b.stiffness = table.number(stiffness);
  if (table.has("strength")) b.strength = table.number(strength);
  b.compression = table.flag({"compression", "whether bars carry compression"}, true);
  b.areal_density = table.number(density);
  b.damping = table.number(damping, 0.4);
  b.safety = table.number(safety, b.safety);
  b.stop_when_broken =
      table.choice({"broken", "whether a run stops at its first broken bar"}, {"stop", "go on"}, "stop") == "stop";
  m.seat_pressure = table.number(seat, 0);
  read_touch(table.table("contact"), b.touch);
  b.start = read_end(table.table("start"));
  b.end = read_end(table.table("end"));
  read_guides(table, b.guides);
  for (const std::string& name : m.along) {
    try {
      m.soil.mesh.boundary_with_edges(name);
    } catch (const DataError& error) {
      table.mistake("along", error.what());
    }
  }
  check_chain(table, m, b.radius);
  m.bars = std::move(b);
}

void read_time(Settings& document, Scenario& s) {
  static constexpr Parameter duration{"duration", "s", 0, 1e9, true, "duration of the run"};
  static constexpr Parameter interval{"output_interval", "s", 0, 1e9, true, "time between recorded states"};
  static constexpr Parameter safety{"safety",
                                    "1",
                                    0,
                                    0.9,
                                    true,
                                    "fraction of the soil's stable time step",
                                    "beyond it a soil that stiffens a little would be unstable"};
  static constexpr Parameter step{"step", "s", 0, 1e3, true, "fixed time step of the soil"};
  Settings table = document.table("time");
  s.duration = table.number(duration);
  s.model.interval = table.number(interval);
  constexpr double most = 1e6;
  if (table.sound("duration") && table.sound("output_interval") && s.duration > most * s.model.interval)
    table.mistake("output_interval",
                  fmt::format("makes {:.3g} outputs, and at most {:.0f} are recorded: give at least {:.3g} s",
                              s.duration / s.model.interval, most, s.duration / most));
  // A shorter run than its interval has one output, at its end.
  s.model.interval = std::min(s.model.interval, s.duration);
  s.model.safety = table.number(safety, s.model.safety);
  if (!table.has("step")) return;
  s.model.time_step = table.number(step);
  if (table.has("safety"))
    table.mistake("safety", "has no effect beside step, which is the time step itself: leave one of the two out");
}

std::optional<QuasiStatic> read_quasi_static(Settings& document) {
  static constexpr Parameter soil{"soil_damping", "1/s", 0, 1e6, true, "viscous coefficient of the soil at rest"};
  static constexpr Parameter grains{"grain_damping", "1", 0, 0.999, false, "local damping of grains and chain at rest"};
  static constexpr Parameter energy{
      "kinetic_energy", "J/m", 0, 1e9, true, "largest kinetic energy of soil that counts as at rest"};
  static constexpr Parameter steps{"steps", "1", 1, 1e9, false, "steps after which rest counts as unreachable"};
  if (!document.has("quasi_static")) return std::nullopt;
  Settings table = document.table("quasi_static");
  QuasiStatic q;
  const double local = table.number(grains, 0.9);
  q.damping = {table.number(soil, 100), local, local};
  q.kinetic_energy = table.number(energy, 1e-3);
  q.largest_rest = table.integer(steps, 100000);
  return q;
}

/// Returns the friction angles of the soil, its grains and its contact with the geosynthetic, rad.
std::vector<double> friction_angles(const ModelSetup& m) {
  std::vector<double> angles;
  if (m.law && m.law->friction_angle) angles.push_back(*m.law->friction_angle);
  for (std::size_t k = 0; !m.law && k < m.grains.model.materials.size(); ++k)
    angles.push_back(m.grains.model.materials.at(k).friction_angle);
  if (m.bars) angles.push_back(m.bars->touch.friction_angle);
  return angles;
}

// Returns doubts about numbers without a unit that no soil or geosynthetic has, as those in another unit.
std::vector<Doubt> unit_doubts(const ModelSetup& m, const Settings& document) {
  // The lightest peat has 200 kg/m3 and 0.1 MPa. Nonwovens have 0.1 kg/m2 and 10 kN/m, strips of steel 40 kg/m2.
  constexpr double lightest = 200, softest = 1e5, heaviest = 100, slackest = 1e3;
  std::vector<Doubt> doubts;
  const auto doubt = [&](bool odd, std::string_view key, double value, std::string_view unit, std::string_view others) {
    const std::vector<BareNumber> bare = document.bare(unit);
    if (odd && std::ranges::any_of(bare, [&](const BareNumber& number) { return number.key == key; }))
      doubts.push_back({fmt::format("unit-{}", key.substr(key.find('.') + 1)),
                        fmt::format("{} is {:.4g} {}, as no {} has: if it is in {}, convert it, else write its unit",
                                    key, value, unit, key.substr(0, key.find('.')), others)});
  };
  doubt(m.soil.density > 0 && m.soil.density < lightest, "soil.density", m.soil.density, "kg/m3", "g/cm3 or kN/m3");
  if (m.law) doubt(m.law->young_modulus < softest, "soil.young_modulus", m.law->young_modulus, "Pa", "kPa or MPa");
  if (!m.bars) return doubts;
  doubt(m.bars->areal_density > heaviest, "geosynthetic.areal_density", m.bars->areal_density, "kg/m2", "g/m2");
  doubt(m.bars->stiffness < slackest, "geosynthetic.stiffness", m.bars->stiffness, "N/m", "kN/m");
  doubt(m.bars->strength < slackest, "geosynthetic.strength", m.bars->strength, "N/m", "kN/m");
  return doubts;
}

}  // namespace

Scenario read_scenario(std::string_view text, const std::string& name, const std::vector<std::string>& overrides,
                       std::optional<Mesh> mesh) {
  Settings document = Settings::parse(text, name);
  for (const std::string& assignment : overrides) document.set(assignment);
  return read_scenario(document, std::move(mesh));
}

std::vector<Key> scenario_keys() {
  return keys_of([](Settings& document) {
    read_scenario(document, std::nullopt);
    read_scenario(document, rectangle(1, 1, 1, 1, Shape::quadrilateral8));
  });
}

Scenario read_scenario(Settings& document, std::optional<Mesh> mesh) {
  static constexpr Parameter points{"points", "1", 0, 1e9, false, "points whose grains are recorded whole"};
  Scenario s;
  Settings table = document.table("mesh");
  s.model.soil.mesh = read_mesh(table, std::move(mesh));
  s.model.soil.integration = read_integration(table, s.model.soil.mesh.shape);
  read_soil(document, s.model);
  read_boundary_conditions(document, s.model.soil);
  read_geosynthetic(document, s.model);
  read_time(document, s);
  s.quasi_static = read_quasi_static(document);
  Settings record = document.table("record");
  for (const double p : record.numbers(points, std::vector<double>{})) {
    if (p != std::floor(p)) record.mistake("points", fmt::format("{} is no number of a point", p));
    s.recorded.push_back(static_cast<Index>(p));
  }
  if (s.model.law && !s.recorded.empty())
    record.mistake("points",
                   "names points whose grains are recorded, but this soil is a continuum: leave it out, or give "
                   "soil.material = \"grains\"");
  document.finish();
  s.doubts = s.model.soil.mesh.doubts;
  for (Doubt& doubt : loading_doubts(s.model)) s.doubts.push_back(std::move(doubt));
  for (Doubt& doubt : analysis::radian_doubts(friction_angles(s.model))) s.doubts.push_back(std::move(doubt));
  for (Doubt& doubt : unit_doubts(s.model, document)) s.doubts.push_back(std::move(doubt));
  s.bare_stresses = document.bare("Pa");
  std::erase_if(s.bare_stresses, [](const BareNumber& number) {
    return !number.key.starts_with("traction.") && number.key != "soil.initial_stress" &&
           number.key != "soil.cohesion" && number.key != "geosynthetic.seat_pressure";
  });
  s.resolved = document.resolved();
  return s;
}

}  // namespace soilweave::fem
