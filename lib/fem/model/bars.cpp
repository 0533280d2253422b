// The geosynthetic.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/model/bars.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"

namespace soilweave::fem {
namespace {

// Distance, in radii, that disks may approach within one step of the soil. Pairs farther apart are skipped.
constexpr double room = 0.5;

Vec2 right_of(const Vec2& direction) { return {direction[1], -direction[0]}; }

// Returns the tangent, counter-clockwise from n.
Vec2 tangent(const Vec2& n) { return {-n[1], n[0]}; }

double turning(const Vec2& bar, const Vec2& relative) {
  return (bar[0] * relative[1] - bar[1] * relative[0]) / bar.squaredNorm();
}

}  // namespace

std::vector<Vec2> chain_beside(const std::vector<Vec2>& line, double radius, double spacing, double overhang) {
  constexpr double most = 1e5;
  double length = overhang;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) length += (line[k + 1] - line[k]).norm();
  if (!(length <= most * spacing))
    throw DataError(fmt::format("a chain of {} m in bars of {} m: more than {} bars; raise geosynthetic.spacing",
                                length, spacing, most));
  std::vector<Vec2> beside;
  for (std::size_t k = 0; k < line.size(); ++k) {
    const Vec2 into = (line[std::max<std::size_t>(k, 1)] - line[std::max<std::size_t>(k, 1) - 1]).normalized();
    const std::size_t next = std::min(k + 1, line.size() - 1);
    const Vec2 onward = (line[next] - line[next - 1]).normalized();
    const Vec2 bisector = right_of(into) + right_of(onward);
    beside.push_back(line[k] + 4 * radius / bisector.squaredNorm() * bisector);
  }
  std::vector<Vec2> nodes = {beside.front()};
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const auto parts =
        static_cast<std::size_t>(std::max(1.0, std::floor((line[k + 1] - line[k]).norm() / spacing * (1 + 1e-12))));
    for (std::size_t i = 1; i <= parts; ++i)
      nodes.push_back(beside[k] + static_cast<double>(i) / static_cast<double>(parts) * (beside[k + 1] - beside[k]));
  }
  if (!(overhang > 0)) return nodes;
  const Vec2 back = (nodes[0] - nodes[1]).normalized();
  const auto further = static_cast<std::size_t>(std::ceil(overhang / spacing * (1 - 1e-12)));
  std::vector<Vec2> before;
  for (std::size_t i = further; i > 0; --i)
    before.push_back(nodes[0] + overhang * static_cast<double>(i) / static_cast<double>(further) * back);
  nodes.insert(nodes.begin(), before.begin(), before.end());
  return nodes;
}

Bars::Bars(BarsSetup setup) : setup_(std::move(setup)), x_(setup_.chain) {
  v_.assign(x_.size(), Vec2::Zero());
  f_ = v_;
  mass_.assign(x_.size(), 0);
  broken_.assign(bars(), false);
  for (std::size_t b = 0; b < bars(); ++b) {
    length_.push_back((x_[b + 1] - x_[b]).norm());
    mass_[b] += 0.5 * setup_.areal_density * length_[b];
    mass_[b + 1] += 0.5 * setup_.areal_density * length_[b];
  }
  on_interface_.assign(setup_.interface.size(), Vec2::Zero());
  offsets_ = on_interface_;
  lines_.push_back({setup_.interface, on_interface_, false});
  for (const Guide& g : setup_.guides) lines_.push_back({{g.from, g.to}, {Vec2::Zero(), Vec2::Zero()}, true});
  add_contacts();
  find_step();
  look_around();
  forces(0);
  energies_.initial = elastic_ + touching_;
}

