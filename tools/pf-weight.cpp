// pf-weight: parameter sets drawn from a prior, weighted by observations with a particle filter, drawn anew.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "calibration/output/options.h"
#include "calibration/output/report.h"
#include "calibration/proposal.h"
#include "calibration/sampling.h"
#include "core/cli/tool.h"
#include "core/error.h"
#include "core/progress.h"
#include "files/exchange/table.h"

namespace {

using namespace soilweave;
using calibration::Ensemble;

struct Draw {
  std::filesystem::path prior;
  std::int64_t samples = 100, first = 0, first_id = 0;
  std::string method = "halton", bases;
  calibration::Output output;

  void options(tool::Table& t) {
    t.about("pf-weight draw", "parameter sets that fill the ranges of a prior evenly");
    t.example("pf-weight draw prior.toml --samples 100 -o ensemble.h5", "an ensemble, for assimilate");
    t.example("pf-weight draw prior.toml -n 100 --tsv > sets.tsv", "a table whose rows feed GNU parallel");
    t.input(prior, "PRIOR", "parameters with their ranges and scales (TOML)");
    t.keys("a prior of pf-weight", &calibration::prior_keys);
    t.option(samples, calibration::samples_range);
    t.choice(method, "method", {"halton", "sobol", "latin-hypercube"}, "sequence, or slices at random");
    t.option(bases, "bases", "B,B,...", "bases of the Halton sequence, one a parameter; else the first primes");
    t.option(first, calibration::first_range);
    t.option(first_id, calibration::first_id_range);
    output.declare(t, "ensemble file to write");
    t.seed();
  }

  void validate() const {
    std::vector<std::string> wrong;
    if (!bases.empty() && method != "halton") wrong.push_back("--bases: only the Halton sequence has bases");
    if (first != 0 && method == "latin-hypercube") wrong.emplace_back("--first: a Latin hypercube is no sequence");
    if (!bases.empty()) try {
        calibration::parse_bases(bases);
      } catch (const UsageError& error) {
        wrong.emplace_back(error.what());
      }
    output.check(wrong, true);
  }

  void run(const tool::Invocation& invocation) const {
    const io::TextFile text = io::read_text(prior, "prior");
    const calibration::Prior ranges = calibration::parse_prior(text.text, prior.string());
    const Ensemble drawn = calibration::members_at(ranges, points(ranges.size(), invocation.seed), first_id);
    output.put(calibration::ensemble_file(drawn), calibration::members_table(drawn), "", {text.source}, invocation,
               calibration::doubts(ranges));
  }

  calibration::Matrix points(std::size_t dimension, std::uint64_t seed) const {
    const auto rows = static_cast<std::size_t>(samples);
    const auto start = static_cast<std::uint64_t>(first);
    if (method == "latin-hypercube") return calibration::latin_hypercube(rows, dimension, seed);
    if (seed != 0) throw UsageError("--seed has no effect on a sequence; for other sets of it give --first, as 101");
    if (method == "sobol") return calibration::sobol(rows, dimension, start);
    const auto chosen = bases.empty() ? calibration::prime_bases(dimension) : calibration::parse_bases(bases);
    if (chosen.size() != dimension)
      throw UsageError(
          fmt::format("--bases {}: {} for {} parameters; give one for each", bases, chosen.size(), dimension));
    return calibration::halton(rows, chosen, start);
  }
};

struct Assimilate {
  std::filesystem::path ensemble, observations, prior;
  std::string runs, table = "steps";
  bool goes_on = false;
  calibration::ComparisonOptions comparison;
  calibration::Output output;

  void options(tool::Table& t) {
    t.about("pf-weight assimilate", "weights of an ensemble's parameter sets from observations, step by step");
    t.example("pf-weight assimilate ensemble.h5 observed.tsv --runs runs.tsv --error 0.1 -o posterior.h5",
              "runs in a table of any code: id, station, observables");
    t.example("pf-weight assimilate sets.tsv observed.tsv --prior prior.toml --runs runs.tsv --least-size 0.2",
              "the error chosen so that a fifth of the sets stays effective");
    t.input(ensemble, "ENSEMBLE", "file of draw or resample, or a TSV with id and parameters");
    t.input(observations, "OBSERVATIONS", "TSV: station, observables");
    t.option(runs, "runs", "PATTERN", "run files with {id} for the number, or one TSV with ids");
    t.unrecorded("runs");  // the runs' digests are recorded instead
    comparison.declare(t);
    t.flag(goes_on, "continue", "begin with ENSEMBLE's weights, of another test of the same sets: both count");
    t.option(prior, "prior", "FILE", "prior (TOML) that the sets of a TSV were drawn from");
    t.choice(table, "table", calibration::assimilation_table_names(), "table that --tsv prints");
    t.unrecorded("table");
    output.declare(t, "ensemble with weights and tables to write");
  }

