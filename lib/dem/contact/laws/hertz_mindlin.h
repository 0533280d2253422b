// Hertz-Mindlin law for elastic spheres, with Coulomb's limit, rolling and twisting resistance (LAWS.md §2).
// The shear force is not rescaled when the overlap falls, so cycles can create energy (Elata & Berryman 1996).
// The energy balance has a term for it (energies/law.h), which tests/property/laws_test.cpp measures.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <optional>
#include <string_view>

#include "core/parameter.h"
#include "dem/contact/laws/damping.h"
#include "dem/contact/laws/read.h"
#include "dem/contact/laws/tangential.h"

namespace soilweave::dem {

/// The law. Its members are those that laws.h demands.
struct HertzMindlin {
  /// Name in scenarios.
  static constexpr std::string_view name = "hertz-mindlin";

  /// Two sands, as a scenario writes them, for the property tests.
  static constexpr std::array<std::string_view, 2> examples = {
      "young_modulus = 4e9\n"
      "poisson_ratio = 0.33\n"
      "friction_angle = 29\n"
      "rolling = {stiffness = 0.13, limit = 0.1}\n"
      "twisting = {stiffness = 0.13, limit = 0.1}\n",
      "young_modulus = 2e9\n"
      "poisson_ratio = 0.2\n"
      "friction_angle = 25\n"
      "rolling = {stiffness = 0.2, limit = 0.1}\n"
      "twisting = {stiffness = 0.2, limit = 0.1}\n"};

  /// Parameters of one material.
  struct Material {
    using Law = HertzMindlin;
    /// Young's modulus, Pa.
    double young_modulus;
    /// Poisson's ratio, 1.
    double poisson_ratio;
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
    /// Effective moduli E* and G*, Pa.
    double E_star, G_star;
    /// Dashpot.
    Damping damping;
    /// Friction, rolling and twisting.
    Tangential tangential;
  };

  /// Key `young_modulus` of a material.
  static constexpr Parameter young_modulus{"young_modulus",
                                           "Pa",
                                           1e3,
                                           1e13,
                                           false,
                                           "Young's modulus of the grains",
                                           "the contacts of stiffer grains cannot be resolved in double precision"};
  /// Key `poisson_ratio` of a material.
  static constexpr Parameter poisson_ratio{"poisson_ratio",
                                           "1",
                                           0,
                                           0.5,
                                           false,
                                           "Poisson's ratio of the grains",
                                           "isotropic elastic solids of this field lie between 0 and 0.5"};

  /// Reads a material from [contact] or a [[material]] table.
  static Material read(Settings& table) {
    return {table.number(young_modulus), table.number(poisson_ratio),       read_friction_angle(table),
            read_restitution(table),     read_resistance(table, "rolling"), read_resistance(table, "twisting"),
            read_attraction(table)};
  }

  /// Mixes two materials: 1/E* = sum (1 - nu^2)/E, and 1/G* = sum (2 - nu)/G with G = E/(2(1 + nu)).
  /// Source: thesis Eq. 3.3.
  static MaterialPair mix(const Material& a, const Material& b) {
    const auto compliance = [](const Material& m) { return (1 - m.poisson_ratio * m.poisson_ratio) / m.young_modulus; };
    const auto shear = [](const Material& m) {
      return (2 - m.poisson_ratio) * 2 * (1 + m.poisson_ratio) / m.young_modulus;
    };
    return {1 / (compliance(a) + compliance(b)), 1 / (shear(a) + shear(b)),
            Damping::mix(a.restitution, b.restitution, a.attraction || b.attraction), mix_tangential(a, b)};
  }

  /// Returns the modulus that scales the contacts' stiffness, Pa.
  static double modulus(const Material& m) { return m.young_modulus; }
  /// Returns whether the response needs the masses.
  static bool uses_masses(const MaterialPair& c) { return c.damping.ratio > 0; }
  /// Returns whether contacts can have moments.
  static bool uses_moments(const MaterialPair& c) { return c.tangential.uses_moments(); }

  /// Returns the response: Fn = 4/3 E* sqrt(R*) delta^1.5, ks = 8 G* sqrt(R* delta).
  /// The stiffness kn is the tangent 2 E* sqrt(R* delta), as in thesis Eq. 3.2.
  template <class T, class Space>
  static Response<T> respond(const MaterialPair& c, const Kinematics<T, Space>& k, const T& dt,
                             ContactHistory<T, Space>& history, ContactEnergies<T>& energies) {
    // Contact radius, m.
    const T a = square_root(k.R_star * k.overlap);
    const T kn = 2.0 * c.E_star * a, ks = 8.0 * c.G_star * a;
    const T elastic = (2.0 / 3.0) * kn * k.overlap;
    // Tsuji, Tanaka & Ishida (1992): a critical fraction beta gives a restitution independent of speed.
    const double ratio = std::sqrt(5.0 / 6.0) * c.damping.ratio;
    Response<T> r;
    r.normal_force = c.damping.force(elastic, ratio, kn, k);
    r.normal_stiffness = kn;
    r.shear_stiffness = ks;
    energies.elastic_normal = 0.4 * elastic * k.overlap;
    energies.viscous = c.damping.work(r.normal_force, elastic, k, dt);
    tangential_step(c.tangential, k, history, r, energies);
    return r;
  }
};

}  // namespace soilweave::dem
