// What a step costs and what memory it takes, from a thousand grains to a million, and how many small systems a machine
// steps at once. bench-size draws it (tests/benchmarks/size.sh).
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <memory>
#include <vector>

#include "dem/scenario.h"
#include "dem/simulation.h"
#include "support/assemblies.h"

namespace soilweave::dem {
namespace {

constexpr std::size_t base = 1000;
constexpr int settling = 40;  // steps in which copies, whose contacts are new, come to rest

// Dense grains at rest under 0.1 MPa, made once.
const io::Snapshot& dense(const Model& model, std::size_t grains) {
  constexpr double slippery = 5 * testing::degree;
  static const io::Snapshot spheres = testing::packed(with_friction(testing::sand(), slippery), 1e5, base);
  static const io::Snapshot few = testing::packed(with_friction(testing::linear_sand(), slippery), 1e5, 400);
  return model.materials.index() == 0 && grains == base ? spheres : few;
}

// So many copies in a nearly cubic array, copy after copy.
io::Snapshot copies(const io::Snapshot& one, std::size_t count) {
  io::Snapshot all = one;
  all.contacts = {};  // of one copy; those of all are found again
  std::array<std::size_t, 3> n{1, 1, 1};
  for (std::size_t left = count; left > 1;)
    for (std::size_t& axis : n) {
      const std::size_t factor = left % 10 == 0 ? 10 : left;
      if (left > 1) axis *= factor, left /= factor;
    }
  io::GrainsRecord& g = all.grains;
  const io::GrainsRecord& from = one.grains;
  for (std::size_t copy = 1; copy < count; ++copy) {
    const Vec3 place(static_cast<double>(copy % n[0]), static_cast<double>(copy / n[0] % n[1]),
                     static_cast<double>(copy / n[0] / n[1]));
    for (std::size_t i = 0; i < from.size(); ++i) {
      g.body_id.push_back(static_cast<std::int64_t>(g.size()));
      g.position.emplace_back(from.position[i] + one.cell.matrix * place);
      g.orientation.push_back(from.orientation[i]);
      g.velocity.push_back(from.velocity[i]);
      g.angular_velocity.push_back(from.angular_velocity[i]);
      g.radius.push_back(from.radius[i]);
      g.mass.push_back(from.mass[i]);
      g.material_id.push_back(0);
      g.copy_id.push_back(0);
    }
  }
  for (int a = 0; a < 3; ++a) all.cell.matrix.col(a) *= static_cast<double>(n[static_cast<std::size_t>(a)]);
  return all;
}

// Bytes this process holds.
double resident() {
  malloc_trim(0);
  std::ifstream file("/proc/self/statm");
  double size = 0, pages = 0;
  file >> size >> pages;
  return pages * static_cast<double>(sysconf(_SC_PAGESIZE));
}

// A step as run-dem takes it: servo, motion, sweep, sums, now and then the stable step and the neighbour list.
void advance(Simulation& simulation, Servo& servo) {
  const AxisGoal lateral{AxisGoal::Kind::stress, 1e5, 1.0}, axial{AxisGoal::Kind::strain, 0.1, 1e-2};
  servo.drive({lateral, lateral, axial}, 3, simulation);
  simulation.step();
}

void size_of_system(benchmark::State& state) {
  const auto grains = static_cast<std::size_t>(state.range(0));
  auto start = std::make_unique<io::Snapshot>(copies(dense(testing::sand(), base), grains / base));
  const double before = resident();
  Simulation simulation(*start, testing::sand(), {});
  Servo servo;
  for (int k = 0; k < settling; ++k) advance(simulation, servo);
  const double held = resident() - before;
  const std::int64_t contact_steps = simulation.contact_steps();
  for (auto _ : state) advance(simulation, servo);
  const auto swept = static_cast<double>(simulation.contact_steps() - contact_steps);
  state.counters["grains"] = static_cast<double>(grains);
  state.counters["contacts"] = static_cast<double>(simulation.measures().contacts);
  state.counters["per_contact"] = benchmark::Counter(swept, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.counters["bytes_per_grain"] = held / static_cast<double>(grains);
}

// 128 systems of 400 grains in one process, shared out among threads, each stepped by one.
void small_systems(benchmark::State& state) {
  constexpr int systems = 128, steps = 20;
  const auto threads = static_cast<int>(state.range(0));
  std::vector<Simulation> all;
  for (int k = 0; k < systems; ++k)
    all.emplace_back(dense(testing::linear_sand(), 400), testing::linear_sand(), Numerics{});
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
