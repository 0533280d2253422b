// Output of a long computation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/safe_output.h"

#include <fmt/format.h>

#include <chrono>
#include <new>

#include "core/error.h"
#include "files/files.h"
#include "store/bytes.h"

namespace soilweave::io {
namespace {

namespace fs = std::filesystem;

Part::Entry entry_of(const tool::Invocation& invocation) {
  using enum Part::Entry;
  if (invocation.resume) return invocation.force ? resume_or_anew : resume;
  return invocation.force ? anew : fresh;
}

bool has_folder(const fs::path& output) {
  std::error_code ignored;
  const fs::file_status status = fs::status(output, ignored);
  return output != "-" && (!fs::exists(status) || fs::is_regular_file(status));
}

}  // namespace

void demand_no_input(const fs::path& output, const History& history, std::string_view option) {
  std::error_code failure;
  // Files that documents name are text or surfaces, never HDF5.
  if (history.empty() || !fs::is_regular_file(output, failure) || is_hdf5(output)) return;
  const std::string digest = sha256(read_bytes(output));
  for (const InputRecord& input : history.back().inputs)
    if (input.sha256 == digest)
      throw CannotCreate(
          fmt::format("{}: is the {} that this command reads, or a copy of it, and would be lost; name "
                      "another file with {}",
                      output.string(), input.role, option));
}

SafeOutput::SafeOutput(const fs::path& output, const History& history, const tool::Invocation& invocation) {
  if (!has_folder(output)) return;
  if (invocation.force) demand_no_input(output, history, "--output");
  if (invocation.resume && !invocation.force && io::finished(output, history)) {
    finished_ = true;
    // A crash came after the output was written and before its folder was removed.
    if (fs::exists(part_of(output))) Part(output, history, Part::Entry::anew).remove();
    note_ = invocation.tool + ": " + output.string() + " is finished already";
    return;
  }
  // Part itself explains a folder that cannot be reached.
  std::error_code ignored;
  const bool begun = fs::exists(part_of(output), ignored);
  part_.emplace(output, history, entry_of(invocation));
  if (!invocation.resume) return;
  note_ = invocation.tool + ": ";
  if (!part_->last().empty())
    note_ += "going on from " + part_->last().string();
  else
    note_ += part_of(output).string() + (part_->replaced() ? " held another run, which --force gives up; beginning anew"
                                         : begun           ? " holds nothing to go on from; beginning anew"
                                                           : " does not exist; beginning anew");
}

bool SafeOutput::finished(Progress& progress) const {
  if (!note_.empty()) progress.note(note_);
  return finished_;
}

double SafeOutput::write(const std::function<void()>& write) {
  const auto start = std::chrono::steady_clock::now();
  try {
    write();
    if (part_) part_->remove();
  } catch (const Error& error) {
    throw part_ ? part_->explained(error) : error;
  } catch (const std::bad_alloc&) {
    const Error error(Exit::internal, "not enough memory to write the output; use a machine with more");
    throw part_ ? part_->explained(error) : error;
  }
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace soilweave::io
