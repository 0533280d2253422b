// Output of a long computation.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/safe_output.h"

#include <fmt/format.h>

#include <chrono>
#include <new>

#include "core/error.h"
#include "core/output_path.h"

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

// Returns whether the input came from a file with a name, not from standard input.
bool is_named(const InputRecord& input) { return !input.file.empty() && input.file != "-"; }

// Throws CannotCreate if an input lies in the folder of the run, which is removed at the end.
void demand_no_input_in_part(const fs::path& output, const History& history) {
  if (history.empty()) return;
  const fs::path part = part_of(output);
  std::error_code failure;
  for (const InputRecord& input : history.back().inputs)
    if (is_named(input) && fs::equivalent(input.file.parent_path(), part, failure))
      throw CannotCreate(fmt::format("{}: would be lost, for {} is emptied by this command; copy it elsewhere first",
                                     input.file.string(), part.string()));
}

}  // namespace

void demand_no_input(const fs::path& output, const History& history, std::string_view option) {
  std::error_code failure;
  if (history.empty() || !fs::is_regular_file(output, failure)) return;
  for (const InputRecord& input : history.back().inputs)
    if (is_named(input) && same_file(input.file, output))
      throw CannotCreate(fmt::format("{}: is read by this command and would be lost; name another file with {}",
                                     output.string(), option));
}

SafeOutput::SafeOutput(const fs::path& output, const History& history, const tool::Invocation& invocation) {
  if (!has_folder(output)) return;
  demand_no_input(output, history, "--output");
  demand_no_input_in_part(output, history);
  if (invocation.resume && !invocation.force && io::finished(output, history)) {
    finished_ = true;
    // The folder is left over if a crash came between writing the output and removing the folder.
    if (fs::exists(part_of(output))) Part(output, history, Part::Entry::anew).remove();
    note_ = invocation.tool + ": " + output.string() + " is finished already";
    return;
  }
  // If the folder cannot be reached, Part throws an error that explains it.
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
