// Output of a tool that prints a text or table and may write a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/cli/tool.h"
#include "files/records.h"

namespace soilweave::io {

/// Options --tsv and -o of a tool or verb.
struct TableOutput {
  bool tsv = false;
  /// Empty: none; -: standard output.
  std::filesystem::path file;

  /// Declares the options; `printed` describes --tsv, `written` -o.
  void declare(tool::Table& table, const std::string& printed, const std::string& written);
  /// Adds a mistake if both options write to standard output.
  void check(std::vector<std::string>& mistakes) const;
  /// Adds that mistake, and one if neither option is given.
  void check_needed(std::vector<std::string>& mistakes) const;
  /// Prints the table (--tsv) or the text, unless the file itself goes to standard output.
  void print(const Series& table, const std::string& text) const;
};

/// Adds a mistake if a table is chosen, other than the `usual` one, and nothing is printed as a table.
void check_table(bool tsv, const std::string& table, const std::string& usual, std::vector<std::string>& mistakes);

/// Throws UsageError with the mistakes, one a line, if there are any.
void demand_none(const std::vector<std::string>& mistakes);

}  // namespace soilweave::io
