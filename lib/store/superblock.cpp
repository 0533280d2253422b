// HDF5's signature and superblock.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/superblock.h"

#include <cstring>

#include "core/error.h"

namespace soilweave::io {

std::uint64_t stated_end(std::string_view bytes) {
  constexpr std::size_t version_at = 8, end_at = 28;
  if (bytes.size() < end_at + 8 || (bytes[version_at] != 2 && bytes[version_at] != 3)) return 0;
  std::uint64_t end = 0;
  std::memcpy(&end, bytes.data() + end_at, sizeof end);
  return end;
}

void check_whole(std::string_view bytes, const std::string& where) {
  static constexpr std::string_view signature("\x89HDF\r\n\x1a\n", 8);
  constexpr std::size_t smallest = 48;  // a superblock
  if (bytes.empty()) throw DataError(where + ": empty; make the file again");
  if (bytes.substr(0, signature.size()) != signature.substr(0, bytes.size()))
    throw DataError(where + ": not an HDF5 file; give a file that a soilweave tool wrote");
  constexpr std::size_t version_at = 8, flags_at = 11;
  constexpr unsigned open_to_write = 1U | 4U;  // flags of one writing program, and of one with readers (SWMR)
  if (bytes.size() >= smallest && bytes[version_at] == 3 &&
      (static_cast<unsigned char>(bytes[flags_at]) & open_to_write) != 0)
    throw DataError(
        where + ": is open for writing in another program; close it there, or, if that has crashed, run: h5clear -s " +
        where);
  const std::uint64_t end = stated_end(bytes);
  if (bytes.size() < end || bytes.size() < smallest)
    throw DataError(where + ": truncated: " + std::to_string(bytes.size()) + " bytes of " +
                    (end ? std::to_string(end) : "more") + "; copy or make the file again");
}

}  // namespace soilweave::io
