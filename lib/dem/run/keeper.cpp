// Writes checkpoints of an unfinished run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/keeper.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"

namespace soilweave::dem {
namespace {

// A check of clock and signals costs as much as a step of a few grains, so small runs check less often. This is the
// product of the grains and the steps between two checks.
constexpr std::int64_t grains_per_look = 4096;
// Largest checkpoint time over the time until the next checkpoint, for large runs and slow disks.
constexpr double largest_share = 0.2;

auto duration(double seconds) {
  return std::chrono::duration_cast<std::chrono::steady_clock::duration>(std::chrono::duration<double>(seconds));
}

}  // namespace

Keeper::Keeper(const Safekeeping& how, std::size_t grains)
    : how_(how), look_interval_(1 + grains_per_look / static_cast<std::int64_t>(grains)) {
  due_ = how.interval > 0 ? Clock::now() + duration(how.interval) : Clock::time_point::max();
}

void Keeper::set_next(double took) {
  if (how_.interval > 0) due_ = Clock::now() + duration(std::max(how_.interval, took / largest_share));
}

void Keeper::stop(const char* signal) const {
  throw Stopped(fmt::format("stopped by {} after step {}", signal, part().last_step()));
}

}  // namespace soilweave::dem
