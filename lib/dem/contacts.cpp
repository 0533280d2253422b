// Candidate pairs and the contacts among them, in blocks of eight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contacts.h"

#include <algorithm>
#include <tuple>

namespace soilweave::dem {
namespace {

// Empty lanes name a grain so many cells away that they never touch.
const Vec3i far_away{1 << 20, 0, 0};

bool earlier(const Vec3i& a, const Vec3i& b) { return std::tuple(a[0], a[1], a[2]) < std::tuple(b[0], b[1], b[2]); }

std::vector<Vec3i> images_of(const std::vector<Pair>& pairs) {
  std::vector<Vec3i> found;
  for (const Pair& p : pairs)
    if (!p.image.isZero() && std::find(found.begin(), found.end(), p.image) == found.end()) found.push_back(p.image);
  std::sort(found.begin(), found.end(), earlier);
  found.insert(found.begin(), Vec3i::Zero());
  found.push_back(far_away);
  return found;
}

std::uint32_t row_distance(std::size_t index) { return static_cast<std::uint32_t>(index) * ContactBlock::row_size; }

std::size_t place(const Vec3i& image, const std::vector<Vec3i>& images) {
  if (image.isZero()) return 0;
  return static_cast<std::size_t>(std::lower_bound(images.begin() + 1, images.end() - 1, image, earlier) -
                                  images.begin());
}

auto key(const Pair& p) { return std::tuple(p.first, p.second, p.image[0], p.image[1], p.image[2]); }

// Walks through the pairs of a list in order.
struct Cursor {
  const Contacts& contacts;
  std::size_t block = 0;
  int lane = 0;

  explicit Cursor(const Contacts& list) : contacts(list) { settle(); }
  bool done() const { return block >= contacts.blocks.size(); }
  Pair pair() const { return contacts.pair(block, lane); }
  void next() {
    ++lane;
    settle();
  }

