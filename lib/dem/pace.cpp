// How fast what is moved or strained by a given way goes.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/pace.h"

#include <algorithm>
#include <cmath>

namespace soilweave::dem {
namespace {

// A step is a share of the time in which a grain swings on its neighbours: a wave takes some steps from each to the
// next.
constexpr double steps_past_a_grain = 10;
// The pace is never less: where contacts are lost, however slowly, it must go on until they are found again.
constexpr double least_share = 0.01;
// Crossings in which it becomes e times faster, or as much slower, where the unbalanced force is off by e times or
// more. Faster: slowly enough for the grains to tell, except at the start, when it must not creep, whatever speed it is
// a share of: grains that are hardly loaded lose what they bear.
constexpr double faster = 10, slower = 1, faster_at_start = 1;
// The start is over where the unbalanced force, which lags behind by a crossing, is this share of the wanted one.
constexpr double found_share = 0.5;

}  // namespace

Pace::Pace(std::size_t grains, int dimension)
    : crossing_(steps_past_a_grain * std::pow(static_cast<double>(grains), 1.0 / dimension)), share_(least_share) {}

void Pace::begin_stage() {
  share_ = least_share;
  found_ = false;
}

void Pace::follow(double unbalanced, double wanted, std::int64_t steps) {
  const double room = unbalanced > 0 ? std::clamp(std::log(wanted / unbalanced), -1.0, 1.0) : 1.0;
  found_ = found_ || unbalanced > found_share * wanted;
  const double crossings = room < 0 ? slower : (found_ ? faster : faster_at_start);
  share_ *= std::exp(room * static_cast<double>(steps) / (crossings * crossing_));
  share_ = std::clamp(share_, least_share, 1.0);
}

void Pace::archive(Archive& archive) {
  archive.item("pace_share", share_);
  archive.whole("pace_found", found_);
}

}  // namespace soilweave::dem
