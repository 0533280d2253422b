// The closed form of Matsuoka and Liu (2006) for a soilbag in plane strain, to lay beside the solution.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace soilweave::gws {

/// A long bag: width B and height H, m; tension T of its geotextile, N/m; K_p = (1 + sin phi)/(1 - sin phi) of its
/// soil.
struct LongBag {
  double width = 0, height = 0, tension = 0, passive_ratio = 1;
};

/// Returns K_p of a soil with q/p = `obliquity` in triaxial compression.
double passive_ratio(double obliquity);
/// Returns the friction angle, radians, of the same.
double friction_angle(double obliquity);

/// Returns the apparent cohesion T/(B sqrt(K_p)) (K_p B/H - 1), Pa.
double apparent_cohesion(const LongBag& bag);

/// Returns the vertical stress at failure under the lateral stress `lateral` outside, Pa: K_p lateral + 2 c sqrt(K_p).
///
/// Two hoops carry it in plane strain: the soil's lateral stress is lateral + 2 T/H, and the sides take 2 T/B off the
/// vertical one. A bag as long as it is wide (gws/solution/model.h) has hoops along its length as well: 2 T/B more of
/// lateral stress, which carries K_p 2 T/B, and 2 T/B more off the vertical stress. At small strain and with equal K_p
/// its surcharge is therefore greater by (K_p - 1) 2 T/B. This share of the whole, about H/B, vanishes for flat bags.
double capacity(const LongBag& bag, double lateral);

}  // namespace soilweave::gws
