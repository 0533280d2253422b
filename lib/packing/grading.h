// A grading curve by mass, and the grains that follow it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soilweave::packing {

/// Fraction by mass finer than a diameter: ascending diameters (m), fractions ascending to 1. Linear between points;
/// what is finer than the first point is left out, as its size is not known and as in the author's packings: a per cent
/// of the mass, put in grains of that size, is a tenth of all grains, most of them without a contact.
struct Grading {
  std::vector<double> diameter;
  std::vector<double> finer;

  /// From a table with the columns diameter (a length, as [mm]) and finer_by_mass (a share: [%] or [1]). Throws
  /// DataError naming document and row.
  static Grading from_tsv(std::string_view text, const std::string& where);
  /// The curve of thesis §3.2.2 (data/gradings/toyoura.tsv).
  static Grading toyoura();

  /// Returns what the packing lacks of the curve, "what is finer than 0.075 mm, 10 % of the mass, is left out"; empty
  /// where the curve begins at nothing.
  std::string left_out() const;
  /// The curve without what is coarser than `diameter`, m. Throws DataError where nothing is left.
  Grading up_to(double diameter) const;

  /// Diameter below which a fraction lies of the mass coarser than the first point, m.
  double quantile(double fraction) const;
  /// n radii (m), largest first, at the mid-quantiles of the distribution by number that belongs to the curve in this
  /// dimension (mass ~ d^3 for spheres, d^2 for disks): no sample of n grains follows the curve more closely.
  std::vector<double> radii(std::size_t n, int dimension) const;
};

}  // namespace soilweave::packing
