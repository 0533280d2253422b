// Where the results of gws-solve go.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/output.h"

#include <fmt/format.h>

#include <cstdio>

#include "core/error.h"
#include "io/table.h"

namespace soilweave::gws {

void Output::declare(tool::Table& table) {
  table.flag(tsv, "tsv", "print tab-separated text in SI units");
  table.optional_output(file, "fields file to write");
}

void Output::check(std::vector<std::string> mistakes) const {
  if (tsv && file == "-") mistakes.emplace_back("--tsv and -o - both write to standard output: give one of them");
  if (!mistakes.empty()) throw UsageError(fmt::format("{}", fmt::join(mistakes, "\n")));
}

void Output::put(const Groups& groups, std::size_t chosen, const std::string& text,
                 const std::vector<io::Source>& sources, const std::string& scenario,
                 const tool::Invocation& invocation) const {
  if (file != "-") std::fputs(tsv ? io::to_tsv(groups.at(chosen).table).c_str() : text.c_str(), stdout);
  if (!file.empty()) io::write_fields(file, {groups, {}}, io::extend(sources, invocation, scenario));
}

}  // namespace soilweave::gws
