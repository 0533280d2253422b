// The shape of every tool: a struct with options(), validate() and run(), and a main of one line.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tool is a filter of files: it reads some, computes, and writes one. Its three functions divide that work:
//
//   options()   binds each option to a field of the struct: name, unit, range, sentence. This is its only definition.
//   validate()  checks the fields against each other. It throws all usage mistakes at once and opens no data file.
//   run()       reads, computes, writes. It parses nothing and throws an error of core/error.h where something fails.
//
// From the one table of options come parsing, --help, the manual page, bash completion, range errors, and the command
// that provenance records. start() calls the three in order, and checks in between that all inputs exist and that the
// output can be made. It turns each error into one line on standard error and one exit status. A new tool begins as a
// copy of the smallest one (tools/fabric.cpp):
//
//   struct Fabric {
//     std::filesystem::path input, output;
//     void options(tool::Table& table) { table.input(input, "INPUT", "packing or run"); ... }
//     void validate() const { ... }
//     void run(const tool::Invocation& invocation) const { ... }
//   };
//   int main(int argc, char** argv) { return tool::start<Fabric>(argc, argv); }
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
#include "core/text/keys.h"

namespace soilweave::tool {

inline constexpr std::string_view version = "0.1.0";

/// Call of this process: the words that provenance records, and the options that concern only the terminal.
struct Invocation {
  /// Name of the tool.
  std::string tool;
  std::string version;
  /// Tool and options that bear on results, in table order, without file names, threads, quiet.
  std::string command;
  /// Arguments as typed.
  std::vector<std::string> arguments;
  bool quiet = false;
  bool force = false;
  bool resume = false;
  int threads = 1;
  std::uint64_t seed = 0;
};

/// Option table of one tool. Fields are bound by reference; their values at binding are the defaults.
class Table {
 public:
  Table();
  ~Table();
  /// Sets the name, the sentence and the description that help and manual page begin with.
  void about(std::string name, std::string sentence, std::string description = "");
  /// Adds an example that can be pasted; the tests run every one.
  void example(std::string command, std::string sentence);

  /// Declares a positional file; "-" means standard input if the format is streamable.
  void input(std::filesystem::path& field, std::string name, std::string sentence);
  void inputs(std::vector<std::filesystem::path>& field, std::string name, std::string sentence);
  void optional_inputs(std::vector<std::filesystem::path>& field, std::string name, std::string sentence);
  void optional_input(std::filesystem::path& field, std::string name, std::string sentence);
  /// Declares -o/--output ("-": standard output) and --force, without which an existing file is refused. If the field
  /// is empty when bound, the user must give it.
  void output(std::filesystem::path& field, std::string sentence);
  /// Declares the output of a tool that can do without a file because it prints.
  void optional_output(std::filesystem::path& field, std::string sentence);
  /// Declares an option that names one more output file, on the terms of output(); call it beside output().
  void also_output(std::filesystem::path& field, std::string_view name, std::string sentence);
  /// Declares the output of a tool that writes a folder of files.
  void output_folder(std::filesystem::path& field, std::string sentence);

  // Declares an option. A name of one letter ("n") is written -n, a longer one --with-hyphens, "pressure,p" both ways.
  // Numbers may carry a unit ("100 kPa"). A number out of range is a usage mistake with range and reason.
  void option(double& field, const Parameter& parameter);
  void option(std::int64_t& field, const Parameter& parameter);
  void option(std::optional<double>& field, const Parameter& parameter);
  void option(std::string& field, std::string_view name, std::string_view metavar, std::string_view sentence);
  void option(std::filesystem::path& field, std::string_view name, std::string_view metavar, std::string_view sentence);
  void option(std::vector<std::string>& field, std::string_view name, std::string_view metavar,
              std::string_view sentence);  // repeatable
  void choice(std::string& field, std::string_view name, std::vector<std::string> values, std::string_view sentence);
  void flag(bool& field, std::string_view name, std::string_view sentence);
  /// Keeps an option that cannot change the result (--resume) out of Invocation::command.
  void unrecorded(std::string_view name);
  /// Declares --checkpoint-every, s, and --resume, with which the tool itself judges an existing output.
  void resume(double& interval);
  /// Declares a flag with which the tool writes no file, so that none need be named.
  void instead_of_output(bool& field, std::string_view name, std::string_view sentence);
  /// Declares --keys, which prints every key of the tool's TOML document. title: what the document is.
  void keys(std::string title, std::vector<Key> (*of)());
  void seed();     // --seed N, into Invocation::seed
  void threads();  // --threads N, into Invocation::threads

  struct Impl;
  Impl& impl() { return *impl_; }

 private:
  std::unique_ptr<Impl> impl_;
};

/// A tool as tool::start needs it, type-erased.
struct Program {
  std::function<void(Table&)> options;
  /// Throws UsageError with all mistakes; opens no data file.
  std::function<void()> validate;
  std::function<void(const Invocation&)> run;
};

/// Parses, validates and runs a tool, and translates errors to one line and an exit status. Handles --help, --version,
/// --man, --completion and --keys. A broken pipe counts as success. Standard output is closed and checked.
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

/// A tool of several verbs ("gws-solve respond"). The first argument names the verb. Each verb is a program named "TOOL
/// VERB" with its own option table; help, manual page and completion of the tool cover all verbs.
struct Suite {
  /// One verb: the word after the tool's name, and its program.
  struct Verb {
    std::string name;
    Program program;
  };
  std::string name, sentence, description;
  std::vector<Verb> verbs;
};
int start(int argc, char** argv, const Suite& suite);

}  // namespace soilweave::tool
