// Digests against published vectors; merged histories with every record once.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/provenance.h"

#include <gtest/gtest.h>

namespace soilweave::io {
namespace {

TEST(Sha256, AgreesWithTheStandard) {
  // FIPS 180-4 examples (NIST), and the digest of nothing.
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256("abcdbcdecdefdefgefghfghighijhijkijkljklmklmnlmnomnopnopq"),
            "248d6a61d20638b8e5c026930c3e6039a33ce45964ff2167f6ecedd419db06c1");
  EXPECT_EQ(sha256(std::string(1000000, 'a')), "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

tool::Invocation called(const std::string& name, std::uint64_t seed = 0) {
  tool::Invocation invocation;
  invocation.tool = name;
  invocation.version = "1.0.0";
  invocation.command = name + " --option 1";
  invocation.seed = seed;
  return invocation;
}

TEST(History, OfOutsideDataIsOneRecord) {
  const History history = extend({{"grading", "aa", {}}}, called("pack-generate", 7), "a = 1\n");
  ASSERT_EQ(history.size(), 1U);
  EXPECT_EQ(history[0].tool, "pack-generate");
  EXPECT_EQ(history[0].command, "pack-generate --option 1");
  EXPECT_EQ(history[0].scenario, "a = 1\n");
  EXPECT_EQ(history[0].seed, 7U);
  ASSERT_EQ(history[0].inputs.size(), 1U);
  EXPECT_EQ(history[0].inputs[0].origin, -1);
  EXPECT_EQ(history[0].inputs[0].sha256, "aa");
}

TEST(History, NamesTheRecordThatMadeEachInput) {
  const History packing = extend({}, called("pack-generate"));
  const History run = extend({{"packing", "bb", packing}, {"scenario", "cc", {}}}, called("run-dem"));
  ASSERT_EQ(run.size(), 2U);
  EXPECT_EQ(run[1].inputs[0].origin, 0);
  EXPECT_EQ(run[1].inputs[1].origin, -1);
}

TEST(History, KeepsAllParentsEachOnce) {
  const History packing = extend({}, called("pack-generate"));
  const History other = extend({}, called("pack-generate", 2));
  const History one = extend({{"packing", "bb", packing}}, called("run-dem", 1));
  const History two = extend({{"packing", "bb", packing}, {"packing", "dd", other}}, called("run-dem", 2));
  const History merged = extend({{"run", "ee", one}, {"run", "ff", two}}, called("pf-weight"));
  ASSERT_EQ(merged.size(), 5U);
  EXPECT_EQ(merged[2].seed, 2U);  // the other packing, at another place than in its own history
  EXPECT_EQ(merged[3].inputs[0].origin, 0);
  EXPECT_EQ(merged[3].inputs[1].origin, 2);
  EXPECT_EQ(merged[4].inputs[0].origin, 1);
  EXPECT_EQ(merged[4].inputs[1].origin, 3);
}

TEST(History, SameDigestFromTwoMakersStaysTwo) {
  const History one = extend({}, called("pack-generate", 1));
  const History two = extend({}, called("pack-generate", 2));
  const History merged = extend({{"a", "00", one}, {"b", "00", two}}, called("fabric"));
  EXPECT_EQ(merged.size(), 3U);
}

TEST(History, IsToldOneParagraphARecord) {
  const History packing = extend({{"grading", "aa", {}}}, called("pack-generate", 7));
  const History run = extend({{"packing", "bb", packing}}, called("run-dem"), "[law]\nname = \"linear\"\n");
  EXPECT_EQ(describe(run),
            "0. pack-generate 1.0.0\n"
            "  command: pack-generate --option 1\n"
            "  seed: 7\n"
            "  input: grading, from outside, sha256 aa\n"
            "\n"
            "1. run-dem 1.0.0\n"
            "  command: run-dem --option 1\n"
            "  seed: 0\n"
            "  input: packing, made by 0, sha256 bb\n"
            "  scenario:\n"
            "    [law]\n"
            "    name = \"linear\"\n");
}

}  // namespace
}  // namespace soilweave::io