  void validate() const {
    std::vector<std::string> wrong;
    if (runs.empty()) wrong.emplace_back("no runs: give --runs, as 'runs/{id}/run.h5'");
    comparison.check(wrong);
    io::check_table(output.tsv, table, "steps", wrong);
    output.check(wrong, false);
  }

  void run(const tool::Invocation& invocation) const {
    std::vector<io::Source> sources;
    Ensemble members = calibration::read_ensemble(ensemble, prior, sources);
    const io::TextFile text = io::read_text(observations, "observations");
    sources.push_back(text.source);
    const calibration::Choice choice = comparison.choice();
    auto observed =
        calibration::observations(io::from_tsv(text.text, observations.string()), choice, observations.string());
    if (goes_on) calibration::demand_new(members.weighings, text.source, observed);
    std::vector<Doubt> doubts = calibration::doubts(members, goes_on);
    for (Doubt& doubt : comparison.doubts(observed)) doubts.push_back(std::move(doubt));
    auto simulated = calibration::simulated(runs, members.id, observed, choice, sources, members.parameters());
    const auto done =
        calibration::assimilate(std::move(members), std::move(observed), std::move(simulated), comparison.model(),
                                comparison.least_size, comparison.chosen_stations(), goes_on);
    const auto groups = calibration::groups_of(done);
    for (Doubt& doubt : calibration::doubts(done, output.tells_weights(table))) doubts.push_back(std::move(doubt));
    output.put(calibration::ensemble_file(done.ensemble, groups), calibration::table_of(done, groups, table),
               calibration::describe(done), sources, invocation, doubts);
    if (const auto remark = comparison.remark())
      Progress("pf-weight", invocation.quiet).note("pf-weight assimilate: " + *remark);
    if (const auto zero = calibration::all_zero(done)) throw TargetNotReached(*zero);
  }
};

struct Resample {
  std::filesystem::path posterior;
  std::int64_t samples = 100, components = 5;
  std::string method = "mixture";
  double prior_share = 0.1, least_size = 0.1;
  bool keep = false;
  calibration::Output output;

  void options(tool::Table& t) {
    t.about("pf-weight resample", "a next ensemble around a posterior, with weights that correct for the draw");
    t.example("pf-weight resample posterior.h5 --samples 60 --seed 1 -o next.h5", "run it, assimilate it, and so on");
    t.input(posterior, "POSTERIOR", "file of assimilate, - for standard input");
    t.option(samples, calibration::samples_range);
    t.choice(method, "method", {"mixture", "kernel"}, "Gaussians fitted to the weights, or one about each set");
    t.option(components, calibration::components_range);
    t.option(least_size, calibration::kept_size_range);
    t.option(prior_share, calibration::prior_share_range);
    t.flag(keep, "keep", "keep the earlier sets, weighted as one sample of all rounds; --tsv prints the new ones");
    output.declare(t, "ensemble file to write");
    t.refuse(
        {"components"}, [this] { return method == "kernel"; }, "beside --method kernel");
    t.refuse(
        {"keep"}, [this] { return output.file.empty(); }, "without -o, for --tsv prints the new sets");
    t.seed();
  }

  void validate() const { output.check({}, true); }

  void run(const tool::Invocation& invocation) const {
    std::vector<io::Source> sources;
    const Ensemble before = calibration::read_ensemble(posterior, {}, sources);
    calibration::demand_weights(before, posterior.string(), keep);
    double power = 1;
    const auto weight = calibration::tempered(before.weight, least_size * static_cast<double>(before.size()), power);
    const auto points = before.coordinates();
    const auto proposal = method == "kernel" ? calibration::Proposal::kernels(points, weight, prior_share)
                                             : calibration::Proposal::mixture(
                                                   points, weight, static_cast<std::size_t>(components), prior_share);
    const std::int64_t next_id = *std::max_element(before.id.begin(), before.id.end()) + 1;
    const Ensemble next =
        calibration::members_from(proposal, before.prior, static_cast<std::size_t>(samples), invocation.seed, next_id);
    output.put(calibration::ensemble_file(keep ? calibration::together(before, next) : next),
               calibration::members_table(next), "", sources, invocation, calibration::doubts(before, true));
    if (power == 1) return;
    Progress("pf-weight", invocation.quiet)
        .note(fmt::format("pf-weight resample: weights raised to the power {:.3g} to have {:.3g} of the sets effective",
                          power, least_size));
  }
};

}  // namespace

int main(int argc, char** argv) {
  Draw draw;
  Assimilate assimilate;
  Resample resample;
  return tool::start(argc, argv,
                     {"pf-weight",
                      "identify the parameters of a model from observations with a particle filter",
                      std::string(calibration::assumptions),
                      {{"draw", tool::program(draw)},
                       {"assimilate", tool::program(assimilate)},
                       {"resample", tool::program(resample)}}});
}
