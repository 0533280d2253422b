// Secant stiffness of a geotextile with a curve, at the strain that is reached.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "gws/solution/respond.h"

namespace soilweave::gws {

/// Returns the bag with the secant stiffness at a hoop strain.
Case with_secant(Case bag, double strain);

/// Returns the greatest hoop strain of a bag with a curve: the curve's end or stated fraction of the strength.
double limit_strain(const Case& bag);

/// Returns the bag with the secant stiffness at its hoop strain under `surcharge`, or at its limit. Returns a bag
/// without a curve unchanged. Throws DataError as Response does.
Case at_strain_reached(const Case& bag, std::optional<double> surcharge);

/// Answers of one bag at its limit, under surcharges and at settlements. With a curve, each answer has the secant
/// stiffness at its own hoop strain, like `respond` with that surcharge. Without a curve, all answers lie on one
/// response.
class Answers {
 public:
  /// State after compaction, and requested state, on one path.
  struct Answer {
    Point start, at;
    /// Returns the axial strain since compaction.
    double settlement() const { return at.settlement() - start.settlement(); }
  };

  /// Computes the response to the bag's limit; `bag.until` does not count. Throws DataError as Response does.
  explicit Answers(const Case& bag);

  /// Returns the response to the limit.
  const Response& ultimate() const { return ultimate_; }
  /// Returns whether the bag has a state under this surcharge.
  bool reaches(double surcharge) const;
  /// Return the answer under a surcharge, or at a settlement since compaction. They throw DataError if there is none.
  Answer under(double surcharge) const;
  Answer settled(double settlement) const;

 private:
  Case bag_;
  Response ultimate_;
};

/// Returns the first state and n states at equal steps of hoop strain, up to Geotextile::secant_at. Each state has the
/// secant stiffness at its own strain. Steps below the first state's hoop strain are left out.
std::vector<Point> secant_points(const Case& bag, std::size_t n);

}  // namespace soilweave::gws
