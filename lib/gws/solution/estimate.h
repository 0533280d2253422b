// Soil constants estimated from one triaxial test, where no bags were computed.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/doubts.h"
#include "core/text/named_file.h"
#include "core/text/settings.h"
#include "files/provenance.h"
#include "gws/solution/soil.h"

namespace soilweave::gws {

/// A drained triaxial compression test.
struct Triaxial {
  /// At the peak, degrees.
  double friction_angle = 0, dilation_angle = 0;
  /// Secant modulus to half of the greatest deviatoric stress, Pa.
  double E50 = 0;
  /// Void ratio before shear.
  double void_ratio = 0;
  /// Confining pressure, Pa.
  double pressure = 1e5;
  /// Whether its curve still rises in the last row.
  bool still_rises = false;
  /// Doubts about its table and its stiffness.
  std::vector<Doubt> doubts = {};
};

/// Returns Toyoura sand's constants (thesis Table 5.2), changed by the test:
/// - M_f, q/p at failure, is 6 sin phi/(3 - sin phi). M is smaller by 6 sin psi/(3 - sin psi) (thesis section 5.3.3).
///   p_c follows from both; n is Toyoura's.
/// - kappa and lambda scale with the strain at half of the strength, at equal pressure. kappa also scales with the
///   strength.
/// - alpha scales with E50, and C_t with 1/E50, at equal pressure. All strains are then in proportion to 1/E50 at equal
///   stress.
/// - C_t also scales with (1 + e)/(2.17 - e)^2 of Hardin and Richart (1963).
/// beta, xi, m, p_0, Poisson's ratio and the slope of the dilatancy line stay Toyoura's.
Soil estimated(const Triaxial& test);

/// Reads [estimate]: friction_angle, dilation_angle, E50, void_ratio, pressure. Key triaxial, a TSV with strain_axial,
/// strain_volumetric and stress_ratio (or deviatoric_stress), replaces the first three. The pressure is then required;
/// otherwise its default is 100 kPa. Doubts about the table are those of triaxial_curves.h; "estimated-stiffness" is an
/// E50 more than ten times off Toyoura sand's at that pressure. The table's source is added to `sources`. Mistakes go
/// to the document. Throws DataError for rows that no drained test has, and for curves whose strength, dilation or
/// stiffness no soil has.
Triaxial read_estimate(Settings& table, const NamedFiles& files, std::vector<io::Source>& sources);

/// Adds a mistake to [estimate] if the dilation angle is so near to the friction angle that p_c leaves its range.
void judge_dilation(Settings& table, const Triaxial& test);

/// Returns the phrase that marks such a soil in answers.
std::string marked(const Triaxial& test);

}  // namespace soilweave::gws
