// Arrangement of contacts and forces.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/fabric.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "analysis/measure/parts.h"
#include "analysis/measure/stress.h"

namespace soilweave::analysis {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double none = std::numeric_limits<double>::quiet_NaN();
const double cos45 = std::sqrt(0.5);
// With friction two contacts can hold a grain, but one cannot (Thornton 2000).
constexpr int least_contacts = 2;

// Returns the scalar of Eq. 3.9: the second invariant of `a`, negative if a : deviator is negative.
double scalar(const Mat3& a, const Mat3& deviator, int dimension) {
  const double size = std::sqrt((dimension == 3 ? 1.5 : 0.5) * a.squaredNorm());
  return a.cwiseProduct(deviator).sum() < 0 ? -size : size;
}

// Returns a quotient, NaN over 0.
double over(double sum, double count) { return count > 0 ? sum / count : none; }

std::vector<int> contacts_per_grain(const io::Snapshot& state) {
  std::vector<int> count(state.grains.size(), 0);
  for (const auto& pair : state.contacts.bodies)
    for (const std::int32_t b : pair)
      if (b >= 0) ++count[static_cast<std::size_t>(b)];
  return count;
}

}  // namespace

Fabric fabric(const io::Snapshot& state) {
  const int d = state.grains.dimension;
  const io::ContactsRecord& c = state.contacts;
  Fabric f;
  if (c.size() == 0) {
    for (Mat3* tensor :
         {&f.normals, &f.normal_force, &f.tangential_force, &f.a_normals, &f.a_normal_force, &f.a_tangential_force})
      tensor->setConstant(none);
    f.a_c = f.a_n = f.a_t = f.mean_normal_force = none;
    return f;
  }
  const double n = static_cast<double>(c.size());
  for (const Vec3& normal : c.normal) f.normals += normal * normal.transpose() / n;
  f.a_normals = (d == 3 ? 7.5 : 4.0) * deviator(f.normals, d);
  for (std::size_t k = 0; k < c.size(); ++k) {
    const Mat3 nn = c.normal[k] * c.normal[k].transpose();
    const double weight = n * (1 + f.a_normals.cwiseProduct(nn).sum());
    f.normal_force += c.normal_force[k] * nn / weight;
    f.tangential_force += c.shear_force[k] * c.normal[k].transpose() / weight;
  }
  f.mean_normal_force = f.normal_force.trace();
  if (f.mean_normal_force != 0) {
    f.a_normal_force = (d == 3 ? 7.5 : 4.0) * deviator(f.normal_force, d) / f.mean_normal_force;
    f.a_tangential_force = (d == 3 ? 5.0 : 4.0) * deviator(symmetric(f.tangential_force), d) / f.mean_normal_force;
  }
  const Mat3 s = deviator(symmetric(contact_stress(state)), d);
  f.a_c = scalar(f.a_normals, s, d);
  f.a_n = scalar(f.a_normal_force, s, d);
  f.a_t = scalar(f.a_tangential_force, s, d);
  return f;
}

StressForceFabric stress_force_fabric(const io::Snapshot& state, const Fabric& f) {
  const int d = state.grains.dimension;
  const Mat3 stress = contact_stress(state);
  const double p = mean(stress, d);
  return {p != 0 ? deviatoric_stress(stress, d) / p : none,
          d == 3 ? 0.4 * (f.a_c + f.a_n + 1.5 * f.a_t) : 0.5 * (f.a_c + f.a_n + f.a_t)};
}

Coordination coordination(const io::Snapshot& state) {
  std::vector<bool> grains = io::nodes(state);
  grains.flip();
  return coordination(state, grains);
}

Coordination coordination(const io::Snapshot& state, const std::vector<bool>& counted) {
  Coordination z;
  std::vector<int> count = contacts_per_grain(state);
  double grains = 0, ends = 0;
  z.histogram.assign(1, 0);
  for (std::size_t i = 0; i < count.size(); ++i) {
    if (!counted[i]) continue;
    const auto k = static_cast<std::size_t>(count[i]);
    if (k >= z.histogram.size()) z.histogram.resize(k + 1, 0);
    ++z.histogram[k], ++grains, ends += count[i];
  }
  const double none = static_cast<double>(z.histogram[0]);
  const double one = z.histogram.size() > 1 ? static_cast<double>(z.histogram[1]) : 0;
  z.all = over(ends, grains);
  z.mechanical = grains > none + one ? (ends - one) / (grains - none - one) : std::nan("");

  std::vector<char> out(count.size(), 0), gone(state.contacts.size(), 0);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < count.size(); ++i)
      if (!out[i] && counted[i] && count[i] < least_contacts) {
        out[i] = 1;
        changed = true;
      }
    for (std::size_t c = 0; c < state.contacts.size(); ++c) {
      const auto [a, b] = state.contacts.bodies[c];
      const bool lost = out[static_cast<std::size_t>(a)] || (b >= 0 && out[static_cast<std::size_t>(b)]);
      if (gone[c] || !lost) continue;
      gone[c] = 1;
      for (const std::int32_t body : {a, b})
        if (body >= 0) --count[static_cast<std::size_t>(body)];
    }
  }
  double left = 0, held = 0;
  for (std::size_t i = 0; i < count.size(); ++i) {
    if (!counted[i]) continue;
    z.rattlers += out[i] ? 1 : 0;
    left += out[i] ? 0 : 1;
    held += out[i] ? 0 : count[i];
  }
  z.backbone = over(held, left);
  return z;
}

