// History, response and energies of a contact under any law.
// Forces and moments act on body 2. T is double or lanes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>

#include "dem/state/space.h"

namespace soilweave::dem {

/// History of one contact, already carried to the present normal.
template <class T, class Space = Spatial>
struct ContactHistory {
  /// Shear force, N.
  Along<T, Space> shear;
  /// Rolling moment, normal to the contact normal, N m.
  Turn<T, Space> rolling;
  /// Twisting moment, about the contact normal, N m.
  T twisting;
};

/// A field of history that only one law keeps.
struct HistoryField {
  /// A number, or a vector along the contact that turns with it.
  enum class Kind { scalar, along };
  /// Name in files, unit, and description.
  std::string_view name, unit, sentence;
  /// Kind of the field.
  Kind kind = Kind::scalar;

  /// Returns how many numbers a contact keeps for this field.
  constexpr std::size_t numbers() const { return kind == Kind::scalar ? 1 : 3; }
};

/// History of one contact under a law with fields of its own.
template <class T, class Space, class Own>
struct HistoryWithOwn : ContactHistory<T, Space> {
  /// Fields that only the law keeps.
  Own own;
};

/// Response of a law. Shear force and moments are in ContactHistory after the call.
template <class T>
struct Response {
  /// Normal force, N, compression positive, viscous part included.
  T normal_force;
  /// Tangent stiffnesses for the time step, N/m.
  T normal_stiffness, shear_stiffness;
  /// Stiffnesses of the moments, N m/rad.
  T rolling_stiffness, twisting_stiffness;
  /// Force between the surfaces that limits friction and rolling, N.
  T pressing;
  /// Whether the Coulomb limit holds the shear force.
  Mask<T> sliding;
};

/// Energies of one contact.
template <class T>
struct ContactEnergies {
  /// Energy stored in each spring, J.
  T elastic_normal, elastic_shear, elastic_rolling, elastic_twisting;
  /// Energy lost in the step, J.
  T frictional, rolling_plastic, viscous;
};

using soilweave::masked;
using soilweave::select;

/// Step of one spring of a contact: force -= stiffness * increment, cut back to the limit.
/// Shear and rolling are vectors, twisting is a scalar.
template <class T, class Quantity>
struct SpringStep {
  /// Force or moment after the step.
  Quantity force;
  /// Energies that the spring holds and that the cut removes (trapezoidal rule), J.
  T stored, dissipated;
  /// Whether the limit cut the force.
  Mask<T> limited;
};

/// Returns the square of a scalar or a vector.
template <class T>
T squared(const T& a) {
  return a * a;
}
template <class T>
T squared(const V3<T>& a) {
  return norm2(a);
}
/// Returns the magnitude of a scalar or a vector.
template <class T>
T magnitude(const T& a) {
  return absolute(a);
}
template <class T>
T magnitude(const V3<T>& a) {
  return norm(a);
}
/// Returns the product of two scalars or vectors.
template <class T>
T product(const T& a, const T& b) {
  return a * b;
}
template <class T>
T product(const V3<T>& a, const V3<T>& b) {
  return dot(a, b);
}

/// Applies a spring with a limit. `limit`: largest magnitude, not negative; 0 without stiffness.
template <class T, class Quantity>
SpringStep<T, Quantity> limited_spring_step(const Quantity& old, const T& stiffness, const Quantity& increment,
                                            const T& limit) {
  SpringStep<T, Quantity> s;
  const Quantity trial = fused_less(stiffness, increment, old);
  const T force2 = squared(trial), force = magnitude(trial);
  s.limited = force > limit;
  // One division serves the scale of the force and the compliance. A branch would cost more.
  const T inverse = 1.0 / maximum(T(force2 * stiffness), broadcast<T>(1e-300)), compliance = force2 * inverse;
  const T scale = select<T>(s.limited, limit * (force * stiffness * inverse), broadcast<T>(1)), half = 0.5 * compliance;
  s.force = scale * trial;
  // Trapezoidal work minus the change of energy, with increment = (old - trial)/stiffness inserted.
  s.dissipated = masked(s.limited, T(half * (1.0 - scale) * product(Quantity(old + s.force), trial)));
  s.stored = half * squared(s.force);
  return s;
}

/// Applies a spring without a limit.
template <class T, class Quantity>
SpringStep<T, Quantity> spring_step(const Quantity& old, const T& stiffness, const T& compliance,
                                    const Quantity& increment) {
  SpringStep<T, Quantity> s;
  s.force = fused_less(stiffness, increment, old);
  s.limited = broadcast<T>(0) > broadcast<T>(0);
  s.dissipated = broadcast<T>(0);
  s.stored = 0.5 * compliance * squared(s.force);
  return s;
}

/// Returns 1/stiffness; 0 for no stiffness.
template <class T>
T compliance_of(const T& stiffness) {
  return select<T>(stiffness > broadcast<T>(0), T(1.0 / maximum(stiffness, broadcast<T>(1e-300))), broadcast<T>(0));
}

}  // namespace soilweave::dem
