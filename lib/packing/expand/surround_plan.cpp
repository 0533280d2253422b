// Reads a plan's [surround].
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <numbers>

#include "files/files.h"
#include "packing/expand/surround.h"

namespace soilweave::packing {
namespace {

void read_volume(Settings& table, const NamedFiles& files, std::vector<io::Source>& sources, Surround& to) {
  static constexpr Parameter copies{"copies", "1", 1, 1e4, false, "copies of the representative volume, by axis"};
  static constexpr Parameter scale{"scale", "1", 0, 1e6, true, "factor on the lengths of the representative volume"};
  const std::string word = table.text({"representative_volume", "packing that the fill is cut from"});
  if (!word.empty()) {
    const io::PackingFile file =
        io::read_state(files.path("surround.representative_volume", word), "representative volume");
    to.volume = file.state;
    sources.push_back(file.source);
    if (to.volume.grains.dimension != 3) table.mistake("representative_volume", "is of disks: give one of spheres");
  }
  to.scale = table.number(scale, to.scale);
  if (!table.has("copies")) return;
  const Vec3 n = table.vector(copies);
  for (int a = 0; a < 3; ++a)
    if (n[a] != std::round(n[a])) table.mistake("copies", "has a part that is no whole number");
  to.copies = {static_cast<int>(n[0]), static_cast<int>(n[1]), static_cast<int>(n[2])};
}

void read_compaction(Settings& table, Surround& to) {
  static constexpr Parameter pressure{"pressure", "Pa", 0, 1e12, true, "isotropic pressure on the cell"};
  static constexpr Parameter target{"void_ratio", "1", 0, 100, true, "void ratio of the cell, nodes counted as solids"};
  static constexpr Parameter lowering{
      "friction_factor", "1", 0, 0.999, true, "factor on the fill's friction angle each time it is lowered"};
  static constexpr Parameter unbalanced{
      "unbalanced_force", "1", 0, 1, true, "largest unbalanced force of the last equilibrium"};
  static constexpr Parameter rate{"max_rate", "1/s", 0, 1e3, true, "largest strain rate of the cell"};
  static constexpr Parameter first{
      "first_friction_angle", "deg", 0, 89.9, true, "friction angle of the fill at the start of compaction"};
  static constexpr Parameter height{"height_tolerance", "1", 0, 1, true, "change of the reinforced part's height"};
  static constexpr Parameter stress{
      "stress_tolerance", "1", 0, 1, true, "deviation of the fill's stress from the pressure, relative"};
  static constexpr Parameter steps{"steps", "1",   1,
                                   1e12,    false, "steps after which an equilibrium counts as unreachable"};
  Recipe& r = to.recipe;
  r.pressure = table.number(pressure);
  if (table.has("void_ratio")) r.void_ratio = table.number(target);
  r.friction_factor = table.number(lowering, r.friction_factor);
  r.tolerances.unbalanced_force = table.number(unbalanced, r.tolerances.unbalanced_force);
  if (table.has("max_rate")) to.max_rate = r.max_rate = table.number(rate);
  r.first_friction = table.number(first, 0.5) * std::numbers::pi / 180;
  to.height_tolerance = table.number(height, to.height_tolerance);
  to.stress_tolerance = table.number(stress, to.stress_tolerance);
  to.missed_is_error =
      table.choice({"missed", "consequence of a missed criterion"}, {"error", "doubt"}, "error") == "error";
  r.largest_stage = table.integer(steps, r.largest_stage);
  r.remedies = {"surround.max_rate", "surround.unbalanced_force", "in the plan", "grains.density"};
}

}  // namespace

Surround Surround::read(Settings& table, const NamedFiles& files, std::vector<io::Source>& sources) {
  static constexpr Parameter rings{"rings", "1", 0, 1e4, false, "copies along each edge whose soil is left out"};
  static constexpr Parameter material{"material", "1", 0, 1e3, false, "material_id of the fill"};
  static constexpr Parameter gap{"gap", "m", 0, 1e3, true, "least distance between the reinforced part and its image"};
  Surround s;
  const std::string form =
      table.choice({"form", "whether fill lies all around the reinforced part, or above and below it"},
                   {"wrapped", "layered"}, "wrapped");
  s.form = form == "layered" ? Form::layered : Form::wrapped;
  read_volume(table, files, sources, s);
  if (s.form == Form::layered) s.rings = table.number(rings, s.rings);
  s.material = static_cast<std::int32_t>(table.integer(material, s.material));
  if (table.has("gap")) s.gap = table.number(gap);
  read_compaction(table, s);
  s.recipe.materials = {s.material};
  return s;
}

}  // namespace soilweave::packing
