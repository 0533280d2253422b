// Refuses a processor that is too old for the compiled code, before anything else runs.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/processor.h"

#include <unistd.h>

namespace {

#ifdef __x86_64__
// The Makefile compiles this file for any x86-64, the others for newer ones. The check runs before the constructors of
// the other files, and may call only the system.
[[gnu::constructor(101)]] void demand_processor() {
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma") && __builtin_cpu_supports("bmi2")) return;
  constexpr char message[] =
      "soilweave: this processor lacks AVX2, FMA or BMI2 (x86-64-v3, in use since 2013 to 2015): run it on a newer "
      "one\n";
  [[maybe_unused]] const auto told = write(STDERR_FILENO, message, sizeof message - 1);
  _exit(soilweave::old_processor_status);
}
#endif

}  // namespace

namespace soilweave {

void link_processor_check() {}

}  // namespace soilweave
