// Closed form of Matsuoka and Liu (2006) for a soilbag in plane strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave::gws {

/// A long bag.
struct LongBag {
  /// Width B and height H, m; tension T, N/m; K_p = (1 + sin phi)/(1 - sin phi).
  double width = 0, height = 0, tension = 0, passive_ratio = 1;
};

/// Returns K_p of a soil with q/p = `obliquity` in triaxial compression.
double passive_ratio(double obliquity);
/// Returns the friction angle for that q/p, rad.
double friction_angle(double obliquity);

/// Returns the apparent cohesion T/(B sqrt(K_p)) (K_p B/H - 1), Pa.
double apparent_cohesion(const LongBag& bag);

/// Returns the vertical stress at failure under a lateral stress outside, Pa: K_p lateral + 2 c sqrt(K_p).
///
/// In plane strain the soil's lateral stress is lateral + 2 T/H, and the sides take 2 T/B off the vertical one. A
/// square bag (gws/solution/model.h) has hoops along its length as well. They add 2 T/B of lateral stress, which
/// carries K_p 2 T/B, and take 2 T/B more off the vertical stress. Its surcharge at small strain is thus greater
/// by (K_p - 1) 2 T/B. This share, about H/B, vanishes for flat bags.
double capacity(const LongBag& bag, double lateral);

}  // namespace soilweave::gws
