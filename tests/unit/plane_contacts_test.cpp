// Pairs with planes are grouped by chunks of grains, whatever else is listed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact/plane_contacts.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <utility>
#include <vector>

#include "support/assembly.h"

namespace soilweave::dem {
namespace {

using Key = std::pair<std::int32_t, std::int32_t>;

// Returns grain and plane of the pairs of each group, in which sums are taken one by one.
std::vector<std::vector<Key>> groups_of(const PlaneContacts& planes) {
  std::vector<std::vector<Key>> all;
  for (std::size_t g = 0; g + 1 < planes.groups().size(); ++g) {
    all.emplace_back();
    for (std::size_t b = planes.groups()[g]; b < planes.groups()[g + 1]; ++b) {
      const PlaneBlock& block = planes.blocks()[b];
      for (int k = 0; k < block.pairs.count; ++k)
        all.back().emplace_back(ContactBlock::index(block.pairs.first[k]), block.plane);
    }
  }
  return all;
}

TEST(PlaneContacts, AreGroupedAlikeWhateverDistantPairsAreListed) {
  constexpr std::int32_t grains = 2500;
  io::Snapshot row;
  for (int grain = 0; grain < grains; ++grain) analysis::test::add_grain(row, Vec3(grain, 0, 0), 0.4);
  const Bodies bodies(row.grains);
  std::vector<PlanePair> all, touching;
  std::set<Key> touch;
  for (std::int32_t plane = 0; plane < 2; ++plane)
    for (std::int32_t grain = 0; grain < grains; ++grain) {
      all.push_back({grain, plane});
      if (grain % 3 != 0) continue;
      touching.push_back({grain, plane});
      touch.emplace(grain, plane);
    }
  PlaneContacts few, many;
  few.list(touching, bodies);
  many.list(all, bodies);
  std::vector<std::vector<Key>> of_many = groups_of(many);
  for (std::vector<Key>& group : of_many)
    std::erase_if(group, [&touch](const Key& pair) { return touch.count(pair) == 0; });
  EXPECT_EQ(groups_of(few), of_many);
  EXPECT_GT(of_many.size(), 4u);
  few.list({}, bodies);
  EXPECT_TRUE(groups_of(few).empty());
}

}  // namespace
}  // namespace soilweave::dem
