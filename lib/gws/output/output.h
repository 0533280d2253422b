// Output of gws-solve: text, a TSV table, or a fields file of all tables.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/cli/tool.h"
#include "core/doubts.h"
#include "files/exchange/table_output.h"
#include "files/files.h"

namespace soilweave::gws {

using Groups = std::vector<io::FieldsFile::Group>;

/// Output of a verb.
struct Output : io::TableOutput {
  /// Declares the options in a tool's table.
  void declare(tool::Table& table);
  /// Throws UsageError with these mistakes and its own.
  void check(std::vector<std::string> mistakes) const;
  /// Returns the index of the table that --tsv prints. Throws DataError if --tsv asks for a table that was not
  /// identified.
  std::size_t place_of(const Groups& groups, const std::string& table) const;
  /// Reports the doubts. Prints the text or table `chosen` as TSV, unless the file goes to standard output. Writes the
  /// file with the doubts.
  void put(const Groups& groups, std::size_t chosen, const std::string& text, const std::vector<io::Source>& sources,
           const std::string& scenario, const tool::Invocation& invocation, const std::vector<Doubt>& doubts) const;
};

/// Adds a mistake if there is no such table of an identification, or if it is chosen without tsv.
void check_table(bool tsv, const std::string& name, std::vector<std::string>& mistakes);
/// Makes options of `respond` usage mistakes where nothing depends on them.
void refuse_idle(tool::Table& table, const std::int64_t& samples, const bool& sensitivity, const Output& output);
/// Makes options of `design` usage mistakes where nothing depends on them.
void refuse_idle(tool::Table& table, const std::optional<double>& surcharge, const bool& chart);

}  // namespace soilweave::gws
