// Fabric of ensembles drawn from known distributions, coordination of lattices and chains, roses, force chains.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/fabric.h"

#include <gtest/gtest.h>

#include <numbers>

#include "analysis/measure/fabric_doubts.h"
#include "analysis/measure/stress.h"
#include "analysis/tables/bag.h"
#include "support/assembly.h"

namespace soilweave::analysis {
namespace {

constexpr double pi = std::numbers::pi;

// Anisotropy tensors of an ensemble: contact density 1 + a_c : nn, normal force 1 + a_n : nn, shear force a_t . n minus
// its normal part (Rothenburg & Bathurst 1989).
struct Anisotropy {
  Mat3 normals = Mat3::Zero(), normal_force = Mat3::Zero(), tangential_force = Mat3::Zero();
};

Mat3 axial(double a, int dimension = 3) {
  return dimension == 3 ? Mat3(a * Vec3(-1. / 3, -1. / 3, 2. / 3).asDiagonal()) : Mat3(a * Vec3(-1, 1, 0).asDiagonal());
}

// Returns an ensemble of evenly spread directions (golden spiral, or even angles). A direction enters as often as the
// density asks; the remainder carries over to the next, so that sampling errors fall as 1/count and not as its root.
io::Snapshot ensemble(const Anisotropy& a, int dimension, int count) {
  io::Snapshot s;
  s.grains.dimension = dimension;
  s.cell.matrix = 10 * Mat3::Identity();
  test::add_grain(s, Vec3::Zero(), 1);
  test::add_grain(s, Vec3::Ones(), 1);
  double owed = 0;
  for (int k = 0; k < count; ++k) {
    const double height = 1 - (2 * k + 1.0) / count, turn = k * pi * (3 - std::sqrt(5.0));
    const double width = std::sqrt(1 - height * height), angle = 2 * pi * (k + 0.5) / count;
    const Vec3 n = dimension == 3 ? Vec3(width * std::cos(turn), width * std::sin(turn), height)
                                  : Vec3(std::cos(angle), std::sin(angle), 0);
    owed += 10 * (1 + n.dot(a.normals * n));
    const Vec3 shear = a.tangential_force * n - n.dot(a.tangential_force * n) * n;
    for (; owed >= 1; owed -= 1) test::add_direction(s, n, 100 * (1 + n.dot(a.normal_force * n)), 100 * shear);
  }
  return s;
}

TEST(Fabric, OfEvenDirectionsIsIsotropic) {
  for (const int d : {2, 3}) {
    const Fabric f = fabric(ensemble({}, d, 2000));
    EXPECT_NEAR(f.normals.trace(), 1, 1e-12);
    EXPECT_LT(f.a_normals.norm() + f.a_normal_force.norm() + f.a_tangential_force.norm(), 1e-3);
    EXPECT_NEAR(f.mean_normal_force, 100, 1e-9);
  }
}

TEST(Fabric, RecoversTheAnisotropyOfAnEnsemble) {
  for (const int d : {2, 3}) {
    const Anisotropy a = {axial(0.3, d), axial(0.5, d), axial(0.2, d)};
    const Fabric f = fabric(ensemble(a, d, 4000));
    EXPECT_LT((f.a_normals - a.normals).norm(), 5e-3);
    EXPECT_LT((f.a_normal_force - a.normal_force).norm(), 5e-3);
    EXPECT_LT((f.a_tangential_force - a.tangential_force).norm(), 5e-3);
    EXPECT_NEAR(f.mean_normal_force, 100, 0.1);
    EXPECT_NEAR(f.a_c, 0.3, 5e-3);
    EXPECT_NEAR(f.a_n, 0.5, 5e-3);
    EXPECT_NEAR(f.a_t, 0.2, 5e-3);
  }
}

TEST(Fabric, AnisotropyAcrossTheMainStressIsNegative) {
  // Contacts are mostly horizontal while forces are vertical.
  const Fabric f = fabric(ensemble({axial(-0.3), axial(0.9), axial(0.2)}, 3, 4000));
  EXPECT_NEAR(f.a_c, -0.3, 2e-3);
  EXPECT_NEAR(f.a_n, 0.9, 2e-3);
}

TEST(Fabric, GivesTheStressRatio) {
  // The relation drops products of anisotropies, which are of the order 0.05^2 here (3 % of q/p).
  for (const int d : {2, 3}) {
    const io::Snapshot s = ensemble({axial(0.04, d), axial(0.05, d), axial(0.03, d)}, d, 4000);
    const StressForceFabric r = stress_force_fabric(s, fabric(s));
    EXPECT_NEAR(r.fabric, d == 3 ? 0.4 * (0.04 + 0.05 + 0.045) : 0.5 * (0.04 + 0.05 + 0.03), 1e-3);
    EXPECT_NEAR(r.stress / r.fabric, 1, 0.03);
  }
}

TEST(Fabric, TurnsWithTheAssembly) {
  const io::Snapshot s = ensemble({axial(0.3), axial(0.5), axial(0.2)}, 3, 300);
  io::Snapshot turned = s;
  const Mat3 q = Eigen::AngleAxisd(0.7, Vec3(1, 2, -1).normalized()).toRotationMatrix();
  for (Vec3& v : turned.contacts.normal) v = q * v;
  for (Vec3& v : turned.contacts.branch_vector) v = q * v;
  for (Vec3& v : turned.contacts.shear_force) v = q * v;
  const Fabric one = fabric(s), other = fabric(turned);
  EXPECT_LT((other.normals - q * one.normals * q.transpose()).norm(), 1e-12);
  EXPECT_LT((other.a_tangential_force - q * one.a_tangential_force * q.transpose()).norm(), 1e-12);
  EXPECT_NEAR(other.a_n, one.a_n, 1e-12);
}

TEST(Fabric, OfNoContactsIsNotANumber) {
  io::Snapshot s;
  test::add_grain(s, Vec3::Zero(), 0.1);
  EXPECT_TRUE(std::isnan(fabric(s).a_c));
  EXPECT_TRUE(std::isnan(stress_force_fabric(s, fabric(s)).stress));
  EXPECT_EQ(coordination(s).all, 0);
  EXPECT_EQ(coordination(s).rattlers, 1U);
  EXPECT_EQ(force_chains(s).count, 0U);
  for (const double density : polar_rose(s, 9).density) EXPECT_TRUE(std::isnan(density));
}

// Returns four spheres per cubic cell of side sqrt 2, each touching twelve.
io::Snapshot face_centred(int n) {
  io::Snapshot s;
  const double side = std::sqrt(2.0);
  s.cell.matrix = n * side * Mat3::Identity();
  const std::vector<Vec3> basis = {{0, 0, 0}, {0, .5, .5}, {.5, 0, .5}, {.5, .5, 0}};
  for (int c = 0; c < n * n * n; ++c)
    for (const Vec3& b : basis) test::add_grain(s, side * (Vec3i(c % n, c / n % n, c / n / n).cast<double>() + b), 0.5);
  for (std::size_t i = 0; i < s.grains.size(); ++i)
    for (std::size_t j = i + 1; j < s.grains.size(); ++j) {
      const Vec3 apart = (s.grains.position[i] - s.grains.position[j]) / (n * side);
      const Vec3i image = apart.array().round().cast<int>();
      if ((apart - image.cast<double>()).norm() * n * side < 1.001)
        test::add_contact(s, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), image, 1);
    }
  return s;
}

TEST(Coordination, OfLattices) {
  const Coordination face = coordination(face_centred(3));
  EXPECT_EQ(face.all, 12);
  EXPECT_EQ(face.mechanical, 12);
  EXPECT_EQ(face.backbone, 12);
  EXPECT_EQ(face.histogram[12], 108U);
  EXPECT_EQ(coordination(test::simple_cubic(3, Vec3::Ones())).all, 6);
  EXPECT_EQ(coordination(test::simple_cubic(3, Vec3::Ones(), 2)).all, 4);
}

TEST(Coordination, LeavesOutRattlersAgainAndAgain) {
  // A face-centred block gets a chain of three hanging on one grain (1, 2, 2 contacts), and a grain alone.
  io::Snapshot s = face_centred(3);
  for (int k = 0; k < 4; ++k) test::add_grain(s, Vec3(10 + k, 0, 0), 0.5);
  for (int k = 0; k < 3; ++k) test::add_contact(s, k == 0 ? 0 : 107 + k, 108 + k, Vec3i::Zero(), 1);
  const Coordination z = coordination(s);
  const double ends = 108 * 12 + 6;
  EXPECT_DOUBLE_EQ(z.all, ends / 112);
  EXPECT_DOUBLE_EQ(z.mechanical, (ends - 1) / (112 - 1 - 1));
  EXPECT_EQ(z.rattlers, 4U);
  EXPECT_EQ(z.backbone, 12);
}

TEST(Coordination, CountsAPlaneOnce) {
  io::Snapshot s;
  test::add_grain(s, Vec3::Zero(), 1);
  test::add_direction(s, Vec3(0, 0, -1), 1, Vec3::Zero());
  s.contacts.bodies[0] = {0, -1};
  EXPECT_EQ(coordination(s).all, 1);
}

TEST(Coordination, NodesOfAGeotextileHoldGrainsButAreNone) {
  // Grain 0 lies on both nodes and on grain 1, which touches nothing else.
  io::Snapshot s;
  for (int k = 0; k < 4; ++k) test::add_grain(s, Vec3(k, 0, 0), 1);
  s.yarns = {{{2, 3}}, {0}, {0}, {0}, {5e-3}, {0.01}, {1.5}, {0}, {0}, {Vec3::Zero()}};
  for (const std::int32_t other : {1, 2, 3}) test::add_contact(s, 0, other, Vec3i::Zero(), 1);
  const Coordination z = coordination(s);
  EXPECT_EQ(z.all, 2);
  EXPECT_EQ(z.histogram, (std::vector<std::size_t>{0, 1, 0, 1}));
  EXPECT_EQ(z.rattlers, 1U);
  EXPECT_EQ(z.backbone, 2) << "on the two nodes";
  EXPECT_EQ(coordination(soil_contacts(s, true)).histogram, (std::vector<std::size_t>{0, 2}));
}

TEST(Rose, OfEvenDirectionsIsOneEverywhere) {
  const io::Snapshot s = ensemble({}, 3, 20000);
  for (const double density : polar_rose(s, 9).density) EXPECT_NEAR(density, 1, 0.01);
  for (const double density : plane_rose(s, 0, 2, 36).density) EXPECT_NEAR(density, 1, 0.03);
}

TEST(Rose, FollowsTheDensityOfAnEnsemble) {
  const io::Snapshot s = ensemble({axial(0.6), axial(0.5), Mat3::Zero()}, 3, 20000);
  const Rose polar = polar_rose(s, 9);
  for (std::size_t k = 0; k < 9; ++k) {
    // The mean over a class of 1 + a (cos^2 - 1/3) has a closed integral over the sphere.
    const double low = std::cos(polar.angle[k] + pi / 36), high = std::cos(polar.angle[k] - pi / 36);
    EXPECT_NEAR(polar.density[k], 1 + 0.6 * ((high * high + high * low + low * low) / 3 - 1. / 3), 0.01);
  }
  EXPECT_GT(polar.normal_force[0], polar.normal_force[8]);
  // Within 45 deg of the plane, the mean of cos^2 of the distance from it is 5/6; sin^2 of the angle in the plane is
  // integrated over the class.
  const Rose plane = plane_rose(s, 0, 2, 8);
  ASSERT_EQ(plane.angle.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    const double square = 0.5 - std::cos(2 * plane.angle[k]) * std::sin(pi / 4) / (pi / 2);
    EXPECT_NEAR(plane.density[k], (1 + 0.6 * (5. / 6 * square - 1. / 3)) / (1 + 0.6 * (5. / 12 - 1. / 3)), 0.01);
  }
  const Rose disks = plane_rose(ensemble({axial(0.6, 2), Mat3::Zero(), Mat3::Zero()}, 2, 20000), 0, 1, 36);
  for (std::size_t k = 0; k < 36; ++k) EXPECT_NEAR(disks.density[k], 1 - 0.6 * std::cos(2 * disks.angle[k]), 0.01);
}

TEST(Rose, ClassesWithoutContactsHaveNoForceAndAreTold) {
  io::Snapshot s = ensemble({}, 3, 60);
  const auto said = [&](std::size_t classes) {
    const std::vector<Doubt> doubts = rose_doubts(s, classes);
    return doubts.empty() ? "" : doubts.front().sentence;
  };
  EXPECT_EQ(said(8), "");
  EXPECT_NE(said(360).find(" classes of the rose hold no contact, and have no mean force (nan); give --classes "),
            std::string::npos);
  for (const double force : plane_rose(s, 0, 1, 360).normal_force)
    EXPECT_FALSE(std::signbit(force) && std::isnan(force));
  s.contacts = {};
  EXPECT_NE(said(8).find("no contacts, and so no fabric"), std::string::npos);
  EXPECT_EQ(fabric_doubts(s).size(), 1U);
  EXPECT_TRUE(std::isnan(plane_rose(s, 0, 1, 8).density[0]) && std::isnan(polar_rose(s, 8).density[0]));
  EXPECT_TRUE(std::isnan(force_chains(s).mean_length) && std::isnan(coordination(s).backbone));
}

TEST(ContactDoubts, AreOfGrainsThatOverlapWithoutContacts) {
  io::Snapshot s = ensemble({}, 3, 60);
  EXPECT_TRUE(contact_doubts(s).empty());
  s.contacts = {};
  s.cell = {};
  s.cell.matrix = 10 * Mat3::Identity(), s.cell.periodic = {false, false, false};
  for (std::size_t i = 0; i < s.grains.size(); ++i)
    s.grains.position[i] = Vec3(static_cast<double>(i), 0, 0), s.grains.radius[i] = 0.5;
  EXPECT_TRUE(contact_doubts(s).empty()) << "grains that only touch";
  EXPECT_NE(fabric_doubts(s).at(0).sentence.find("give a state under load"), std::string::npos);
  s.grains.position[1].x() = 0.75;
  ASSERT_EQ(contact_doubts(s).size(), 1U);
  EXPECT_NE(
      contact_doubts(s)[0].sentence.find("1 pairs of grains overlap, and the stress and coordination number count "
                                         "none of them (0): the file keeps no contacts"),
      std::string::npos)
      << contact_doubts(s)[0].sentence;
  EXPECT_NE(fabric_doubts(s).at(0).sentence.find("give a state of run-dem"), std::string::npos);
  s.yarns.nodes = {{0, 1}}, s.yarns.fabric = {0};
  EXPECT_TRUE(contact_doubts(s).empty()) << "nodes of one fabric";
}

TEST(ForceChains, FollowStrongContactsInLine) {
  // Each of two loaded columns of four grains, with weak contacts in between, is a chain.
  io::Snapshot s;
  s.cell.matrix = 20 * Mat3::Identity();
  for (int column = 0; column < 2; ++column)
    for (int k = 0; k < 4; ++k) test::add_grain(s, Vec3(column, 0, k), 0.5);
  for (int k = 0; k < 3; ++k) test::add_contact(s, k, k + 1, Vec3i::Zero(), 10);
  for (int k = 0; k < 4; ++k) test::add_contact(s, k, k + 4, Vec3i::Zero(), 1);
  for (int k = 4; k < 7; ++k) test::add_contact(s, k, k + 1, Vec3i::Zero(), 12);
  const ForceChains chains = force_chains(s);
  EXPECT_EQ(chains.count, 2U);
  EXPECT_EQ(chains.mean_length, 4);
  EXPECT_EQ(chains.grains_in_chains, 1);
  EXPECT_EQ(chains.chain, (std::vector<std::int32_t>{0, 0, 0, -1, -1, -1, -1, 1, 1, 1}));
}

TEST(ForceChains, EndWhereTheForceTurns) {
  // The top grain of a column of three pushes harder sideways, so its own axis is horizontal.
  io::Snapshot s;
  s.cell.matrix = 20 * Mat3::Identity();
  for (int k = 0; k < 3; ++k) test::add_grain(s, Vec3(0, 0, k), 0.5);
  for (int k = 0; k < 2; ++k) test::add_grain(s, Vec3(k == 0 ? 1 : -1, 0, 2), 0.5);
  test::add_contact(s, 0, 1, Vec3i::Zero(), 30);
  test::add_contact(s, 1, 2, Vec3i::Zero(), 30);
  test::add_contact(s, 2, 3, Vec3i::Zero(), 40);
  test::add_contact(s, 2, 4, Vec3i::Zero(), 40);
  for (const int k : {0, 1})
    for (const int side : {3, 4}) test::add_contact(s, k, side, Vec3i::Zero(), 1);
  const ForceChains chains = force_chains(s);
  EXPECT_EQ(chains.count, 1U);
  EXPECT_EQ(chains.chain, (std::vector<std::int32_t>{-1, -1, 0, 0, -1, -1, -1, -1}));
}

TEST(BrokenYarns, AreToldInTheOrderTheyBroke) {
  io::Snapshot s;
  io::YarnsRecord& y = s.yarns;
  y.nodes.resize(4);
  y.family = {0, 1, 2, 0}, y.broken = {1, 1, 0, 1}, y.break_time = {3, 1, 0, 2};
  y.break_position.assign(4, Vec3::Zero());
  io::Series table;
  put_broken(table, s);
  EXPECT_EQ(table.at("yarn").values, (std::vector<double>{1, 3, 0}));
  EXPECT_EQ(table.at("break_time").values, (std::vector<double>{1, 2, 3}));
}

}  // namespace
}  // namespace soilweave::analysis
