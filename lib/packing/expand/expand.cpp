// Grains that grow until they fill a container.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/expand/expand.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "analysis/measure/tessellation.h"
#include "analysis/tables/bag.h"
#include "analysis/tables/tables.h"
#include "core/error.h"
#include "dem/run/checkpoint.h"
#include "dem/run/prepare.h"
#include "dem/run/scenario.h"
#include "dem/state/bodies.h"
#include "dem/sweep/contact_sweep.h"
#include "packing/expand/tile.h"

namespace soilweave::packing {
namespace {

// Factor on the steps of a round before a measurement. In that time the container comes to hold grains that press.
constexpr std::int64_t patience = 10;

// Share of the mean overlap by which radii shrink at a time. A share of one half would separate grains that do not
// move.
constexpr double relief = 0.05;

// Difference from the asked void ratio below which a container counts as filled as asked.
constexpr double void_ratio_met = 0.02;

// Present work: rounds of growth, with friction lowered if needed; then coming to rest at full friction.
enum class Stage { growing, resting, done };

struct Standing {
  Stage stage = Stage::growing;
  std::int64_t round = 0, first = 0;               // first: step at which the stage or round began
  double growth = 1, volume = 0, measured_at = 1;  // volume: m3, at the last measurement; measured_at: growth then
  double friction = 1;                             // over its final value
  bool standing = false;                           // whether the volume stood still when grains last grew

  void archive(Archive& a) {
    a.whole("stage", stage), a.item("round", round), a.item("stage_first_step", first);
    a.item("growth", growth), a.item("delaunay_volume", volume), a.item("measured_at", measured_at);
    a.item("friction", friction), a.whole("volume_stands", standing);
  }
};

std::vector<std::int32_t> numbers_of(const std::vector<bool>& node) {
  std::vector<std::int32_t> numbers;
  for (std::size_t i = 0; i < node.size(); ++i)
    if (node[i]) numbers.push_back(static_cast<std::int32_t>(i));
  return numbers;
}

class Grower {
 public:
  Grower(const io::Snapshot& start, const dem::Model& model, const dem::Numerics& numerics, const Growth& growth,
         const ProgressReport& report, const dem::Safekeeping& safekeeping, std::optional<io::Checkpoint> last)
      : growth_(growth),
        threads_(numerics.threads),
        model_(model),
        report_(report),
        keeper_(safekeeping, start.grains.size()),
        kept_(last ? Archive(std::move(last->numbers), keeper_.part().last().string()) : Archive()),
        simulation_(last ? dem::Simulation(last->state, model, numerics, kept_)
                         : dem::Simulation(start, model, numerics)),
        node_(io::nodes(start)) {
    const double r = *std::max_element(start.grains.radius.begin(), start.grains.radius.end());
    const double u = growth.negligible * r;
    least_force_ = 2.0 / 3.0 * dem::make_contact_sweep(model)->stiffness(r, u, 1, 3).normal * u;
    if (last) {
      at_.archive(kept_), clock_.archive(simulation_, 0, kept_);
      dem::demand_kept(at_.stage >= Stage::growing && at_.stage <= Stage::done, keeper_.part().last(), "stage");
      dem::demand_kept(at_.first >= 0 && at_.first <= simulation_.steps(), keeper_.part().last(), "first step");
      dem::demand_kept(at_.round >= 0, keeper_.part().last(), "round");
      history_ = std::move(last->series);
    } else {
      dem::demand_stable(simulation_, numerics);
    }
    simulation_.set_damping(growth.damping);
    adjust();
  }

  Grown run() {
    while (at_.stage != Stage::done) go_on();
    io::Snapshot state = simulation_.snapshot();
    for (auto* rows : {&state.grains.velocity, &state.grains.angular_velocity})
      for (Vec3& v : *rows) v.setZero();
    state.step = 0, state.time = 0;
    return {std::move(state), fill_, std::move(history_), clock_.cost(simulation_, keeper_.seconds())};
  }

  io::Snapshot left() const { return simulation_.snapshot(); }

 private:
  void enter(Stage stage) {
    at_.stage = stage;
    at_.first = simulation_.steps();
    adjust();
  }

  // Sets the friction of the stage.
  void adjust() {
    const bool lowered = at_.friction < 1 && at_.stage == Stage::growing;
    simulation_.set_model(lowered ? dem::with_friction_times(at_.friction, model_) : model_);
  }