void Bars::add_contacts() {
  const double friction = std::tan(setup_.touch.friction_angle);
  for (std::size_t b = 0; b < bars(); ++b)
    for (std::size_t line = 0; line < lines_.size(); ++line) {
      const double k = setup_.touch.normal_stiffness * length_[b];
      contacts_.push_back({b, line, false, k, k * setup_.touch.shear_ratio, line == 0 ? friction : 0});
    }
  const std::vector<Vec2>& edge = setup_.interface;
  for (std::size_t g = 0; g < setup_.guides.size(); ++g)
    for (std::size_t n = 0; setup_.guides[g].holds_soil && n < edge.size(); ++n) {
      const double before = n > 0 ? (edge[n] - edge[n - 1]).norm() : 0,
                   after = n + 1 < edge.size() ? (edge[n + 1] - edge[n]).norm() : 0;
      contacts_.push_back({n, g + 1, true, setup_.touch.normal_stiffness * 0.5 * (before + after), 0, 0});
    }
  for (Contact& c : contacts_) {
    // The whole line is searched once, later only the neighbourhood.
    const Vec2 p = place(c);
    const Line& line = lines_[c.line];
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t s = 0; s + 1 < line.x.size(); ++s) {
      const Vec2 a = line.x[s + 1] - line.x[s];
      const double m = std::clamp(a.dot(p - line.x[s]) / a.squaredNorm(), 0.0, 1.0);
      const double distance = (p - line.x[s] - m * a).squaredNorm();
      if (distance < least) least = distance, c.segment = s;
    }
  }
}

void Bars::find_step() {
  std::vector<double> stiffness(x_.size(), 0);
  for (std::size_t b = 0; b < bars(); ++b)
    for (const std::size_t n : {b, b + 1}) stiffness[n] += 2 * setup_.stiffness / length_[b];
  for (const Contact& c : contacts_)
    if (!c.of_interface)
      for (const std::size_t n : {c.bar, c.bar + 1}) stiffness[n] += 0.5 * (c.normal_stiffness + c.shear_stiffness);
  double largest = 0;
  for (std::size_t n = 0; n < x_.size(); ++n) largest = std::max(largest, stiffness[n] / mass_[n]);
  stable_ = setup_.safety * 2 / std::sqrt(largest);
}

std::vector<double> Bars::interface_stiffness() const {
  std::vector<double> stiffness(lines_[0].x.size(), 0);
  for (const Contact& c : contacts_) {
    if (c.of_interface) {
      stiffness[c.bar] += c.normal_stiffness;
    } else if (c.line == 0) {
      // Rows of the interpolation sum to one, so at most the whole stiffness goes to either node.
      for (const std::size_t n : {c.segment, c.segment + 1}) stiffness[n] += 0.5 * c.normal_stiffness;
    }
  }
  return stiffness;
}

void Bars::bar_forces() {
  elastic_ = 0;
  for (std::size_t b = 0; b < bars(); ++b) {
    if (broken_[b]) continue;
    const Vec2 a = x_[b + 1] - x_[b];
    const double length = a.norm(), stretch = length - length_[b];
    if (stretch < 0 && !setup_.compression) continue;
    const double stiffness = setup_.stiffness / length_[b], tension = stiffness * stretch;
    if (!std::isfinite(tension))
      throw PhysicsError(
          fmt::format("bar {} of the geosynthetic has a length that is not a number: its time step is too large; lower "
                      "geosynthetic.time_step_safety",
                      b));
    if (tension > setup_.strength) {
      broken_[b] = true;
      energies_.broken += 0.5 * tension * stretch;
      if (setup_.stop_when_broken)
        throw PhysicsError(fmt::format(
            "bar {} of the geosynthetic broke: its tension of {:.4g} N/m is over its strength of {:.4g} N/m; take a "
            "stronger one, pull less, or set geosynthetic.broken = \"go on\"",
            b, tension, setup_.strength));
      continue;
    }
    elastic_ += 0.5 * tension * stretch;
    f_[b] += tension / length * a;
    f_[b + 1] -= tension / length * a;
  }
}

double Bars::nearest(const Line& line, const Vec2& p, Contact& contact) {
  const auto along = [&](std::size_t s) {
    const Vec2 a = line.x[s + 1] - line.x[s];
    return a.dot(p - line.x[s]) / a.squaredNorm();
  };
  double m = along(contact.segment);
  // A disk beyond the end of its bar moves to the next bar, unless it lies before that bar's start, at a corner.
  while (m > 1 && contact.segment + 2 < line.x.size()) {
    const double next = along(contact.segment + 1);
    if (next <= 0) return 1;
    ++contact.segment, m = next;
  }
  while (m < 0 && contact.segment > 0) {
    const double next = along(contact.segment - 1);
    if (next >= 1) return 0;
    --contact.segment, m = next;
  }
  return std::clamp(m, 0.0, 1.0);
}

