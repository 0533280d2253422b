// A granular assembly in motion.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/simulation.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "dem/contact_sweep.h"
#include "dem/motion.h"
#include "dem/neighbours.h"

namespace soilweave::dem {
namespace {

// The list's skin over the largest radius: rebuilds against candidates (measured flat between 0.03 and 0.1 at 1000
// grains).
constexpr double relative_skin = 0.05;
// A pair overlapping by more than this fraction of the smaller radius is no longer a contact of stiff grains.
constexpr double overlap_guard = 0.5;
// Steps between two looks at the stiffness: it changes slowly against the step it limits.
constexpr std::int64_t stiffness_interval = 8;
// Overlap over radius of the contact that bounds the step while no stiffer one exists.
constexpr double reference_overlap = 1e-4;
// The fastest grain moves at most this fraction of the smallest radius in a step.
constexpr double largest_move = 1e-2;

}  // namespace

struct Simulation::Impl {
  Impl(const io::Snapshot& state, const Model& model, const Numerics& settings)
      : numerics(settings),
        record(state),
        bodies(state.grains),
        cell(state.cell, state.grains.dimension),
        planes(state.planes),
        neighbours(relative_skin * bodies.largest_radius()),
        sweep(make_contact_sweep(model)),
        time(state.time),
        steps(state.step) {
    restore(state.contacts);
    neighbours.rebuild(bodies, cell, planes, contacts);
    sums = sweep->run(bodies, cell, planes, 0.0, numerics.threads, contacts);
    measure(gather(contacts, numerics.gravity, numerics.threads, bodies));
    estimate_step();
    energy_of_contacts();
    energies.initial = kinetic_energy(bodies, numerics.gravity, 0.0) + energies.elastic();
  }

  void restore(const io::ContactsRecord& r) {
    contacts.resize(r.size());
    for (std::size_t k = 0; k < r.size(); ++k) {
      contacts.clear(k);
      contacts.first[k] = r.bodies[k][0], contacts.second[k] = r.bodies[k][1], contacts.image[k] = r.image[k];
      contacts.touching[k] = 1;
      const auto v3 = [](const Vec3& v) { return V3<double>{v.x(), v.y(), v.z()}; };
      contacts.normal[k] = v3(r.normal[k]);
      contacts.memory[k] = {v3(r.shear_force[k]), v3(r.rolling_moment[k]), r.twisting_moment[k]};
    }
  }

  void step() {
    const double dt = time_step;
    const MotionSums motion = advance(cell, numerics.gravity, numerics.damping, dt, numerics.threads, bodies);
    const Mat3 force_branch_before = sums.force_branch;
    const Mat3 gradient = cell.velocity_gradient();
    cell.advance(dt);
    planes.advance(dt);
    if (neighbours.outdated(motion.fastest + fastest_plane(), gradient, bodies.largest_radius(), dt))
      neighbours.rebuild(bodies, cell, planes, contacts);
    sums = sweep->run(bodies, cell, planes, dt, numerics.threads, contacts);
    const double resultants = gather(contacts, numerics.gravity, numerics.threads, bodies);
    ++steps;
    time += dt;

    account(motion, dt, force_branch_before, gradient);
    measure(resultants);
    guard();
    if (steps % stiffness_interval == 0) estimate_step();
    limit_move(motion.fastest);
  }

  void account(const MotionSums& motion, double dt, const Mat3& force_branch_before, const Mat3& gradient) {
    const double stored_before = energies.elastic_shear + energies.elastic_rolling + energies.elastic_twisting;
    energies.law += stored_before - (sums.shear_before + sums.rolling_before + sums.twisting_before) + sums.kinematic;
    energies.frictional += sums.frictional;
    energies.rolling_plastic += sums.rolling_plastic;
    energies.viscous += sums.viscous;
    energies.damping += motion.damping;
    energies.gravity_work += motion.gravity_work;
    energies.boundary_work +=
        sums.plane_work - 0.5 * dt * (force_branch_before + sums.force_branch).cwiseProduct(gradient).sum();
    energy_of_contacts();
  }

  void energy_of_contacts() {
    energies.elastic_normal = sums.elastic_normal, energies.elastic_shear = sums.elastic_shear;
    energies.elastic_rolling = sums.elastic_rolling, energies.elastic_twisting = sums.elastic_twisting;
  }

  // resultants: sum over the grains of |resultant|, N.
  void measure(double resultants) {
    const double volume = cell.volume();
    measures.stress = symmetric(sums.force_branch) / volume;
    measures.axial_stiffness = sums.axial_stiffness / volume;
    measures.contacts = sums.contacts;
    measures.largest_overlap = sums.largest_relative_overlap;
    const double mean_contact = sums.contacts ? sums.force_magnitude / static_cast<double>(sums.contacts) : 0;
    const double mean_resultant = resultants / static_cast<double>(bodies.size());
    measures.unbalanced_force = mean_contact > 0 ? mean_resultant / mean_contact : (mean_resultant > 0 ? 1.0 : 0.0);
  }

  void guard() const {
    if (!std::isfinite(sums.force_magnitude) || !std::isfinite(energies.elastic_normal))
      throw PhysicsError(fmt::format(
          "step {}: a force is not a number: the time step is too large for the stiffness, or the input overlaps",
          steps));
    if (sums.largest_relative_overlap > overlap_guard) {
      std::size_t worst = 0;
      for (std::size_t k = 1; k < contacts.size(); ++k)
        if (contacts.overlap[k] > contacts.overlap[worst]) worst = k;
      throw PhysicsError(
          fmt::format("step {}: grains {} and {} overlap by {:.3g} m, {:.0f} % of the radius: lower the time step or "
                      "the loading rate, or check the packing",
                      steps, contacts.first[worst], contacts.second[worst], contacts.overlap[worst],
                      100 * sums.largest_relative_overlap));
    }
  }

