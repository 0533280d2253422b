// The two scales together.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/model/model.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <exception>
#include <utility>

#include "core/error.h"
#include "core/memory.h"
#include "fem/model/guides.h"

namespace soilweave::fem {
namespace {

// Greatest ratio of a step to its stability limit; beyond it the run fails.
constexpr double tolerated = 1.0;

}  // namespace

Model::Model(ModelSetup setup, const Ranks* ranks) : setup_(std::move(setup)), ranks_(ranks) {
  std::vector<Probe> probes;
  if (setup_.law && !setup_.packings.empty())
    throw DataError(
        fmt::format("{} packing{} given, and the soil is a continuum, which holds none: leave {} out, or give "
                    "soil.material = \"grains\"",
                    setup_.packings.size(), setup_.packings.size() == 1 ? " is" : "s are",
                    setup_.packings.size() == 1 ? "it" : "them"));
  if (!setup_.law) {
    if (setup_.packings.empty())
      throw DataError("the soil consists of grains, but no packing is given: name one for all points, or one for each");
    for (io::Snapshot& packing : setup_.packings) {
      packing = prepare(packing, setup_.grains);
      probes.push_back(probe(packing, setup_.grains));
      if (!(probes.back().tangent(0, 0) > 0))
        throw DataError(
            fmt::format("packing {} of {} has no contacts, and a soil of it no stiffness: give one under pressure, as "
                        "pack-generate --dimension 2 --pressure makes it",
                        probes.size(), setup_.packings.size()));
    }
    if (setup_.soil.density == 0) {
      double mass = 0;
      for (const double m : setup_.packings[0].grains.mass) mass += m;
      setup_.soil.density = mass / setup_.packings[0].cell.matrix.topLeftCorner<2, 2>().determinant();
    }
  }
  soil_ = std::make_unique<Soil>(setup_.soil);
  const Index points = soil_->points();
  if (!setup_.law && probes.size() != 1 && probes.size() != points)
    throw DataError(fmt::format("{} packings are given for {} points: give one for all, or one for each, in order",
                                probes.size(), points));
  make_bars();
  const ContinuumPoint continuum(setup_.law.value_or(ContinuumLaw{}));
  eigenvalue_ = soil_->largest_eigenvalue(
      [&](Index p) { return setup_.law ? continuum.tangent() : probes[probes.size() == 1 ? 0 : p].tangent; });
  eigenvalue_ += interface_eigenvalue();
  dt_ = setup_.time_step.value_or(setup_.safety * stable_time_step());
  if (!(dt_ <= stable_time_step()))
    throw DataError(
        fmt::format("the time step of {:.4g} s is over the stable one of {:.4g} s: lower time.step, or leave it out",
                    dt_, stable_time_step()));
  if (setup_.interval > 0 && !setup_.time_step) dt_ = setup_.interval / std::ceil(setup_.interval / dt_ * (1 - 1e-12));
  double limit = dt_;
  for (const Probe& p : probes) limit = std::min(limit, setup_.grains.numerics.time_step_safety * p.limit);
  if (const auto fixed = setup_.grains.numerics.time_step; fixed) {
    for (const Probe& p : probes)
      if (*fixed > p.limit)
        throw DataError(
            fmt::format("the time step of {:.4g} s is over the stable one of {:.4g} s of the grains: lower "
                        "numerics.time_step, or leave it out",
                        *fixed, p.limit));
    limit = *fixed;
  }
  substeps_ = std::max<std::int64_t>(1, std::llround(std::ceil(dt_ / limit * (1 - 1e-12))));
  make_points();
}

void Model::make_points() {
  double grains = 0;
  for (const io::Snapshot& packing : setup_.packings) grains += static_cast<double>(packing.grains.size());
  if (setup_.packings.size() == 1) grains *= static_cast<double>(soil_->points());
  if (!setup_.law)
    demand_memory(bytes_of_grain * grains, fmt::format("the {:.4g} grains of {} points", grains, soil_->points()),
                  "take a coarser mesh or smaller packings");
  for (Index p = 0; p < soil_->points(); ++p) {
    if (setup_.law)
      points_.push_back(std::make_unique<ContinuumPoint>(*setup_.law));
    else
      points_.push_back(
          std::make_unique<Rve>(setup_.packings[setup_.packings.size() == 1 ? 0 : p], setup_.grains, dt_, substeps_));
    areas_.push_back(soil_->soil_point(p).area);
  }
  setup_.packings.clear();
  share_stresses();
}

void Model::make_bars() {
  if (!setup_.bars) return;
  line_ = soil_->mesh().line(setup_.along);
  BarsSetup& b = *setup_.bars;
  for (const Index n : line_) b.interface.push_back(soil_->positions()[n]);
  b.chain = chain_beside(b.interface, b.radius, setup_.spacing, setup_.overhang);
  bars_ = std::make_unique<Bars>(b);
  if (setup_.seat_pressure == 0) return;
  std::vector<double> loads(line_.size(), 0);
  for (Index k = 0; k + 1 < line_.size(); ++k) {
    const double half = 0.5 * std::abs(b.interface[k + 1][0] - b.interface[k][0]);
    loads[k] -= half * setup_.seat_pressure;
    loads[k + 1] -= half * setup_.seat_pressure;
  }
  try {
    bars_->seat(loads);
  } catch (const Error& error) {
    const std::vector<std::size_t> uncarried = uncarried_bars(b);
    if (uncarried.empty()) throw;
    // The error names the bar that failed first, and remedies for bars that are carried.
    throw DataError("geosynthetic.seat_pressure: the chain finds no rest on its guides before the start: " +
                    uncarried_text(b, uncarried));
  }
}

// Returns the contribution of the contacts with the geosynthetic to the eigenvalue, 1/s2 (Weyl: eigenvalues of a sum
// are at most the sum).
double Model::interface_eigenvalue() const {
  double largest = 0;
  if (!bars_) return 0;
  const std::vector<double> stiffness = bars_->interface_stiffness();
  for (Index k = 0; k < line_.size(); ++k) largest = std::max(largest, stiffness[k] / soil_->masses()[line_[k]]);
  return largest;
}

void Model::step() {
  std::vector<Vec2> interface(soil_->positions().size(), Vec2::Zero());
  if (bars_)
    for (Index k = 0; k < line_.size(); ++k) interface[line_[k]] += bars_->interface_forces()[k];
  try {
    soil_->step(stresses_, interface, dt_);
  } catch (const PhysicsError& error) {
    throw PhysicsError(fmt::format("step {}: {}", steps_ + 1, error.what()));
  }
  std::vector<Vec2> moved;
  for (const Index n : line_) moved.push_back(soil_->positions()[n]);

  // The geosynthetic comes first because it takes longest.
  const Index first = bars_ ? 1 : 0, tasks = first + points_.size();
  std::vector<std::exception_ptr> failures(tasks);
#pragma omp parallel for schedule(dynamic, 1) num_threads(setup_.threads) if (setup_.threads > 1)
  for (Index t = 0; t < tasks; ++t) {
    try {
      if (t < first)
        bars_->advance(moved, dt_);
      else if (owns(t - first))
        points_[t - first]->advance(soil_->gradients()[t - first]);
    } catch (...) {
      failures[t] = std::current_exception();
    }
  }
  ++steps_;
  if (!relaxing_) time_ = static_cast<double>(++loading_steps_) * dt_;
  Index failed = 0;
  while (failed < tasks && !failures[failed]) ++failed;
  std::string failure = failed < tasks ? failure_of(failed, failures[failed]) : "";
  if (ranks_) failure = ranks_->agree(failure, static_cast<std::int64_t>(failed));
  if (!failure.empty()) throw PhysicsError(failure);
  share_stresses();
}

// Returns the text of a physics failure; rethrows any other.
std::string Model::failure_of(Index task, const std::exception_ptr& failure) const {
  const Index first = bars_ ? 1 : 0;
  try {
    std::rethrow_exception(failure);
  } catch (const PhysicsError& error) {
    if (task < first) return fmt::format("step {}: {}", steps_, error.what());
    const SoilPoint at = soil_->soil_point(task - first);
    return fmt::format("step {}: element {}, point {} at ({:.4g}, {:.4g}) m: its grains: {}", steps_, at.element,
                       task - first, at.position[0], at.position[1], error.what());
  }
}

void Model::share_stresses() {
  stresses_.resize(points_.size());
  for (Index p = 0; p < points_.size(); ++p)
    if (owns(p)) stresses_[p] = points_[p]->stress();
  if (!ranks_ || ranks_->size() == 1) return;
  std::vector<double> flat;
  for (const Mat2& s : stresses_) flat.insert(flat.end(), s.data(), s.data() + 4);
  ranks_->share(flat, 4);
  for (Index p = 0; p < points_.size(); ++p)
    std::copy_n(flat.begin() + static_cast<std::ptrdiff_t>(4 * p), 4, stresses_[p].data());
}

void Model::collect() {
  if (!ranks_ || ranks_->size() == 1) return;
  for (Index p = 0; p < points_.size(); ++p) {
    if (ranks_->owner(p) == 0) continue;
    Archive own;
    if (owns(p)) points_[p]->archive(own, "");
    const std::string bytes = ranks_->to_first(Archive::packed(own.numbers()), ranks_->owner(p));
    if (!ranks_->first()) continue;
    Archive given(Archive::unpacked(bytes), "another process");
    points_[p]->archive(given, "");
  }
}

double Model::soil_eigenvalue() const {
  return soil_->largest_eigenvalue([&](Index p) { return points_[p]->tangent(); });
}

void Model::check_steps() const {
  const double stable = 2 / std::sqrt(soil_eigenvalue() + interface_eigenvalue());
  if (dt_ > tolerated * stable)
    throw PhysicsError(
        fmt::format("step {}: the time step of {:.4g} s is over the stable one of {:.4g} s: the soil has grown "
                    "stiffer, or an element "
                    "smaller, than at the start; lower time.safety",
                    steps_, dt_, stable));
  for (Index p = 0; p < points_.size(); ++p) {
    const double over = points_[p]->step_over_limit();
    if (over > tolerated)
      throw PhysicsError(
          fmt::format("step {}: element {}, point {}: the time step of its grains is {:.3g} times the stable one: "
                      "their contacts have "
                      "grown stiffer; lower numerics.time_step_safety",
                      steps_, p / soil_->points_of_element(), p, over));
  }
}

Balance Model::balance() const {
  const SoilEnergies soil = soil_->energies();
  Balance b{soil.traction_work + soil.support_work, soil.kinetic, 0, soil.viscous};
  if (bars_) {
    const BarEnergies bars = bars_->energies();
    // The bars lose the work that the interface does on the soil.
    b.external += bars.end_work + soil.interface_work + bars.interface_work;
    b.kinetic += bars.kinetic;
    b.stored += bars.elastic + bars.contact - bars.initial;
    b.dissipated += bars.damping + bars.friction + bars.broken;
  }
  for (Index p = 0; p < points_.size(); ++p) {
    const PointEnergy e = points_[p]->energy();
    b.kinetic += areas_[p] * e.kinetic;
    b.stored += areas_[p] * e.stored;
    b.dissipated += areas_[p] * e.dissipated;
  }
  return b;
}

void Model::relax(const std::optional<Relaxation>& how) {
  relaxing_ = how.has_value();
  soil_->hold(relaxing_, how ? std::optional(how->soil) : std::nullopt);
  if (bars_) bars_->hold(relaxing_, how ? std::optional(how->bars) : std::nullopt);
  for (const auto& point : points_) point->set_damping(how ? std::optional(how->grains) : std::nullopt);
}

void Model::archive(Archive& a) {
  a.item("model_time", time_), a.item("model_steps", steps_), a.item("model_loading_steps", loading_steps_);
  soil_->archive(a);
  if (bars_) bars_->archive(a);
  for (Index p = 0; p < points_.size(); ++p) points_[p]->archive(a, fmt::format("point_{:06}_", p));
  if (a.giving_back()) share_stresses();
}

}  // namespace soilweave::fem
