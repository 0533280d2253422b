// Provenance of a file: one record per tool run. No clock, host, absolute path or thread count, since these change no
// result.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/cli/tool.h"
#include "core/doubts.h"

namespace soilweave::io {

/// One input of a tool run.
struct InputRecord {
  std::string role;    // "packing", "scenario", "grading", ...
  std::string sha256;  // digest of the bytes read
  /// Index in History of the record that made the input; -1: data from outside.
  int origin = -1;
  /// Path that was read. It is never written to a file, so it is empty for inputs of earlier runs.
  std::filesystem::path file = {};
};

/// One tool run.
struct ProvenanceRecord {
  std::string tool, version, command;
  std::string scenario;  // resolved TOML; empty: none
  std::uint64_t seed = 0;
  std::vector<InputRecord> inputs;
  std::vector<Doubt> doubts = {};  // about the output of this run
};

/// Records, oldest first, each once. The last one wrote the file.
using History = std::vector<ProvenanceRecord>;

/// Returns the SHA-256 of bytes in lower-case hexadecimal.
std::string sha256(std::string_view bytes);

/// One input as read: its role, digest, history (empty for text files) and file.
struct Source {
  std::string role, sha256;
  History history;
  std::filesystem::path file = {};
};

/// Returns the merged histories of the sources, then a record of this invocation.
History extend(const std::vector<Source>& sources, const tool::Invocation& invocation, std::string scenario = "");

/// Returns the history with these doubts in its last record.
History with_doubts(History history, const Doubts& doubts);
/// Returns the history without the doubts of its last record, as it is before a run ends.
History without_doubts(History history);

/// Returns a paragraph per record (to-vtk --history).
std::string describe(const History& history);

}  // namespace soilweave::io