  void estimate_step() {
    if (numerics.time_step) {
      stable = *numerics.time_step;
    } else {
      const double r = bodies.smallest_radius();
      const double m = *std::min_element(bodies.mass.begin(), bodies.mass.end());
      const double reference = std::sqrt(2.0 * m / (4.0 * sweep->stiffness(r, reference_overlap * r)));
      stable = numerics.time_step_safety * std::min(reference, stable_time_step(bodies, contacts, numerics.threads));
    }
    time_step = stable;
  }

  void limit_move(double fastest) {
    time_step = stable;
    if (!numerics.time_step && fastest * stable > largest_move * bodies.smallest_radius())
      time_step = largest_move * bodies.smallest_radius() / fastest;
  }

  double fastest_plane() const {
    double v = 0;
    for (const Plane& p : planes.all) v = std::max(v, p.velocity.norm());
    return v;
  }

  io::ContactsRecord contacts_record() const;

  Numerics numerics;
  io::Snapshot record;  // identities and whatever the engine does not change
  Bodies bodies;
  Cell cell;
  Planes planes;
  Neighbours neighbours;
  std::unique_ptr<ContactSweep> sweep;
  Contacts contacts;
  SweepSums sums;
  Measures measures;
  Energies energies;
  double stable = 0, time_step = 0, time = 0;
  std::int64_t steps = 0;
};

io::ContactsRecord Simulation::Impl::contacts_record() const {
  io::ContactsRecord r;
  const auto vec3 = [](const V3<double>& v) { return Vec3(v.x, v.y, v.z); };
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (!contacts.touching[k]) continue;
    r.bodies.push_back({contacts.first[k], contacts.second[k]});
    r.image.push_back(contacts.image[k]);
    r.normal.push_back(vec3(contacts.normal[k]));
    r.branch_vector.push_back(vec3(contacts.branch[k]));
    r.overlap.push_back(contacts.overlap[k]);
    r.normal_force.push_back(contacts.normal_force[k]);
    r.shear_force.push_back(vec3(contacts.memory[k].shear));
    r.rolling_moment.push_back(vec3(contacts.memory[k].rolling));
    r.twisting_moment.push_back(contacts.memory[k].twisting);
    r.sliding.push_back(contacts.sliding[k]);
  }
  return r;
}

Simulation::Simulation(const io::Snapshot& state, const Model& model, const Numerics& numerics)
    : impl_(std::make_unique<Impl>(state, model, numerics)) {}
Simulation::Simulation(Simulation&&) noexcept = default;
Simulation& Simulation::operator=(Simulation&&) noexcept = default;
Simulation::~Simulation() = default;

void Simulation::step() { impl_->step(); }
const Measures& Simulation::measures() const { return impl_->measures; }

Energies Simulation::energies() const {
  Energies e = impl_->energies;
  e.kinetic = kinetic_energy(impl_->bodies, impl_->numerics.gravity, impl_->time_step);
  return e;
}

double Simulation::time_step() const { return impl_->time_step; }
double Simulation::time() const { return impl_->time; }
std::int64_t Simulation::steps() const { return impl_->steps; }
const Mat3& Simulation::cell_matrix() const { return impl_->cell.matrix(); }
const Mat3& Simulation::deformation_gradient() const { return impl_->cell.deformation_gradient(); }
double Simulation::volume() const { return impl_->cell.volume(); }
double Simulation::solid_volume() const { return impl_->bodies.solid_volume(); }
double Simulation::void_ratio() const { return volume() / solid_volume() - 1; }

Vec3 Simulation::strain() const { return -deformation_gradient().diagonal().array().log().matrix(); }

void Simulation::set_reference() { impl_->cell.set_reference(); }
void Simulation::set_velocity_gradient(const Mat3& gradient) { impl_->cell.set_velocity_gradient(gradient); }
void Simulation::set_model(const Model& model) { impl_->sweep = make_contact_sweep(model); }
void Simulation::set_damping(double damping) { impl_->numerics.damping = damping; }

void Simulation::scale_radii(double factor) {
  impl_->bodies.scale_radii(factor);
  Impl& s = *impl_;
  const double before = s.energies.elastic();
  s.neighbours = Neighbours(relative_skin * s.bodies.largest_radius());
  s.neighbours.rebuild(s.bodies, s.cell, s.planes, s.contacts);
  s.sums = s.sweep->run(s.bodies, s.cell, s.planes, 0.0, s.numerics.threads, s.contacts);
  s.measure(gather(s.contacts, s.numerics.gravity, s.numerics.threads, s.bodies));
  s.energy_of_contacts();
  s.energies.boundary_work += s.energies.elastic() - before;
  s.estimate_step();
}

void Simulation::stop_motion() {
  for (auto& v : impl_->bodies.velocity) v = {0, 0, 0};
  for (auto& w : impl_->bodies.angular_velocity) w = {0, 0, 0};
}

io::Snapshot Simulation::snapshot() const {
  io::Snapshot s = impl_->record;
  s.step = impl_->steps;
  s.time = impl_->time;
  s.cell = impl_->cell.record();
  impl_->bodies.store(s.grains);
  s.contacts = impl_->contacts_record();
  s.planes = impl_->planes.record();
  return s;
}

}  // namespace soilweave::dem
