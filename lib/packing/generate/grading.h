// A grading curve by mass, and the grains that follow it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace soilweave::packing {

/// Fraction by mass finer than a diameter: ascending diameters (m), fractions ascending to 1, linear in between. Grains
/// finer than the first point are left out, as in the author's packings: their size is unknown. One per cent of the
/// mass would be a tenth of all grains, most without a contact.
struct Grading {
  /// Diameters, m.
  std::vector<double> diameter;
  /// Fractions by mass.
  std::vector<double> finer;
  /// Names of further columns of the table, which are not read.
  std::vector<std::string> unread = {};

  /// Reads a table with columns diameter (a length, as [mm]) and finer_by_mass ([%] or [1]). Throws DataError naming
  /// document and row, also where another column has nearly one of these names.
  static Grading from_tsv(std::string_view text, const std::string& where);
  /// Returns data/gradings/toyoura.tsv (thesis §3.2.2), as built into this program.
  static Grading toyoura();

  /// Returns the missing part in words: "the part finer than 0.075 mm, 10 % of the mass, is left out"; empty for a
  /// curve from 0 %.
  std::string left_out() const;
  /// Returns sentences on what is left out: columns, and, with `finest`, the part of left_out().
  std::vector<std::string> notes(bool finest) const;
  /// Returns the curve without grains coarser than `diameter`, m. Throws DataError if nothing is left.
  Grading up_to(double diameter) const;

  /// Returns the diameter below which a fraction of the mass lies, m, without the mass finer than the first point.
  double quantile(double fraction) const;
  /// Returns n radii (m), largest first, at mid-quantiles of the distribution by number (mass ~ d^3 for spheres, d^2
  /// for disks). No sample of n grains is closer to the curve.
  std::vector<double> radii(std::size_t n, int dimension) const;
};

}  // namespace soilweave::packing
