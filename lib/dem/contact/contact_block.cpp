// Lanes of blocks of pairs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact/contact_block.h"

namespace soilweave::dem {

void copy_history(const ContactBlock& from, const double* own, int k, std::size_t arrays, ContactBlock& to,
                  double* own_to, int l) {
  if (!((from.touching >> k) & 1)) return;  // the lane holds zeros
  const double* source = from.shear[0] + k;
  double* target = to.shear[0] + l;
  for (int array = 0; array < ContactBlock::arrays; ++array)
    target[array * ContactBlock::size] = source[array * ContactBlock::size];
  for (std::size_t a = 0; a < arrays; ++a) own_to[a * ContactBlock::size + l] = own[a * ContactBlock::size + k];
  to.touching = ContactBlock::with_bit(to.touching, l, true);
  to.sliding = ContactBlock::with_bit(to.sliding, l, (from.sliding >> k) & 1);
}

PairHistory history_of(const ContactBlock& b, int k, const double* own, std::size_t arrays) {
  PairHistory h;
  h.history.shear = {b.shear[0][k], b.shear[1][k], b.shear[2][k]};
  h.history.rolling = {b.rolling[0][k], b.rolling[1][k], b.rolling[2][k]};
  h.history.twisting = b.twisting[k];
  h.normal_force = b.normal_force[k];
  h.touching = (b.touching >> k) & 1;
  h.sliding = (b.sliding >> k) & 1;
  for (std::size_t a = 0; a < arrays; ++a) h.own.push_back(own[a * ContactBlock::size + static_cast<std::size_t>(k)]);
  return h;
}

void set_history(ContactBlock& b, int k, const PairHistory& h, double* own) {
  b.shear[0][k] = h.history.shear.x, b.shear[1][k] = h.history.shear.y, b.shear[2][k] = h.history.shear.z;
  b.rolling[0][k] = h.history.rolling.x, b.rolling[1][k] = h.history.rolling.y, b.rolling[2][k] = h.history.rolling.z;
  b.twisting[k] = h.history.twisting;
  b.normal_force[k] = h.normal_force;
  b.touching = ContactBlock::with_bit(b.touching, k, h.touching);
  b.sliding = ContactBlock::with_bit(b.sliding, k, h.sliding);
  for (std::size_t a = 0; a < h.own.size(); ++a) own[a * ContactBlock::size + static_cast<std::size_t>(k)] = h.own[a];
}

}  // namespace soilweave::dem
