// The yarns of all geotextiles.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/engine/yarns.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/error.h"
#include "core/in_parallel.h"
#include "core/simd/columns.h"
#include "dem/sweep/pair_rows.h"

namespace soilweave::dem {
namespace {

// Blocks of yarns per chunk; one thread takes a chunk at a time, and sums are made chunk by chunk.
constexpr std::size_t blocks_per_chunk = 128;
// Least length, m, for divisions. Nodes of a torn fabric may coincide. Their yarn is then slack and has no direction.
constexpr double least_length = 1e-12;

double sum_of(const Lane4& l) { return l[0] + l[1] + l[2] + l[3]; }

/// Returns the energy that unloading returns, J. `per_unloading`: inverse slope of unloading, 1/N.
Lane4 elastic(const Lane4& tension, const Lane4& rest_length, double per_unloading) {
  return 0.5 * per_unloading * rest_length * tension * tension;
}

}  // namespace

Yarns::Yarns(const io::YarnsRecord& record, std::size_t grains, std::vector<WireCurve> curves)
    : curves_(std::move(curves)), identity_(record), grains_(grains) {
  if (record.size() == 0) return;
  lay_out(record);
  list_ends(record);
  partial_.resize((blocks_.size() + blocks_per_chunk - 1) / blocks_per_chunk);
  fabric_of();
}

void Yarns::lay_out(const io::YarnsRecord& record) {
  std::vector<std::size_t> order(record.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  // Yarns are sorted by nodes, so that a thread sums forces at nodes whose yarns it has just stretched.
  const auto place = [&record](std::size_t k) { return std::pair(record.geotextile_id[k], record.nodes[k][0]); };
  std::stable_sort(order.begin(), order.end(), [&place](std::size_t a, std::size_t b) { return place(a) < place(b); });
  slot_.resize(record.size());
  for (const std::size_t k : order) {
    const std::int32_t geotextile = record.geotextile_id[k];
    if (static_cast<std::size_t>(geotextile) >= curves_.size())
      throw DataError(
          fmt::format("the packing has yarns of geotextile {}, the scenario describes {}: add [[geotextile]]",
                      geotextile, curves_.size()));
    if (blocks_.empty() || blocks_.back().count == Block::size || blocks_.back().geotextile != geotextile)
      blocks_.push_back(Block(geotextile));
    Block& block = blocks_.back();
    const auto lane = static_cast<std::size_t>(block.count++);
    slot_[k] = (blocks_.size() - 1) * Block::size + lane;
    block.first[lane] = grain_distance(static_cast<std::size_t>(record.nodes[k][0])),
    block.second[lane] = grain_distance(static_cast<std::size_t>(record.nodes[k][1]));
    block.rest_length[lane] = record.rest_length[k];
    block.tension[lane] = record.tension[k];
    block.history.largest_strain[lane] = record.largest_strain[k];
    block.history.broken[lane] = record.broken[k] ? -1 : 0;
  }
  pulls_.resize(blocks_.size() * Block::size);
  breakage_.resize(pulls_.size());
  for (std::size_t k = 0; k < record.size(); ++k)
    breakage_[slot_[k]] = {record.break_time[k], record.break_position[k]};
}

void Yarns::list_ends(const io::YarnsRecord& record) {
  std::vector<std::uint32_t> count(grains_, 0), place(grains_, 0);
  for (const auto& nodes : record.nodes)
    for (const std::int32_t node : nodes) ++count[static_cast<std::size_t>(node)];
  start_.assign(1, 0);
  for (std::size_t i = 0; i < grains_; ++i) {
    if (count[i] == 0) continue;
    place[i] = start_.back();
    node_.push_back(static_cast<std::int32_t>(i));
    start_.push_back(start_.back() + count[i]);
  }
  ends_.resize(start_.back());
  for (std::size_t k = 0; k < record.size(); ++k)
    for (std::uint32_t side = 0; side < 2; ++side)
      ends_[place[static_cast<std::size_t>(record.nodes[k][side])]++] = 2 * static_cast<std::uint32_t>(slot_[k]) + side;
}

std::vector<std::int32_t> Yarns::fabric_of() const {
  if (!any()) return {};
  std::vector<std::int32_t> fabric(grains_, -1);
  for (std::size_t k = 0; k < identity_.size(); ++k)
    for (const std::int32_t node : identity_.nodes[k]) {
      std::int32_t& of = fabric[static_cast<std::size_t>(node)];
      if (of >= 0 && of != identity_.fabric[k])
        throw DataError(fmt::format("node {} belongs to the fabrics {} and {}", node, of, identity_.fabric[k]));
      of = identity_.fabric[k];
    }
  return fabric;
}

YarnSums Yarns::stretch(double time, const Bodies& bodies, std::size_t number) {
  Block& block = blocks_[number];
  const auto* const grains = reinterpret_cast<const std::byte*>(bodies.grains.data());
  const Side one{grains, block.first}, two{grains, block.second};
  const auto along = [&](int k) -> Lane4 { return two[k].position - one[k].position; };
  const Columns<Lane4> c = columns({along(0), along(1), along(2), along(3)});
  const V3<Lane4> reach{c.a, c.b, c.c};
  const WireCurve& curve = curves_[static_cast<std::size_t>(block.geotextile)];
  const double per_unloading = 1 / curve.unloading;

  const Lane4 length = square_root(norm2(reach)), before = block.tension, length_before = block.length;
  const Mask<Lane4> broken_before = block.history.broken;
  const Lane4 tension = pull<Lane4>(curve, length / block.rest_length - 1, block.history);
  block.tension = tension, block.length = length;
  Lane4* const pulls = pulls_.data() + number * Block::size;
  const Lane4 inverse = 1 / maximum(length, broadcast<Lane4>(least_length));
  to_rows(inverse * reach.x, inverse * reach.y, inverse * reach.z, tension,
          [pulls](int lane, const Lane4& row) { pulls[lane] = row; });
  if (const unsigned breaking = bits(block.history.broken & ~broken_before)) [[unlikely]]
    for (std::size_t lane = 0; lane < Block::size; ++lane)
      if ((breaking >> lane) & 1) note_breakage(time, bodies, number * Block::size + lane);

  const Lane4 stored = elastic(tension, block.rest_length, per_unloading);
  const Lane4 gained = stored - elastic(before, block.rest_length, per_unloading);
  const Lane4 work = 0.5 * (before + tension) * (length - length_before);
  const Mask<Lane4> known = ~broken_before & (length_before > 0);
  const auto in = [](const Mask<Lane4>& mask) { return std::popcount(bits(mask)); };
  YarnSums s;
  s.elastic = sum_of(stored);
  s.dissipated = sum_of(masked(known, Lane4(work - gained)));
  s.tension = sum_of(tension);
  const Lane4 pull_over_length = tension * inverse;
  const std::array<const Lane4*, 3> parts = {&reach.x, &reach.y, &reach.z};
  for (int a = 0; a < 3; ++a)
    for (int b = a; b < 3; ++b)
      s.force_branch(a, b) = s.force_branch(b, a) =
          -sum_of(pull_over_length * *parts[static_cast<std::size_t>(a)] * *parts[static_cast<std::size_t>(b)]);
  s.taut = in(tension > 0);
  s.broken = in(block.history.broken) - static_cast<std::int64_t>(Block::size) + block.count;
  return s;
}

void Yarns::note_breakage(double time, const Bodies& bodies, std::size_t slot) {
  const Block& block = blocks_[slot / Block::size];
  const auto at = [&](const std::uint32_t* end) {
    return vector_of(Side{reinterpret_cast<const std::byte*>(bodies.grains.data()), end}[slot % Block::size].position);
  };
  breakage_[slot] = {time, 0.5 * (at(block.first) + at(block.second))};
}

void Yarns::run(double time, int threads, Bodies& bodies) {
  in_parallel(partial_.size(), threads, [&](std::size_t chunk) {
    const std::size_t end = std::min(blocks_.size(), (chunk + 1) * blocks_per_chunk);
    partial_[chunk] = {};
    for (std::size_t b = chunk * blocks_per_chunk; b < end; ++b) partial_[chunk] += stretch(time, bodies, b);
  });
  sums_ = {};
  for (const YarnSums& p : partial_) sums_ += p;
  in_parallel(node_.size(), threads, [&](std::size_t n) {
    Lane4 force{};
    for (std::uint32_t e = start_[n]; e < start_[n + 1]; ++e) {
      const Lane4& pull = pulls_[ends_[e] / 2];
      force += (ends_[e] % 2 == 0 ? pull[3] : -pull[3]) * pull;
    }
    force[3] = 0;
    bodies.loads[static_cast<std::size_t>(node_[n])].force += force;
  });
}

double Yarns::stiffness_over_mass(const Bodies& bodies, const Contacts& contacts) const {
  const std::vector<double> stiffest = this->stiffest();
  return largest_in_parallel(node_.size(), contacts.threads, [&](std::size_t n) {
    const auto i = static_cast<std::size_t>(node_[n]);
    Lane4 along = bodies.stiffness[i].force;
    for (std::uint32_t s = contacts.single_loads_start[i]; s < contacts.single_loads_start[i + 1]; ++s)
      along += bodies.stiffness[contacts.single_loads[s].load].force;
    for (std::uint32_t e = start_[n]; e < start_[n + 1]; ++e) {
      const std::size_t slot = ends_[e] / 2, lane = slot % Block::size;
      const Block& block = blocks_[slot / Block::size];
      if (block.history.broken[lane]) continue;
      const double k = stiffest[static_cast<std::size_t>(block.geotextile)] / block.rest_length[lane];
      const double sideways =
          block.tension[lane] / std::max(block.length[lane], least_length);  // stiffness of a taut string
      const Lane4 n2 = pulls_[slot] * pulls_[slot];
      along += k * n2 + sideways * (1.0 - n2);
    }
    return std::max({along[0], along[1], along[2]}) / bodies.mass(i);
  });
}

std::vector<double> Yarns::stiffest() const {
  std::vector<double> stiffest;
  for (const WireCurve& curve : curves_) stiffest.push_back(curve.stiffest());
  return stiffest;
}

Vec3 Yarns::affine_stiffness(int threads) const {
  const std::vector<double> stiffest = this->stiffest();
  std::vector<Vec3> partial((blocks_.size() + blocks_per_chunk - 1) / blocks_per_chunk, Vec3::Zero());
  in_parallel(partial.size(), threads, [&](std::size_t chunk) {
    const std::size_t end = std::min(blocks_.size(), (chunk + 1) * blocks_per_chunk);
    for (std::size_t b = chunk * blocks_per_chunk; b < end; ++b)
      for (std::size_t lane = 0; lane < Block::size; ++lane) {
        const Block& block = blocks_[b];
        if (!(block.tension[lane] > 0)) continue;
        const double length = block.length[lane], sideways = block.tension[lane] / length;
        const double along = stiffest[static_cast<std::size_t>(block.geotextile)] / block.rest_length[lane];
        const Vec3 n2 = vector_of(pulls_[b * Block::size + lane]).cwiseAbs2();
        partial[chunk] += length * length * n2.cwiseProduct(((along - sideways) * n2.array() + sideways).matrix());
      }
  });
  return std::accumulate(partial.begin(), partial.end(), Vec3(Vec3::Zero()));
}

io::YarnsRecord Yarns::record() const {
  io::YarnsRecord r = identity_;
  for (std::size_t k = 0; k < slot_.size(); ++k) {
    const Block& block = blocks_[slot_[k] / Block::size];
    const std::size_t lane = slot_[k] % Block::size;
    r.largest_strain[k] = block.history.largest_strain[lane];
    r.broken[k] = block.history.broken[lane] != 0;
    r.tension[k] = block.tension[lane];
    r.break_time[k] = breakage_[slot_[k]].time, r.break_position[k] = breakage_[slot_[k]].position;
  }
  return r;
}

}  // namespace soilweave::dem
