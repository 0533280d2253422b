// Carries out a two-scale scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/run/run.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <utility>

#include "analysis/doubts/loading_doubts.h"
#include "core/error.h"
#include "core/memory.h"
#include "core/text/text.h"
#include "dem/run/checkpoint.h"
#include "dem/run/forecast.h"
#include "fem/run/boundary_conditions.h"
#include "fem/run/packing_doubts.h"
#include "fem/run/record.h"
#include "fem/run/rest_doubts.h"
#include "fem/run/timing.h"

namespace soilweave::fem {
namespace {

using Clock = std::chrono::steady_clock;

double since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

ModelSetup with_packings(const Scenario& scenario, const std::vector<io::Snapshot>& packings) {
  ModelSetup setup = scenario.model;
  setup.packings = packings;
  return setup;
}

// Adds everything that is doubted before the first step.
void doubt_start(const Scenario& scenario, const std::vector<io::Snapshot>& packings, const Model& model,
                 std::int64_t steps, Doubts& doubts) {
  const std::vector<Doubt> of_packings = packing_doubts(packings, scenario.model, model);
  doubts.add_all(of_packings);
  // Another stress than that of the files would miss the loads, too.
  std::vector<Doubt> of_loads;
  if (std::none_of(of_packings.begin(), of_packings.end(), [](const Doubt& d) { return d.key == "jump"; }))
    of_loads = balance_doubts(scenario.model, model);
  if (of_loads.empty()) of_loads = analysis::bare_stress_doubts(scenario.bare_stresses);
  doubts.add_all(of_loads);
  doubts.add_all(guide_doubts(model));
  doubts.add_all(timing_doubts(scenario, model, steps));
}

struct GrainWork {
  std::int64_t steps = 0, contact_steps = 0;
};

GrainWork grain_work(const Model& model) {
  GrainWork w;
  for (const auto& p : model.points()) w.steps += p->steps(), w.contact_steps += p->contact_steps();
  return w;
}

// The steps of a run and those after which an output is due: at every interval, and at the end of the duration.
class Timetable {
 public:
  Timetable(const Scenario& scenario, double dt) : interval_(std::max(1.0, scenario.model.interval / dt)) {
    double intervals = scenario.duration / scenario.model.interval;
    // Decimals of the interval are often rounded. Without this rounding, a few steps left over would become an output
    // of their own.
    if (std::abs(intervals - std::round(intervals)) < 1e-3) intervals = std::round(intervals);
    steps_ = std::max<std::int64_t>(1, std::llround(intervals * scenario.model.interval / dt));
    outputs_ = static_cast<std::int64_t>(static_cast<double>(steps_) / interval_);
    while (due(outputs_) < steps_) ++outputs_;
  }
  /// Returns the number of all steps.
  std::int64_t steps() const { return steps_; }
  /// Returns the number of outputs.
  std::int64_t outputs() const { return outputs_; }
  /// Returns the step after which an output is due. The number of an output counts from 1.
  std::int64_t due(std::int64_t output) const {
    return std::min(steps_, static_cast<std::int64_t>(std::llround(static_cast<double>(output) * interval_)));
  }

 private:
  std::int64_t steps_ = 0, outputs_ = 0;
  double interval_;  // in steps
};

class Runner {
 public:
  Runner(const Scenario& scenario, const std::vector<io::Snapshot>& packings, const ProgressReport& report,
         const dem::Safekeeping& safekeeping, const io::History& history, const Ranks& ranks, Doubts& doubts)
      : scenario_(scenario),
        ranks_(ranks),
        report_(report),
        history_(history),
        doubts_(doubts),
        keeper_(safekeeping, 1 << 20),
        model_(with_packings(scenario, packings), &ranks),
        timetable_(scenario, model_.time_step()) {
    file_.scenario = scenario.resolved;
    doubt_start(scenario, packings, model_, timetable_.steps(), doubts);
    start_ = out_of_balance(scenario.model, model_);
    std::optional<io::Checkpoint> last = keeper_.keeps() ? keeper_.part().take_last() : std::nullopt;
    go_on(std::move(last));
    start_steps_ = grain_work(model_).steps;
  }

  Outcome run() {
    tell();
    if (!going_on_) note();
    while (done_ < timetable_.outputs()) {
      if (resting_) {
        rest();
      } else {
        model_.step();
        if (++since_output_ >= timetable_.due(done_ + 1) - timetable_.due(done_)) reached();
      }
      if (model_.steps() % 16 == 0) tell();
      keep();
    }
    model_.collect();
    if (ranks_.first()) doubts_.add_all(rest_doubts(scenario_, model_, start_, doubts_.all()));
    const GrainWork work = grain_work(model_);
    file_.work = {work.steps, work.contact_steps};
    return {std::move(file_), cost()};
  }

