// Checks the files of a tool before its work: inputs exist, outputs can be made and replace nothing that is still
// needed.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

#include "core/cli/tool_table.h"
#include "core/error.h"
#include "core/output_path.h"

namespace soilweave::tool {
namespace {

namespace fs = std::filesystem;

struct Output {
  std::string option;
  fs::path path;
  bool may_be_folder;
};

void check_input(const fs::path& path) {
  if (path == "-") return;
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) throw MissingInput(fmt::format("{}: no such file; check the name", path.string()));
  if (access(path.c_str(), R_OK) != 0)
    throw MissingInput(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
}

std::vector<fs::path> inputs_of(const Table::Impl& table) {
  std::vector<fs::path> all;
  for (const Positional& place : table.inputs) all.insert(all.end(), place.given.begin(), place.given.end());
  // The value of an option "NAME|FILE" is an input if a file of this name exists.
  for (const Entry& entry : table.options)
    if (!entry.writes && entry.metavar.find("FILE") != std::string::npos)
      all.insert(all.end(), entry.given.begin(), entry.given.end());
  return all;
}

std::vector<Output> outputs_of(const Table::Impl& table) {
  std::vector<Output> all;
  for (const Entry& entry : table.options) {
    const fs::path path = entry.writes ? entry.value() : "";
    if (path.empty() || path == "-") continue;
    const bool may_be_folder = entry.name == "output" && table.output_is_folder;
    if (!may_be_folder && !path.has_filename())
      throw CannotCreate(fmt::format("{}: is a directory; name a file to be written", path.string()));
    all.push_back({entry.written(), path.has_filename() ? path : path.parent_path(), may_be_folder});
  }
  return all;
}

void check_output(const Output& output, bool may_replace) {
  const fs::path& path = output.path;
  std::error_code failure;
  const bool folder = fs::is_directory(path, failure);
  if (folder && !output.may_be_folder)
    throw CannotCreate(fmt::format("{}: is a directory; name a file to be written", path.string()));
  demand_place(path);
  if (!may_replace && (folder || fs::is_regular_file(path, failure)))
    throw CannotCreate(fmt::format("{}: exists; give --force to overwrite it", path.string()));
}

/// Returns whether an input ("-": standard input) is the regular file at `output`.
bool reads(const fs::path& input, const fs::path& output) {
  std::error_code failure;
  if (!fs::is_regular_file(output, failure)) return false;
  if (input != "-") return fs::is_regular_file(input, failure) && same_file(input, output);
  struct stat in = {}, out = {};
  return fstat(STDIN_FILENO, &in) == 0 && stat(output.c_str(), &out) == 0 && in.st_dev == out.st_dev &&
         in.st_ino == out.st_ino;
}

/// Checks that no output is an input or another output, and that no input is in the folder OUTPUT.part.
void check_apart(const Table::Impl& table, const std::vector<Output>& outputs) {
  const std::vector<fs::path> inputs = inputs_of(table);
  for (std::size_t k = 0; k < outputs.size(); ++k) {
    const auto& [option, path, may_be_folder] = outputs[k];
    for (const fs::path& input : inputs) {
      if (reads(input, path))
        throw CannotCreate(fmt::format("{}: is read by this command and would be lost; name another file with {}",
                                       path.string(), option));
      std::error_code failure;
      const fs::path part = path.string() + ".part";
      const bool of_part = fs::equivalent(input, part, failure) || fs::equivalent(input.parent_path(), part, failure);
      if (table.has("resume") && of_part)
        throw CannotCreate(
            fmt::format("{}: would be lost, for {}.part is emptied by this command; copy it elsewhere first",
                        input.string(), path.string()));
    }
    for (std::size_t other = 0; other < k; ++other)
      if (!may_be_folder && !written_in_place(path) && same_file(outputs[other].path, path))
        throw CannotCreate(fmt::format("{}: is to be written by {} and {}; name two files", path.string(),
                                       outputs[other].option, option));
  }
}

}  // namespace

void check_files(const Table::Impl& table) {
  for (const Positional& place : table.inputs)
    for (const std::string& file : place.given) check_input(file);
  if (!table.writes()) return;
  const std::vector<Output> outputs = outputs_of(table);
  std::error_code failure;
  // With --resume the tool itself checks its output. If the main output exists, the run has written all outputs.
  const bool goes_on = table.invocation.resume, finished = goes_on && fs::exists(*table.output, failure);
  for (const Output& output : outputs) {
    const bool main = output.option == "--output";
    check_output(output, table.invocation.force || (main ? goes_on : finished));
  }
  check_apart(table, outputs);
}

}  // namespace soilweave::tool
