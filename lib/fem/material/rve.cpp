// Representative volume elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/material/rve.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "dem/engine/described.h"
#include "dem/state/bodies.h"

namespace soilweave::fem {
namespace {

// Returns the tangent of an isotropic network of central forces: lambda = mu = a third of the stiffness in compression
// (Cauchy's relations). That stiffness is the greater one of both axes, so that the step is safe.
Mat3 tangent_of(const dem::Simulation& simulation) {
  const double stiffness = simulation.measures().axial_stiffness.head<2>().maxCoeff();
  Mat3 t = Mat3::Zero();
  t.topLeftCorner<2, 2>().setConstant(stiffness / 3);
  t(0, 0) = t(1, 1) = stiffness;
  t(2, 2) = stiffness / 3;
  return t;
}

dem::Numerics fixed_step(dem::Numerics numerics, double step) {
  numerics.time_step = step;
  numerics.watch_stiffness = false;
  numerics.threads = 1;
  return numerics;
}

template <class Row>
void rows(Archive& a, const std::string& name, std::vector<Row>& values) {
  constexpr std::size_t width = sizeof(Row) / sizeof(double);
  std::vector<double> flat;
  if (!a.giving_back())
    for (const Row& row : values) flat.insert(flat.end(), row.data(), row.data() + width);
  a.item(name, flat);
  if (!a.giving_back()) return;
  values.resize(flat.size() / width);
  for (std::size_t i = 0; i < values.size(); ++i)
    std::copy_n(flat.begin() + static_cast<std::ptrdiff_t>(i * width), width, values[i].data());
}

template <class Whole>
void wholes(Archive& a, const std::string& name, std::vector<Whole>& values) {
  std::vector<double> flat(values.begin(), values.end());
  a.item(name, flat);
  if (!a.giving_back()) return;
  values.clear();
  for (const double v : flat) values.push_back(static_cast<Whole>(v));
}

void contacts_of(Archive& a, const std::string& prefix, io::ContactsRecord& c) {
  std::vector<std::int32_t> pairs;
  std::vector<Vec3> images;
  for (const auto& [first, second] : c.bodies) pairs.insert(pairs.end(), {first, second});
  for (const Vec3i& image : c.image) images.push_back(image.cast<double>());
  wholes(a, prefix + "contact_bodies", pairs);
  rows(a, prefix + "contact_image", images);
  rows(a, prefix + "contact_normal", c.normal);
  rows(a, prefix + "contact_branch", c.branch_vector);
  a.item(prefix + "contact_overlap", c.overlap);
  a.item(prefix + "contact_normal_force", c.normal_force);
  rows(a, prefix + "contact_shear_force", c.shear_force);
  rows(a, prefix + "contact_rolling_moment", c.rolling_moment);
  a.item(prefix + "contact_twisting_moment", c.twisting_moment);
  wholes(a, prefix + "contact_sliding", c.sliding);
  for (io::OwnHistory& field : c.own) a.item(prefix + "contact_" + field.name, field.values);
  if (!a.giving_back()) return;
  c.bodies.clear(), c.image.clear();
  for (std::size_t k = 0; k + 1 < pairs.size(); k += 2) c.bodies.push_back({pairs[k], pairs[k + 1]});
  for (const Vec3& image : images) c.image.push_back(image.cast<int>());
}

// Keeps or restores everything in a state that steps change.
void state_of(Archive& a, const std::string& prefix, io::Snapshot& s) {
  a.item(prefix + "step", s.step), a.item(prefix + "time", s.time);
  a.item(prefix + "cell", s.cell.matrix), a.item(prefix + "gradient", s.cell.velocity_gradient);
  a.item(prefix + "deformation", s.cell.deformation_gradient);
  rows(a, prefix + "position", s.grains.position);
  rows(a, prefix + "orientation", s.grains.orientation);
  rows(a, prefix + "velocity", s.grains.velocity);
  rows(a, prefix + "spin", s.grains.angular_velocity);
  contacts_of(a, prefix, s.contacts);
}

}  // namespace

io::Snapshot prepare(const io::Snapshot& packing, const Grains& grains) {
  if (packing.grains.dimension != 2 || !packing.cell.periodic[0] || !packing.cell.periodic[1])
    throw DataError(
        "a material point needs disks in a cell that is periodic along x and y (pack-generate --dimension 2)");
  if (!packing.planes.point.empty() || packing.yarns.size() > 0)
    throw DataError(
        "a material point takes disks alone, and this packing has planes or yarns; give one that pack-generate "
        "--dimension 2 made");
  dem::described(packing, grains.model);
  io::Snapshot state = packing;
  if (grains.density > 0)
    for (std::size_t i = 0; i < state.grains.size(); ++i)
      state.grains.mass[i] = grains.density * dem::grain_volume(2, state.grains.radius[i]);
  state.step = 0;
  state.time = 0;
  state.cell.velocity_gradient.setZero();
  state.cell.deformation_gradient.setIdentity();
  // Rotations of disks during packing are no rotation of the soil.
  std::fill(state.grains.orientation.begin(), state.grains.orientation.end(), Vec4(1, 0, 0, 0));
  return state;
}

Probe probe(const io::Snapshot& packing, const Grains& grains) {
  dem::Simulation simulation(packing, grains.model, grains.numerics);
  const Mat3 stress = simulation.measures().stress;
  return {simulation.stability_limit(), tangent_of(simulation), -stress.topLeftCorner<2, 2>(),
          1 / (1 + simulation.void_ratio())};
}

double anisotropy(const io::ContactsRecord& contacts) {
  if (contacts.size() == 0) return -1;
  Mat2 fabric = Mat2::Zero();
  for (const Vec3& n : contacts.normal) fabric += n.head<2>() * n.head<2>().transpose();
  fabric /= static_cast<double>(contacts.size());
  const Mat2 deviator = 4 * (fabric - 0.5 * fabric.trace() * Mat2::Identity());
  return std::sqrt(0.5 * deviator.squaredNorm());
}

Rve::Rve(const io::Snapshot& packing, const Grains& grains, double step, std::int64_t substeps)
    : identities_(packing),
      grains_{grains.model, fixed_step(grains.numerics, step / static_cast<double>(substeps)), grains.density},
      step_(step),
      substeps_(substeps),
      simulation_(packing, grains_.model, grains_.numerics) {
  area_ = simulation_.volume();
}

void Rve::advance(const Mat2& gradient) {
  Mat3 velocity_gradient = Mat3::Zero();
  velocity_gradient.topLeftCorner<2, 2>() = gradient / step_;
  simulation_.set_velocity_gradient(velocity_gradient);
  for (std::int64_t k = 0; k < substeps_; ++k) simulation_.step();
}

Mat2 Rve::stress() const {
  const Mat3& compression = simulation_.measures().stress;
  return -compression.topLeftCorner<2, 2>();
}

Mat3 Rve::tangent() const { return tangent_of(simulation_); }

Local Rve::local() const {
  const io::Snapshot state = simulation_.snapshot();
  double rotation = 0;
  for (const Vec4& q : state.grains.orientation) rotation += 2 * std::atan2(q[3], q[0]);
  return {simulation_.void_ratio(), anisotropy(state.contacts), rotation / static_cast<double>(state.grains.size()),
          static_cast<double>(state.contacts.size())};
}

PointEnergy Rve::energy() const {
  const dem::Energies e = simulation_.energies();
  return {(e.stored() - e.initial()) / area_, e.kinetic() / area_,
          (e.sum(dem::EnergyRole::dissipated) + e.sum(dem::EnergyRole::numerical)) / area_};
}

void Rve::set_damping(std::optional<double> damping) {
  simulation_.set_damping(damping.value_or(grains_.numerics.damping));
}

double Rve::step_over_limit() { return *grains_.numerics.time_step / simulation_.stability_limit(); }

void Rve::archive(Archive& a, const std::string& prefix) {
  io::Snapshot state = a.giving_back() ? identities_ : simulation_.snapshot();
  state_of(a, prefix, state);
  Archive inner;
  const std::string further = prefix + "engine_";
  if (!a.giving_back()) {
    simulation_.archive(inner);
    for (auto [name, values] : inner.numbers()) a.item(further + name, values);
    return;
  }
  Archive::Numbers numbers;
  for (auto at = a.numbers().lower_bound(further); at != a.numbers().end() && at->first.starts_with(further); ++at)
    numbers[at->first.substr(further.size())] = at->second;
  inner = Archive(std::move(numbers), prefix);
  simulation_ = dem::Simulation(state, grains_.model, grains_.numerics, inner);
}

}  // namespace soilweave::fem
