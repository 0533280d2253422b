// libFuzzer on one reader, chosen when this is compiled: -DREADER=scenario and so on.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <cstdint>

#include "support/hostile.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  soilweave::hostile::READER({reinterpret_cast<const char*>(data), size});
  return 0;
}
