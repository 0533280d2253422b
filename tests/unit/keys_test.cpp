// Keys as data: every branch of a reader is seen, with type, range, default and condition.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "core/text/settings.h"

namespace soilweave {
namespace {

constexpr Parameter pressure{"pressure", "Pa", 0, 1e9, true, "mean stress"};
constexpr Parameter limit{"limit", "1", 0, 1, false, "plastic limit"};
constexpr Parameter gravity{"gravity", "m/s2", -10, 10, false, "acceleration"};
constexpr Parameter steps{"steps", "1", 1, 100, false, "number of steps"};

// A reader with each kind of question, one inside the other.
void read(Settings& document) {
  const std::string law = document.table("contact").kind({"law", "contact law"}, {"stiff", "soft"});
  document.table("numerics").vector(gravity, Vec3(0, 0, -9.81));
  for (Settings table : document.tables("stage")) {
    const std::string path = table.kind({"path", "loading path"}, {"hold", "press", "file"});
    if (path == "press") table.number(pressure);
    if (path == "press" && table.has("limit")) table.number_or(limit, "none");
    if (path == "hold" && table.flag({"long", "whether it holds long"}, false)) table.integer(steps, 5);
    if (path == "file") throw DataError("there is no such file");
    if (law == "soft") table.text({"note", "remark"}, "nothing");
  }
  if (law == "stiff") document.table("numerics").number(limit);
  document.finish();
}

const Key& key(const std::vector<Key>& keys, const std::string& table, const std::string& name) {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const Key& k) { return k.table == table && k.name == name; });
  if (found == keys.end()) throw DataError("no key " + name);
  return *found;
}

TEST(Keys, AreAllThatAReaderAsksForInAnyBranch) {
  const std::vector<Key> keys = keys_of(read);
  EXPECT_EQ(keys.size(), 9u);
  EXPECT_EQ(key(keys, "contact", "law").words, (std::vector<std::string>{"stiff", "soft"}));
  EXPECT_EQ(key(keys, "stage[]", "steps").standard, "5");
  EXPECT_EQ(key(keys, "numerics", "gravity").standard, "[0, 0, -9.81]");
  EXPECT_EQ(key(keys, "stage[]", "limit").words, std::vector<std::string>{"none"});
}

TEST(Keys, SayWhetherATableMustHaveThem) {
  const std::vector<Key> keys = keys_of(read);
  EXPECT_TRUE(key(keys, "stage[]", "pressure").required);
  EXPECT_FALSE(key(keys, "stage[]", "limit").required) << "its reader asks whether it is there";
  EXPECT_FALSE(key(keys, "numerics", "gravity").required) << "it has a default";
}

TEST(Keys, NameTheChoicesUnderWhichTheyAreRead) {
  const std::vector<Key> keys = keys_of(read);
  EXPECT_EQ(key(keys, "stage[]", "pressure").when, std::vector<std::string>{"path = press"});
  EXPECT_EQ(key(keys, "numerics", "limit").when, std::vector<std::string>{"contact.law = stiff"});
  EXPECT_TRUE(key(keys, "numerics", "gravity").when.empty());
  EXPECT_TRUE(key(keys, "stage[]", "path").when.empty());
}

TEST(Keys, ArePrintedWithRangeDefaultAndCondition) {
  const std::string text = keys_as_text(keys_of(read));
  EXPECT_NE(text.find("[[stage]]\n"), std::string::npos);
  EXPECT_NE(text.find("pressure  number, between 0 and 1e9 Pa; required: mean stress (path = press)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("steps     whole number, from 1 to 100; default 5: number of steps"), std::string::npos) << text;
}

TEST(Keys, MakeASchemaThatRefusesOtherKeys) {
  const std::string text = keys_as_schema(keys_of(read), "an example");
  for (const char* part :
       {"\"additionalProperties\": false", "\"title\": \"an example\"", "\"stage\": {\"type\": \"array\"",
        "\"exclusiveMinimum\": 0, \"exclusiveMaximum\": 1e9", "\"enum\": [\"stiff\", \"soft\"]",
        "\"if\": {\"properties\": {\"path\": {\"const\": \"press\"}}, \"required\": [\"path\"]}"})
    EXPECT_NE(text.find(part), std::string::npos) << part << "\n" << text;
}

}  // namespace
}  // namespace soilweave
