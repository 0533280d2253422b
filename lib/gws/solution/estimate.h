// Constants of the wrapped soil where no bags were computed: from strength, dilation and stiffness of a triaxial test.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/text/settings.h"
#include "gws/solution/soil.h"

namespace soilweave::gws {

/// A drained triaxial compression test. Angles in degrees, at the peak.
struct Triaxial {
  double friction_angle = 0, dilation_angle = 0;
  double E50 = 0;         // secant modulus to half of the greatest deviatoric stress, Pa
  double void_ratio = 0;  // before shear
  double pressure = 1e5;  // confining pressure, Pa
};

/// Returns Toyoura sand's constants (thesis Table 5.2), except for the constants that the test determines:
/// - M_f, q/p at failure, is 6 sin phi/(3 - sin phi). M is smaller by the dilation at failure,
///   6 sin psi/(3 - sin psi) (thesis section 5.3.3). p_c follows from both; the exponent n is Toyoura's.
/// - kappa and lambda are scaled by the strain at half of the strength over Toyoura's at the same pressure. kappa is
///   scaled by the strength as well.
/// - C_t is scaled by the void ratio's function (2.17 - e)^2/(1 + e) of Hardin and Richart (1963).
/// The stiffness with a geotextile, alpha and beta, and the slope of the dilatancy line stay Toyoura's.
Soil estimated(const Triaxial& test);

/// Reads [estimate]: friction_angle, dilation_angle, E50, void_ratio, pressure; or triaxial, a TSV with strain_axial,
/// strain_volumetric and stress_ratio, instead of the first three. Mistakes go to the document.
Triaxial read_estimate(Settings& table);

/// Returns the phrase that marks such a soil in answers.
std::string marked(const Triaxial& test);

}  // namespace soilweave::gws
