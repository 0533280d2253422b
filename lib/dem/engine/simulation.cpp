// A granular assembly in motion.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem/contact/contacts_record.h"
#include "dem/engine/described.h"
#include "dem/engine/energy_term.h"
#include "dem/engine/guard.h"
#include "dem/engine/ledger.h"
#include "dem/engine/motion.h"
#include "dem/engine/step_passes.h"
#include "dem/state/overlap.h"
#include "dem/sweep/contact_sweep.h"
#include "dem/sweep/neighbours.h"
#include "dem/sweep/step_bound.h"

namespace soilweave::dem {
namespace {

// Steps between two evaluations of the stiffness, which changes little in a step. With 16 steps a compressed cloud of
// grains became unstable. The calm interval suffices while few contacts form and overlaps hardly grow, and without
// yarns, which tie light nodes to heavy grains.
constexpr std::int64_t stiffness_interval = 8, calm_stiffness_interval = 32;
constexpr double calm_contact_growth = 1.01, calm_overlap_growth = 1.05;
// Steps between two passes of the guards over the grains.
constexpr std::int64_t guard_interval = 256;
// Growth of the largest overlap that calls for an earlier evaluation. Hertzian stiffness grows with the root of the
// overlap, so the step is too long by a factor of at most 2^(1/4) = 1.19. The default safety of 0.8 covers it.
constexpr double overlap_growth = 2;
// Greatest motion of a grain or plane in a step, over the smallest radius.
constexpr double largest_move = 1e-2;

}  // namespace

struct Simulation::Impl {
  Impl(const io::Snapshot& state, const Model& model, const Numerics& settings, Archive* kept)
      : numerics(settings),
        record(described(state, model)),
        bodies(state.grains),
        cell(state.cell, state.grains.dimension),
        planes(state.planes),
        yarns(state.yarns, bodies.size(), model.geotextiles),
        motion(bodies.size(), settings.threads),
        sweep(make_contact_sweep(model)),
        neighbours(bodies.largest_radius(), sweep->range()),
        guard(settings, bodies, cell, planes, sweep->range()),
        smallest(bodies),
        time(state.time),
        steps(state.step) {
    bodies.set_fabric(yarns.fabric_of());
    smallest = Smallest(bodies);  // nodes do not rotate
    dashpots = bound_to_come(*sweep, bodies, smallest).dashpots;
    contacts.threads = numerics.threads;
    contacts.keep_own(sweep->own_history());
    list_recorded(state.contacts, bodies, contacts);
    record.contacts = {};
    record.grains = Bodies::identities(std::move(record.grains));
    neighbours.rebuild(bodies, cell, planes, contacts);
    for (const auto& held : numerics.clamps) clamps.all.push_back({held});
    if (kept) {
      yarns.run(time, numerics.threads, bodies);  // restores lengths and directions, which no checkpoint keeps
      archive(*kept);
    } else {
      begin();
    }
  }

  Scene scene() { return {bodies, cell, planes}; }

  void begin() {
    meet();
    for (std::size_t k = 0; k < clamps.all.size(); ++k) clamps.set_velocity(k, Vec3::Zero(), bodies);
    clamps.take(numerics.gravity, 0, bodies);
    measure();
    if (const DeepestContact c = deepest(); c.relative > numerics.limits.overlap)
      throw DataError(description(c) + ": too deep for a contact of stiff grains: check positions, radii and cell");
    energies.start(assembly(0));
  }

  // Computes forces and the stable step at the present positions.
  void meet() {
    StepPasses passes(false, contacts, motion, bodies);
    Vec3 stiffness;
    act(0, passes, &stiffness);
    estimate_step(stiffness);
  }

  // Computes forces of contacts and yarns after a step dt, and the contacts' stiffness if requested.
  void act(double dt, StepPasses& passes, Vec3* stiffness) {
    sums = sweep->run(scene(), dt, contacts, passes, stiffness);
    sums.force_branch += motion.collected();
    time += dt;
    if (yarns.any()) yarns.run(time, numerics.threads, bodies);
    if (stress_has_yarns()) sums.force_branch += yarns.sums().force_branch;
  }
  bool stress_has_yarns() const { return yarns.any() && cell.any_periodic(); }  // open cells have no faces

