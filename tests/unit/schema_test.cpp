// The schema is the only table: FORMAT.md prints it, and every written dataset is in it with its shape and unit.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "store/schema.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <stdexcept>

#include "files/part.h"
#include "store/store.h"
#include "support/page.h"
#include "support/schema_tables.h"
#include "support/states.h"

namespace soilweave::io {
namespace {

TEST(Schema, IsWhatThePageSays) {
  soilweave::test::demand_on_page("lib/files/FORMAT.md", "<!-- tables: printed from schema.cpp -->\n",
                                  "<!-- end of tables -->\n", test::schema_tables());
}

TEST(Schema, ShapesBecomeNumbers) {
  const Extents extents = {{'F', 3}, {'N', 100}, {'D', 2}};
  EXPECT_EQ(resolve("F N D", extents), (Shape{3, 100, 2}));
  EXPECT_EQ(resolve("F 3 3", extents), (Shape{3, 3, 3}));
  EXPECT_EQ(resolve("(F) N", extents), (Shape{3, 100}));
  EXPECT_EQ(resolve("(F) N", extents, false), (Shape{100}));
  EXPECT_EQ(resolve("", extents), Shape{});
  EXPECT_THROW(resolve("Q", extents), std::out_of_range);
  EXPECT_EQ(count({3, 100, 2}), 600U);
  EXPECT_EQ(count({}), 1U);
  EXPECT_EQ(count({Extent{1} << 63, 4}), ~Extent{0});
  EXPECT_EQ(print({3, 100}), "3 x 100");
  EXPECT_EQ(print({}), "a single value");
  EXPECT_THROW(entry("/nowhere"), std::out_of_range);
}

TEST(Schema, NamesEachPathOnceWithUnitAndMeaning) {
  std::set<std::string_view> paths;
  for (const Section& section : schema())
    for (const Entry& e : section.entries) {
      EXPECT_TRUE(paths.insert(e.path).second) << e.path;
      EXPECT_FALSE(e.units.empty() || e.long_name.empty()) << e.path;
    }
}

/// Returns the path with varying names replaced as in the schema.
std::string in_schema(const std::string& path) {
  const std::vector<std::pair<std::regex, std::string>> rules = {
      {std::regex("/contacts/[0-9]{6}/"), "/contacts/<frame>/"},
      {std::regex("^(/contacts/<frame>)/own_.*"), "$1/<field>"},
      {std::regex("/provenance/[0-9]{6}/"), "/provenance/<n>/"},
      {std::regex("^/fields/[^/]+/step$"), "/fields/<group>/step"},
      {std::regex("^/fields/[^/]+/(?!step$).*"), "/fields/<group>/<column>"},
      {std::regex("^/series/(?!step$).*"), "/series/<column>"},
      {std::regex("^/members/(?!id$).*"), "/members/<column>"},
      {std::regex("^/checkpoint/.*"), "/checkpoint/<name>"},
      {std::regex("^(/particles/grains/(radius|mass|species|id|copy_id))/value$"), "$1"},
      {std::regex("^/particles/grains/.*/(step|time)$"), "/particles/grains/position/$1"}};
  std::string general = path;
  for (const auto& [pattern, replacement] : rules) general = std::regex_replace(general, pattern, replacement);
  return general;
}

void check_datasets(const Reader& file, const std::string& group, std::set<std::string>& seen) {
  for (const std::string& child : file.children(group)) {
    const std::string path = (group == "/" ? "" : group) + "/" + child;
    if (path == "/observables") continue;  // another name for /series
    if (file.is_group(path)) {
      check_datasets(file, path, seen);
      continue;
    }
    const Entry& e = entry(in_schema(path));
    seen.insert(std::string(e.path));
    if (e.units != "its own") {
      EXPECT_EQ(file.text_attribute(path, "units"), e.units) << path;
      EXPECT_EQ(file.text_attribute(path, "long_name"), e.long_name) << path;
    }
    EXPECT_EQ(file.is_integer(path), e.type == Type::int64 || e.type == Type::int32 || e.type == Type::uint8) << path;
    const Shape shape = file.shape(path);
    const Extents letters = {{'F', 0}, {'N', 0}, {'D', 0}, {'M', 0}, {'P', 0}, {'R', 0}, {'K', 0}, {'Y', 0}};
    const bool frames = !e.shape.starts_with("(F)") || path.ends_with("/value");
    EXPECT_EQ(shape.size(), resolve(e.shape, letters, frames).size()) << path;
  }
}

TEST(Schema, HoldsEveryDatasetThatIsWrittenAndNoOther) {
  const test::Folder folder;
  const auto path = folder / "file.h5";
  std::set<std::string> seen;
  write_run(path, test::example_run(12, true), test::example_history());
  check_datasets(Reader(test::bytes_of(path), "run"), "/", seen);
  write_packing(path, test::example_state(5, 2), {});
  check_datasets(Reader(test::bytes_of(path), "packing"), "/", seen);
  Snapshot wrapped = test::example_state(5, 3, true);
  wrapped.planes.partners = {1, 2};
  wrapped.contacts.own = {{"own_overlap", "m", "largest overlap so far", 1, wrapped.contacts.overlap}};
  wrapped.yarns = {{{0, 1}}, {0}, {0}, {0}, {5e-3}, {0.01}, {1.5}, {0}, {0}, {Vec3::Zero()}};
  write_packing(path, wrapped, {});
  check_datasets(Reader(test::bytes_of(path), "packing with yarns"), "/", seen);
  FieldsFile fields;
  fields.groups = {{"grains", "per grain", test::example_run().series}};
  write_fields(path, fields, {});
  check_datasets(Reader(test::bytes_of(path), "fields"), "/", seen);
  EnsembleFile ensemble{
      {{{"id", "1", std::string(entry("/members/id").long_name), {0, 1}}, {"E", "Pa", "modulus", {1e7, 2e7}}}},
      "",
      fields.groups,
      {}};
  write_ensemble(path, ensemble, {});
  check_datasets(Reader(test::bytes_of(path), "ensemble"), "/", seen);
  write_checkpoint(path, {test::example_state(5), test::example_run().series, {{"number", {1, 2}}}}, {});
  check_datasets(Reader(test::bytes_of(path), "checkpoint"), "/", seen);
  for (const Section& section : schema())
    for (const Entry& e : section.entries) EXPECT_TRUE(seen.contains(std::string(e.path))) << e.path;
}

}  // namespace
}  // namespace soilweave::io