  /// Returns a function that leaves the present state as a file for inspection.
  std::function<void(const std::filesystem::path&)> left() {
    return [this](const std::filesystem::path& path) { leave(path); };
  }

 private:
  /// Leaves the present state as a file for inspection.
  void leave(const std::filesystem::path& path) {
    try {
      record(model_, scenario_.recorded, file_);
    } catch (const Error&) {
      // A state that can no longer be measured is left out; the outputs so far are inspected instead.
    }
    std::erase_if(file_.frames, [](const io::Snapshot& s) {
      return std::any_of(s.grains.position.begin(), s.grains.position.end(),
                         [](const Vec3& x) { return !x.allFinite(); });
    });
    io::write_multiscale(path, file_, history_);
  }

  void reached() {
    since_output_ = 0;
    if (!scenario_.quasi_static) return output();
    resting_ = true;
    rested_ = 0;
    model_.relax(scenario_.quasi_static->damping);
  }

  void rest() {
    model_.step();
    const QuasiStatic& q = *scenario_.quasi_static;
    if (++rested_ > q.largest_rest)
      throw TargetNotReached(fmt::format(
          "step {}, {:.4g} s: not at rest after {} steps, the kinetic energy is {:.3g} J/m of {:.3g}: raise "
          "quasi_static.steps or kinetic_energy, or change soil_damping",
          model_.steps(), model_.time(), q.largest_rest, model_.soil().kinetic_energy(), q.kinetic_energy));
    if (model_.soil().kinetic_energy() > q.kinetic_energy) return;
    resting_ = false;
    model_.relax(std::nullopt);
    output();
  }

  void output() {
    note();
    ++done_;
    std::string failure;
    try {
      if (ranks_.first()) model_.check_steps();
    } catch (const PhysicsError& error) {
      failure = error.what();
    }
    if (failure = ranks_.told(failure); !failure.empty()) throw PhysicsError(failure);
  }

  void note() {
    model_.collect();
    if (ranks_.first()) record(model_, scenario_.recorded, file_);
  }

  // The first process decides about checkpoints. The others collect points with it until it sends `go`.
  void keep() {
    if (!ranks_.first()) {
      while (const std::int64_t word = ranks_.told(go)) {
        if (word == stop) throw Stopped("the first process has stopped");
        model_.collect();
      }
      return;
    }
    try {
      keeper_.after_step([this] {
        ranks_.told(collect);
        return checkpoint();
      });
    } catch (...) {
      ranks_.told(stop);
      throw;
    }
    ranks_.told(go);
  }

  void archive(Archive& a) {
    model_.archive(a);
    a.item("outputs_done", done_), a.item("steps_since_output", since_output_), a.item("rested", rested_);
    a.whole("resting", resting_);
    double seconds = seconds_ + since(began_);
    a.item("seconds", seconds);
    if (a.giving_back()) seconds_ = seconds;
  }

  io::Checkpoint checkpoint() {
    model_.collect();
    Archive a;
    archive(a);
    io::Checkpoint m;
    m.state.step = model_.steps();
    m.series = file_.series;
    m.numbers = a.numbers();
    m.tables = file_.groups;
    m.frames = file_.frames;
    return m;
  }

  void go_on(std::optional<io::Checkpoint> last) {
    going_on_ = ranks_.told(std::int64_t{last.has_value()}) != 0;
    if (!going_on_) return;
    std::string where = "the first process";
    if (last) {
      file_.series = std::move(last->series);
      file_.groups = std::move(last->tables);
      file_.frames = std::move(last->frames);
      where = keeper_.part().last().string();
    }
    Archive::Numbers numbers = last ? std::move(last->numbers) : Archive::Numbers();
    if (ranks_.size() > 1) numbers = Archive::unpacked(ranks_.told(last ? Archive::packed(numbers) : std::string()));
    Archive a(std::move(numbers), where);
    archive(a);
    const auto among = [](std::int64_t n, std::int64_t most) { return n >= 0 && n <= most; };
    dem::demand_kept(among(done_, timetable_.outputs()), where, "number of outputs");
    dem::demand_kept(model_.steps() >= 0 && among(since_output_, model_.steps()), where, "number of steps");
    if (resting_) model_.relax(scenario_.quasi_static->damping);
  }

