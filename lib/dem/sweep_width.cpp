// How many contacts are swept at a time: chosen once per run, by what the processor can do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact_sweep.h"

namespace soilweave::dem {

std::unique_ptr<ContactSweep> make_contact_sweep(const Model& model) {
#ifdef SOILWEAVE_AVX512
  // What the object of eight lanes is compiled for (Makefile).
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512vl") &&
      __builtin_cpu_supports("avx512bw"))
    return make_contact_sweep_of_eight(model);
#endif
  return make_contact_sweep_of_four(model);
}

}  // namespace soilweave::dem
