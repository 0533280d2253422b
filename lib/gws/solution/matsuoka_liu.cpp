// The closed form of Matsuoka and Liu for a soilbag in plane strain.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/solution/matsuoka_liu.h"

#include <cmath>

namespace soilweave::gws {

double passive_ratio(double obliquity) { return (3 + 2 * obliquity) / (3 - obliquity); }

double friction_angle(double obliquity) { return std::asin(3 * obliquity / (6 + obliquity)); }

double apparent_cohesion(const LongBag& bag) {
  return bag.tension / (bag.width * std::sqrt(bag.passive_ratio)) * (bag.passive_ratio * bag.width / bag.height - 1);
}

double capacity(const LongBag& bag, double lateral) {
  return bag.passive_ratio * lateral + 2 * apparent_cohesion(bag) * std::sqrt(bag.passive_ratio);
}

}  // namespace soilweave::gws