void Bars::contact_force(Contact& c, double dt) {
  if (c.of_interface) return touch(c, lines_[0].x[c.bar], lines_[0].v[c.bar], 0, dt);
  if (broken_[c.bar]) return;
  const Vec2 a = x_[c.bar + 1] - x_[c.bar];
  touch(c, 0.5 * (x_[c.bar] + x_[c.bar + 1]), 0.5 * (v_[c.bar] + v_[c.bar + 1]), turning(a, v_[c.bar + 1] - v_[c.bar]),
        dt);
}

// Computes the contact of two virtual disks, at `p` and at the nearest point of the line. Velocities are interpolated
// from the nodes, with the spins of the bars. Forces and moments go to the nodes by the same interpolation, so that
// their work is equal.
void Bars::touch(Contact& c, const Vec2& p, const Vec2& v, double spin, double dt) {
  Line& line = lines_[c.line];
  const double m = nearest(line, p, c);
  const std::size_t s = c.segment;
  const Vec2 b = line.x[s + 1] - line.x[s];
  const Vec2 apart = p - line.x[s] - m * b;
  const double distance = apart.norm(), overlap = 2 * setup_.radius - distance;
  c.normal = 0;
  if (overlap <= 0) {
    c.shear = 0;
    return;
  }
  if (overlap > setup_.radius)
    throw PhysicsError(fmt::format(
        "{} {} is {:.3g} m deep in {}: it moves too fast for its stiffness; raise "
        "geosynthetic.contact.normal_stiffness or pull "
        "slower",
        c.of_interface ? "interface node" : "bar", c.bar, overlap, c.line == 0 ? "the boundary" : "a guide"));
  const Vec2 n = apart / distance, t = tangent(n);
  const double line_spin = turning(b, line.v[s + 1] - line.v[s]), arm = 0.5 * distance;
  const Vec2 relative = v - (1 - m) * line.v[s] - m * line.v[s + 1];
  const double slip = relative.dot(t) - arm * (spin + line_spin);
  c.normal = c.normal_stiffness * overlap;
  const double trial = c.shear - c.shear_stiffness * slip * dt, most = c.friction * c.normal;
  c.shear = std::clamp(trial, -most, most);
  c.direction = n;
  touching_ += 0.5 * c.normal * overlap;
  if (c.shear_stiffness > 0) {
    energies_.friction += (trial - c.shear) * c.shear / c.shear_stiffness;
    touching_ += 0.5 * c.shear * c.shear / c.shear_stiffness;
  }
  const Vec2 force = c.normal * n + c.shear * t;
  const double moment = -arm * c.shear;  // on either disk
  if (c.of_interface) {
    on_interface_[c.bar] += force;
  } else {
    const Vec2 a = x_[c.bar + 1] - x_[c.bar], couple = moment / a.squaredNorm() * tangent(a);
    f_[c.bar] += 0.5 * force - couple;
    f_[c.bar + 1] += 0.5 * force + couple;
  }
  if (line.fixed) return;
  const Vec2 couple = moment / b.squaredNorm() * tangent(b);
  on_interface_[s] -= (1 - m) * force + couple;
  on_interface_[s + 1] += couple - m * force;
}

void Bars::forces(double dt) {
  std::fill(f_.begin(), f_.end(), Vec2::Zero());
  std::fill(on_interface_.begin(), on_interface_.end(), Vec2::Zero());
  touching_ = 0;
  bar_forces();
  for (const std::size_t c : near_) contact_force(contacts_[c], dt);
}

// Finds the contacts that may close before the next search. Only these take part in the steps until then.
void Bars::look_around() {
  near_.clear();
  const double reach = 2 * setup_.radius + room * setup_.radius;
  for (std::size_t k = 0; k < contacts_.size(); ++k) {
    Contact& c = contacts_[k];
    if (!c.of_interface && broken_[c.bar]) continue;
    const Vec2 p = place(c);
    const Line& line = lines_[c.line];
    const double m = nearest(line, p, c);
    const Vec2 apart = p - line.x[c.segment] - m * (line.x[c.segment + 1] - line.x[c.segment]);
    if (apart.squaredNorm() < reach * reach)
      near_.push_back(k);
    else
      c.normal = c.shear = 0;
  }
}

