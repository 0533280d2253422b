// Scenario documents: conversion of units, and every mistake with its line and remedy.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/settings.h"

#include <gtest/gtest.h>

#include "core/error.h"
#include "support/same_state.h"

namespace soilweave {
namespace {

constexpr Parameter pressure{"pressure", "Pa", 0, 1e9, true, "mean stress of the cell", "no pressure, no stiffness"};
constexpr Parameter size{"size", "m", 0, 10, true, "edge of the cell", ""};
constexpr Parameter angle{"angle", "deg", 0, 90, false, "friction angle", ""};
constexpr Parameter density{"density", "kg/m3", 0, 3e4, true, "density of the grains", ""};
constexpr Parameter limit{"limit", "1", 0, 1, false, "rolling limit", ""};
constexpr Parameter steps{"steps", "1", 1, 1e9, false, "number of steps", ""};

std::string mistakes_of(const Settings& settings) {
  try {
    settings.finish();
  } catch (const DataError& error) {
    return error.what();
  }
  return "";
}

TEST(Settings, ConvertsQuantitiesWithUnitsToTheParametersUnit) {
  Settings s = Settings::parse(
      "pressure = '100 kPa'\nsize = '3 mm'\nangle = '0.5 rad'\ndensity = '2.65 g/cm3'\nlimit = '20 %'\n", "t.toml");
  EXPECT_EQ(s.number(pressure), 1e5);
  EXPECT_EQ(s.number(size), 3e-3);
  EXPECT_DOUBLE_EQ(s.number(angle), 28.647889756541160);  // 0.5 * 180 / pi
  EXPECT_DOUBLE_EQ(s.number(density), 2650);
  EXPECT_DOUBLE_EQ(s.number(limit), 0.2);
  EXPECT_EQ(mistakes_of(s), "");
}

TEST(Settings, BareNumbersAreInTheParametersUnitAndAbsentOnesFallBack) {
  Settings s = Settings::parse("pressure = 5\nsteps = 1e3\n", "t.toml");
  EXPECT_EQ(s.number(pressure), 5);
  EXPECT_EQ(s.integer(steps), 1000);
  EXPECT_EQ(s.number(size, 0.25), 0.25);
  EXPECT_EQ(s.integer(limit, 7), 7);
  EXPECT_EQ(mistakes_of(s), "");
}

TEST(Settings, ReadsListsVectorsWordsAndFlags) {
  Settings s = Settings::parse("size = ['1 m', 2, 3.5]\nlimit = 'none'\nlaw = 'linear'\non = true\nname = 'x'\n", "t");
  EXPECT_EQ(s.vector(size), Vec3(1, 2, 3.5));
  EXPECT_EQ(s.numbers(size), (std::vector<double>{1, 2, 3.5}));
  EXPECT_EQ(s.number_or(limit, "none"), std::nullopt);
  EXPECT_EQ(s.choice("law", {"linear", "hertz-mindlin"}), "linear");
  EXPECT_TRUE(s.flag("on", false));
  EXPECT_EQ(s.text("name"), "x");
  EXPECT_EQ(s.text("other", "y"), "y");
  EXPECT_EQ(s.vector(pressure, Vec3(1, 1, 1)), Vec3(1, 1, 1));
  EXPECT_EQ(mistakes_of(s), "");
}

TEST(Settings, NoneAndZeroAreDifferentLimits) {
  Settings s = Settings::parse("limit = 0\n", "t");
  EXPECT_EQ(s.number_or(limit, "none"), 0);
}

TEST(Settings, TellsEveryMistakeWithItsLineAndRemedy) {
  Settings s = Settings::parse(
      "presure = 1\nsize = 20\nangle = '3 m'\nlaw = 'hertz'\nlimit = true\n[stage]\nsteps = 1.5\n", "a.toml");
  s.number(pressure);
  s.number(size);
  s.number(angle);
  s.choice("law", {"linear", "hertz-mindlin"});
  s.number(limit);
  s.table("stage").integer(steps);
  EXPECT_EQ(mistakes_of(s),
            "a.toml:1: unknown key 'presure'; did you mean 'pressure'?\n"
            "a.toml:2: size: 20 is out of range: must be between 0 and 10 m\n"
            "a.toml:3: angle: 'm' does not measure what 'deg' measures\n"
            "a.toml:4: law: 'hertz' is not one of linear, hertz-mindlin; did you mean 'hertz-mindlin'?\n"
            "a.toml:5: limit: true is not a number\n"
            "a.toml:7: stage.steps: 1.5 is not a whole number");
}

TEST(Settings, RangeErrorsGiveTheReason) {
  Settings s = Settings::parse("pressure = 0\n", "a.toml");
  s.number(pressure);
  EXPECT_EQ(mistakes_of(s),
            "a.toml:1: pressure: 0 is out of range: must be between 0 and 1e9 Pa (no pressure, no stiffness)");
}

TEST(Settings, RefusesNanAndInfinity) {
  Settings s = Settings::parse("pressure = nan\nsize = inf\n", "a.toml");
  s.number(pressure);
  s.number(size);
  EXPECT_EQ(mistakes_of(s),
            "a.toml:1: pressure: 'nan' is not a finite number\na.toml:2: size: 'inf' is not a finite number");
}

TEST(Settings, WrongKindsOfValueAreMistakes) {
  Settings s = Settings::parse("size = 1\nname = 2\non = 3\ntable = 4\nstage = 5\nangle = [1, 2]\nlimit = [7]\n", "a");
  s.vector(size);
  s.text("name");
  s.flag("on", false);
  s.table("table");
  s.tables("stage");
  s.vector(angle);
  s.numbers(limit);
  s.text("absent");
  s.choice("kind", {"one", "two"});
  s.number_or(steps, "none");
  s.numbers(density);
  EXPECT_EQ(mistakes_of(s),
            "a:1: size: 1 is not a list; write [1, ...]\n"
            "a:1: absent: is missing; give a text\n"
            "a:1: kind: is missing; give one of one, two\n"
            "a:1: steps: is missing; give \"none\" or from 1 to 1e9: number of steps\n"
            "a:1: density: is missing; give a list, each between 0 and 30000 kg/m3: density of the grains\n"
            "a:2: name: 2 is not a text; write \"2\"\n"
            "a:3: on: 3 is neither true nor false\n"
            "a:4: table: 4 is not a table; write [table] on a line of its own\n"
            "a:5: stage: is not a list of tables; write [[stage]] on a line of its own before each\n"
            "a:6: angle: has 2 components; a vector has 3\n"
            "a:7: limit: entry 1: 7 is out of range: must be from 0 to 1");
}

TEST(Settings, AListWhereTextBelongsIsOfferedAsText) {
  Settings s = Settings::parse("a = [\"top\"]\nb = [[2]]\nc = [\"x\", \"y\"]\nd = []\n", "t");
  for (const char* key : {"a", "b", "c", "d"}) s.text(key);
  const std::string text = mistakes_of(s);
  for (const std::string words :
       {"t:1: a: [ 'top' ] is not a text; write \"top\"\n", "is not a text; write \"2\"\n",
        "t:3: c: [ 'x', 'y' ] is not a text; give one text in quotes\n", "is not a text; give one text in quotes"})
    EXPECT_NE(text.find(words), std::string::npos) << text;
}

TEST(Settings, UnknownKeysAreFoundInsideTablesAndListsOfTables) {
  Settings s = Settings::parse("[a]\nsize = 1\nsise = 2\n[[stage]]\nsteps = 3\n[[stage]]\nstep = 4\n[b]\nx = 1\n", "t");
  s.table("a").number(size);
  for (Settings& stage : s.tables("stage")) stage.integer(steps, 1);
  EXPECT_EQ(mistakes_of(s),
            "t:3: unknown key 'a.sise'; did you mean 'size'?\n"
            "t:7: unknown key 'stage.1.step'; did you mean 'steps'?\n"
            "t:8: unknown key 'b'; known: a, stage");
}

TEST(Settings, OwnMistakesOfTheReaderJoinTheOthers) {
  Settings s = Settings::parse("\n[stage]\nsize = 1\n", "t");
  Settings stage = s.table("stage");
  stage.number(size);
  stage.mistake("size", "is larger than the cell");
  stage.mistake("", "has no goal");
  s.mistake("", "has no laws");
  EXPECT_EQ(mistakes_of(s), "t:1: has no laws\nt:2: stage: has no goal\nt:3: stage.size: is larger than the cell");
}

TEST(Settings, SyntaxErrorsNameLineAndColumn) {
  try {
    Settings::parse("a = 1\nb = = 2\n", "bad.toml");
    FAIL() << "no error";
  } catch (const DataError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("bad.toml:2:5: ")) << error.what();
  }
}

TEST(Settings, SetOverridesReachesTablesAndListsAndMakesTables) {
  Settings s = Settings::parse("size = 1\n[[stage]]\nsteps = 1\n[[stage]]\nsteps = 2\n", "t");
  s.set("size=0.5 mm");
  s.set("stage.1.steps=7");
  s.set("grains.density=2650");
  s.set("law=hertz-mindlin");
  s.set("list=[1, 2]");
  s.set("list.1=5");
  EXPECT_EQ(s.number(size), 5e-4);
  EXPECT_EQ(s.tables("stage")[1].integer(steps), 7);
  EXPECT_EQ(s.table("grains").number(density), 2650);
  EXPECT_EQ(s.text("law"), "hertz-mindlin");
  EXPECT_EQ(s.numbers({"list", "1"}), (std::vector<double>{1, 5}));
  for (Settings& stage : s.tables("stage")) stage.integer(steps);
  EXPECT_EQ(mistakes_of(s), "");
}

TEST(Settings, MistakesInSetNameTheAssignment) {
  Settings s = Settings::parse("size = 1\n", "t");
  s.set("size=50");
  s.set("siez=1");
  s.number(size);
  EXPECT_EQ(mistakes_of(s),
            "--set size=50: size: 50 is out of range: must be between 0 and 10 m\n"
            "--set siez=1: unknown key 'siez'; did you mean 'size'?");
}

TEST(Settings, ASlipOfTheFingerIsOneMistake) {
  Settings s = Settings::parse("[staeg]\nsteps = 3\n", "t");
  s.set("grians.density=1");
  s.table("stage").integer(steps);
  s.table("grains").number(density);
  EXPECT_EQ(mistakes_of(s),
            "--set grians.density=1: unknown key 'grians'; did you mean 'grains'?\n"
            "t:1: unknown key 'staeg'; did you mean 'stage'?");
}

TEST(Settings, AWrongKindOrNoTableIsOneMistake) {
  Settings s = Settings::parse("grains = 1\n[[stage]]\nlaw = 'liner'\nsize = 20\n[stage.more]\nx = 1\n", "t");
  s.table("grains").number(density);
  for (Settings& stage : s.tables("stage")) {
    EXPECT_EQ(stage.kind("law", {"linear", "hertz"}), "linear");
    stage.number(pressure);
    stage.table("more").number(size);
  }
  EXPECT_EQ(mistakes_of(s),
            "t:1: grains: 1 is not a table; write [grains] on a line of its own\n"
            "t:3: stage.0.law: 'liner' is not one of linear, hertz; did you mean 'linear'?");
}

TEST(Settings, NumbersAreToldAsTheyWereWritten) {
  Settings s = Settings::parse("size = 10.7\n", "t");
  s.number(size);
  EXPECT_EQ(mistakes_of(s), "t:1: size: 10.7 is out of range: must be between 0 and 10 m");
}

TEST(Settings, ImpossibleSetsAreUsageErrors) {
  Settings s = Settings::parse("size = 1\n[[stage]]\nsteps = 1\n", "t");
  EXPECT_THROW(s.set("size"), UsageError);
  EXPECT_THROW(s.set("=1"), UsageError);
  EXPECT_THROW(s.set("stage.3.steps=1"), UsageError);
  EXPECT_THROW(s.set("stage.x.steps=1"), UsageError);
  EXPECT_THROW(s.set("size.x=1"), UsageError);
  s.set("stage.0=3");
  io::test::expect_error<UsageError>([&] { s.set("stage.0.steps=1"); }, "'0' is a value and holds no keys");
}

std::string many(const std::string& piece, int times) {
  std::string text;
  for (int k = 0; k < times; ++k) text += piece;
  return text;
}

TEST(Settings, DeepDocumentsAreErrorsAndDoNotOverrunTheStack) {
  constexpr int deep = 40'000;
  const std::string key = many("a.", deep) + "a";
  const std::vector<std::pair<std::string, std::string>> documents{
      {key + " = 1\n", "t:1:64: a key of more than 32 parts"},
      {"x = 1\n[" + key + "]\n", "t:2:65: a key of more than 32 parts"},
      {"[[" + key + "]]\n", "a key of more than 32 parts"},
      {many("\"a\" . ", deep) + "a = 1\n", "a key of more than 32 parts"},
      {"x = {" + key + " = 1}\n", "a key of more than 32 parts"},
      {"x = " + many("[", deep) + many("]", deep) + "\n", "t:1:37: lists or tables more than 32 within one another"},
      {"x = " + many("{a = ", deep) + "1" + many("}", deep) + "\n", "lists or tables more than 32"},
      {"x = '''" + std::string(std::size_t{17} << 20, ' ') + "'''\n", "t:1:1: a document of 17 MiB; at most 16"}};
  for (const auto& [document, words] : documents)
    io::test::expect_error<DataError>([&, &text = document] { Settings::parse(text, "t"); }, words);
  Settings s = Settings::parse("size = 1\n", "t");
  io::test::expect_error<UsageError>([&] { s.set(key + "=1"); }, "is no key");
  io::test::expect_error<UsageError>([&] { s.set("size={" + key + "=1}"); }, "a key of more than 32 parts");
}

TEST(Settings, DotsInStringsCommentsAndNumbersAreNoParts) {
  const std::string dots = many(".", 100);
  const std::string text = "# " + dots + "\na = \"" + dots + "\\\"" + dots + "\" # " + dots + "\nb = '" + dots +
                           "'\nc = '''\n" + dots + "'\n'''\nd = [" + many("1.5, ", 100) + "1.5]\ne = [" +
                           many("[1.0], ", 100) + "]\n";
  EXPECT_EQ(Settings::parse(text, "t").text("b"), dots);
}

TEST(Settings, DecimalCommasAndUnitsInOtherLettersAreToldAsSuch) {
  Settings s = Settings::parse("size = \"0,5 m\"\n[a]\nsize = \"5 MM\"\n", "t");
  s.number(size);
  s.table("a").number(size);
  EXPECT_EQ(mistakes_of(s),
            "t:1: size: '0,5 m' is not a number: write 0.5, with a decimal point\n"
            "t:3: a.size: 'MM' is not a known unit; did you mean 'mm'?");
}

TEST(Settings, WholeNumbersBeyondTheirRangeAreErrors) {
  Settings s = Settings::parse("steps = 1e300\n", "t");
  s.integer({"steps", "1"});
  EXPECT_EQ(mistakes_of(s), "t:1: steps: 1e+300 is beyond the whole numbers that are read");
}

TEST(Settings, ATableThatIsLeftIsNotJudged) {
  Settings s = Settings::parse("[[product]]\nsize = 1\n[[product]]\nsiz = 1\n[product.inner]\nx = 1\n", "t.toml");
  std::vector<Settings> products = s.tables("product");
  EXPECT_EQ(products[0].number(size), 1);
  EXPECT_NE(mistakes_of(s), "");
  Settings again = Settings::parse("[[product]]\nsize = 1\n[[product]]\nsiz = 1\n[product.inner]\nx = 1\n", "t.toml");
  products = again.tables("product");
  EXPECT_EQ(products[0].number(size), 1);
  products[1].leave();
  EXPECT_EQ(mistakes_of(again), "");
}

TEST(Settings, ResolvedIsTheSameForTheSameContentInAnyOrder) {
  Settings one = Settings::parse("b = 2\na = 1\n[t]\ny = 'q'\nx = 1.5\n", "one");
  Settings other = Settings::parse("# a remark\na = 5\nb = 2\n[t]\nx = 1.5\ny = 'q'\n", "other");
  other.set("a=1");
  EXPECT_EQ(one.resolved(), other.resolved());
  Settings again = Settings::parse(one.resolved(), "again");
  EXPECT_EQ(again.resolved(), one.resolved());
}

}  // namespace
}  // namespace soilweave
