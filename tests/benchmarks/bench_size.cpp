// Time and memory of a step from a thousand grains to a million, and throughput of many small systems at once.
// bench-size draws it (tests/benchmarks/size.sh).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <memory>
#include <vector>

#include "dem/contact/contact_block.h"
#include "dem/engine/simulation.h"
#include "dem/run/scenario.h"
#include "dem/state/bodies.h"
#include "packing/expand/tile.h"
#include "support/assemblies.h"

namespace soilweave::dem {
namespace {

constexpr std::size_t base = 1000;
constexpr int settling = 40;  // steps in which the grains come to rest under this friction

// Returns dense grains at rest under 0.1 MPa, made once.
const io::Snapshot& dense(const Model& model, std::size_t grains) {
  constexpr double slippery = 5 * support::degree;
  static const io::Snapshot spheres = support::packed(with_friction(support::sand(), slippery), 1e5, base);
  static const io::Snapshot few = support::packed(with_friction(support::linear_sand(), slippery), 1e5, 400);
  return model.materials.law() == "hertz-mindlin" && grains == base ? spheres : few;
}

// Returns copies in a nearly cubic array.
io::Snapshot copies(const io::Snapshot& one, std::size_t count) {
  std::array<int, 3> n{1, 1, 1};
  for (auto left = static_cast<int>(count); left > 1;)
    for (int& axis : n) {
      const int factor = left % 10 == 0 ? 10 : left;
      if (left > 1) axis *= factor, left /= factor;
    }
  return packing::tile(one, n, {true, true, true});
}

// Returns the resident memory of this process, bytes.
double resident() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double size = 0, pages = 0;
  file >> size >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// Returns the bytes of the records that a step of run-dem reads and writes once (lib/PERFORMANCE.md): pairs in their
// blocks, loads of pairs, grains, and loads of grains. `pairs` are those of the list.
double records(double grains, double pairs) {
  return pairs * (sizeof(ContactBlock) / ContactBlock::size + sizeof(Load)) + grains * (sizeof(Grain) + sizeof(Load));
}

// Returns the time of reading and writing so many bytes once, in order, s: the least that a step can take whose records
// no cache holds. The least of several passes counts.
double seconds_of_memory(double bytes) {
  constexpr int passes = 9;
  std::vector<double> memory(static_cast<std::size_t>(bytes / sizeof(double)), 1.0);
  double least = 1e300;
  for (int k = 0; k < passes; ++k) {
    const auto began = std::chrono::steady_clock::now();
    for (double& value : memory) value = value * 0.5 + 1;
    benchmark::ClobberMemory();
    least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  }
  return least;
}

// Takes a step as run-dem does: servo, motion, sweep, sums, at times the stable step and the neighbour list.
void advance(Simulation& simulation, Servo& servo) {
  const AxisGoal lateral{AxisGoal::Kind::stress, 1e5, 1.0}, axial{AxisGoal::Kind::strain, 0.1, 1e-2};
  servo.drive({lateral, lateral, axial}, 3, simulation);
  simulation.step();
}

void size_of_system(benchmark::State& state) {
  const auto grains = static_cast<std::size_t>(state.range(0));
  auto start = std::make_unique<io::Snapshot>(copies(dense(support::sand(), base), grains / base));
  const double before = resident();
  Simulation simulation(*start, support::sand(), {});
  Servo servo;
  for (int k = 0; k < settling; ++k) advance(simulation, servo);
  // Memory that a run returned is used again by the next one and does not count there, so that the first run decides.
  static std::map<std::size_t, double> held;
  held.try_emplace(grains, resident() - before);
  const std::int64_t contact_steps = simulation.contact_steps();
  for (auto _ : state) advance(simulation, servo);
  const auto swept = static_cast<double>(simulation.contact_steps() - contact_steps);
  // More pairs are listed than touch, by about this share.
  constexpr double listed_over_contacts = 1.15;
  const auto contacts = static_cast<double>(simulation.measures().contacts);
  state.counters["memory_per_contact"] =
      seconds_of_memory(records(static_cast<double>(grains), listed_over_contacts * contacts)) / contacts;
  state.counters["grains"] = static_cast<double>(grains);
  state.counters["contacts"] = contacts;
  state.counters["per_contact"] = benchmark::Counter(swept, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes_per_grain"] = held.at(grains) / static_cast<double>(grains);
}

// Steps 128 systems of 400 grains in one process. Threads share the systems, and one thread steps each.
void small_systems(benchmark::State& state) {
  constexpr int systems = 128, steps = 20;
  const auto threads = static_cast<int>(state.range(0));
  std::vector<Simulation> all;
  for (int k = 0; k < systems; ++k)
    all.emplace_back(dense(support::linear_sand(), 400), support::linear_sand(), Numerics{});
  std::vector<Servo> servos(systems);
  for (auto _ : state) {
    const auto began = std::chrono::steady_clock::now();
#pragma omp parallel for schedule(dynamic) num_threads(threads)
    for (int k = 0; k < systems; ++k)
      for (int step = 0; step < steps; ++step)
        advance(all[static_cast<std::size_t>(k)], servos[static_cast<std::size_t>(k)]);
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count());
  }
  state.counters["steps"] =
      benchmark::Counter(static_cast<double>(state.iterations()) * systems * steps, benchmark::Counter::kIsRate);
}

BENCHMARK(size_of_system)
    ->Arg(1000)
    ->Arg(10'000)
    ->Arg(70'000)
    ->Arg(200'000)
    ->Arg(1'000'000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK(small_systems)->Arg(1)->Arg(2)->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace soilweave::dem
