// Cundall's linear springs: stiffness from moduli and radii, Coulomb's limit, rolling and twisting resistance (LAWS.md
// §3).
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "core/parameter.h"
#include "dem/contact/laws/damping.h"
#include "dem/contact/laws/read.h"
#include "dem/contact/laws/tangential.h"

namespace soilweave::dem {

/// The law. Its members are those that laws.h demands.
struct Linear {
  /// Name in scenarios.
  static constexpr std::string_view name = "linear";

  /// Two sands, as a scenario writes them, for the property tests.
  static constexpr std::array<std::string_view, 2> examples = {
      "young_modulus = 5.449e8\n"
      "stiffness_ratio = 0.08\n"
      "friction_angle = 30.2\n"
      "rolling = {stiffness = 0.56, scale = \"contact\", limit = 0.1, arm = \"smaller-radius\"}\n"
      "twisting = {stiffness = 0.56, scale = \"contact\", limit = 0.1, arm = \"smaller-radius\"}\n",
      "young_modulus = 3e8\n"
      "stiffness_ratio = 0.4\n"
      "friction_angle = 25\n"
      "rolling = {stiffness = 0.8, scale = \"contact\", limit = 0.1, arm = \"smaller-radius\"}\n"
      "twisting = {stiffness = 0.8, scale = \"contact\", limit = 0.1, arm = \"smaller-radius\"}\n"};

  /// Parameters of one material.
  struct Material {
    using Law = Linear;
    /// Modulus E in kn, Pa.
    double young_modulus;
    /// ks/kn of two equal grains, 1.
    double stiffness_ratio;
    /// Friction angle, rad.
    double friction_angle;
    /// Normal coefficient of restitution; unset without viscous damping.
    std::optional<double> restitution;
    /// Resistance to rolling and to twisting.
    Resistance rolling, twisting;
    /// Whether the dashpot may pull while the grains part (damping.h).
    bool attraction = false;
    /// Whether this friction angle applies in contacts with any other material.
    bool friction_decides = false;
  };
  /// A pair of materials.
  struct MaterialPair {
    /// Moduli, Pa.
    double E1, E2;
    /// Modulus times stiffness ratio, Pa.
    double S1, S2;
    /// Dashpot.
    Damping damping;
    /// Friction, rolling and twisting.
    Tangential tangential;
  };

  /// Key `young_modulus` of a material.
  static constexpr Parameter young_modulus{"young_modulus",
                                           "Pa",
                                           1e2,
                                           1e13,
                                           false,
                                           "contact modulus of the grains",
                                           "the contacts of stiffer grains cannot be resolved in double precision"};
  /// Key `stiffness_ratio` of a material.
  static constexpr Parameter stiffness_ratio{"stiffness_ratio",
                                             "1",
                                             0,
                                             10,
                                             false,
                                             "shear stiffness over normal stiffness of a contact",
                                             "a contact much stiffer in shear than in compression is not a grain's"};

  /// Reads a material from [contact] or a [[material]] table.
  static Material read(Settings& table) {
    return {table.number(young_modulus), table.number(stiffness_ratio),     read_friction_angle(table),
            read_restitution(table),     read_resistance(table, "rolling"), read_resistance(table, "twisting"),
            read_attraction(table)};
  }

  /// Keeps the moduli of both materials, and mixes damping and friction.
  static MaterialPair mix(const Material& a, const Material& b) {
    return {a.young_modulus,
            b.young_modulus,
            a.young_modulus * a.stiffness_ratio,
            b.young_modulus * b.stiffness_ratio,
            Damping::mix(a.restitution, b.restitution, a.attraction || b.attraction),
            mix_tangential(a, b)};
  }

  /// Returns the modulus that scales the contacts' stiffness, Pa.
  static double modulus(const Material& m) { return m.young_modulus; }
  /// Returns whether the response needs the masses.
  static bool uses_masses(const MaterialPair& c) { return c.damping.ratio > 0; }
  /// Returns whether contacts can have moments.
  static bool uses_moments(const MaterialPair& c) { return c.tangential.uses_moments(); }

  /// Returns the response of two springs in series (LAWS.md §3).
  /// Fn = kn delta, kn = 2 E1 r1 E2 r2/(E1 r1 + E2 r2). For ks, moduli times stiffness ratios replace E1 and E2.
  template <class T, class Space>
  static Response<T> respond(const MaterialPair& c, const Kinematics<T, Space>& k, const T& dt,
                             ContactHistory<T, Space>& history, ContactEnergies<T>& energies) {
    Response<T> r;
    if (c.E1 == c.E2 && c.S1 == c.S2) {
      const T twice = 2.0 * k.r1 * k.r2 * k.per_reach;
      r.normal_stiffness = c.E1 * twice, r.shear_stiffness = c.S1 * twice;
    } else {
      const T tiny = broadcast<T>(1e-300);
      const T n1 = c.E1 * k.r1, n2 = c.E2 * k.r2, s1 = c.S1 * k.r1, s2 = c.S2 * k.r2;
      // One division serves both stiffnesses.
      const T n = n1 + n2, s = maximum(s1 + s2, tiny), inverse = 1.0 / (n * s);
      r.normal_stiffness = 2.0 * n1 * n2 * (s * inverse);
      r.shear_stiffness = 2.0 * s1 * s2 * (n * inverse);
    }
    const T elastic = r.normal_stiffness * k.overlap;
    r.normal_force = c.damping.force(elastic, c.damping.ratio, r.normal_stiffness, k);
    energies.elastic_normal = 0.5 * elastic * k.overlap;
    energies.viscous = c.damping.work(r.normal_force, elastic, k, dt);
    // Without shear stiffness no shear force remains, and no moment scaled by it.
    if (c.S1 == 0 || c.S2 == 0) c.tangential.let_go(history);
    tangential_step(c.tangential, k, history, r, energies);
    return r;
  }
};

}  // namespace soilweave::dem
