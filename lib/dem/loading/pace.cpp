// Loading speed of plates and cells.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/pace.h"

#include <algorithm>
#include <cmath>

namespace soilweave::dem {
namespace {

// Steps that a wave takes from one grain to the next. A step is a fraction of the period of a grain on its neighbours.
constexpr double steps_past_a_grain = 10;
// Least share of the prescribed speed. Even if contacts are lost, the loading must go on until new ones form.
constexpr double least_share = 0.01;
// Wave crossings in which the speed grows (`faster`) or falls (`slower`) by a factor e, if the unbalanced force is off
// by a factor e or more. The speed grows slowly, so that the grains can respond. At the start it grows fast, because
// hardly loaded grains lose their contacts under a creeping load.
constexpr double faster = 10, slower = 1, faster_at_start = 1;
// Share of the wanted unbalanced force at which the fast start ends, since this force lags the speed by a crossing.
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
