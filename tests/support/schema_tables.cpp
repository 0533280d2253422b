// Prints the schema as Markdown.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/schema_tables.h"

#include <fmt/format.h>

#include "store/schema.h"

namespace soilweave::io::test {
namespace {

std::string dataset_row(const Entry& e) {
  return fmt::format("| `{}` | {} | {} | {} | {}{} |\n", e.path, name(e.type), e.shape.empty() ? "scalar" : e.shape,
                     e.units, e.long_name, e.optional ? " (may be absent)" : "");
}

std::string attribute_row(const AttributeEntry& a) {
  return fmt::format("| `{}` | `{}` | {} | {} |\n", a.path, a.name, a.value, a.meaning);
}

}  // namespace

std::string schema_tables() {
  std::string text;
  for (const Section& section : schema()) {
    text += fmt::format("### {}\n\nIn: {}.\n\n", section.title, section.kinds);
    if (!section.entries.empty()) {
      text += "| dataset | type | shape | units | long_name |\n|---|---|---|---|---|\n";
      for (const Entry& e : section.entries) text += dataset_row(e);
      text += "\n";
    }
    if (section.attributes.empty()) continue;
    text += "| object | attribute | value | meaning |\n|---|---|---|---|\n";
    for (const AttributeEntry& a : section.attributes) text += attribute_row(a);
    text += "\n";
  }
  return text;
}

}  // namespace soilweave::io::test