Vec2 Bars::place(const Contact& c) const {
  return c.of_interface ? lines_[0].x[c.bar] : Vec2(0.5 * (x_[c.bar] + x_[c.bar + 1]));
}

void Bars::kick(double dt) {
  const double damping = damping_.value_or(setup_.damping);
  for (std::size_t n = 0; n < x_.size(); ++n) {
    const ChainEnd* end = n == 0 ? &setup_.start : n + 1 == x_.size() ? &setup_.end : nullptr;
    for (int a = 0; a < 2; ++a) {
      const std::optional<double> driven = !end ? std::nullopt : a == 0 ? end->x : end->y;
      const double before = v_[n][a], weight = mass_[n] * setup_.gravity[a], force = f_[n][a] + weight;
      if (only_along_y_ ? a == 0 : driven.has_value()) {
        v_[n][a] = held_ || only_along_y_ ? 0 : *driven;
        energies_.end_work += 0.5 * (before + v_[n][a]) * (mass_[n] * (v_[n][a] - before) - force * dt);
        continue;
      }
      const double power = force * (before + 0.5 * dt / mass_[n] * force);
      const double side = static_cast<double>((power > 0) - (power < 0));
      const double change = dt / mass_[n] * force * (1 - damping * side);
      v_[n][a] = before + change;
      energies_.gravity_work += weight * dt * (before + 0.5 * change);
      energies_.damping += damping * side * force * dt * (before + 0.5 * change);
    }
  }
}

void Bars::advance(const std::vector<Vec2>& interface, double duration) {
  const auto parts = static_cast<std::int64_t>(std::ceil(duration / stable_));
  const double dt = duration / static_cast<double>(parts);
  Line& boundary = lines_[0];
  const std::vector<Vec2> from = boundary.x;
  look_around();
  for (std::size_t n = 0; n < from.size(); ++n) boundary.v[n] = (interface[n] + offsets_[n] - from[n]) / duration;
  for (std::int64_t k = 1; k <= parts; ++k) {
    kick(dt);
    for (std::size_t n = 0; n < x_.size(); ++n) x_[n] += dt * v_[n];
    const double done = static_cast<double>(k) / static_cast<double>(parts);
    for (std::size_t n = 0; n < from.size(); ++n) {
      energies_.interface_work -= 0.5 * dt * on_interface_[n].dot(boundary.v[n]);
      boundary.x[n] = k == parts ? Vec2(interface[n] + offsets_[n]) : Vec2(from[n] + done * duration * boundary.v[n]);
    }
    forces(dt);
    for (std::size_t n = 0; n < from.size(); ++n)
      energies_.interface_work -= 0.5 * dt * on_interface_[n].dot(boundary.v[n]);
  }
  steps_ += parts;
}

void Bars::hold(bool held, std::optional<double> damping) {
  held_ = held;
  damping_ = damping;
}

double Bars::tension(std::size_t bar) const {
  if (broken_[bar]) return 0;
  const double stretch = (x_[bar + 1] - x_[bar]).norm() - length_[bar];
  return stretch < 0 && !setup_.compression ? 0 : setup_.stiffness / length_[bar] * stretch;
}

std::size_t Bars::broken_bars() const {
  return static_cast<std::size_t>(std::count(broken_.begin(), broken_.end(), true));
}

Vec2 Bars::contact_of(std::size_t bar) const {
  const Contact& c = contacts_[bar * lines_.size()];
  const Vec2 along = x_[bar + 1] - x_[bar];
  const double sense = tangent(c.direction).dot(along) < 0 ? -1 : 1;
  return {c.normal, sense * c.shear};
}

Vec2 Bars::contact_sum() const {
  Vec2 sum = Vec2::Zero();
  for (std::size_t b = 0; b < bars(); ++b) sum += contact_of(b);
  return sum;
}

Vec2 Bars::end_force(bool last) const { return last ? Vec2(-f_.back()) : Vec2(-f_.front()); }

BarEnergies Bars::energies() const {
  BarEnergies e = energies_;
  for (std::size_t n = 0; n < x_.size(); ++n) e.kinetic += 0.5 * mass_[n] * v_[n].squaredNorm();
  e.elastic = elastic_;
  e.contact = touching_;
  return e;
}

}  // namespace soilweave::fem
