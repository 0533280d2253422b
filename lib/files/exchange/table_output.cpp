// Output of a tool that prints a text or a table and may write a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/table_output.h"

#include <fmt/format.h>

#include <cstdio>

#include "core/error.h"
#include "files/exchange/table.h"

namespace soilweave::io {

void TableOutput::declare(tool::Table& table, const std::string& printed, const std::string& written) {
  table.flag(tsv, "tsv", printed);
  table.optional_output(file, written);
}

void TableOutput::check(std::vector<std::string>& mistakes) const {
  if (tsv && file == "-") mistakes.emplace_back("--tsv and -o - both write to standard output: give one of them");
}

void TableOutput::check_needed(std::vector<std::string>& mistakes) const {
  if (!tsv && file.empty()) mistakes.emplace_back("nothing to do: give --tsv or -o FILE");
  check(mistakes);
}

void TableOutput::print(const Series& table, const std::string& text) const {
  if (file != "-") std::fputs((tsv ? to_tsv(table) : text).c_str(), stdout);
}

void check_table(bool tsv, const std::string& table, const std::string& usual, std::vector<std::string>& mistakes) {
  if (!tsv && table != usual)
    mistakes.push_back(
        fmt::format("--table {}: chooses the table that --tsv prints: give --tsv too, or leave it out", table));
}

void demand_none(const std::vector<std::string>& mistakes) {
  if (!mistakes.empty()) throw UsageError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

}  // namespace soilweave::io
