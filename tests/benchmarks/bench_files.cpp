// Time to write a state to a file and read it, with checks, digest and sync to the disk.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include <filesystem>

#include "support/states.h"

namespace soilweave::io {
namespace {

Snapshot chain(const benchmark::State& state) { return test::example_state(static_cast<std::size_t>(state.range(0))); }

void tell(benchmark::State& state, const std::filesystem::path& path) {
  state.SetItemsProcessed(state.iterations() * state.range(0));  // grains
  state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(std::filesystem::file_size(path)));
}

void write_state(benchmark::State& state) {
  const test::Folder folder;
  const Snapshot snapshot = chain(state);
  for (auto _ : state) write_packing(folder / "state.h5", snapshot, {});
  tell(state, folder / "state.h5");
}

void read_state_back(benchmark::State& state) {
  const test::Folder folder;
  write_packing(folder / "state.h5", chain(state), {});
  for (auto _ : state) benchmark::DoNotOptimize(read_state(folder / "state.h5"));
  tell(state, folder / "state.h5");
}

BENCHMARK(write_state)->Arg(1000)->Arg(10000)->UseRealTime();
BENCHMARK(read_state_back)->Arg(1000)->Arg(10000)->UseRealTime();

}  // namespace
}  // namespace soilweave::io