  void archive(Archive& a) {
    dem::archive(a, bodies);
    if (bodies.dimension == 2) archive_shear_forces(a);
    a.item("damping", numerics.damping);
    a.item("stable_time_step", stable), a.item("time_step", time_step);
    a.item("overlap_at_estimate", estimated_at), a.item("overlap_at_look", looked_at);
    a.item("contacts_at_estimate", contacts_at_estimate), a.whole("rotation_bounds", rotation_bounds);
    a.item("contact_steps", contact_steps);
    dem::archive(a, sums);
    dem::archive(a, measures);
    energies.archive(a);
    guard.archive(a);
    for (Clamp& c : clamps.all) a.item(fmt::format("clamp_velocity_{}", &c - clamps.all.data()), c.velocity);
    for (Clamp& c : clamps.all) a.item(fmt::format("clamp_force_{}", &c - clamps.all.data()), c.force);
  }

  // Keeps the shear forces of disks as numbers: as vectors of a record they would lose bits.
  void archive_shear_forces(Archive& a) {
    std::vector<double> forces = shear_forces_of_disks(contacts);
    a.sized("shear_force", forces);
    if (a.giving_back()) set_shear_forces_of_disks(forces, contacts);
  }

  void step() {
    const double dt = time_step;
    StepWatch clock(times, steps);
    const SweepSums before = sums;
    const Mat3 gradient = cell.velocity_gradient();
    const bool look_at_stiffness =
        numerics.watch_stiffness &&
        (rotation_bounds || (steps + 1) % (calm() ? calm_stiffness_interval : stiffness_interval) == 0);
    motion.set_out(cell, numerics.gravity, numerics.damping, dt, bodies);
    PassTime beside_sweep;
    StepPasses passes(list_outlasts_step(), contacts, motion, bodies, clock.on() ? &beside_sweep : nullptr);
    if (!passes.moving()) motion.advance_all(bodies);
    cell.advance(dt);
    planes.advance(dt);
    clock.lap(Phase::integration);
    if (!passes.moving() && neighbours.outdated(bodies, motion.advanced().skin_rate, fastest_plane(), gradient, dt))
      neighbours.rebuild(bodies, cell, planes, contacts);
    clock.lap(Phase::neighbours);
    Vec3 stiffness;
    act(dt, passes, look_at_stiffness ? &stiffness : nullptr);
    ++steps;
    clock.lap(Phase::contacts);
    clock.shift(beside_sweep.seconds() / numerics.threads, Phase::contacts, Phase::integration);
    const MotionSums moved = motion.advanced();
    if (passes.moving()) neighbours.outdated(bodies, moved.skin_rate, 0, gradient, dt);
    const double clamped = clamps.take(numerics.gravity, dt, bodies);
    clock.lap(Phase::integration);
    contact_steps += sums.contacts;

    energies.add({dt, bodies, gradient, before, sums, moved, yarns.sums(), clamped});
    measure();
    watch(moved.damping);
    if (look_at_stiffness)
      estimate_step(stiffness);
    else if (numerics.watch_stiffness && outgrown(overlap_growth))
      estimate_step(sweep->stiffen(scene(), contacts));
    limit_move(std::max(moved.fastest, fastest_plane()));
    clock.lap(Phase::contacts);
  }

  // Returns whether no new list will be needed, so that grains may move while their pairs are swept. Yarns and clamps
  // act after forces are collected, so the speed of their grains cannot be foreseen.
  bool list_outlasts_step() const {
    return planes.all.empty() && !yarns.any() && clamps.all.empty() &&
           neighbours.outlast(motion.gain_bound(smallest.mass), cell.velocity_gradient(), time_step);
  }

  void measure() {
    measures.stress = symmetric(sums.force_branch) / cell.volume();
    measures.contacts = sums.contacts;
  }

  double unbalanced_force(double least = 0) {
    const auto carriers = static_cast<double>(sums.contacts + yarns.sums().taut);
    const double mean_contact =
        std::max(least, carriers > 0 ? (force_sum(contacts) + yarns.sums().tension) / carriers : 0);
    const double mean_resultant = motion.resultants(numerics.gravity, bodies) / static_cast<double>(bodies.size());
    return mean_contact > 0 ? mean_resultant / mean_contact : (mean_resultant > 0 ? 1.0 : 0.0);
  }

  // damped: the energy that local damping took in this step, J.
  void watch(double damped) {
    guard.finite(steps, bodies, sums.force_branch.sum() + sums.tangential_work, damped);
    if (sums.largest_overlap > alarm()) look_at_overlap();
    if (steps % stiffness_interval == 0) guard.room(steps, cell);
    if (steps % guard_interval != 0) return;
    guard.balance(steps, energies_now());
    guard.escape(steps, bodies);
  }

