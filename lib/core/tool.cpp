// One run of a tool from arguments to exit status: the only place where errors become lines and numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tool.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>

#include "core/error.h"
#include "core/processor.h"
#include "core/text.h"
#include "core/tool_table.h"

namespace soilweave::tool {
namespace {

namespace fs = std::filesystem;

int code(Exit status) { return static_cast<int>(status); }

void complain(const std::string& tool, std::string_view message) {
  for (const std::string& line : lines_of(message)) fmt::print(stderr, "{}: {}\n", tool, line);
}

/// Whether nobody reads standard output any more: a reader such as head has seen enough.
bool output_pipe_broken() {
  pollfd descriptor{STDOUT_FILENO, POLLOUT, 0};
  return poll(&descriptor, 1, 0) == 1 && (descriptor.revents & POLLERR) != 0;
}

void check_input(const fs::path& path) {
  if (path == "-") return;
  std::error_code failure;
  const fs::file_status status = fs::status(path, failure);
  if (!fs::exists(status)) throw MissingInput(fmt::format("{}: no such file; check the name", path.string()));
  if (access(path.c_str(), R_OK) != 0)
    throw MissingInput(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
}

void check_output(const Table::Impl& table) {
  const fs::path path = table.output->has_filename() ? *table.output : table.output->parent_path();
  const bool force = table.invocation.force || table.invocation.resume, may_be_folder = table.output_is_folder;
  if (path.empty() || path == "-") return;
  std::error_code failure;
  if (!may_be_folder && (!table.output->has_filename() || fs::is_directory(path, failure)))
    throw CannotCreate(fmt::format("{}: is a directory; name a file to be written", table.output->string()));
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, failure))
    throw CannotCreate(
        fmt::format("{}: cannot be created: {} is not a directory; make it first", path.string(), folder.string()));
  if (access(folder.c_str(), W_OK) != 0)
    throw CannotCreate(
        fmt::format("{}: cannot be created: {}: {}", path.string(), folder.string(), std::strerror(errno)));
  if (!force && (fs::is_regular_file(path, failure) || fs::is_directory(path, failure)))
    throw CannotCreate(fmt::format("{}: exists; give --force to overwrite it", path.string()));
}

std::string asked_text(Table::Impl& table, Ask ask) {
  switch (ask) {
    case Ask::help:
      return help_text(table);
    case Ask::version:
      return version_text(table);
    case Ask::man:
      return man_text(table);
    case Ask::completion:
      return completion_text(table);
    case Ask::nothing:
      break;
  }
  return "";
}

/// Everything that needs no data: usage, then inputs, then the output, so that hours of work are not lost at their end.
void prepare(Table::Impl& table, const Program& program, std::vector<std::string>& mistakes) {
  try {
    if (table.understood && program.validate) program.validate();
  } catch (const UsageError& error) {
    for (std::string& line : lines_of(error.what())) mistakes.push_back(std::move(line));
  }
  if (!mistakes.empty()) throw UsageError(fmt::format("{}", fmt::join(mistakes, "\n")));
  for (const Positional& place : table.inputs)
    for (const std::string& file : place.given) check_input(file);
  if (table.writes()) check_output(table);
}

void run(Table::Impl& table, int argc, char** argv, const Program& program) {
  std::vector<std::string> mistakes;
  const Ask ask = parse(table, argc, argv, mistakes);
  if (ask != Ask::nothing) {
    std::cout << asked_text(table, ask);
    return;
  }
  prepare(table, program, mistakes);
  table.invocation.command = canonical_command(table);
  table.invocation.arguments.assign(argv, argv + argc);
  program.run(table.invocation);
}

/// Flushes and closes standard output: only then is it known whether all of it arrived.
void close_output() {
  errno = 0;
  std::cout.flush();
  const bool failed = !std::cout || std::ferror(stdout) != 0 || std::fflush(stdout) != 0;
  const int reason = errno;
  const bool broken = output_pipe_broken();
  const bool closed = std::fclose(stdout) == 0;
  if ((!failed && closed) || broken) return;
  const int known = reason != 0 ? reason : closed ? ENOSPC : errno;
  throw IoError(fmt::format("standard output: {}; not everything was written", std::strerror(known)));
}

}  // namespace

int start(int argc, char** argv, const Program& program) {
  link_processor_check();
  // A reader that goes away must not kill us before the files are in order; writing then fails with EPIPE.
  std::signal(SIGPIPE, SIG_IGN);
  std::string name = argc > 0 ? fs::path(argv[0]).filename().string() : "soilweave";
  try {
    Table table;
    program.options(table);
    bool& quiet = table.impl().invocation.quiet;
    table.flag(quiet, "quiet,q", "no progress on standard error");
    table.impl().options.back().general = true;
    table.unrecorded("quiet");
    if (!table.impl().name.empty()) name = table.impl().name;
    run(table.impl(), argc, argv, program);
    close_output();
    return code(Exit::done);
  } catch (const Error& error) {
    if (error.status() == Exit::io && output_pipe_broken()) return code(Exit::done);
    complain(name, error.what());
    return code(error.status());
  } catch (const std::bad_alloc&) {
    complain(name, "not enough memory; use fewer grains or a machine with more");
  } catch (const std::exception& error) {
    complain(name, fmt::format("unexpected: {}; this is a defect, please report it", error.what()));
  }
  return code(Exit::internal);
}

}  // namespace soilweave::tool
