// A grading curve by mass, and the grains that follow it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soilweave::packing {

/// Fraction by mass finer than a diameter: ascending diameters (m), fractions ascending to 1, linear in between. Grains
/// finer than the first point are left out, because their size is unknown, and as in the author's packings. One per
/// cent of the mass in grains of that size would be a tenth of all grains, most of them without a contact.
struct Grading {
  std::vector<double> diameter;
  std::vector<double> finer;

  /// Reads a table with the columns diameter (a length, as [mm]) and finer_by_mass (a share: [%] or [1]). Throws
  /// DataError naming document and row.
  static Grading from_tsv(std::string_view text, const std::string& where);
  /// Returns the curve of thesis §3.2.2: data/gradings/toyoura.tsv, as it was when this program was built.
  static Grading toyoura();

  /// Returns what the packing lacks of the curve: "the part finer than 0.075 mm, 10 % of the mass, is left out"; empty
  /// if the curve begins at 0 %.
  std::string left_out() const;
  /// Returns the curve without grains coarser than `diameter`, m. Throws DataError if nothing is left.
  Grading up_to(double diameter) const;

  /// Returns the diameter below which a fraction of the mass lies, m. The mass finer than the first point does not
  /// count.
  double quantile(double fraction) const;
  /// Returns n radii (m), largest first, at the mid-quantiles of the curve's distribution by number in this dimension
  /// (mass ~ d^3 for spheres, d^2 for disks). No sample of n grains follows the curve more closely.
  std::vector<double> radii(std::size_t n, int dimension) const;
};

}  // namespace soilweave::packing
