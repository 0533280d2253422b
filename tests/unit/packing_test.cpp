// Gradings, clouds and packings.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "core/error.h"
#include "dem/state/bodies.h"
#include "packing/expand/tile.h"
#include "packing/generate/rows.h"
#include "packing/generate/spatial_order.h"
#include "support/assemblies.h"
#include "support/distance.h"
#include "support/reference.h"
#include "support/same_state.h"

namespace soilweave::packing {
namespace {

TEST(Grading, BuiltInCurveIsTheOneInTheDataFolder) {
  std::ifstream file("data/gradings/toyoura.tsv");
  ASSERT_TRUE(file) << "run the tests from the top folder";
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const Grading read = Grading::from_tsv(text, "toyoura.tsv"), built_in = Grading::toyoura();
  ASSERT_EQ(read.diameter.size(), built_in.diameter.size());
  for (std::size_t k = 0; k < read.diameter.size(); ++k) {
    EXPECT_NEAR(read.diameter[k], built_in.diameter[k], 1e-15);
    EXPECT_EQ(read.finer[k], built_in.finer[k]);
  }
}

// n grains at the mid-quantiles by number follow the curve by mass, from its first point on, to about the mass of one
// large grain.
TEST(Grading, GrainsFollowTheCurveByMass) {
  for (const int d : {2, 3}) {
    const Grading curve = Grading::toyoura();
    const std::vector<double> radii = curve.radii(2000, d);
    double total = 0;
    for (const double r : radii) total += std::pow(r, d);
    for (std::size_t k = 1; k + 1 < curve.diameter.size(); ++k) {
      double finer = 0;
      for (const double r : radii)
        if (2 * r <= curve.diameter[k]) finer += std::pow(r, d);
      const double expected = (curve.finer[k] - curve.finer[0]) / (1 - curve.finer[0]);
      EXPECT_NEAR(finer / total, expected, 2 * std::pow(radii.front(), d) / total) << "diameter " << k;
    }
    EXPECT_TRUE(std::is_sorted(radii.rbegin(), radii.rend()));
  }
}

TEST(Grading, UnitsAreConverted) {
  const Grading plain = Grading::from_tsv("diameter [mm]\tfiner_by_mass [1]\n6\t0\n10\t0.5\n16\t1\n", "g");
  for (const std::string table : {"diameter [mm],finer_by_mass [%]\n6,0\n10,50\n16,100\n",
                                  "diameter [um];finer_by_mass [1]\n6000;0\n1e4;0.5\n16000;1\n",
                                  "finer_by_mass\tdiameter [\u00b5m]\n0\t6000\n0.5\t10000\n1\t16000\n",
                                  "diameter [cm]\tfiner_by_mass [\u2030]\n0.6\t0\n1\t500\n1.6\t1000\n"}) {
    const Grading read = Grading::from_tsv(table, "g");
    ASSERT_EQ(read.diameter.size(), 3U) << table;
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(read.diameter[k], plain.diameter[k], 1e-15) << table;
      EXPECT_NEAR(read.finer[k], plain.finer[k], 1e-15) << table;
    }
  }
}

TEST(Grading, SaysWhatIsLeftOut) {
  EXPECT_EQ(Grading::from_tsv("diameter [mm]\tfiner_by_mass [%]\n0.075\t10\n1\t100\n", "g").left_out(),
            "the part finer than 0.075 mm, 10 % of the mass, is left out");
  EXPECT_EQ(Grading::from_tsv("diameter [mm]\tfiner_by_mass [%]\n0.075\t0\n1\t100\n", "g").left_out(), "");
}

TEST(Grading, FurtherColumnsAreNamedAndThoseWithNearlyANeededNameRefused) {
  const auto read = [](const std::string& heads) {
    return Grading::from_tsv("diameter [mm]\tfiner_by_mass [%]\t" + heads + "\n1\t0\t5\n2\t100\t5\n", "g");
  };
  EXPECT_EQ(read("depth [m]").notes(true), (std::vector<std::string>{"columns left out: depth"}));
  EXPECT_EQ(read("finer_by_number [%]").unread, (std::vector<std::string>{"finer_by_number"}));
  for (const std::string name : {"finer_by_mass_upper", "Finer_By_Mass", "Diameter", "diameter_mean"})
    io::test::expect_error<DataError>([&] { read(name + " [mm]"); },
                                      name + " could both be meant: leave one of them out");
}

TEST(Grading, OneSizeIsACurve) {
  const Grading curve = Grading::from_tsv("diameter [mm]\tfiner_by_mass [1]\n3\t1\n", "g");
  for (const double r : curve.radii(5, 3)) EXPECT_DOUBLE_EQ(r, 1.5e-3);
}

// Diameters over the median one in the author's packing of 5000 grains, at fractions of its mass.
TEST(Grading, IsThatOfTheAuthorsPackings) {
  std::ifstream file(soilweave::test::reference_file("ch2/toyoura_rv_5000.csv"));
  if (!file) GTEST_SKIP() << "SOILWEAVE_REFERENCE is not set";
  std::vector<double> theirs;
  std::string line;
  std::getline(file, line);
  while (std::getline(file, line)) theirs.push_back(std::stod(line.substr(line.rfind(',') + 1)));
  const auto at = [](std::vector<double> radii, double fraction) {
    std::sort(radii.begin(), radii.end());
    double total = 0, below = 0;
    for (const double r : radii) total += r * r * r;
    for (const double r : radii)
      if ((below += r * r * r) >= fraction * total) return r;
    return radii.back();
  };
  const std::vector<double> ours = Grading::toyoura().radii(theirs.size(), 3);
  for (const double f : {0.002, 0.01, 0.02, 0.05, 0.1, 0.3, 0.6, 0.9, 0.99})
    EXPECT_NEAR(at(ours, f) / at(ours, 0.5), at(theirs, f) / at(theirs, 0.5), 0.01) << "fraction " << f;
  const auto small = [&](const std::vector<double>& radii) {
    const double limit = 0.65 * at(radii, 0.5);
    return std::count_if(radii.begin(), radii.end(), [&](double r) { return r < limit; });
  };
  EXPECT_NEAR(static_cast<double>(small(ours)), static_cast<double>(small(theirs)), 0.1 * small(theirs));
}

TEST(Grading, TellsWhatIsWrongWithATable) {
  const std::string head = "diameter [mm]\tfiner_by_mass [1]\n";
  EXPECT_THROW(Grading::from_tsv(head + "1\t0.2\n0.5\t1\n", "g"), DataError);
  EXPECT_THROW(Grading::from_tsv(head + "1\t0.2\n2\t0.1\n3\t1\n", "g"), DataError);
  EXPECT_THROW(Grading::from_tsv(head + "1\t0.2\n2\t0.9\n", "g"), DataError);
  EXPECT_THROW(Grading::from_tsv("diameter [inch]\tfiner_by_mass [1]\n1\t1\n", "g"), DataError);
  const auto refuses = [](const std::string& table, const std::string& words) {
    io::test::expect_error<DataError>([&] { Grading::from_tsv(table, "g"); }, words);
  };
  refuses("diameter [mm]\tfiner_by_mass [1]\n6\t0\n16\t100\n",
          "g: row 2: finer_by_mass 100 must rise from 0 to 1: are these per cent? head the column finer_by_mass [%]");
  refuses("diameter [mm]\tfiner_by_mass\n6\t0\n16\t100\n", "are these per cent?");
  refuses("diameter [mm]\tfiner_by_mass [%]\n6\t0\n10\t0.5\n16\t1\n", "the last finer_by_mass is 1 %, not all");
  refuses("diameter [mm]\tfiner_by_mass [%]\n6\t0\n16\t101\n", "finer_by_mass 101 must rise from 0 to 100 %");
  refuses("diameter\tfiner_by_mass [%]\n6\t0\n16\t100\n",
          "g: column diameter: has no unit: write it in the header, such as diameter [m]");
  refuses("size [mm]\tfiner_by_mass [%]\n6\t0\n", "g: no column diameter among size, finer_by_mass: head the columns");
  refuses("diameter [mm]\tfiner_by_mass [%]\n", "g: no rows below the header");
  refuses("diameter [MM]\tfiner_by_mass [%]\n6\t100\n", "'MM' is not a known unit; did you mean 'mm'?");
  refuses("diameter [mm]\tfiner_by_mass [%]\ninf\t100\n", "diameter inf is not above");
}

TEST(Cloud, HasTheVoidRatioAndNoOverlap) {
  for (const int d : {2, 3}) {
    const std::vector<double> radii = Grading::toyoura().radii(300, d);
    const io::Snapshot s = cloud(radii, 2.0, {1, d == 2 ? 2.0 : 1.0, 2}, d, 2650, 7);
    double solids = 0;
    for (const double r : s.grains.radius) solids += dem::grain_volume(d, r);
    EXPECT_NEAR(s.cell.matrix.diagonal().prod() / solids, 3.0, 1e-12);
    for (std::size_t i = 0; i < s.grains.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        Vec3 gap = s.grains.position[i] - s.grains.position[j];
        for (int a = 0; a < d; ++a) gap[a] -= s.cell.matrix(a, a) * std::round(gap[a] / s.cell.matrix(a, a));
        EXPECT_GE(gap.norm(), s.grains.radius[i] + s.grains.radius[j]);
      }
  }
}

TEST(Cloud, IsTheSeeds) {
  const std::vector<double> radii = Grading::toyoura().radii(50, 3);
  EXPECT_EQ(cloud(radii, 3, {1, 1, 1}, 3, 1, 5).grains.position, cloud(radii, 3, {1, 1, 1}, 3, 1, 5).grains.position);
  EXPECT_NE(cloud(radii, 3, {1, 1, 1}, 3, 1, 5).grains.position, cloud(radii, 3, {1, 1, 1}, 3, 1, 6).grains.position);
}

TEST(Cloud, RefusesACellTooSmallForItsGrains) {
  EXPECT_THROW(cloud(Grading::toyoura().radii(3, 3), 1, {1, 1, 4}, 3, 1, 0), DataError);
  EXPECT_THROW(cloud(Grading::toyoura().radii(300, 3), 0.5, {1, 1, 1}, 3, 1, 0), DataError);
}

// Returns the share of grains whose nearest grain is within fifty rows.
double share_side_by_side(const io::GrainsRecord& g) {
  double sum = 0;
  for (std::size_t i = 0; i < g.size(); ++i) {
    std::size_t nearest = i == 0 ? 1 : 0;
    double least = support::squared_distance(g.position[nearest], g.position[i]);
    for (std::size_t j = 0; j < g.size(); ++j) {
      const double here = support::squared_distance(g.position[j], g.position[i]);
      if (j != i && here < least) nearest = j, least = here;
    }
    sum += (i < nearest ? nearest - i : i - nearest) <= 50 ? 1 : 0;
  }
  return sum / static_cast<double>(g.size());
}

TEST(SpatialOrder, LaysNeighboursSideBySideAndLosesNoGrain) {
  for (const int d : {2, 3}) {
    // The cloud is in the random order of its making; some grains have left the cell.
    const io::Snapshot made = cloud(Grading::toyoura().radii(2000, d), 3, {1, 1, d == 2 ? 1.0 : 2.0}, d, 2650, 7);
    io::Snapshot random = made;
    for (std::size_t i = 0; i < made.grains.size(); ++i) {
      const auto id = static_cast<std::size_t>(made.grains.body_id[i]);
      random.grains.body_id[id] = made.grains.body_id[i];
      random.grains.position[id] = made.grains.position[i];
      random.grains.radius[id] = made.grains.radius[i];
      random.grains.mass[id] = made.grains.mass[i];
    }
    EXPECT_LT(share_side_by_side(random.grains), 0.1);
    io::Snapshot ordered = random;
    for (std::size_t i = 0; i < 2000; i += 7) ordered.grains.position[i] += made.cell.matrix.col(0);
    const std::vector<Vec3> moved = ordered.grains.position;
    ordered = in_spatial_order(ordered);
    EXPECT_EQ(ordered.grains.body_id, made.grains.body_id);
    EXPECT_GT(share_side_by_side(made.grains), 0.75);
    for (std::size_t i = 0; i < made.grains.size(); ++i) {
      EXPECT_EQ(ordered.grains.position[i], moved[static_cast<std::size_t>(made.grains.body_id[i])]);
      EXPECT_EQ(ordered.grains.radius[i], made.grains.radius[i]);
      EXPECT_EQ(ordered.grains.mass[i], made.grains.mass[i]);
    }
  }
}

TEST(SpatialOrder, CutsAFlatCellIntoChunksAboutAsLongAsWide) {
  const io::Snapshot flat = cloud(Grading::toyoura().radii(8000, 3), 3, {4, 4, 1}, 3, 2650, 7);
  for (std::size_t chunk = 0; chunk < 8; ++chunk) {
    const auto from = flat.grains.position.begin() + static_cast<std::ptrdiff_t>(chunk * dem::grains_per_chunk);
    Vec3 low = *from, high = *from;
    for (auto x = from; x != from + dem::grains_per_chunk; ++x) low = low.cwiseMin(*x), high = high.cwiseMax(*x);
    // Halving the longest side leaves no side above twice another; grains end within half their distance of the cuts.
    EXPECT_LT((high - low).maxCoeff(), 2.2 * (high - low).minCoeff());
  }
}

TEST(SpatialOrder, LeavesWhatACacheHoldsAndRowsThatYarnsName) {
  const io::Snapshot few = cloud(Grading::toyoura().radii(1000, 3), 3, {1, 1, 1}, 3, 2650, 7);
  EXPECT_EQ(in_spatial_order(few).grains.position, few.grains.position);
  io::Snapshot reversed = cloud(Grading::toyoura().radii(1001, 3), 3, {1, 1, 1}, 3, 2650, 7);
  std::reverse(reversed.grains.position.begin(), reversed.grains.position.end());
  EXPECT_NE(in_spatial_order(reversed).grains.position, reversed.grains.position);
  reversed.yarns.nodes.push_back({0, 1});
  EXPECT_EQ(in_spatial_order(reversed).grains.position, reversed.grains.position);
  // Rows before the first one stay, so that yarns may name them.
  const io::Snapshot later = in_spatial_order(reversed, 2);
  EXPECT_NE(later.grains.position, reversed.grains.position);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_EQ(later.grains.position[i], reversed.grains.position[i]);
}

TEST(SpatialOrder, BeginsItsBoxesWhereChunksBegin) {
  io::Snapshot state = cloud(Grading::toyoura().radii(4600, 3), 3, {2, 2, 1}, 3, 2650, 7);
  std::mt19937 engine(5);
  std::shuffle(state.grains.position.begin(), state.grains.position.end(), engine);
  state = in_spatial_order(state, 600);
  for (std::size_t chunk = 1; chunk < 4; ++chunk) {
    Vec3 low = Vec3::Constant(1e9), high = -low;
    for (std::size_t i = chunk * dem::grains_per_chunk; i < (chunk + 1) * dem::grains_per_chunk; ++i)
      low = low.cwiseMin(state.grains.position[i]), high = high.cwiseMax(state.grains.position[i]);
    EXPECT_LT((high - low).prod(), 0.4 * state.cell.matrix.determinant()) << chunk;
  }
}

TEST(SpatialOrder, TakesContactsAlong) {
  const io::Snapshot packed = tile(support::packed(support::sand(), 1e5), {2, 2, 2}, {true, true, true});
  io::Snapshot turned = packed;
  // Reversed rows reverse every contact.
  const std::size_t n = packed.grains.size();
  turned.grains = {};
  turned.grains.dimension = 3;
  for (std::size_t i = n; i-- > 0;) take_grain(turned.grains, packed.grains, i);
  turned.contacts = {};
  for (std::size_t c = 0; c < packed.contacts.size(); ++c) {
    const auto [first, second] = packed.contacts.bodies[c];
    take_contact(turned.contacts, packed.contacts, c, static_cast<std::int32_t>(n) - 1 - first,
                 static_cast<std::int32_t>(n) - 1 - second, packed.contacts.image[c]);
  }
  const io::Snapshot one = in_spatial_order(packed), other = in_spatial_order(turned);
  ASSERT_EQ(one.contacts.size(), packed.contacts.size());
  EXPECT_TRUE(std::is_sorted(one.contacts.bodies.begin(), one.contacts.bodies.end()));
  for (std::size_t c = 0; c < one.contacts.size(); ++c) {
    const auto row = [&](int end) { return static_cast<std::size_t>(one.contacts.bodies[c][end]); };
    const Vec3 branch = one.grains.position[row(1)] - one.grains.position[row(0)] +
                        one.cell.matrix * one.contacts.image[c].cast<double>();
    EXPECT_NEAR((branch - one.contacts.branch_vector[c]).norm(), 0, 1e-12);
  }
  EXPECT_EQ(one.grains.body_id, other.grains.body_id);
  EXPECT_EQ(one.contacts.shear_force, other.contacts.shear_force);
}

}  // namespace
}  // namespace soilweave::packing