  // Completes one stage, or one round of growth.
  void go_on() {
    if (at_.stage == Stage::growing) {
      if (!presses()) return grow();
      if (!loose()) return enter(Stage::resting);
      // Radii do not grow in this round: lower friction lets grains slide, so that they press less.
      lower_friction();
      return enter(Stage::growing);
    }
    const bool rests = settle(growth_.largest_round, 0);
    measure();
    if (report_) report_(progress(), fmt::format("at rest after round {}: {}", at_.round, text()));
    // Grains that press while they move may fall apart as they come to rest.
    fell_apart_ = !held();
    if (fell_apart_) return grow();
    if (loose()) {
      lower_friction();
      return grow();
    }
    if (!rests)
      throw TargetNotReached(
          fmt::format("full, but no equilibrium after {} steps (unbalanced force {:.2e} of {:.2e}): loosen "
                      "growth.unbalanced_force",
                      growth_.largest_round, simulation_.unbalanced_force(), growth_.unbalanced_force));
    if (growth_.largest_coordination_number && fill_.coordination_number > *growth_.largest_coordination_number)
      return scale(1 - relief * fill_.overlap, Stage::resting);
    enter(Stage::done);
  }

  void grow() {
    if (at_.round >= growth_.largest_rounds) unreached();
    ++at_.round;
    scale(growth_.factor, Stage::growing);
  }

  // Multiplies the radii by `factor` and enters `stage`.
  void scale(double factor, Stage stage) {
    // Share of the way to the full container in this round.
    const double share = factor > 1 && at_.growth < growth_.filling ? std::log(factor) / std::log(growth_.filling) : 0;
    at_.growth *= factor;
    simulation_.scale_radii(factor, growth_.stretch.array().pow(share).matrix());
    enter(stage);
  }

  // Runs until equilibrium and returns true. Returns false after `most` steps, or as soon as resting grains fall apart.
  // least: least reference of the unbalanced force, N.
  bool settle(std::int64_t most, double least) {
    // Motion is stopped only during growth. At rest, stopped rattlers would keep touching grains that they no longer
    // press on.
    const std::int64_t stop = at_.stage == Stage::growing ? growth_.stop_every : 0;
    for (;;) {
      simulation_.step();
      const std::int64_t steps = simulation_.steps() - at_.first;
      if (stop > 0 && steps % stop == 0) simulation_.slow_motion(0);
      if (steps % dem::look_interval == 0 && simulation_.unbalanced_force(least) <= growth_.unbalanced_force)
        return true;
      if (steps >= most) return false;
      if (at_.stage != Stage::growing && steps % dem::report_interval == 0 &&
          mean_overlap(simulation_.snapshot()) < growth_.overlap)
        return false;
      if (report_ && steps % dem::report_interval == 0)
        report_(progress(), fmt::format("round {}, step {}, unbalanced {:.1e}; {}", at_.round, simulation_.steps(),
                                        simulation_.unbalanced_force(), text()));
      keeper_.after_step([this] { return checkpoint(); });
    }
  }

  // Returns the logarithmic share of the growth that fills the container. If that growth is unknown, returns the mean
  // overlap over its target.
  double progress() const {
    const double filling = std::log(growth_.filling);
    return std::min(1.0, filling > 0 ? std::log(at_.growth) / filling : fill_.overlap / growth_.overlap);
  }
  std::string text() const { return fmt::format("radii x {:.5f}, {}", at_.growth, fill_.text()); }

  // Returns the mean overlap of the contacts over the soil's mean radius.
  double mean_overlap(const io::Snapshot& state) const {
    double radii = 0, overlaps = 0, soil = 0;
    for (std::size_t i = 0; i < node_.size(); ++i)
      if (!node_[i]) radii += state.grains.radius[i], soil += 1;
    for (const double u : state.contacts.overlap) overlaps += u;
    return state.contacts.size() ? overlaps / static_cast<double>(state.contacts.size()) / (radii / soil) : 0;
  }

