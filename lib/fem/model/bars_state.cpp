// The geosynthetic before the start, and its state in checkpoints.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "fem/model/bars.h"

namespace soilweave::fem {

void Bars::seat(const std::vector<double>& loads) {
  constexpr int most = 200000;
  constexpr double tolerance = 1e-7, relaxing = 0.7;
  const std::vector<double> stiffness = interface_stiffness();
  Line& boundary = lines_[0];
  only_along_y_ = true;
  damping_ = relaxing;
  double total = 0;
  for (const double load : loads) total += std::abs(load);
  std::vector<double> speed(loads.size(), 0);
  double worst = 1;
  for (int k = 0; k < most && worst > tolerance; ++k) {
    const double dt = stable_;
    kick(dt);
    worst = 0;
    for (std::size_t n = 0; n < x_.size(); ++n) x_[n][1] += dt * v_[n][1];
    // Fictitious masses are chosen to be stable with the step.
    for (std::size_t n = 0; n < loads.size(); ++n) {
      const double mass = 4 * std::max(stiffness[n], 1e-12) * dt * dt, force = loads[n] + on_interface_[n][1];
      const double side = force * speed[n] > 0 ? 1 : -1;
      speed[n] += dt / mass * force * (1 - relaxing * side);
      boundary.x[n][1] += dt * speed[n];
      worst = std::max(worst, std::abs(force) / total);
    }
    forces(0);
    for (std::size_t n = 0; n < x_.size(); ++n) worst = std::max(worst, std::abs(f_[n][1]) / total);
  }
  if (worst > tolerance)
    throw TargetNotReached(
        fmt::format("the geosynthetic does not come to rest under the load before the start: {:.2g} of it is out of "
                    "balance; a guide "
                    "must lie below it",
                    worst));
  only_along_y_ = false;
  damping_.reset();
  std::fill(v_.begin(), v_.end(), Vec2::Zero());
  for (std::size_t n = 0; n < offsets_.size(); ++n) offsets_[n] = boundary.x[n] - setup_.interface[n];
  forces(0);
  energies_ = {};
  energies_.initial = elastic_ + touching_;
}

void Bars::archive(Archive& a) {
  const auto pairs = [&a](const std::string& name, std::vector<Vec2>& values) {
    std::vector<double> flat;
    for (const Vec2& v : values) flat.insert(flat.end(), {v[0], v[1]});
    a.sized(name, flat);
    for (std::size_t n = 0; n < values.size(); ++n) values[n] = Vec2(flat.at(2 * n), flat.at(2 * n + 1));
  };
  pairs("bars_position", x_), pairs("bars_velocity", v_), pairs("bars_force", f_);
  pairs("bars_interface", lines_[0].x), pairs("bars_interface_velocity", lines_[0].v);
  pairs("bars_interface_force", on_interface_), pairs("bars_offset", offsets_);
  std::vector<double> broken(broken_.begin(), broken_.end()), contacts;
  for (const Contact& c : contacts_)
    contacts.insert(contacts.end(),
                    {static_cast<double>(c.segment), c.shear, c.normal, c.direction[0], c.direction[1]});
  a.sized("bars_broken", broken), a.sized("bars_contact", contacts);
  for (std::size_t b = 0; b < broken_.size(); ++b) broken_[b] = broken.at(b) != 0;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    Contact& c = contacts_[k];
    const double segment = contacts.at(5 * k), segments = static_cast<double>(lines_[c.line].x.size()) - 1;
    if (!(segment >= 0 && segment < segments && segment == std::floor(segment)))
      throw DataError(
          fmt::format("the checkpoint has bar contact {} at segment {} of {}: it was changed; give --force without "
                      "--resume to begin "
                      "anew",
                      k, segment, segments));
    c.segment = static_cast<std::size_t>(segment);
    c.shear = contacts.at(5 * k + 1), c.normal = contacts.at(5 * k + 2);
    c.direction = Vec2(contacts.at(5 * k + 3), contacts.at(5 * k + 4));
  }
  BarEnergies& e = energies_;
  a.item("bars_damping_energy", e.damping), a.item("bars_friction_energy", e.friction);
  a.item("bars_broken_energy", e.broken), a.item("bars_end_work", e.end_work);
  a.item("bars_interface_work", e.interface_work), a.item("bars_initial_energy", e.initial);
  a.item("bars_elastic", elastic_), a.item("bars_touching", touching_);
  a.item("bars_steps", steps_);
}

}  // namespace soilweave::fem
