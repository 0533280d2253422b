// A contact law from outside the library, with a parameter and two fields of history of its own: softer when unloaded.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string_view>
#include <tuple>

#include "dem/contact/laws/linear.h"

namespace soilweave::dem {

/// The law. It has the members that laws.h requires.
struct Toy {
  static constexpr std::string_view name = "toy";
  static constexpr std::array<std::string_view, 2> examples = Linear::examples;

  static constexpr Parameter softening{
      "toy_softening", "1", 0, 0.5, false, "share of the stiffness that a contact loses while it is unloaded"};
  static constexpr std::array history = {
      HistoryField{"toy_largest_overlap", "m", "largest overlap so far"},
      HistoryField{"toy_walk", "m", "slip since the contact began", HistoryField::Kind::along}};

  /// Values of these fields.
  template <class T, class Space>
  struct Own {
    T largest_overlap;
    Along<T, Space> walk;
    auto fields() { return std::tie(largest_overlap, walk); }
  };

  struct Material : Linear::Material {
    using Law = Toy;
    double softening = 0;
  };
  struct MaterialPair : Linear::MaterialPair {
    double softening;
  };

  static Material read(Settings& table) { return {Linear::read(table), table.number(softening, 0.1)}; }
  static MaterialPair mix(const Material& a, const Material& b) {
    return {Linear::mix(a, b), 0.5 * (a.softening + b.softening)};
  }
  static double modulus(const Material& m) { return m.young_modulus; }
  static bool uses_masses(const MaterialPair& c) { return Linear::uses_masses(c); }
  static bool uses_moments(const MaterialPair& c) { return Linear::uses_moments(c); }

  /// Returns the response of the springs, less stiff by up to the softening where the overlap is below its largest.
  template <class T, class Space>
  static Response<T> respond(const MaterialPair& c, const Kinematics<T, Space>& k, const T& dt,
                             HistoryWithOwn<T, Space, Own<T, Space>>& history, ContactEnergies<T>& energies) {
    Response<T> r = Linear::respond(static_cast<const Linear::MaterialPair&>(c), k, dt,
                                    static_cast<ContactHistory<T, Space>&>(history), energies);
    T& largest = history.own.largest_overlap;
    largest = maximum(largest, k.overlap);
    const T loss = c.softening * (1.0 - k.overlap / maximum(largest, broadcast<T>(1e-300)));
    r.normal_force = (1.0 - loss) * r.normal_force;
    history.own.walk = history.own.walk + k.slip;
    return r;
  }
};

}  // namespace soilweave::dem
