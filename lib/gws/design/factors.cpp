// Factors that a design office brings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/design/factors.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/error.h"
#include "gws/design/beside_grains.h"
#include "gws/solution/matsuoka_liu.h"
#include "gws/solution/path.h"

namespace soilweave::gws {
namespace {

constexpr Parameter factor_range(const char* name, const char* sentence) {
  return {name, "1", 1, 100, false, sentence, "a factor below 1 would take away safety"};
}
constexpr Parameter creep_range = factor_range("rf_creep", "divides the strength: creep"),
                    installation_range = factor_range("rf_installation", "divides the strength: installation"),
                    durability_range = factor_range("rf_durability", "divides the strength: durability"),
                    load_range = factor_range("factor_load", "multiplies the surcharge, against failure"),
                    soil_range = factor_range("factor_soil", "divides tan phi, against failure");

/// Returns why the soil's path ends below a hundred times its first mean stress; none: it goes on. The stiffness of the
/// geotextile, here 1 MN/m, hardly matters at such stresses.
End early_end(const Soil& soil) {
  Path path(soil, soil.young_modulus(1e6), tolerance_range.high);
  while (path.last() < std::log(100 * soil.p_0) && path.advance()) {
  }
  return path.end();
}

}  // namespace

void Factors::declare(tool::Table& t) {
  t.option(creep, creep_range);
  t.option(installation, installation_range);
  t.option(durability, durability_range);
  t.option(load, load_range);
  t.option(soil, soil_range);
}

std::optional<Soil> Factors::weakened(const Soil& given) const {
  if (soil == 1) return std::nullopt;
  Soil weak = given;
  const double sine = std::sin(std::atan(std::tan(friction_angle(given.M)) / soil));
  weak.M = 6 * sine / (3 - sine);
  const double ratio = weak.M / given.M;
  weak.kappa *= ratio;
  weak.xi *= ratio;
  if (const End end = early_end(weak); end != End::none && early_end(given) == End::none)
    throw DataError(fmt::format(
        "--factor-soil: {:.4g} lowers M from {:.4g} to {:.4g}, which leaves the soil no state at low stress "
        "({}); give a smaller factor",
        soil, given.M, weak.M, reason(end)));
  return weak;
}

std::string conditions(const Case& bag, const Factors& factors, bool chosen) {
  const Soil weak = factors.weakened(bag.soil).value_or(bag.soil);
  std::string text = fmt::format("Failure is counted at {:.4g} of the strength", bag.strength_fraction);
  text += chosen ? ".\n"
                 : ", the default: in the thesis's discrete elements the mean tension was half of\n"
                   "the strength when the bag failed, for spheres of 5 mm stand for a fabric of 0.4 mm (section 5.4); "
                   "--strength-fraction 1 takes all.\n";
  if (factors.soil == 1) text += beside_grains(bag);
  if (factors.reduction() != 1)
    text += fmt::format(
        "Long-term strength: {:.4g} kN/m over creep {:.4g}, installation {:.4g}, durability {:.4g} leaves {:.4g} kN/m; "
        "the stiffness is as given.\n",
        bag.geotextile.strength / 1e3, factors.creep, factors.installation, factors.durability,
        bag.geotextile.strength / factors.reduction() / 1e3);
  if (factors.load != 1 || factors.soil != 1)
    text += fmt::format(
        "Against failure the surcharge is multiplied by {:.4g}, and tan phi divided by {:.4g}: M {:.4g} becomes "
        "{:.4g}.\n",
        factors.load, factors.soil, bag.soil.M, weak.M);
  // The stiffness of a curve is the secant at the strain reached. It does not give the tension at failure.
  const double tension = bag.geotextile.curve.known() ? bag.usable_share() * bag.geotextile.strength
                                                      : bag.hoop_limit() * bag.geotextile.stiffness;
  const double M = weak.M;
  if (!(tension > 0)) return text;
  const LongBag flat{bag.bag.width, bag.bag.height, tension, passive_ratio(M)};
  const double bears = capacity(flat, bag.lateral.at(0));
  text += fmt::format(
      "Matsuoka and Liu (2006), plane strain, phi {:.1f} deg (q/p = M), at the same tension of {:.4g} kN/m: apparent "
      "cohesion {:.1f} kPa,\n{}. Ours has hoops along both sides, q/p above M at low stress, and a bag that "
      "flattens.\n",
      friction_angle(M) * 180 / std::numbers::pi, tension / 1e3, apparent_cohesion(flat) / 1e3,
      bears > 0 ? fmt::format("capacity {:.1f} kPa", bears / 1e3) : "no capacity for a bag so slender");
  return text;
}

}  // namespace soilweave::gws
