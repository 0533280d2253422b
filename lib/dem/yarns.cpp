// The yarns of all geotextiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/yarns.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace soilweave::dem {
namespace {

// Yarns that one thread takes in one go; sums are made chunk by chunk.
constexpr std::size_t yarns_per_chunk = 512;

}  // namespace

Yarns::Yarns(const io::YarnsRecord& record, std::size_t grains, std::vector<WireCurve> curves)
    : curves_(std::move(curves)), identity_(record), grains_(grains) {
  if (record.size() == 0) return;
  std::vector<std::uint32_t> count(grains, 0);
  for (std::size_t k = 0; k < record.size(); ++k) {
    if (static_cast<std::size_t>(record.geotextile_id[k]) >= curves_.size())
      throw DataError(
          fmt::format("the packing has yarns of geotextile {}, the scenario describes {}: add [[geotextile]]",
                      record.geotextile_id[k], curves_.size()));
    Yarn yarn{record.nodes[k][0], record.nodes[k][1], record.geotextile_id[k], record.rest_length[k], {}};
    yarn.memory = {record.largest_strain[k], record.broken[k] != 0};
    yarn.tension = record.tension[k];
    yarn.break_time = record.break_time[k], yarn.break_position = record.break_position[k];
    yarns_.push_back(yarn);
    for (const std::int32_t node : record.nodes[k]) ++count[static_cast<std::size_t>(node)];
  }
  std::vector<std::uint32_t> place(grains, 0);
  start_.assign(1, 0);
  for (std::size_t i = 0; i < grains; ++i) {
    if (count[i] == 0) continue;
    place[i] = start_.back();
    node_.push_back(static_cast<std::int32_t>(i));
    start_.push_back(start_.back() + count[i]);
  }
  ends_.resize(start_.back());
  for (std::size_t k = 0; k < yarns_.size(); ++k)
    for (std::uint32_t side = 0; side < 2; ++side)
      ends_[place[static_cast<std::size_t>(record.nodes[k][side])]++] = 2 * static_cast<std::uint32_t>(k) + side;
  partial_.resize((yarns_.size() + yarns_per_chunk - 1) / yarns_per_chunk);
  fabric_of();
}

std::vector<std::int32_t> Yarns::fabric_of() const {
  if (yarns_.empty()) return {};
  std::vector<std::int32_t> fabric(grains_, -1);
  for (std::size_t k = 0; k < yarns_.size(); ++k)
    for (const std::int32_t node : identity_.nodes[k]) {
      std::int32_t& of = fabric[static_cast<std::size_t>(node)];
      if (of >= 0 && of != identity_.fabric[k])
        throw DataError(fmt::format("node {} belongs to the fabrics {} and {}", node, of, identity_.fabric[k]));
      of = identity_.fabric[k];
    }
  return fabric;
}

double Yarns::elastic(const Yarn& yarn) const {
  const double k = curves_[static_cast<std::size_t>(yarn.geotextile)].unloading / yarn.rest_length;
  return 0.5 * yarn.tension * yarn.tension / k;
}

YarnSums Yarns::stretch(double time, const Bodies& bodies, Yarn& yarn) const {
  if (yarn.memory.broken) return {.broken = 1};
  const Lane4& a = bodies.grains[static_cast<std::size_t>(yarn.first)].position;
  const Lane4& b = bodies.grains[static_cast<std::size_t>(yarn.second)].position;
  const Vec3 reach = vector_of(b) - vector_of(a);
  const double length = reach.norm(), before = yarn.tension, stored = elastic(yarn);
  const double stretched = yarn.length > 0 ? length - yarn.length : 0;
  yarn.tension = pull(curves_[static_cast<std::size_t>(yarn.geotextile)], length / yarn.rest_length - 1, yarn.memory);
  yarn.length = length;
  yarn.direction = row((1 / length) * reach, 0);
  if (yarn.memory.broken) {
    yarn.break_time = time;
    yarn.break_position = 0.5 * (vector_of(a) + vector_of(b));
  }
  YarnSums s;
  s.elastic = elastic(yarn);
  s.dissipated = stretched == 0 ? 0 : 0.5 * (before + yarn.tension) * stretched - (s.elastic - stored);
  s.tension = yarn.tension;
  s.taut = yarn.tension > 0, s.broken = yarn.memory.broken;
  return s;
}

void Yarns::run(double time, int threads, Bodies& bodies) {
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (std::size_t c = 0; c < partial_.size(); ++c) {
    YarnSums sum;
    const std::size_t end = std::min(yarns_.size(), (c + 1) * yarns_per_chunk);
    for (std::size_t k = c * yarns_per_chunk; k < end; ++k) {
      const YarnSums one = stretch(time, bodies, yarns_[k]);
      sum.elastic += one.elastic, sum.dissipated += one.dissipated, sum.tension += one.tension;
      sum.taut += one.taut, sum.broken += one.broken;
    }
    partial_[c] = sum;
  }
  sums_ = {};
  for (const YarnSums& p : partial_) {
    sums_.elastic += p.elastic, sums_.dissipated += p.dissipated, sums_.tension += p.tension;
    sums_.taut += p.taut, sums_.broken += p.broken;
  }
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
  for (std::size_t n = 0; n < node_.size(); ++n) {
    Lane4 force{};
    for (std::uint32_t e = start_[n]; e < start_[n + 1]; ++e) {
      const Yarn& yarn = yarns_[ends_[e] / 2];
      force += (ends_[e] % 2 == 0 ? yarn.tension : -yarn.tension) * yarn.direction;
    }
    const auto i = static_cast<std::size_t>(node_[n]);
    bodies.loads[i].force += force;
    bodies.loads[i].torque = Lane4{};
  }
}

double Yarns::stiffness_over_mass(const Bodies& bodies, const Contacts& contacts) const {
  std::vector<double> stiffest;
  for (const WireCurve& curve : curves_) stiffest.push_back(curve.stiffest());
  double largest = 0;
  for (std::size_t n = 0; n < node_.size(); ++n) {
    const auto i = static_cast<std::size_t>(node_[n]);
    Lane4 along = bodies.stiffness[i].force;
    for (std::uint32_t s = contacts.singles_start[i]; s < contacts.singles_start[i + 1]; ++s)
      along += bodies.stiffness[contacts.singles[s].load].force;
    for (std::uint32_t e = start_[n]; e < start_[n + 1]; ++e) {
      const Yarn& yarn = yarns_[ends_[e] / 2];
      if (yarn.memory.broken) continue;
      const double k = stiffest[static_cast<std::size_t>(yarn.geotextile)] / yarn.rest_length;
      const double sideways = yarn.tension / yarn.length;  // a taut string's
      const Lane4 n2 = yarn.direction * yarn.direction;
      along += k * n2 + sideways * (1.0 - n2);
    }
    largest = std::max(largest, std::max({along[0], along[1], along[2]}) / bodies.mass(i));
  }
  return largest;
}

io::YarnsRecord Yarns::record() const {
  io::YarnsRecord r = identity_;
  for (std::size_t k = 0; k < yarns_.size(); ++k) {
    const Yarn& yarn = yarns_[k];
    r.largest_strain[k] = yarn.memory.largest_strain;
    r.broken[k] = yarn.memory.broken;
    r.tension[k] = yarn.tension;
    r.break_time[k] = yarn.break_time, r.break_position[k] = yarn.break_position;
  }
  return r;
}

}  // namespace soilweave::dem
