// Pairs of grains and planes, in blocks of eight.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact/plane_contacts.h"

#include <algorithm>
#include <tuple>

namespace soilweave::dem {

std::vector<PlanePair> PlaneContacts::pairs() const {
  std::vector<PlanePair> all;
  for (std::size_t b = 0; b < blocks_.size(); ++b)
    for (int k = 0; k < blocks_[b].pairs.count; ++k)
      all.push_back({ContactBlock::index(blocks_[b].pairs.first[k]), blocks_[b].plane,
                     history_of(blocks_[b].pairs, k, own(b), own_arrays_)});
  return all;
}

void PlaneContacts::list(std::vector<PlanePair> pairs, const Bodies& bodies) {
  const auto material = [&bodies](const PlanePair& p) { return bodies.material[static_cast<std::size_t>(p.grain)]; };
  const auto place = [&](const PlanePair& p) { return std::tuple(p.plane, material(p), p.grain); };
  std::sort(pairs.begin(), pairs.end(),
            [&place](const PlanePair& a, const PlanePair& b) { return place(a) < place(b); });
  const std::vector<PlanePair> known = this->pairs();
  auto old = known.begin();
  blocks_.clear(), own_.clear(), groups_.clear();
  const PlanePair* like = nullptr;
  for (PlanePair& p : pairs) {
    while (old != known.end() && place(*old) < place(p)) ++old;
    if (old != known.end() && place(*old) == place(p)) p.history = old->history;
    const bool grouped =
        like && like->plane == p.plane && material(*like) == material(p) && chunk_of(like->grain) == chunk_of(p.grain);
    if (!grouped) groups_.push_back(blocks_.size());
    if (!grouped || blocks_.back().pairs.count == ContactBlock::size) {
      PlaneBlock& block = blocks_.emplace_back();
      block.plane = p.plane;
      own_.resize(own_.size() + own_arrays_ * ContactBlock::size);
      std::fill_n(block.pairs.first, ContactBlock::size, grain_distance(static_cast<std::size_t>(p.grain)));
    }
    like = &p;
    ContactBlock& block = blocks_.back().pairs;
    block.first[block.count] = grain_distance(static_cast<std::size_t>(p.grain));
    set_history(block, block.count++, p.history, own(blocks_.size() - 1));
  }
  groups_.push_back(blocks_.size());
}

void PlaneContacts::set_loads(std::size_t first) {
  for (PlaneBlock& block : blocks_)
    for (int k = 0; k < block.pairs.count; ++k) block.pairs.load_second[k] = load_distance(first++);
}

}  // namespace soilweave::dem
