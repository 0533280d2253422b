// Time of identification: the filter itself, and the triaxial test behind each row of an ensemble. One thread.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <benchmark/benchmark.h>

#include "calibration/assimilation.h"
#include "calibration/sampling.h"
#include "dem/run/run.h"
#include "dem/run/scenario.h"
#include "support/assemblies.h"

namespace soilweave::calibration {
namespace {

/// Weighs 2000 sets over 100 steps of 3 observables, with all tables.
void particle_filter(benchmark::State& state) {
  const auto members = static_cast<std::size_t>(state.range(0));
  Observations observed;
  observed.observables = {{"a", "1", {}}, {"b", "1", {}}, {"c", "1", {}}};
  observed.values = Matrix::Zero(100, 3);
  for (int t = 0; t < 100; ++t) observed.at.push_back(t);
  const Prior prior{{{"a", "1", "", 0, 1, Scale::linear}, {"b", "1", "", 0, 1, Scale::linear}}};
  const Ensemble ensemble = members_at(prior, halton(members, {2, 3}, 1));
  Simulated runs;
  for (Eigen::Index i = 0; i < ensemble.values.rows(); ++i) {
    runs.values.push_back(Matrix::Constant(100, 3, ensemble.values(i, 0)));
    runs.fate.push_back(Fate::used);
    runs.why.emplace_back();
  }
  for (auto _ : state) {
    const Assimilation a = assimilate(ensemble, observed, runs, {ErrorModel::Kind::uniform, {1}}, std::nullopt, {});
    benchmark::DoNotOptimize(groups_of(a));
  }
}

/// Runs isotropic compression to 0.2 MPa, then drained triaxial compression of 1000 grains to 1 % axial strain. The
/// rate counts whole tests to 10 %, which take ten times as long.
void triaxial_test(benchmark::State& state, const std::string& contact) {
  const dem::Scenario scenario = dem::read_scenario(
      contact +
          "[equilibrium]\nstress_tolerance = 1e-3\n[[stage]]\npath = \"isotropic\"\npressure = 2e5\nmax_rate = 1\n"
          "[[stage]]\npath = \"triaxial\"\nconfining_pressure = 2e5\naxial_strain = 0.01\nincrement = 0.001\n"
          "rate = 0.1\nmax_rate = 1\nreset_strain = true\n",
      "benchmark", {});
  const io::Snapshot packing = dem::prepare(support::packed(scenario.model, 1e4, 1000), scenario);
  for (auto _ : state) benchmark::DoNotOptimize(dem::run(packing, scenario, {}));
  state.counters["runs_per_hour"] =
      benchmark::Counter(360 * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
}

const std::string hertz_mindlin =
    "[contact]\nlaw = \"hertz-mindlin\"\nyoung_modulus = 4e9\npoisson_ratio = 0.33\nfriction_angle = 29\n"
    "[contact.rolling]\nstiffness = 0.13\nlimit = \"none\"\n[contact.twisting]\nstiffness = 0.13\nlimit = \"none\"\n"
    "[grains]\ndensity = 2650e3\n";
const std::string linear =
    "[contact]\nlaw = \"linear\"\nyoung_modulus = 5.4e8\nstiffness_ratio = 0.08\nfriction_angle = 30\n"
    "[grains]\ndensity = 2650e3\n";

BENCHMARK(particle_filter)->Arg(2000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(triaxial_test, hertz_mindlin, hertz_mindlin)->Unit(benchmark::kSecond)->Iterations(1);
BENCHMARK_CAPTURE(triaxial_test, linear, linear)->Unit(benchmark::kSecond)->Iterations(1);

}  // namespace
}  // namespace soilweave::calibration
