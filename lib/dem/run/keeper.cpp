// Writes checkpoints of an unfinished run.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/run/keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

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

void Keeper::keep(io::Checkpoint checkpoint, bool recorded) {
  const Clock::time_point start = Clock::now();
  part().keep(std::move(checkpoint), recorded);
  const Clock::time_point end = Clock::now();
  const double took = std::chrono::duration<double>(end - start).count();
  seconds_ += took;
  if (how_.interval > 0) due_ = end + duration(std::max(how_.interval, took / largest_share));
}

void Keeper::stop(const char* signal) const {
  throw Stopped(fmt::format("stopped by {} after step {}", signal, part().last_step()));
}

}  // namespace soilweave::dem
