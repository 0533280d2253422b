// Candidate pairs and the contacts among them.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// They lie in blocks of eight: what a lane of the sweep reads and writes lies side by side. A pair whose grains do not
// touch holds zeros.
//
// Grains are cut into chunks by their index, and a pair belongs to the chunk of its first grain. Of a chunk, pairs of
// one couple of materials come one after the other, sorted by (first, second, image). A chunk begins with a new block,
// and so does a couple: the pairs of a block have one answer of the law. So neither the sums over a chunk nor their
// order depend on pairs that are listed without touching, on the width of a vector register or on the number of
// threads.
#pragma once

#include <cstdint>
#include <vector>

#include "dem/bodies.h"
#include "dem/chunk_plan.h"
#include "dem/contact_block.h"
#include "dem/plane_contacts.h"

namespace soilweave::dem {

struct Contacts {
  std::vector<LargeVector<ContactBlock>> chunks;
  PlaneContacts planes;
  // Cell offsets that occur: none first, the others sorted, and last one so far away that nothing touches over it.
  std::vector<CellOffset> images;
  // Of one pair each: what pairs of other chunks, and planes, do to a grain; pairs of its own chunk add to its own
  // load. They lie in Bodies::loads after those of the grains, in the order of the blocks, planes last. Of grain b are
  // singles[singles_start[b]] up to singles[singles_start[b + 1]], in the order of its pairs, planes last.
  struct Single {
    std::uint32_t load;  // among Bodies::loads
    std::int32_t grain;
  };
  std::vector<Single> singles;
  std::vector<std::uint32_t> singles_start;
  int threads = 1;  // that share the chunks
  ChunkPlan plan;

  /// Lists these pairs, in the order of lists, and pairs with planes. A pair that was listed before keeps its history.
  /// Loads are made to fit; they must be used up, that is zero. Throws DataError beyond 65,000 cell offsets or 33
  /// million grains.
  void list(const std::vector<Pair>& pairs, std::vector<PlanePair> with_planes, Bodies& bodies);

  Pair pair(const ContactBlock& block, int lane) const;

 private:
  void look_across(const std::vector<Pair>& pairs);
  void name_singles(Bodies& bodies);

  std::vector<LargeVector<ContactBlock>> known_;     // by thread: of one chunk, while it is listed anew
  std::vector<std::vector<std::uint32_t>> reached_;  // by chunk: others that its pairs reach
  std::vector<std::vector<std::int32_t>> across_;    // by chunk: second grains of other chunks, pair by pair
  std::vector<std::size_t> work_;                    // by chunk: of a step, of a pair or a grain 1
  std::vector<std::uint32_t> next_;                  // place for another one in `singles`, of each grain
};

/// Shear forces of the contacts of disks, N, numbers as they are kept (space.h), in the order of lists.
std::vector<double> shear_forces_of_disks(const Contacts& contacts);
/// Gives them back. Throws DataError where there are not as many.
void set_shear_forces_of_disks(const std::vector<double>& forces, Contacts& contacts);

/// Sum of the magnitudes of all contact forces, N, contact by contact.
double force_sum(const Contacts& contacts);

}  // namespace soilweave::dem
