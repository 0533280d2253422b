// Keys that contact laws share in a scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <optional>

#include "core/text/settings.h"
#include "dem/contact/laws/resistance.h"

namespace soilweave::dem {

/// Reads a friction angle in degrees and returns it in radians.
inline double read_friction_angle(Settings& table) {
  static constexpr Parameter friction_angle{"friction_angle",
                                            "deg",
                                            0,
                                            89.9,
                                            false,
                                            "inter-particle friction angle",
                                            "the tangent of a right angle is infinite"};
  return table.number(friction_angle) * std::numbers::pi / 180;
}

/// Reads the coefficient of restitution; none if the key is absent.
inline std::optional<double> read_restitution(Settings& table) {
  static constexpr Parameter restitution{"restitution",
                                         "1",
                                         0,
                                         1,
                                         true,
                                         "normal coefficient of restitution",
                                         "1 means no viscous damping: leave the key out"};
  if (!table.has("restitution")) return std::nullopt;
  return table.number(restitution);
}

/// Reads whether the dashpot may pull while the grains part.
inline bool read_attraction(Settings& table) {
  return table.flag({"attraction", "whether the dashpot may pull while the grains part"}, false);
}

/// Reads [contact.rolling] or [contact.twisting]: stiffness, scale, limit and arm.
/// The limit is "none" or a number; 0 means no moment at all.
inline Resistance read_resistance(Settings& table, std::string_view key) {
  static constexpr Parameter stiffness{
      "stiffness", "1",   0,
      1e12,        false, "stiffness: N m/rad where scale is \"absolute\", a factor on ks r1 r2 where \"contact\""};
  static constexpr Parameter limit{"limit", "1", 0, 1e6, false, "plastic limit: moment over normal force and arm"};
  Resistance r;
  if (!table.has(key)) return r;
  Settings part = table.table(key);
  r.stiffness = part.number(stiffness);
  r.scale = part.choice({"scale", "what the stiffness is: in N m/rad, or a factor on ks r1 r2"},
                        {"absolute", "contact"}, "absolute") == "absolute"
                ? Resistance::Scale::absolute
                : Resistance::Scale::contact;
  r.limit = part.number_or(limit, "none");
  r.arm = part.choice({"arm", "length over which the plastic limit acts"}, {"mean-radius", "smaller-radius"},
                      "mean-radius") == "mean-radius"
              ? Resistance::Arm::mean_radius
              : Resistance::Arm::smaller_radius;
  return r;
}

}  // namespace soilweave::dem