Rose polar_rose(const io::Snapshot& state, std::size_t classes) {
  Rose rose;
  const double width = pi / 2 / static_cast<double>(classes), n = static_cast<double>(state.contacts.size());
  rose.density.assign(classes, 0.0);
  rose.normal_force.assign(classes, 0.0);
  for (std::size_t c = 0; c < state.contacts.size(); ++c) {
    const double angle = std::acos(std::min(1.0, std::abs(state.contacts.normal[c].z())));
    const std::size_t k = std::min(classes - 1, static_cast<std::size_t>(angle / width));
    rose.density[k] += 1;
    rose.normal_force[k] += state.contacts.normal_force[c];
  }
  for (std::size_t k = 0; k < classes; ++k) {
    const double low = static_cast<double>(k) * width;
    rose.angle.push_back(low + 0.5 * width);
    rose.contacts.push_back(rose.density[k]);
    rose.normal_force[k] = over(rose.normal_force[k], rose.density[k]);
    // The divisor is the share of the half sphere between the two cones.
    rose.density[k] = over(rose.density[k], n * (std::cos(low) - std::cos(low + width)));
  }
  return rose;
}

Rose plane_rose(const io::Snapshot& state, int a, int b, std::size_t classes) {
  Rose rose;
  const double width = 2 * pi / static_cast<double>(classes);
  rose.density.assign(classes, 0.0);
  rose.normal_force.assign(classes, 0.0);
  double total = 0;
  for (std::size_t c = 0; c < state.contacts.size(); ++c) {
    const Vec3& n = state.contacts.normal[c];
    if (std::hypot(n[a], n[b]) < cos45) continue;
    for (const double side : {1.0, -1.0}) {
      const double angle = std::atan2(side * n[b], side * n[a]);
      const std::size_t k =
          std::min(classes - 1, static_cast<std::size_t>((angle < 0 ? angle + 2 * pi : angle) / width));
      rose.density[k] += 1;
      rose.normal_force[k] += state.contacts.normal_force[c];
      total += 1;
    }
  }
  for (std::size_t k = 0; k < classes; ++k) {
    rose.angle.push_back((static_cast<double>(k) + 0.5) * width);
    rose.contacts.push_back(rose.density[k]);
    rose.normal_force[k] = over(rose.normal_force[k], rose.density[k]);
    rose.density[k] = over(static_cast<double>(classes) * rose.density[k], total);
  }
  return rose;
}

ForceChains force_chains(const io::Snapshot& state) {
  const io::ContactsRecord& c = state.contacts;
  ForceChains result;
  result.chain.assign(c.size(), -1);
  result.mean_length = none;
  if (c.size() == 0) return result;
  double mean_force = 0;
  for (const double f : c.normal_force) mean_force += f / static_cast<double>(c.size());
  const std::vector<Mat3> dyads = grain_dyads(state);
  std::vector<Vec3> axis;
  for (const Mat3& dyad : dyads) axis.push_back(principal(dyad, state.grains.dimension).directions.col(0));

  // A strong contact along the major stress of both grains joins them. Sets of joined grains are the chains.
  std::vector<std::size_t> root(state.grains.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
  };
  std::vector<char> strong(c.size(), 0);
  for (std::size_t k = 0; k < c.size(); ++k) {
    const auto [i, j] = c.bodies[k];
    if (j < 0 || c.normal_force[k] <= mean_force) continue;
    const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>(j);
    strong[k] = std::abs(axis[a].dot(c.normal[k])) > cos45 && std::abs(axis[b].dot(c.normal[k])) > cos45;
    if (strong[k]) root[std::max(find(a), find(b))] = std::min(find(a), find(b));
  }
  std::vector<std::size_t> members(root.size(), 0);
  for (std::size_t i = 0; i < root.size(); ++i) ++members[find(i)];
  std::vector<std::int32_t> number(root.size(), -1);
  double grains = 0;
  for (std::size_t i = 0; i < root.size(); ++i)
    if (root[i] == i && members[i] >= 3) {
      number[i] = static_cast<std::int32_t>(result.count++);
      grains += static_cast<double>(members[i]);
    }
  for (std::size_t k = 0; k < c.size(); ++k)
    if (strong[k]) result.chain[k] = number[find(static_cast<std::size_t>(c.bodies[k][0]))];
  result.mean_length = over(grains, static_cast<double>(result.count));
  // Fill is left out of the divisor, because only fill that touches soil has contacts here.
  const auto fill = std::ranges::count(parts(state), Part::fill);
  result.grains_in_chains = grains / static_cast<double>(std::ssize(root) - fill);
  return result;
}

}  // namespace soilweave::analysis
