// How a file came to be: one record per tool run, pointing to the records of its inputs.
// Only what can change the result is kept: no clock, host, absolute path, thread count.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/doubts.h"
#include "core/tool.h"

namespace soilweave::io {

struct InputRecord {
  std::string role;    // "packing", "scenario", "grading", ...
  std::string sha256;  // of the bytes read
  int origin = -1;     // index into History of the record that made it; -1 for a datum from outside
};

struct ProvenanceRecord {
  std::string tool, version, command;
  std::string scenario;  // resolved TOML, empty where there is none
  std::uint64_t seed = 0;
  std::vector<InputRecord> inputs;
  std::vector<Doubt> doubts = {};  // about what this run wrote
};

/// Oldest first; the last record is the run that wrote the file. A merge keeps all parents, each once.
using History = std::vector<ProvenanceRecord>;

/// Lower-case hexadecimal SHA-256 of bytes.
std::string sha256(std::string_view bytes);

/// One input as it was read: its role, digest and own history (empty for text files).
struct Source {
  std::string role, sha256;
  History history;
};

/// The history a new file gets: all histories of its sources merged, then the record of this invocation.
History extend(const std::vector<Source>& sources, const tool::Invocation& invocation, std::string scenario = "");

/// The history with the doubts of the run that writes the file, in its last record.
History with_doubts(History history, const Doubts& doubts);
/// The history without the doubts in its last record: what is known of a run before it has ended.
History without_doubts(History history);

/// The chain for people, one paragraph a record (to-vtk --history).
std::string describe(const History& history);

}  // namespace soilweave::io
