// One run of a tool, from arguments to exit status. Only here do errors become lines and numbers.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/cli/tool.h"

#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <iostream>
#include <new>

#include "core/cli/tool_table.h"
#include "core/mistakes.h"
#include "core/processor.h"
#include "core/terminal.h"
#include "core/text/text.h"
#include "core/threads.h"

namespace soilweave::tool {
namespace {

namespace fs = std::filesystem;

int code(Exit status) { return static_cast<int>(status); }

/// Shortens a line that a user's word made too long. It cuts the middle, because the remedy is at the end.
std::string readable(const std::string& line) {
  constexpr std::size_t longest = 2000, first = 400, last = 800;
  if (line.size() <= longest) return line;
  return line.substr(0, first) + " ... " + line.substr(line.size() - last);
}

void complain(const std::string& tool, std::string_view line) {
  tell(printable(readable(fmt::format("{}: {}", tool, line))) + "\n");
}
void complain(const std::string& tool, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) complain(tool, std::string_view(line));
}

/// Name of the running tool. A library that gives up (OpenMP without threads) calls exit(1), which would mean a missed
/// target. Only a function called by exit() can tell the two apart, and it takes no argument.
const std::string* at_work = nullptr;
void exit_of_a_library() {
  if (!at_work) return;
  complain(*at_work, std::string_view("a library ended the program, for the reason before this line; try --threads 1"));
  _exit(code(Exit::internal));
}

/// Ignores signals that a failed write would raise, and keeps files from taking the number of a standard stream.
void take_precautions() {
  link_processor_check();
  occupy_standard_streams();
  // If a reader goes away, writing must fail with EPIPE, so that files are put in order first. A limit on file size
  // acts like a full disk: writing fails with EFBIG.
  for (const int signal : {SIGPIPE, SIGXFSZ}) std::signal(signal, SIG_IGN);
  static const int registered = std::atexit(exit_of_a_library);
  if (registered != 0) throw Error(Exit::internal, "the C library can note no function for the end of the program");
}

/// Returns whether the reader of standard output, such as head, has closed it.
bool output_pipe_broken() {
  pollfd descriptor{STDOUT_FILENO, POLLOUT, 0};
  return poll(&descriptor, 1, 0) == 1 && (descriptor.revents & POLLERR) != 0;
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
    case Ask::keys:
      return keys_as_text(table.keys());
    case Ask::schema:
      return keys_as_schema(table.keys(), table.keys_title);
    case Ask::nothing:
      break;
  }
  return "";
}

/// Checks everything that needs no data: usage, inputs, then outputs. So no run loses hours of work at its end.
void prepare(Table::Impl& table, const Program& program, std::vector<std::string>& mistakes) {
  // A line feed in a user's word is a character of that word, not the end of a mistake.
  for (std::string& mistake : mistakes) mistake = printable(mistake);
  try {
    if (table.understood && program.validate) program.validate();
  } catch (const UsageError& error) {
    for (std::string& line : lines_of(error.what())) mistakes.push_back(std::move(line));
  }
  if (!mistakes.empty()) throw UsageError(fmt::format("{}", fmt::join(mistakes, "\n")));
  check_files(table);
  if (table.has("threads")) demand_threads(table.invocation.threads);
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

/// Flushes and closes standard output, because only then is it known whether all of it arrived.
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
  std::string name = argc > 0 ? fs::path(argv[0]).filename().string() : "soilweave";
  struct AtWork {
    explicit AtWork(const std::string& tool) { at_work = &tool; }
    ~AtWork() { at_work = nullptr; }
  } const now(name);
  try {
    take_precautions();
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
  } catch (const UsageError& error) {
    complain(name, lines_of(error.what()));
    return code(error.status());
  } catch (const Mistakes& error) {
    complain(name, lines_of(error.what()));
    return code(error.status());
  } catch (const Error& error) {
    if (error.status() == Exit::io && output_pipe_broken()) return code(Exit::done);
    complain(name, std::string_view(error.what()));
    return code(error.status());
  } catch (const std::bad_alloc&) {
    complain(name, std::string_view("not enough memory; use fewer grains or a machine with more"));
  } catch (const std::exception& error) {
    const std::string what = fmt::format("unexpected: {}; this is a defect, please report it", error.what());
    complain(name, std::string_view(what));
  }
  return code(Exit::internal);
}

}  // namespace soilweave::tool
