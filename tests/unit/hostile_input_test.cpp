// Readers under unchecked bytes: the fuzzing corpus, and a few thousand random changes of it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "support/hostile.h"

namespace soilweave {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> seeds(const fs::path& folder, const std::string& ending) {
  std::vector<fs::path> paths;
  if (!fs::exists(folder)) return {};
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() && (ending.empty() || entry.path().extension() == ending)) paths.push_back(entry);
  std::sort(paths.begin(), paths.end());
  std::vector<std::string> bytes;
  for (const fs::path& path : paths) {
    std::ifstream file(path, std::ios::binary);
    bytes.emplace_back(std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>());
  }
  return bytes;
}

// Returns the bytes with one change: a byte changed, a piece cut out or repeated, a number made extreme.
std::string changed(std::string bytes, std::mt19937& chance) {
  static const std::vector<std::string> extremes{"nan", "-1", "1e999", "1e308", "-0", "99999999999999999999", "1e-320"};
  if (bytes.empty()) return bytes;
  const std::size_t at = chance() % bytes.size(),
                    length = chance() % (1 + std::min<std::size_t>(bytes.size() - at, 60));
  switch (chance() % 4) {
    case 0:
      bytes[at] = static_cast<char>(chance());
      return bytes;
    case 1:
      return bytes.erase(at, length);
    case 2:
      return bytes.insert(at, bytes.substr(at, length));
    default: {
      const std::size_t digit = bytes.find_first_of("0123456789", at);
      if (digit == std::string::npos) return bytes;
      const std::size_t end = bytes.find_first_not_of("0123456789.e-+", digit);
      return bytes.replace(digit, (end == std::string::npos ? bytes.size() : end) - digit,
                           extremes[chance() % extremes.size()]);
    }
  }
}

void feed(const std::string& name, const std::vector<std::string>& from, int changes) {
  const hostile::Reader read = hostile::reader(name);
  ASSERT_NE(read, nullptr);
  for (const std::string& bytes : seeds("tests/fuzz/corpus/" + name, "")) EXPECT_NO_THROW(read(bytes)) << bytes;
  ASSERT_FALSE(from.empty());
  std::mt19937 chance(1);
  for (int k = 0; k < changes; ++k) {
    std::string bytes = from[chance() % from.size()];
    for (unsigned n = 1 + chance() % 3; n > 0; --n) bytes = changed(std::move(bytes), chance);
    EXPECT_NO_THROW(read(bytes)) << "change " << k << ":\n" << bytes;
  }
}

TEST(HostileInput, Scenarios) { feed("scenario", seeds("pipelines", ".toml"), 400); }
TEST(HostileInput, Tables) { feed("table", seeds("data/gradings", ".tsv"), 400); }
TEST(HostileInput, Meshes) { feed("mesh", seeds("tests/fuzz/corpus/mesh", ".msh"), 400); }
TEST(HostileInput, Surfaces) { feed("surface", seeds("tests/fuzz/corpus/surface", ""), 400); }
TEST(HostileInput, Files) { feed("file", seeds("tests/fuzz/corpus/file", ".h5"), 100); }
TEST(HostileInput, Spheres) { feed("spheres", seeds("tests/tools/examples", ".txt"), 400); }

}  // namespace
}  // namespace soilweave