  void measure() {
    const io::Snapshot state = simulation_.snapshot();
    const analysis::BagRoom room = analysis::bag_room(state, node_, threads_);
    double ends = 0;
    for (const auto& bodies : state.contacts.bodies)
      for (const std::int32_t body : bodies) ends += !node_[static_cast<std::size_t>(body)];
    fill_.growth = at_.growth;
    fill_.volume = room.soil.volume;
    fill_.void_ratio = std::accumulate(room.cells.begin(), room.cells.end(), 0.0) / room.soil.solids - 1;
    fill_.delaunay_void_ratio = room.soil.void_ratio();
    fill_.overlap = mean_overlap(state);
    fill_.coordination_number = ends / static_cast<double>(std::count(node_.begin(), node_.end(), false));
    using analysis::put;
    put(history_, "round", "1", "growths of the radii", static_cast<double>(at_.round));
    put(history_, "step", "1", "time steps", static_cast<double>(simulation_.steps()));
    put(history_, "growth", "1", "radii over those at the start", at_.growth);
    put(history_, "delaunay_volume", "m3", "volume of the tetrahedra of the soil's centres", fill_.volume);
    put(history_, "delaunay_void_ratio", "1", "void ratio of that volume", fill_.delaunay_void_ratio);
    put(history_, "void_ratio", "1", "void ratio of the soil from its power cells", fill_.void_ratio);
    put(history_, "mean_overlap", "1", "mean overlap over the mean radius", fill_.overlap);
    put(history_, "coordination_number", "1", "2 Nc/N of the soil", fill_.coordination_number);
  }

  bool held() const {
    return fill_.overlap >= growth_.overlap && fill_.coordination_number >= growth_.coordination_number;
  }

  // Completes one round. Returns false without a measurement, else whether the volume stands still and grains press on
  // each other.
  bool presses() {
    const bool measuring = at_.round % growth_.measure_every == 0;
    settle(measuring ? patience * growth_.steps : growth_.steps, least_force_);
    if (!measuring) return false;
    const double before = at_.volume;
    measure();
    at_.volume = fill_.volume;
    // The volume of free grains grows with their radii. Held grains press on each other instead.
    const double free = 3 * std::log(at_.growth / at_.measured_at);
    if (free > 0) at_.standing = before > 0 && std::log(fill_.volume / before) < growth_.volume_tolerance * free;
    at_.measured_at = at_.growth;
    if (report_) report_(progress(), fmt::format("round {}: {}", at_.round, text()));
    return at_.standing && held();
  }

  double void_ratio() const { return fill_.void_ratio_of(growth_); }
  bool loose() const { return growth_.void_ratio && void_ratio() > *growth_.void_ratio; }

  void lower_friction() {
    at_.friction *= growth_.friction_factor;
    if (at_.friction * dem::friction(model_) < dem::lowest_friction)
      throw TargetNotReached(
          fmt::format("void ratio {:.4f} is not reached: without friction the grains press at {:.4f} ({})",
                      *growth_.void_ratio, void_ratio(), text()));
  }

  [[noreturn]] void unreached() const {
    throw TargetNotReached(fmt::format(
        "after {} rounds the grains do not fill the container: {} ({})", at_.round,
        !at_.standing ? "the Delaunay volume still grows; allow more rounds (growth.rounds) or a larger factor"
        : fell_apart_ ? "the grains fall apart as they come to rest; allow more rounds (growth.rounds)"
                      : "the mean overlap is below growth.overlap, or the coordination number below "
                        "growth.coordination_number; allow more rounds (growth.rounds)",
        text()));
  }

  io::Checkpoint checkpoint() { return dem::checkpoint_of(simulation_, clock_, keeper_.seconds(), history_, at_); }