  void tell() const {
    if (!report_) return;
    const double seconds = since(began_);
    const GrainWork work = grain_work(model_);
    report_(model_.time() / (static_cast<double>(timetable_.steps()) * model_.time_step()),
            fmt::format("{:.4g} s, step {}, kinetic {:.2e} J/m{}", model_.time(), model_.steps(),
                        model_.soil().kinetic_energy(),
                        work.steps > 0 ? fmt::format(", {:.3g} grain steps/s",
                                                     static_cast<double>(work.steps - start_steps_) / seconds)
                                       : ""));
  }

  std::string cost() const {
    const double seconds = seconds_ + since(began_);
    const GrainWork work = grain_work(model_);
    std::string line =
        fmt::format("{} steps of {} points in {:.3g} s", model_.steps(), model_.points().size(), seconds);
    if (work.steps > 0)
      line += fmt::format(": {:.4g} packing steps/s of {} grains, {:.4g} a thread, {:.3g} ns per contact",
                          static_cast<double>(work.steps) / seconds, model_.points().front()->grains(),
                          static_cast<double>(work.steps) / seconds / scenario_.model.threads,
                          1e9 * seconds * scenario_.model.threads / static_cast<double>(work.contact_steps));
    return line;
  }

  static constexpr std::int64_t go = 0, collect = 1, stop = 2;

  const Scenario& scenario_;
  const Ranks& ranks_;
  const ProgressReport& report_;
  const io::History& history_;
  Doubts& doubts_;
  dem::Keeper keeper_;
  Model model_;
  Timetable timetable_;
  OutOfBalance start_;  // before the first step, also in a run that goes on
  std::int64_t done_ = 0, since_output_ = 0, rested_ = 0, start_steps_ = 0;
  bool resting_ = false, going_on_ = false;
  io::MultiscaleFile file_;
  Clock::time_point began_ = Clock::now();
  double seconds_ = 0;  // seconds of earlier sessions
};

}  // namespace

Outcome run(const Scenario& scenario, const std::vector<io::Snapshot>& packings, const ProgressReport& report,
            const dem::Safekeeping& safekeeping, const io::History& history, const Ranks& ranks, Doubts& doubts) {
  Runner runner(scenario, packings, report, safekeeping, history, ranks, doubts);
  return dem::carry_out<true>(runner, safekeeping.part);
}

std::string forecast(const Scenario& scenario, const std::vector<io::Snapshot>& packings, Doubts& doubts) {
  constexpr double tried_seconds = 3;  // a step of the soil is many of the grains
  Model model(with_packings(scenario, packings));
  const double dt = model.time_step();
  const Timetable timetable(scenario, dt);
  const std::int64_t steps = timetable.steps();
  doubt_start(scenario, packings, model, steps, doubts);
  const Mesh& mesh = model.soil().mesh();
  std::string text = fmt::format(
      "{} nodes, {} elements of the shape {}, {} points, {}\ntime step {:.4g} s, stability limit {:.4g} s; {} steps, "
      "{} outputs\n",
      mesh.nodes.size(), mesh.elements.size(), name_of(mesh.shape), model.points().size(), extent_text(mesh), dt,
      model.stable_time_step(), steps, timetable.outputs());
  const std::size_t grains = model.points().front()->grains();
  if (grains > 0)
    text +=
        fmt::format("{} grains a point, {} steps of {:.4g} s each to a step of the soil: {:.3g} packing steps in all\n",
                    grains, model.substeps(), dt / static_cast<double>(model.substeps()),
                    static_cast<double>(steps * model.substeps()) * static_cast<double>(model.points().size()));
  if (model.bars())
    text += fmt::format("{} bars, steps of {:.4g} s\n", model.bars()->bars(), model.bars()->time_step());
  const dem::Trial trial = dem::try_steps(tried_seconds, [&] { model.step(); });
  const double seconds = trial.seconds / static_cast<double>(trial.steps) * static_cast<double>(steps);
  io::MultiscaleFile file;
  record(model, scenario.recorded, file);
  double numbers = static_cast<double>(file.frames.size()) * 30.0 * static_cast<double>(grains);
  for (const auto& group : file.groups) numbers += static_cast<double>(group.table.rows() * group.table.columns.size());
  const double bytes = 8 * numbers * static_cast<double>(timetable.outputs() + 1);
  text +=
      fmt::format("file about {}, memory about {}\n", bytes_text(bytes), bytes_text(1.1 * peak_memory() + 2 * bytes));
  return text + fmt::format("about {} on {} thread{}; contacts grow, and with them the time\n", time_text(seconds),
                            scenario.model.threads, scenario.model.threads == 1 ? "" : "s");
}

}  // namespace soilweave::fem