  // Overlap, m, beyond which grains are checked one by one: the limit for the smallest radius. Larger grains may
  // overlap more, so a check may pass. The next check then waits until the overlap has grown by a tenth.
  double alarm() const { return std::max(numerics.limits.overlap * smallest.radius, 1.1 * looked_at); }
  void look_at_overlap() {
    looked_at = sums.largest_overlap;
    if (const DeepestContact c = deepest(); c.relative > numerics.limits.overlap)
      guard.too_deep(steps, description(c), unbalanced_force(), measures);
  }

  DeepestContact deepest() const { return deepest_of(contacts_record(), bodies); }

  // Returns the assembly with velocities that lag half of `dt` behind its positions.
  AssemblyState assembly(double dt) {
    return {bodies,           cell, planes,          contacts, yarns, sweep->stored(scene(), contacts),
            numerics.gravity, dt,   numerics.threads};
  }
  Energies energies_now() { return energies.at(assembly(time_step)); }

  // Returns the stability limit, s, from the grains' stiffnesses, which are left zero.
  double stability_limit() {
    const StepBound to_come = bound_to_come(*sweep, bodies, smallest);
    const double nodes = std::sqrt(2.0 / yarns.stiffness_over_mass(bodies, contacts));  // infinite without yarns
    const double others = std::min({to_come.translation, nodes, motion.stable_time_step(contacts, bodies)});
    rotation_bounds = to_come.rotation < others;
    return dashpots * std::min(others, to_come.rotation);
  }

  // Returns whether the largest overlap is more than `times` its value at the last estimate of the step.
  bool outgrown(double times) const {
    return sums.largest_overlap > times * std::max(estimated_at, reference_overlap * smallest.radius);
  }
  bool calm() const {
    return !yarns.any() && !outgrown(calm_overlap_growth) &&
           static_cast<double>(sums.contacts) <= calm_contact_growth * static_cast<double>(contacts_at_estimate);
  }

  // Estimates the step from the grains' stiffnesses. affine: their affine sum over the contacts.
  void estimate_step(const Vec3& affine) {
    estimated_at = sums.largest_overlap, contacts_at_estimate = sums.contacts;
    const double limit = stability_limit();
    stable = numerics.time_step ? *numerics.time_step : numerics.time_step_safety * limit;
    time_step = stable;
    const Vec3 of_yarns = stress_has_yarns() ? yarns.affine_stiffness(numerics.threads) : Vec3(Vec3::Zero());
    measures.axial_stiffness = (affine + of_yarns) / cell.volume();
  }

  void limit_move(double fastest) {
    time_step = stable;
    if (!numerics.time_step && fastest * stable > largest_move * smallest.radius)
      time_step = largest_move * smallest.radius / fastest;
  }

  double fastest_plane() const {
    double v = 0;
    for (const Plane& p : planes.all) v = std::max(v, p.velocity.norm());
    return v;
  }

  io::ContactsRecord contacts_record() const { return dem::contacts_record(contacts, bodies, cell, planes); }