  const Growth& growth_;
  const int threads_;
  const dem::Model& model_;
  const ProgressReport& report_;
  dem::Keeper keeper_;
  Archive kept_;
  dem::Simulation simulation_;
  std::vector<bool> node_;
  Standing at_;
  Fill fill_;
  double least_force_ = 0;   // N
  bool fell_apart_ = false;  // whether grains fell apart as they came to rest
  io::Series history_;
  dem::CostClock clock_;
};

}  // namespace

std::string Fill::text() const {
  return fmt::format("Delaunay volume {:.6f} m3, e {:.4f} ({:.4f} by that volume), mean overlap {:.2e}, Z {:.3f}",
                     volume, void_ratio, delaunay_void_ratio, overlap, coordination_number);
}

double Fill::void_ratio_of(const Growth& growth) const { return growth.by_delaunay ? delaunay_void_ratio : void_ratio; }

std::vector<Doubt> filling_doubts(const Growth& growth, const Fill& fill) {
  const double full = fill.void_ratio_of(growth);
  if (!growth.void_ratio || full > *growth.void_ratio - void_ratio_met) return {};
  const char* key = growth.by_delaunay ? "delaunay_void_ratio" : "void_ratio";
  return {{"dense",
           fmt::format("the full container has a void ratio of {:.4g}, and growth.{} asks for {:.4g}: soil of "
                       "this friction cannot fill it more loosely; ask for less, leave the key out, or give the soil "
                       "more friction while it grows",
                       full, key, *growth.void_ratio)}};
}

Growth Growth::read(Settings& table) {
  static constexpr Parameter factor{
      "factor", "1", 1, 1.01, true, "factor on the radii at equilibrium", "larger steps scatter the grains"};
  static constexpr Parameter stretch{
      "stretch", "1", 0, 1, false, "share of the stretch to the container's surface that the growing soil gets"};
  static constexpr Parameter unbalanced{
      "unbalanced_force", "1", 0, 1, true, "largest unbalanced force of an equilibrium"};
  static constexpr Parameter negligible{
      "negligible_overlap",
      "1",
      0,
      1,
      false,
      "overlap over radius; its force is the least one that residual forces are related to"};
  static constexpr Parameter damping{"damping", "1", 0, 0.999, false, "local non-viscous damping"};
  static constexpr Parameter steps{
      "steps", "1", 1, 1e9, false, "largest number of steps in a round, ten times that before a measurement"};
  static constexpr Parameter stop{"stop_every", "1",   0,
                                  1e9,          false, "steps of growth after which all motion is stopped; 0: never"};
  static constexpr Parameter volume{
      "volume_tolerance",
      "1",
      0,
      1,
      true,
      "growth of the Delaunay volume, over that of free grains, that counts as standing still"};
  static constexpr Parameter overlap{"overlap", "1",  0,
                                     1,         true, "mean overlap over the mean radius of a full container"};
  static constexpr Parameter coordination{
      "coordination_number", "1", 0, 20, true, "least coordination number of a full container at rest"};
  static constexpr Parameter most{
      "largest_coordination_number", "1", 0, 20, true, "largest coordination number of a full container at rest"};
  static constexpr Parameter target{"void_ratio", "1", 0, 100, true, "void ratio when full, by power cells"};
  static constexpr Parameter delaunay_target{
      "delaunay_void_ratio", "1", 0, 100, true, "void ratio when full, by Delaunay tetrahedra"};
  static constexpr Parameter lowering{
      "friction_factor", "1", 0, 0.999, true, "factor on the friction angle each time it is lowered"};
  static constexpr Parameter every{"measure_every", "1", 1, 1e6, false, "rounds between measurements"};
  static constexpr Parameter rounds{"rounds", "1", 1, 1e9, false, "rounds after which filling has failed"};
  Growth g;
  g.factor = table.number(factor, g.factor);
  g.stretch_share = table.number(stretch, g.stretch_share);
  g.unbalanced_force = table.number(unbalanced, g.unbalanced_force);
  g.negligible = table.number(negligible, g.negligible);
  g.damping = table.number(damping, g.damping);
  g.steps = table.integer(steps, g.steps);
  g.stop_every = table.integer(stop, g.stop_every);
  g.volume_tolerance = table.number(volume, g.volume_tolerance);
  g.overlap = table.number(overlap, g.overlap);
  g.coordination_number = table.number(coordination, g.coordination_number);
  if (table.has("largest_coordination_number")) g.largest_coordination_number = table.number(most);
  if (table.has("void_ratio")) g.void_ratio = table.number(target);
  if (table.has("delaunay_void_ratio")) {
    if (g.void_ratio) table.mistake("delaunay_void_ratio", "is given beside void_ratio: leave one of the two out");
    g.void_ratio = table.number(delaunay_target);
    g.by_delaunay = true;
  }
  g.friction_factor = table.number(lowering, g.friction_factor);
  g.measure_every = table.integer(every, g.measure_every);
  g.largest_rounds = table.integer(rounds, g.largest_rounds);
  return g;
}

Grown grow(const io::Snapshot& start, const dem::Model& model, const dem::Numerics& numerics, const Growth& growth,
           const ProgressReport& report, const dem::Safekeeping& safekeeping) {
  dem::Numerics held = numerics;
  held.clamps = {numbers_of(io::nodes(start))};
  // The energy balance is not checked: growing radii add energy without work of any boundary. Damping removes that
  // energy.
  held.limits.energy_error = std::numeric_limits<double>::infinity();
  io::Part* part = safekeeping.part;
  Grower grower(start, model, held, growth, report, safekeeping, part ? part->take_last() : std::nullopt);
  return dem::carry_out<false>(grower, part);
}

}  // namespace soilweave::packing
