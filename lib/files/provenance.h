// Provenance of a file: one record per tool run. Only what can change the result is kept: no clock, host, absolute path
// or thread count.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/cli/tool.h"
#include "core/doubts.h"

namespace soilweave::io {

/// One input of a tool run.
struct InputRecord {
  std::string role;    // "packing", "scenario", "grading", ...
  std::string sha256;  // digest of the bytes read
  int origin = -1;     // index in History of the record that made it; -1: data from outside
};

/// One tool run.
struct ProvenanceRecord {
  std::string tool, version, command;
  std::string scenario;  // resolved TOML; empty: none
  std::uint64_t seed = 0;
  std::vector<InputRecord> inputs;
  std::vector<Doubt> doubts = {};  // about the output of this run
};

/// Records, oldest first. The last record is the run that wrote the file. A merge keeps all parents, each once.
using History = std::vector<ProvenanceRecord>;

/// Returns the SHA-256 of bytes in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// One input as read: its role, digest and history (empty for text files).
struct Source {
  std::string role, sha256;
  History history;
};

/// Returns the history of a new file: the merged histories of its sources, then the record of this invocation.
History extend(const std::vector<Source>& sources, const tool::Invocation& invocation, std::string scenario = "");

/// Returns the history with the doubts of the writing run in its last record.
History with_doubts(History history, const Doubts& doubts);
/// Returns the history without the doubts in its last record, as it is known before a run has ended.
History without_doubts(History history);

/// Returns the chain for people, one paragraph per record (to-vtk --history).
std::string describe(const History& history);

}  // namespace soilweave::io
