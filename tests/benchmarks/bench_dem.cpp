// Time of the engine's hot loops: contact sweep by law, neighbour lists, motion, whole steps. One thread.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <map>
#include <utility>

#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/run/scenario.h"
#include "packing/expand/tile.h"
#include "support/assemblies.h"
#include "support/engine_parts.h"

namespace soilweave::dem {
namespace {

using support::linear_sand;
using support::sand;

constexpr double time_step = 1e-7;  // s; far below the stable one, so that the grains stay in place
constexpr std::size_t base = 1000;
constexpr int settling = 200;  // steps in which the grains come to rest under this friction

/// Returns dense grains at rest under 0.1 MPa, made once; more than 1000 are copies of 1000 on top of each other.
const io::Snapshot& assembly(std::size_t grains, const Model& model) {
  static std::map<std::pair<std::string_view, std::size_t>, io::Snapshot> made;
  const std::pair key(model.materials.law(), grains);
  const auto known = made.find(key);
  if (known != made.end()) return known->second;
  constexpr double slippery = 5 * support::degree;
  io::Snapshot state =
      grains > base ? packing::tile(assembly(base, model), {1, 1, static_cast<int>(grains / base)}, {true, true, true})
                    : support::packed(with_friction(model, slippery), 1e5, grains);
  return made.emplace(key, std::move(state)).first->second;
}

/// Data of the loops, after one sweep.
struct Loops : support::EngineParts {
  Loops(std::size_t grains, const Model& model) : EngineParts(assembly(grains, model), make_contact_sweep(model)) {
    motion.set_out(cell, Vec3::Zero(), 0.2, time_step, bodies);
    act(0);
  }
};

/// Reports seconds for one of `count` things, and things per second.
void tell(benchmark::State& state, const char* thing, double count) {
  const double all = count * static_cast<double>(state.iterations());
  state.counters[std::string("per_") + thing] =
      benchmark::Counter(all, benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
  state.SetItemsProcessed(static_cast<std::int64_t>(all));
}

std::size_t grains_of(const benchmark::State& state) { return static_cast<std::size_t>(state.range(0)); }

void contact_sweep(benchmark::State& state, const Model& model) {
  Loops loops(grains_of(state), model);
  for (auto _ : state) loops.act(time_step);
  tell(state, "contact", static_cast<double>(loops.sums.contacts));
}

Model without_moments() { return {std::vector<HertzMindlin::Material>{{4e9, 0.33, 29 * support::degree, {}, {}, {}}}}; }

void neighbour_search(benchmark::State& state) {
  Loops loops(grains_of(state), sand());
  for (auto _ : state) {
    Neighbours fresh(loops.bodies.largest_radius());
    fresh.rebuild(loops.bodies, loops.cell, loops.planes, loops.contacts);
  }
  tell(state, "grain", static_cast<double>(loops.bodies.size()));
}

void neighbour_filter(benchmark::State& state) {
  Loops loops(grains_of(state), sand());
  for (auto _ : state) loops.neighbours.rebuild(loops.bodies, loops.cell, loops.planes, loops.contacts);
  tell(state, "grain", static_cast<double>(loops.bodies.size()));
}

void collecting(benchmark::State& state) {
  Loops loops(grains_of(state), sand());
  for (auto _ : state)
    for (std::size_t chunk = 0; chunk < loops.contacts.chunks.size(); ++chunk)
      loops.motion.collect(chunk, loops.contacts, loops.bodies);
  tell(state, "grain", static_cast<double>(loops.bodies.size()));
}

void integration(benchmark::State& state) {
  Loops loops(grains_of(state), sand());
  for (auto _ : state) loops.motion.advance_all(loops.bodies);
  tell(state, "grain", static_cast<double>(loops.bodies.size()));
}

// Times a step as run-dem takes it: servo, motion, sweep, sums, at times the stable step and the neighbour list.
void whole_step(benchmark::State& state, const Model& model) {
  Simulation simulation(assembly(grains_of(state), model), model, {});
  Servo servo;
  const AxisGoal lateral{AxisGoal::Kind::stress, 1e5, 1.0}, axial{AxisGoal::Kind::strain, 0.1, 1e-2};
  const auto advance = [&] {
    servo.drive({lateral, lateral, axial}, 3, simulation);
    simulation.step();
  };
  for (int k = 0; k < settling; ++k) advance();
  for (auto _ : state) advance();
  tell(state, "contact", static_cast<double>(simulation.measures().contacts));
  state.counters["steps"] = benchmark::Counter(static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

BENCHMARK_CAPTURE(contact_sweep, hertz_mindlin, sand())->Arg(base)->Arg(10 * base);
BENCHMARK_CAPTURE(contact_sweep, hertz_mindlin_without_moments, without_moments())->Arg(base)->Arg(10 * base);
BENCHMARK_CAPTURE(contact_sweep, linear, linear_sand())->Arg(base)->Arg(10 * base);
BENCHMARK(neighbour_search)->Arg(base)->Arg(10 * base);
BENCHMARK(neighbour_filter)->Arg(base)->Arg(10 * base);
BENCHMARK(collecting)->Arg(base)->Arg(10 * base);
BENCHMARK(integration)->Arg(base)->Arg(10 * base);
BENCHMARK_CAPTURE(whole_step, hertz_mindlin, sand())->Arg(base)->Arg(10 * base);
BENCHMARK_CAPTURE(whole_step, linear, linear_sand())->Arg(base)->Arg(10 * base);

}  // namespace
}  // namespace soilweave::dem
