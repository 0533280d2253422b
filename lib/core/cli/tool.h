// The shape of every tool: a struct with options(), validate() and run(), and a main of one line.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A tool is a filter of files. Three functions divide its work:
//
//   options()   binds each option to a field of the struct: name, unit, range, sentence.
//   validate()  checks the fields against each other. It throws all usage mistakes at once and opens no data file.
//   run()       reads, computes, writes. It throws an error of core/error.h where something fails.
//
// The table of options serves parsing, --help, manual page, completion, range errors and provenance. start() calls the
// three in order. Before run() it checks that all inputs exist and that the output can be made. It turns each error
// into one line and one exit status. A new tool begins as a copy of the smallest one (tools/fabric.cpp):
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

/// Call of this process, for provenance and for options that every tool has.
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
  /// Sets the name and the texts with which help and manual page begin.
  void about(std::string name, std::string sentence, std::string description = "");
  /// Adds an example that can be pasted; the tests run every one.
  void example(std::string command, std::string sentence);

  /// Declares a positional file; "-" means standard input if the format is streamable.
  void input(std::filesystem::path& field, std::string name, std::string sentence);
  void inputs(std::vector<std::filesystem::path>& field, std::string name, std::string sentence);
  void optional_inputs(std::vector<std::filesystem::path>& field, std::string name, std::string sentence);
  void optional_input(std::filesystem::path& field, std::string name, std::string sentence);
  /// Declares -o/--output ("-": standard output) and --force. An empty field makes it required.
  void output(std::filesystem::path& field, std::string sentence);
  /// Declares an optional output, for a tool that can print its result instead.
  void optional_output(std::filesystem::path& field, std::string sentence);
  /// Declares an option for one more output file. Call it beside output().
  void also_output(std::filesystem::path& field, std::string_view name, std::string sentence);
  /// Declares the output of a tool that writes a folder of files.
  void output_folder(std::filesystem::path& field, std::string sentence);

  /// Declares an option: "n" is written -n, a longer name --with-hyphens, "pressure,p" both ways.
  /// Numbers may carry a unit. A number out of range is a usage mistake, and so is a second, different value.
  void option(double& field, const Parameter& parameter);
  void option(std::int64_t& field, const Parameter& parameter);
  void option(std::optional<double>& field, const Parameter& parameter);
  void option(std::string& field, std::string_view name, std::string_view metavar, std::string_view sentence);
  void option(std::filesystem::path& field, std::string_view name, std::string_view metavar, std::string_view sentence);
  /// Declares a repeatable option.
  void option(std::vector<std::string>& field, std::string_view name, std::string_view metavar,
              std::string_view sentence);
  void choice(std::string& field, std::string_view name, std::vector<std::string> values, std::string_view sentence);
  void flag(bool& field, std::string_view name, std::string_view sentence);
  /// Keeps an option that cannot change the result (--resume) out of Invocation::command.
  void unrecorded(std::string_view name);
  /// Declares --checkpoint-every (s) and --resume. With --resume the tool itself checks an existing output.
  void resume(double& interval);
  /// Declares a flag with which the tool writes no file, needs no output name and refuses options of outputs.
  void instead_of_output(bool& field, std::string_view name, std::string_view sentence);
  /// Makes these options usage mistakes while `idle` returns true. why: "without --chart", "beside --table".
  void refuse(std::vector<std::string_view> names, std::function<bool()> idle, std::string_view why);
  /// Declares --keys, which prints every key of the tool's TOML document. title: what the document is.
  void keys(std::string title, std::vector<Key> (*of)());
  /// Declares --seed N, into Invocation::seed.
  void seed();
  /// Declares --threads N, into Invocation::threads.
  void threads();

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

/// Parses, validates and runs a tool, and returns its exit status. A broken pipe counts as success.
/// Handles --help, --version, --man, --completion and --keys.
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

/// A tool of several verbs ("gws-solve respond"), each with its own option table.
/// Help, manual page and completion of the tool cover all verbs.
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
