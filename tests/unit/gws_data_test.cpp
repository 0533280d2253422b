// Geotextiles and soils by name, multiple and path; the data that come with the tools.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cstdlib>

#include "core/data.h"
#include "core/error.h"
#include "gws/output/options.h"
#include "gws/solution/geotextile.h"

namespace soilweave::gws {
namespace {

std::string refusal(const std::string& name) {
  try {
    find_geotextile(name);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(GwsData, GeotextilesAreFoundByNameAndMultiple) {
  const Geotextile PP = find_geotextile("PP"), half = find_geotextile("0.5PP");
  EXPECT_DOUBLE_EQ(PP.stiffness, 232e3);
  EXPECT_DOUBLE_EQ(PP.strength, 31.754e3);
  EXPECT_DOUBLE_EQ(half.stiffness, 116e3);
  EXPECT_DOUBLE_EQ(half.strength, 31.754e3 / 2);
  EXPECT_DOUBLE_EQ(half.failure_strain, PP.failure_strain);
  EXPECT_EQ(half.name, "0.5PP");
}

TEST(GwsData, UnknownGeotextilesAreToldWithTheNearest) {
  EXPECT_NE(refusal("PF").find("did you mean 'PE'?"), std::string::npos);
  EXPECT_NE(refusal("0PP").find("must be above 0"), std::string::npos);
  EXPECT_NE(refusal("./absent.toml").find("absent.toml"), std::string::npos);
}

TEST(GwsData, AGeotextileFileIsCheckedWhole) {
  try {
    read_geotextile("name = \"x\"\nstiffness = -1\nstrenght = 5\nfailure_strain = 0.1\n", "x.toml");
    FAIL();
  } catch (const DataError& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("stiffness"), std::string::npos);
    EXPECT_NE(what.find("strenght"), std::string::npos);
    EXPECT_NE(what.find("strength"), std::string::npos);
  }
}

TEST(GwsData, TheSoilThatComesWithTheToolsIsTable52) {
  std::vector<io::Source> sources;
  std::string resolved;
  const SoilFile file = find_soil("toyoura-gws", {}, sources, resolved);
  for (const Constant& c : constants()) EXPECT_DOUBLE_EQ(file.soil.*c.field, Soil{}.*c.field) << c.key();
  ASSERT_EQ(file.scatter.size(), 1u);
  // The author's 95 % intervals are 1.349 to 1.422, 1.238 to 1.302, 0.0299 to 0.0393.
  const double t = file.scatter[0].quantile();
  EXPECT_NEAR(t * file.scatter[0].standard_errors[0], 0.0365, 1e-4);
  EXPECT_NEAR(t * file.scatter[0].standard_errors[1], 0.032, 1e-4);
  EXPECT_NEAR(t * file.scatter[0].standard_errors[2], 0.0047, 1e-5);
  EXPECT_EQ(find_soil("toyoura-gws", {"failure_line.M=1.4"}, sources, resolved).soil.M, 1.4);
  EXPECT_THROW(find_soil("toyoura", {}, sources, resolved), DataError);
  EXPECT_THROW(find_soil("toyoura-gws", {"failure_line.N=1"}, sources, resolved), DataError);
}

TEST(GwsData, AnotherFolderOfDataCanBeNamed) {
  setenv("SOILWEAVE_DATA", "/nonexistent", 1);
  EXPECT_THROW(data_file("geotextiles", "PP.toml"), MissingInput);
  unsetenv("SOILWEAVE_DATA");
  EXPECT_THROW(data_file("geotextiles", "absent.toml"), MissingInput);
}

}  // namespace
}  // namespace soilweave::gws
