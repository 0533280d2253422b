// Candidate pairs and the contacts among them, in blocks of eight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact/contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

#include "core/error.h"
#include "core/in_parallel.h"

namespace soilweave::dem {
namespace {

// Offset of empty lanes: so far away that they never touch.
const CellOffset far_away = cell_offset({1 << 20, 0, 0});

std::vector<CellOffset> images_of(const std::vector<Pair>& pairs) {
  std::vector<CellOffset> found;
  for (const Pair& p : pairs)
    if (p.image != 0 && std::find(found.begin(), found.end(), p.image) == found.end()) found.push_back(p.image);
  std::sort(found.begin(), found.end());
  found.insert(found.begin(), 0);
  found.push_back(far_away);
  return found;
}

std::uint16_t place(CellOffset image, const std::vector<CellOffset>& images) {
  if (image == 0) return 0;
  return static_cast<std::uint16_t>(std::lower_bound(images.begin() + 1, images.end() - 1, image) - images.begin());
}

Pair pair_of(const ContactBlock& b, int k, const std::vector<CellOffset>& images) {
  return {ContactBlock::index(b.first[k]), ContactBlock::index(b.second[k]), images[b.image[k]]};
}

// Returns whether the second grain of a pair of this chunk is in another chunk, which is then a higher one.
bool is_far(const Pair& pair, std::size_t chunk) {
  return static_cast<std::size_t>(pair.second) >= (chunk + 1) * grains_per_chunk;
}

// Pairs of a chunk in the previous list, visited in order.
class Known {
 public:
  Known(const std::vector<ContactBlock>& chunk, const std::vector<double>& own, std::size_t numbers,
        const std::vector<CellOffset>& images, const PairOrder& before)
      : block_(chunk.data()), end_(block_ + chunk.size()), images_(images), before_(before) {
    own_ = own.data(), numbers_ = numbers;
    settle();
  }
  /// Returns how many numbers only the law keeps for a pair.
  std::size_t own_numbers() const { return numbers_; }
  /// Copies the history of a pair that was listed before into a lane. Calls must follow the order of pairs.
  void pass_on(const Pair& pair, ContactBlock& to, double* own_to, int lane) {
    while (block_ != end_ && before_(pair_, pair)) next();
    if (block_ != end_ && !before_(pair, pair_)) copy_history(*block_, own_, lane_, numbers_, to, own_to, lane);
  }

 private:
  void next() {
    if (++lane_ == block_->count) ++block_, lane_ = 0, own_ += numbers_ * ContactBlock::size;
    settle();
  }
  void settle() {
    if (block_ != end_) pair_ = pair_of(*block_, lane_, images_);
  }

