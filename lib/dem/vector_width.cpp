// How many contacts, and grains, are taken at a time: chosen once per run, by what the processor can do.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact_sweep.h"
#include "dem/grain_motion.h"

namespace soilweave::dem {
namespace {

#ifdef SOILWEAVE_AVX512
// What the objects of eight lanes are compiled for (Makefile).
bool eight_at_a_time() {
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512bw");
}
#endif

}  // namespace

std::unique_ptr<ContactSweep> make_contact_sweep(const Model& model) {
#ifdef SOILWEAVE_AVX512
  if (eight_at_a_time()) return make_contact_sweep_of_eight(model);
#endif
  return make_contact_sweep_of_four(model);
}

GrainMotion grain_motion() {
#ifdef SOILWEAVE_AVX512
  if (eight_at_a_time()) return grain_motion_of_eight();
#endif
  return grain_motion_of_four();
}

}  // namespace soilweave::dem
