// Lanes of blocks of pairs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact/contact_block.h"

namespace soilweave::dem {

void copy_history(const ContactBlock& from, int k, ContactBlock& to, int l) {
  if (!((from.touching >> k) & 1)) return;  // the lane holds zeros
  const double* source = from.shear[0] + k;
  double* target = to.shear[0] + l;
  for (int array = 0; array < ContactBlock::arrays; ++array)
    target[array * ContactBlock::size] = source[array * ContactBlock::size];
  to.touching = ContactBlock::with_bit(to.touching, l, true);
  to.sliding = ContactBlock::with_bit(to.sliding, l, (from.sliding >> k) & 1);
}

PairHistory history_of(const ContactBlock& b, int k) {
  PairHistory h;
  h.history.shear = {b.shear[0][k], b.shear[1][k], b.shear[2][k]};
  h.history.rolling = {b.rolling[0][k], b.rolling[1][k], b.rolling[2][k]};
  h.history.twisting = b.twisting[k];
  h.normal_force = b.normal_force[k];
  h.touching = (b.touching >> k) & 1;
  h.sliding = (b.sliding >> k) & 1;
  return h;
}

void set_history(ContactBlock& b, int k, const PairHistory& h) {
  b.shear[0][k] = h.history.shear.x, b.shear[1][k] = h.history.shear.y, b.shear[2][k] = h.history.shear.z;
  b.rolling[0][k] = h.history.rolling.x, b.rolling[1][k] = h.history.rolling.y, b.rolling[2][k] = h.history.rolling.z;
  b.twisting[k] = h.history.twisting;
  b.normal_force[k] = h.normal_force;
  b.touching = ContactBlock::with_bit(b.touching, k, h.touching);
  b.sliding = ContactBlock::with_bit(b.sliding, k, h.sliding);
}

}  // namespace soilweave::dem