  const ContactBlock *block_, *end_;
  const double* own_ = nullptr;  // the law's own numbers of the block
  std::size_t numbers_ = 0;
  int lane_ = 0;
  const std::vector<CellOffset>& images_;
  PairOrder before_;
  Pair pair_{};
};

// Fills the empty lanes from k on with a pair of `grain` and its own image, far away.
void leave_empty(ContactBlock& block, int k, std::size_t grain, std::size_t far) {
  std::fill(block.first + k, block.first + ContactBlock::size, grain_distance(grain));
  std::fill(block.second + k, block.second + ContactBlock::size, grain_distance(grain));
  std::fill(block.load_second + k, block.load_second + ContactBlock::size, load_distance(grain));
  std::fill(block.image + k, block.image + ContactBlock::size, static_cast<std::uint16_t>(far));
  block.folded = static_cast<std::uint8_t>(block.folded | (~0u << k));
}

// Returns how many blocks the pairs of a chunk fill. Each pair of materials begins a new block.
std::size_t blocks_of(std::span<const Pair> pairs, const PairOrder& order) {
  std::size_t blocks = 0, begin = 0;
  for (std::size_t k = 1; k <= pairs.size(); ++k) {
    if (k < pairs.size() && order.same_materials(pairs[k], pairs[begin])) continue;
    blocks += (k - begin + ContactBlock::size - 1) / ContactBlock::size;
    begin = k;
  }
  return blocks;
}

// Fills the blocks of a chunk with pairs and their history. Pairs with grains of other chunks get loads from `load` on.
void fill(std::vector<ContactBlock>& blocks, std::vector<double>& own, std::size_t chunk, std::span<const Pair> pairs,
          std::size_t load, const std::vector<CellOffset>& images, const PairOrder& order, Known known) {
  const std::size_t begin = chunk * grains_per_chunk;
  blocks.clear(), own.clear();
  const std::size_t own_size = known.own_numbers() * ContactBlock::size;
  // Arrays that grow by doubling would be up to twice as large as needed.
  const std::size_t needed = blocks_of(pairs, order);
  blocks.reserve(needed), own.reserve(needed * own_size);
  for (auto at = pairs.begin(); at != pairs.end();) {
    ContactBlock& block = blocks.emplace_back();
    own.resize(own.size() + own_size);
    double* const own_of_block = own.data() + (own.size() - own_size);
    const Pair& like = *at;
    for (; block.count < ContactBlock::size && at != pairs.end() && order.same_materials(*at, like);
         ++at, ++block.count) {
      const int k = block.count;
      const auto first = static_cast<std::size_t>(at->first), second = static_cast<std::size_t>(at->second);
      block.first[k] = grain_distance(first), block.second[k] = grain_distance(second);
      block.load_second[k] = load_distance(is_far(*at, chunk) ? load++ : second);
      block.image[k] = place(at->image, images);
      block.folded = ContactBlock::with_bit(block.folded, k, block.image[k] != 0);
      known.pass_on(*at, block, own_of_block, k);
    }
    if (block.count < ContactBlock::size) leave_empty(block, block.count, begin, images.size() - 1);
  }
}

}  // namespace

void Contacts::look_across(const std::vector<Pair>& pairs) {
  reached_.resize(chunks.size()), across_.resize(chunks.size()), work_.resize(chunks.size());
  in_parallel(chunks.size(), threads, [&](std::size_t chunk) {
    std::vector<std::uint32_t>& reached = reached_[chunk];
    std::vector<std::int32_t>& grains = across_[chunk];
    reached.clear(), grains.clear();
    const std::span<const Pair> own = of_chunk(std::span(pairs), chunk);
    work_[chunk] = own.size() + grains_per_chunk;
    for (const Pair& p : own) {
      if (!is_far(p, chunk)) continue;
      grains.push_back(p.second);
      const auto other = static_cast<std::uint32_t>(chunk_of(p.second));
      if (std::find(reached.begin(), reached.end(), other) == reached.end()) reached.push_back(other);
    }
  });
}

void Contacts::name_single_loads(Bodies& bodies) {
  const std::size_t grains = bodies.size();
  const auto each = [this](const auto& visit) {
    for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk)
      for (const std::int32_t grain : across_[chunk]) visit(static_cast<std::size_t>(grain));
    for (const PlaneBlock& block : planes.blocks())
      for (int k = 0; k < block.pairs.count; ++k)
        visit(static_cast<std::size_t>(ContactBlock::index(block.pairs.first[k])));
  };
  single_loads_start.assign(grains + 1, 0);
  each([this](std::size_t grain) { ++single_loads_start[grain + 1]; });
  std::partial_sum(single_loads_start.begin(), single_loads_start.end(), single_loads_start.begin());
  single_loads.resize(single_loads_start.back());
  const std::size_t loads = grains + single_loads.size();
  constexpr std::size_t farthest = std::numeric_limits<std::uint32_t>::max();
  if (grains > farthest / sizeof(Grain) || loads > farthest / sizeof(Load))
    throw DataError(fmt::format("{} grains are more than one simulation can hold: {} million", grains,
                                farthest / sizeof(Grain) / 1'000'000));
  bodies.loads.resize(loads);
  bodies.stiffness.resize(loads);
  next_.assign(single_loads_start.begin(), single_loads_start.end() - 1);
  const std::size_t first_of_planes = std::transform_reduce(across_.begin(), across_.end(), grains, std::plus<>(),
                                                            [](const auto& across) { return across.size(); });
  auto load = static_cast<std::uint32_t>(grains);
  each([&](std::size_t grain) { single_loads[next_[grain]++] = {load++, static_cast<std::int32_t>(grain)}; });
  planes.set_loads(first_of_planes);
}

