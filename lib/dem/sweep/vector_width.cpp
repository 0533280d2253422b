// Width of the vector loops over contacts and grains, chosen once per run by the processor.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/contact_sweep.h"
#include "dem/sweep/grain_motion.h"

namespace soilweave::dem {
namespace {

#ifdef SOILWEAVE_AVX512
// Returns whether the processor has the instructions that the objects of eight lanes use (Makefile).
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