 private:
  void settle() {
    while (!done() && lane >= contacts.blocks[block].count) ++block, lane = 0;
  }
};

}  // namespace

bool before(const Pair& a, const Pair& b) { return key(a) < key(b); }

void Contacts::assign(std::size_t grains, const std::vector<Pair>& pairs, std::vector<PlanePair> with_planes) {
  planes = std::move(with_planes);
  images = images_of(pairs);
  load_start.assign(grains + 1, 0);
  for (const Pair& p : pairs)
    if (chunk_of(p.first) != chunk_of(p.second)) ++load_start[static_cast<std::size_t>(p.second) + 1];
  for (const PlanePair& p : planes) ++load_start[static_cast<std::size_t>(p.grain) + 1];
  load_start[0] = static_cast<std::uint32_t>(grains);
  for (std::size_t b = 0; b < grains; ++b) load_start[b + 1] += load_start[b];
  std::vector<std::uint32_t> next(load_start.begin(), load_start.end() - 1);
  loads.assign(load_start.back(), Load{});

  blocks.clear();
  chunk_start.assign(1, 0);
  std::size_t at = 0;
  for (std::size_t chunk = 0; chunk < chunks_of(grains); ++chunk) {
    const auto begin = static_cast<std::uint32_t>(chunk * grains_per_chunk);
    const auto end = static_cast<std::int32_t>((chunk + 1) * grains_per_chunk);
    while (at < pairs.size() && pairs[at].first < end) {
      ContactBlock block{};
      std::fill_n(block.first, ContactBlock::size, row_distance(begin));
      std::fill_n(block.second, ContactBlock::size, row_distance(begin));
      std::fill_n(block.load_second, ContactBlock::size, row_distance(begin));
      std::fill_n(block.image, ContactBlock::size, row_distance(images.size() - 1));
      for (; block.count < ContactBlock::size && at < pairs.size() && pairs[at].first < end; ++at, ++block.count) {
        const Pair& p = pairs[at];
        const int k = block.count;
        const auto first = static_cast<std::size_t>(p.first), second = static_cast<std::size_t>(p.second);
        block.first[k] = row_distance(first), block.second[k] = row_distance(second);
        block.image[k] = row_distance(place(p.image, images));
        block.folded = block.folded || block.image[k] != 0;
        block.load_second[k] = row_distance(p.second < end ? second : next[second]++);
      }
      block.folded = block.folded || block.count < ContactBlock::size;
      blocks.push_back(block);
    }
    chunk_start.push_back(blocks.size());
  }
  for (PlanePair& p : planes) p.load = next[static_cast<std::size_t>(p.grain)]++;
}

void Contacts::inherit(const Contacts& old) {
  Cursor from(old);
  for (Cursor to(*this); !to.done() && !from.done(); to.next()) {
    const Pair wanted = to.pair();
    while (!from.done() && before(from.pair(), wanted)) from.next();
    if (!from.done() && !before(wanted, from.pair()))
      set_history(to.block, to.lane, old.history(from.block, from.lane));
  }
  auto known = old.planes.begin();
  const auto place = [](const PlanePair& p) { return std::tuple(p.grain, p.plane); };
  for (PlanePair& p : planes) {
    while (known != old.planes.end() && place(*known) < place(p)) ++known;
    if (known != old.planes.end() && place(*known) == place(p)) p.history = known->history;
  }
}

Pair Contacts::pair(std::size_t block, int k) const {
  const ContactBlock& b = blocks[block];
  const auto image = static_cast<std::size_t>(ContactBlock::index(b.image[k]));
  return {ContactBlock::index(b.first[k]), ContactBlock::index(b.second[k]), images[image]};
}

History Contacts::history(std::size_t block, int k) const {
  const ContactBlock& b = blocks[block];
  History h;
  h.normal = {b.normal[0][k], b.normal[1][k], b.normal[2][k]};
  h.memory.shear = {b.shear[0][k], b.shear[1][k], b.shear[2][k]};
  h.memory.rolling = {b.rolling[0][k], b.rolling[1][k], b.rolling[2][k]};
  h.memory.twisting = b.twisting[k];
  h.normal_force = b.normal_force[k];
  h.touching = (b.touching >> k) & 1;
  h.sliding = (b.sliding >> k) & 1;
  return h;
}

void Contacts::set_history(std::size_t block, int k, const History& h) {
  ContactBlock& b = blocks[block];
  b.normal[0][k] = h.normal.x, b.normal[1][k] = h.normal.y, b.normal[2][k] = h.normal.z;
  b.shear[0][k] = h.memory.shear.x, b.shear[1][k] = h.memory.shear.y, b.shear[2][k] = h.memory.shear.z;
  b.rolling[0][k] = h.memory.rolling.x, b.rolling[1][k] = h.memory.rolling.y, b.rolling[2][k] = h.memory.rolling.z;
  b.twisting[k] = h.memory.twisting;
  b.normal_force[k] = h.normal_force;
  b.touching = (b.touching & ~(1u << k)) | (static_cast<std::uint32_t>(h.touching) << k);
  b.sliding = (b.sliding & ~(1u << k)) | (static_cast<std::uint32_t>(h.sliding) << k);
}

double force_sum(const Contacts& contacts) {
  double sum = 0;
  // What does not touch holds zeros.
  for (const ContactBlock& block : contacts.blocks)
    for (int k = 0; k < ContactBlock::size; k += width<Lane4>) {
      const V3<Lane4> shear{load<Lane4>(block.shear[0] + k), load<Lane4>(block.shear[1] + k),
                            load<Lane4>(block.shear[2] + k)};
      const Lane4 normal = load<Lane4>(block.normal_force + k);
      const Lane4 force = square_root(fused(normal, normal, norm2(shear)));
      for (int lane = 0; lane < width<Lane4>; ++lane) sum += force[lane];
    }
  for (const PlanePair& pair : contacts.planes)
    sum += std::sqrt(pair.history.normal_force * pair.history.normal_force + norm2(pair.history.memory.shear));
  return sum;
}

}  // namespace soilweave::dem
