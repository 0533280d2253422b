// Digests, and the chain of records from a file to data from outside.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/provenance.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>

#include "core/error.h"
#include "core/terminal.h"

namespace soilweave::io {
namespace {

bool same(const InputRecord& a, const InputRecord& b) {
  return a.role == b.role && a.sha256 == b.sha256 && a.origin == b.origin;
}

bool same(const ProvenanceRecord& a, const ProvenanceRecord& b) {
  return a.tool == b.tool && a.version == b.version && a.command == b.command && a.scenario == b.scenario &&
         a.seed == b.seed &&
         std::equal(a.inputs.begin(), a.inputs.end(), b.inputs.begin(), b.inputs.end(),
                    [](const InputRecord& x, const InputRecord& y) { return same(x, y); });
}

/// Appends a history to `merged`, each record once. Returns the index of its last record; -1 for an empty history.
int merge(History& merged, const History& added) {
  std::vector<int> place;
  for (ProvenanceRecord record : added) {
    for (InputRecord& input : record.inputs)
      if (input.origin >= 0) input.origin = place.at(static_cast<std::size_t>(input.origin));
    const auto known =
        std::find_if(merged.begin(), merged.end(), [&](const ProvenanceRecord& other) { return same(record, other); });
    place.push_back(static_cast<int>(known - merged.begin()));
    if (known == merged.end()) merged.push_back(std::move(record));
  }
  return place.empty() ? -1 : place.back();
}

std::string indented(const std::string& text) {
  std::string out = "    ";
  for (std::size_t k = 0; k < text.size(); ++k) {
    if (text[k] == '\n' && k + 1 == text.size()) break;
    out += text[k];
    if (text[k] == '\n') out += "    ";
  }
  return out + "\n";
}

}  // namespace

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest = {};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw Error(Exit::internal, "libcrypto cannot compute a SHA-256");
  std::string text;
  for (unsigned int k = 0; k < length; ++k) text += fmt::format("{:02x}", digest[k]);
  return text;
}

History extend(const std::vector<Source>& sources, const tool::Invocation& invocation, std::string scenario) {
  History history;
  ProvenanceRecord record{.tool = invocation.tool,
                          .version = invocation.version,
                          .command = invocation.command,
                          .scenario = std::move(scenario),
                          .seed = invocation.seed,
                          .inputs = {}};
  for (const Source& source : sources)
    record.inputs.push_back({source.role, source.sha256, merge(history, source.history), source.file});
  history.push_back(std::move(record));
  return history;
}

History with_doubts(History history, const Doubts& doubts) {
  history.back().doubts = doubts.all();
  return history;
}

History without_doubts(History history) {
  if (!history.empty()) history.back().doubts.clear();
  return history;
}

std::string describe(const History& history) {
  std::string text;
  for (std::size_t k = 0; k < history.size(); ++k) {
    const ProvenanceRecord& record = history[k];
    text += fmt::format("{}{}. {} {}\n  command: {}\n  seed: {}\n", k ? "\n" : "", k, printable(record.tool),
                        printable(record.version), printable(record.command), record.seed);
    for (const InputRecord& input : record.inputs)
      text += fmt::format("  input: {}, {}, sha256 {}\n", printable(input.role),
                          input.origin < 0 ? "from outside" : fmt::format("made by {}", input.origin),
                          printable(input.sha256));
    for (const Doubt& doubt : record.doubts)
      text += fmt::format("  doubt: {}: {}\n", printable(doubt.key), printable(doubt.sentence));
    if (!record.scenario.empty()) text += "  scenario:\n" + indented(printable(record.scenario, "\n\t"));
  }
  return text;
}

}  // namespace soilweave::io
