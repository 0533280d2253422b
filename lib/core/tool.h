// The shape of every tool: a struct with options(), validate(), run(); main is one line.
// From the one option table come parsing, --help, the man page, bash completion, range errors and provenance.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/parameter.h"

namespace soilweave::tool {

inline constexpr std::string_view version = "0.1.0";

/// How this process was called: what provenance records, and what only concerns the terminal.
struct Invocation {
  std::string tool;
  std::string version;
  std::string command;  // canonical: tool and result-relevant options in table order; no file names, threads, quiet
  std::vector<std::string> arguments;  // as typed
  bool quiet = false;
  bool force = false;
  bool resume = false;
  int threads = 1;
  std::uint64_t seed = 0;
};

/// The option table of one tool. Fields are bound by reference and hold their default when bound.
class Table {
 public:
  Table();
  ~Table();
  void about(std::string name, std::string sentence, std::string description = "");
  void example(std::string command, std::string sentence);  // pasteable; the tests run every one

  /// Positional file ("-" means standard input where the format is streamable).
  void input(std::filesystem::path& field, std::string name, std::string sentence);
  void inputs(std::vector<std::filesystem::path>& field, std::string name, std::string sentence);
  void optional_inputs(std::vector<std::filesystem::path>& field, std::string name, std::string sentence);
  void optional_input(std::filesystem::path& field, std::string name, std::string sentence);
  /// -o/--output; "-" means standard output. An existing file is refused without --force (which this also declares).
  /// Where the field is empty when bound, the user must give it.
  void output(std::filesystem::path& field, std::string sentence);
  /// The same for a tool that can do without a file (because it prints).
  void optional_output(std::filesystem::path& field, std::string sentence);
  /// An option that names one more file to be written, under the same terms; declare it beside output().
  void also_output(std::filesystem::path& field, std::string_view name, std::string sentence);
  /// The same for a tool that writes a folder of files.
  void output_folder(std::filesystem::path& field, std::string sentence);

  // A name of one letter ("n") is written -n, a longer one --with-hyphens, "pressure,p" both ways. Numbers may carry a
  // unit ("100 kPa"). Out of the parameter's range: a usage mistake with range and reason.
  void option(double& field, const Parameter& parameter);
  void option(std::int64_t& field, const Parameter& parameter);
  void option(std::optional<double>& field, const Parameter& parameter);
  void option(std::string& field, std::string_view name, std::string_view metavar, std::string_view sentence);
  void option(std::filesystem::path& field, std::string_view name, std::string_view metavar, std::string_view sentence);
  void option(std::vector<std::string>& field, std::string_view name, std::string_view metavar,
              std::string_view sentence);  // repeatable
  void choice(std::string& field, std::string_view name, std::vector<std::string> values, std::string_view sentence);
  void flag(bool& field, std::string_view name, std::string_view sentence);
  /// The option cannot change the result (--resume): it stays out of Invocation::command.
  void unrecorded(std::string_view name);
  /// --checkpoint-every, s; --resume, into Invocation::resume: an existing output is then the tool's to judge.
  void resume(double& interval);
  /// A flag with which the tool writes no file, so that none need be named.
  void instead_of_output(bool& field, std::string_view name, std::string_view sentence);
  void seed();     // --seed N, into Invocation::seed
  void threads();  // --threads N, into Invocation::threads

  struct Impl;
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// What tool::start needs from a tool, type-erased.
struct Program {
  std::function<void(Table&)> options;
  std::function<void()> validate;  // throws UsageError with all mistakes; opens no data file
  std::function<void(const Invocation&)> run;
};

/// Parses, validates, runs, translates errors to one line and an exit status. --help, --version, --man, --completion
/// are handled here. A broken pipe is success; standard output is closed and checked.
int start(int argc, char** argv, const Program& program);

template <class Tool>
Program program(Tool& t) {
  return {[&t](Table& table) { t.options(table); }, [&t] { t.validate(); },
          [&t](const Invocation& invocation) { t.run(invocation); }};
}

template <class Tool>
int start(int argc, char** argv) {
  Tool t;
  return start(argc, argv, program(t));
}

/// A tool of several verbs ("gws-solve respond"): each is a program with an option table of its own, named "TOOL VERB".
/// The first argument names the verb; the tool's own help, manual page and completion tell of them all.
struct Suite {
  struct Verb {
    std::string name;
    Program program;
  };
  std::string name, sentence, description;
  std::vector<Verb> verbs;
};
int start(int argc, char** argv, const Suite& suite);

}  // namespace soilweave::tool