void Contacts::list(const std::vector<Pair>& pairs, std::vector<PlanePair> with_planes, Bodies& bodies) {
  const std::vector<CellOffset> known_images = std::exchange(images, images_of(pairs));
  if (images.size() > std::numeric_limits<std::uint16_t>::max())
    throw DataError(fmt::format("grains touch across {} cell offsets, more than can be told apart", images.size()));
  planes.list(std::move(with_planes), bodies);
  chunks.resize(chunks_of(bodies.size())), own.resize(chunks.size());
  look_across(pairs);
  name_single_loads(bodies);
  plan = ChunkPlan(reached_, work_, threads);
  std::vector<std::size_t> first_load(chunks.size());
  std::transform_exclusive_scan(across_.begin(), across_.end(), first_load.begin(), bodies.size(), std::plus<>(),
                                [](const auto& grains) { return grains.size(); });
  known_.resize(static_cast<std::size_t>(threads)), known_own_.resize(known_.size());
  const PairOrder order(bodies);
  in_parallel(known_.size(), threads, [&](std::size_t share) {
    std::vector<ContactBlock>& known = known_[share];
    const std::size_t end = (share + 1) * chunks.size() / known_.size();
    for (std::size_t chunk = share * chunks.size() / known_.size(); chunk < end; ++chunk) {
      known.swap(chunks[chunk]), known_own_[share].swap(own[chunk]);
      fill(chunks[chunk], own[chunk], chunk, of_chunk(std::span(pairs), chunk), first_load[chunk], images, order,
           Known(known, known_own_[share], own_numbers_, known_images, order));
    }
  });
}

void Contacts::keep_own(std::span<const HistoryField> fields) {
  own_fields = fields, own_numbers_ = 0;
  for (const HistoryField& field : fields) own_numbers_ += field.numbers();
  planes.keep_own(own_numbers_);
}

Pair Contacts::pair(const ContactBlock& block, int k) const { return pair_of(block, k, images); }

namespace {

// Calls use(number) for each number of history that a record of disks keeps as a vector: the shear force, then the
// law's own vectors, contact by contact.
template <class AnyContacts, class Use>
void numbers_of_disks(AnyContacts& contacts, const Use& use) {
  for (std::size_t chunk = 0; chunk < contacts.chunks.size(); ++chunk)
    for (std::size_t b = 0; b < contacts.chunks[chunk].size(); ++b) {
      auto& block = contacts.chunks[chunk][b];
      for (int k = 0; k < block.count; ++k) {
        if (!((block.touching >> k) & 1)) continue;
        use(block.shear[2][k]);
        auto* own = contacts.own_of(chunk, b) + k;
        for (const HistoryField& field : contacts.own_fields) {
          if (field.kind == HistoryField::Kind::along) use(own[2 * ContactBlock::size]);
          own += field.numbers() * ContactBlock::size;
        }
      }
    }
}

}  // namespace

std::vector<double> shear_forces_of_disks(const Contacts& contacts) {
  std::vector<double> forces;
  numbers_of_disks(contacts, [&](double number) { forces.push_back(number); });
  return forces;
}

void set_shear_forces_of_disks(const std::vector<double>& forces, Contacts& contacts) {
  auto next = forces.begin();
  numbers_of_disks(contacts, [&](double& number) {
    if (next == forces.end()) throw DataError("shear_force: is of fewer contacts; begin anew");
    number = *next++;
  });
  if (next != forces.end()) throw DataError("shear_force: is of more contacts; begin anew");
}

double force_sum(const Contacts& contacts) {
  double sum = 0;
  // Pairs that do not touch hold zeros, so they may be added too.
  const auto add = [&sum](const ContactBlock& block) {
    for (int k = 0; k < ContactBlock::size; k += width<Lane4>) {
      const V3<Lane4> shear{load<Lane4>(block.shear[0] + k), load<Lane4>(block.shear[1] + k),
                            load<Lane4>(block.shear[2] + k)};
      const Lane4 normal = load<Lane4>(block.normal_force + k);
      const Lane4 force = square_root(fused(normal, normal, norm2(shear)));
      for (int lane = 0; lane < width<Lane4>; ++lane) sum += force[lane];
    }
  };
  for (const auto& chunk : contacts.chunks)
    for (const ContactBlock& block : chunk) add(block);
  for (const PlaneBlock& block : contacts.planes.blocks()) add(block.pairs);
  return sum;
}

}  // namespace soilweave::dem