  Numerics numerics;
  io::Snapshot record;  // identities, and data that the engine never changes
  Bodies bodies;
  Cell cell;
  Planes planes;
  Yarns yarns;
  Clamps clamps;
  Motion motion;
  std::unique_ptr<ContactSweep> sweep;
  Neighbours neighbours;
  Guard guard;
  Contacts contacts;
  SweepSums sums;
  Measures measures;
  Energies energies;
  Smallest smallest;
  double dashpots = 1;  // share of the stable step that they leave
  double stable = 0, time_step = 0, time = 0;
  double estimated_at = 0;                // largest overlap at the last estimate of the step, m
  std::int64_t contacts_at_estimate = 0;  // number of contacts at the last estimate
  // Whether rolling or twisting in contacts still to form bounds the step. A new contact then has its full stiffness at
  // once, so the stiffness is evaluated in every step.
  bool rotation_bounds = false;
  double looked_at = 0;  // largest overlap at the last check against the grains' own radii, m
  std::int64_t steps = 0, contact_steps = 0;
  StepTimes times;
};

Simulation::Simulation(const io::Snapshot& state, const Model& model, const Numerics& numerics)
    : impl_(std::make_unique<Impl>(state, model, numerics, nullptr)) {}
Simulation::Simulation(const io::Snapshot& state, const Model& model, const Numerics& numerics, Archive& kept)
    : impl_(std::make_unique<Impl>(state, model, numerics, &kept)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::step() { impl_->step(); }
void Simulation::archive(Archive& archive) const { impl_->archive(archive); }
std::int64_t Simulation::contact_steps() const { return impl_->contact_steps; }
const StepTimes& Simulation::step_times() const { return impl_->times; }
const Measures& Simulation::measures() const { return impl_->measures; }
Energies Simulation::energies() const { return impl_->energies_now(); }
double Simulation::time_step() const { return impl_->time_step; }
double Simulation::dashpot_share() const { return impl_->dashpots; }
double Simulation::unbalanced_force(double least) const { return impl_->unbalanced_force(least); }
double Simulation::largest_overlap() const { return impl_->deepest().relative; }
double Simulation::stability_limit() {
  impl_->sweep->stiffen(impl_->scene(), impl_->contacts);
  return impl_->stability_limit();
}
double Simulation::time() const { return impl_->time; }
std::int64_t Simulation::steps() const { return impl_->steps; }
const Cell& Simulation::cell() const { return impl_->cell; }
const Bodies& Simulation::bodies() const { return impl_->bodies; }

void Simulation::set_reference() { impl_->cell.set_reference(); }
void Simulation::set_velocity_gradient(const Mat3& gradient) { impl_->cell.set_velocity_gradient(gradient); }
void Simulation::set_model(const Model& model) {
  impl_->sweep = make_contact_sweep(model);
  impl_->dashpots = bound_to_come(*impl_->sweep, impl_->bodies, impl_->smallest).dashpots;
  impl_->yarns.set_curves(model.geotextiles);
}
void Simulation::set_plane_velocity(std::size_t plane, const Vec3& v) { impl_->planes.all[plane].velocity = v; }
const Planes& Simulation::planes() const { return impl_->planes; }
std::vector<PlateLoad> Simulation::plate_loads() const {
  return dem::plate_loads(impl_->contacts, impl_->bodies, impl_->planes);
}
void Simulation::set_clamp_velocity(std::size_t clamp, const Vec3& velocity) {
  impl_->energies.add({.supplied = impl_->clamps.set_velocity(clamp, velocity, impl_->bodies)});
}
const std::vector<Clamp>& Simulation::clamps() const { return impl_->clamps.all; }
const YarnSums& Simulation::yarns() const { return impl_->yarns.sums(); }
double Simulation::kinetic_energy() const {
  return dem::kinetic_energy(impl_->bodies, impl_->numerics.gravity, impl_->time_step, impl_->numerics.threads);
}
double Simulation::kinetic_energy_of_acted_on() const {
  return dem::kinetic_energy_of_acted_on(impl_->bodies, impl_->numerics.gravity, impl_->time_step,
                                         impl_->numerics.threads);
}
void Simulation::set_damping(double damping) { impl_->numerics.damping = damping; }

void Simulation::scale_radii(double factor, const Vec3& stretch) {
  Impl& s = *impl_;
  const Energies before = s.energies_now();
  s.bodies.scale_radii(factor, stretch);
  s.smallest = Smallest(s.bodies);
  s.neighbours = Neighbours(s.bodies.largest_radius(), s.sweep->range());
  s.neighbours.rebuild(s.bodies, s.cell, s.planes, s.contacts);
  s.meet();
  s.clamps.take(s.numerics.gravity, 0, s.bodies);
  s.measure();
  const Energies after = s.energies_now();
  s.energies.add({.supplied = after.stored() - before.stored(),
                  .numerical = before.sum(EnergyRole::numerical) - after.sum(EnergyRole::numerical)});
}

void Simulation::slow_motion(double share) {
  const Slowed slowed = slow(impl_->bodies, share, impl_->numerics.gravity, impl_->time_step, impl_->numerics.threads);
  impl_->energies.add({.damped = slowed.energy_before - slowed.energy_after});
}

void Simulation::change_velocities(const std::function<void(Bodies&)>& change) {
  const double before = kinetic_energy();
  change(impl_->bodies);
  const double gained = kinetic_energy() - before;
  impl_->energies.add(gained > 0 ? Intervention{.supplied = gained} : Intervention{.damped = -gained});
}

io::Snapshot Simulation::snapshot() const {
  io::Snapshot s = impl_->record;
  s.step = impl_->steps;
  s.time = impl_->time;
  s.cell = impl_->cell.record();
  impl_->bodies.store(s.grains);
  s.contacts = impl_->contacts_record();
  s.planes = impl_->planes.record();
  if (impl_->yarns.any()) s.yarns = impl_->yarns.record();
  return s;
}

}  // namespace soilweave::dem
