// Linear springs with an adhesion that acts within a finite range, also across a gap (LAWS.md §10).
// SPDX-License-Identifier: GPL-3.0-or-later
//
// While two grains overlap, they attract each other with 2 pi w R* (Derjaguin, Muller & Toporov 1975).
// Across a gap the force falls linearly to zero at the range (Singh, Magnanimo, Saitoh & Luding 2014).
// A cycle of approach and separation costs no energy.
// Shear, rolling and damping are as in laws/linear.h, with the repulsive force alone.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

#include "dem/contact/laws/linear.h"

namespace soilweave::dem {

/// The law. Its members are those that laws.h demands.
struct LinearAdhesion {
  /// Name in scenarios.
  static constexpr std::string_view name = "linear-adhesion";

  /// Two moist sands, as a scenario writes them, for the property tests.
  static constexpr std::array<std::string_view, 2> examples = {
      "young_modulus = 5.449e8\n"
      "stiffness_ratio = 0.08\n"
      "friction_angle = 30.2\n"
      "work_of_adhesion = 0.07\n"
      "adhesion_range = 1e-5\n"
      "rolling = {stiffness = 0.56, scale = \"contact\", limit = 0.1, arm = \"smaller-radius\"}\n"
      "twisting = {stiffness = 0.56, scale = \"contact\", limit = 0.1, arm = \"smaller-radius\"}\n",
      "young_modulus = 3e8\n"
      "stiffness_ratio = 0.4\n"
      "friction_angle = 25\n"
      "work_of_adhesion = 0.03\n"
      "adhesion_range = 2e-5\n"
      "rolling = {stiffness = 0.8, scale = \"contact\", limit = 0.1, arm = \"smaller-radius\"}\n"
      "twisting = {stiffness = 0.8, scale = \"contact\", limit = 0.1, arm = \"smaller-radius\"}\n"};

  /// Key `work_of_adhesion` of a material.
  static constexpr Parameter work_of_adhesion{
      "work_of_adhesion", "J/m2", 0, 1e3, false, "work of adhesion w; the grains pull with 2 pi w R*"};
  /// Key `adhesion_range` of a material.
  static constexpr Parameter adhesion_range{
      "adhesion_range", "m", 0, 1, true, "gap at which the adhesion ends", "without a range the force would jump"};

  /// Parameters of one material: springs and adhesion.
  struct Material : Linear::Material {
    using Law = LinearAdhesion;
    /// Work of adhesion w, J/m2.
    double work_of_adhesion = 0;
    /// Gap at which the adhesion ends, m.
    double adhesion_range = 0;
  };
  /// A pair of materials.
  struct MaterialPair : Linear::MaterialPair {
    /// 2 pi w, N/m.
    double pull_per_radius;
    /// Gap at which the adhesion ends, m.
    double range;
  };

  /// Reads a material from [contact] or a [[material]] table.
  static Material read(Settings& table) {
    return {Linear::read(table), table.number(work_of_adhesion), table.number(adhesion_range)};
  }
  /// Mixes two materials: geometric mean of w (Israelachvili 2011), mean of the ranges.
  static MaterialPair mix(const Material& a, const Material& b) {
    return {Linear::mix(a, b), 2 * std::numbers::pi * std::sqrt(a.work_of_adhesion * b.work_of_adhesion),
            0.5 * (a.adhesion_range + b.adhesion_range)};
  }

  /// Returns the modulus that scales the contacts' stiffness, Pa.
  static double modulus(const Material& m) { return m.young_modulus; }
  /// Returns whether the response needs the masses.
  static bool uses_masses(const MaterialPair& c) { return Linear::uses_masses(c); }
  /// Returns whether contacts can have moments.
  static bool uses_moments(const MaterialPair& c) { return Linear::uses_moments(c); }
  /// Returns the gap across which two grains still attract each other, m.
  static double range(const MaterialPair& c) { return c.range; }

  /// Returns the response of the springs minus the pull 2 pi w R* depth/range.
  /// The depth is overlap + range, limited to [0, range]. The energy of the pull is zero at depth 0.
  template <class T, class Space>
  static Response<T> respond(const MaterialPair& c, const Kinematics<T, Space>& k, const T& dt,
                             ContactHistory<T, Space>& history, ContactEnergies<T>& energies) {
    const T zero = broadcast<T>(0);
    const Mask<T> pressed = k.overlap > zero;
    // Across a gap the springs get neither motion nor overlap.
    Kinematics<T, Space> springs = k;
    springs.overlap = maximum(k.overlap, zero);
    springs.approach_speed = masked(pressed, k.approach_speed);
    springs.slip = masked(pressed, k.slip), springs.roll = masked(pressed, k.roll),
    springs.twist = masked(pressed, k.twist);
    Response<T> r = Linear::respond(static_cast<const Linear::MaterialPair&>(c), springs, dt, history, energies);
    const T depth = minimum(maximum(T(k.overlap + c.range), zero), broadcast<T>(c.range));
    // Slope of the pull, N/m.
    const T slope = k.R_star * (c.pull_per_radius / c.range);
    r.normal_force = r.normal_force - slope * depth;
    // Across a gap the pull falls with distance, so the tangent is negative. The time step needs its magnitude.
    r.normal_stiffness = select<T>(pressed, r.normal_stiffness, slope);
    energies.elastic_normal = energies.elastic_normal - slope * (0.5 * depth * depth + c.range * springs.overlap);
    return r;
  }
};

}  // namespace soilweave::dem
