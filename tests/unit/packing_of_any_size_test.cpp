// Defaults of pack-generate for grains of any size. Impossible packings are refused before the first step. A void ratio
// is held at rest, or the message names one that is in reach.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "analysis/doubts/material_doubts.h"
#include "core/error.h"
#include "dem/contact/laws/damping.h"
#include "dem/contact/laws/hertz_mindlin.h"
#include "dem/contact/laws/linear.h"
#include "dem/engine/simulation.h"
#include "dem/state/bodies.h"
#include "dem/sweep/step_bound.h"
#include "packing/generate/ahead.h"
#include "packing/generate/doubtful.h"
#include "support/assemblies.h"
#include "support/clouds.h"
#include "support/messages.h"

namespace soilweave::packing {
namespace {

using support::sparse;
using test::message_of;
using test::number_after;

constexpr double thesis_radius = 2.953e-3;

// Returns the state with all lengths times `factor`, at the same density.
io::Snapshot scaled(io::Snapshot state, double factor) {
  state.cell.matrix *= factor;
  for (Vec3& x : state.grains.position) x *= factor;
  for (double& r : state.grains.radius) r *= factor;
  for (double& m : state.grains.mass) m *= factor * factor * factor;
  return state;
}

dem::Model sand_with_moments(double stiffness) {
  const dem::Resistance moment{stiffness, dem::Resistance::Scale::absolute, {}, dem::Resistance::Arm::mean_radius};
  return {std::vector<dem::HertzMindlin::Material>{{4e9, 0.33, 29 * support::degree, {}, moment, moment}}};
}

TEST(Standard, ThesisGrainsHaveTheThesisStiffnessAndOthersByTheCubeOfTheirSize) {
  for (const std::size_t n : {10, 60, 1000})
    EXPECT_EQ(default_rotational_stiffness(mean_radius(sparse(n))), 0.13) << n << " grains";
  EXPECT_EQ(default_rate(thesis_radius), 1);
  EXPECT_NEAR(default_rotational_stiffness(0.1 * thesis_radius), 0.13e-3, 0.001e-3);
  EXPECT_NEAR(default_rate(0.1 * thesis_radius), 10, 0.01);
  EXPECT_DOUBLE_EQ(default_rotational_stiffness(8e-3), 8 * default_rotational_stiffness(4e-3));
  EXPECT_NE(default_material(thesis_radius).find("stiffness = 0.13\n"), std::string::npos);
  const Contacts contacts(default_material(1e-4), "default");
  EXPECT_EQ(contacts.model.materials.of<dem::HertzMindlin::Material>()[0].twisting.stiffness,
            default_rotational_stiffness(1e-4));
}

// Powers of two scale without rounding, so the smaller soil makes the same packing, bit by bit.
TEST(Standard, ASoilScaledInSizeMakesTheSamePacking) {
  const double factor = 0x1p-5;
  Recipe recipe;
  recipe.pressure = 1e5, recipe.tolerances.unbalanced_force = 1e-2;
  const io::Snapshot large = sparse(60);
  const Result one = compact(large, sand_with_moments(0.13), {}, recipe);
  recipe.max_rate /= factor;
  const Result other = compact(scaled(large, factor), sand_with_moments(0.13 * std::pow(factor, 3)), {}, recipe);
  EXPECT_EQ(one.void_ratio, other.void_ratio);
  EXPECT_EQ(one.cost.steps, other.cost.steps);
  for (std::size_t i = 0; i < 60; ++i)
    EXPECT_EQ(Vec3(factor * one.state.grains.position[i]), other.state.grains.position[i]);
}

// A rolling stiffness that needs no overlap bounds the step of a cloud, so that its grains come to rest.
TEST(StepBound, CountsMomentsOfContactsStillToCome) {
  const io::Snapshot state = sparse(60);
  const dem::Model model = sand_with_moments(130);
  const dem::Bodies bodies(state.grains);
  const dem::Smallest smallest(bodies);
  const dem::StepBound bound = dem::bound_to_come(*dem::make_contact_sweep(model), bodies, smallest);
  EXPECT_DOUBLE_EQ(bound.rotation, std::sqrt(2 * 0.4 * smallest.mass * std::pow(smallest.radius, 2) / 130));
  EXPECT_LT(bound.rotation, 0.1 * bound.translation);
  EXPECT_DOUBLE_EQ(dem::Simulation(state, model, {}).time_step(), 0.8 * bound.rotation);
  const dem::StepBound thesis = dem::bound_to_come(*dem::make_contact_sweep(support::sand()), bodies, smallest);
  EXPECT_GT(thesis.rotation, thesis.translation);  // its packings keep their steps
  Recipe recipe;
  recipe.pressure = 1e5, recipe.tolerances.unbalanced_force = 1e-2;
  EXPECT_NO_THROW(compact(state, sand_with_moments(3), {}, recipe));
}

// A dashpot's damping ratio follows from its restitution in closed form (damping.h), for Hertz times the root of 5/6.
TEST(StepBound, DashpotsLeaveAShareOfIt) {
  const io::Snapshot state = sparse(60);
  const auto step = [&](const dem::Model& model) { return dem::Simulation(state, model, {}).time_step(); };
  for (const double restitution : {0.9, 0.3, 0.02}) {
    const double beta = dem::damping_ratio(restitution, false);
    dem::Model linear = support::linear_sand(), hertz = support::sand();
    const double linear_step = step(linear), hertz_step = step(hertz);
    for (auto& m : linear.materials.of<dem::Linear::Material>()) m.restitution = restitution;
    for (auto& m : hertz.materials.of<dem::HertzMindlin::Material>()) m.restitution = restitution;
    const auto share = [](double xi) { return std::sqrt(1 + xi * xi) - xi; };
    EXPECT_NEAR(step(linear) / linear_step, share(std::sqrt(2.0) * beta), 1e-9) << restitution;
    EXPECT_NEAR(step(hertz) / hertz_step, share(std::sqrt(5.0 / 3.0) * beta), 1e-9) << restitution;
  }
}

TEST(Ahead, ExpectsTheOverlapThatAPackingHas) {
  const io::Snapshot state = support::packed(support::sand(), 1e6, 100);
  double mean = 0;
  for (const double u : state.contacts.overlap) mean += u / static_cast<double>(state.contacts.size());
  const double r = mean_radius(state), expected = expected_overlap(support::sand(), r, 1e6, 3);
  EXPECT_NEAR(mean / r, expected, 0.3 * expected);
  EXPECT_NEAR(pressure_at_overlap(support::sand(), r, expected, 3), 1e6, 1e3);
}

TEST(Ahead, RefusesAPressureThatPushesGrainsThroughEachOtherAndNamesOneThatDoesNot) {
  Recipe recipe;
  recipe.pressure = 1e9, recipe.tolerances.unbalanced_force = 1e-2;
  const std::string said = message_of<DataError>([&] { compact(sparse(60), support::sand(), {}, recipe); });
  recipe.pressure = number_after("lower the pressure to ", said);
  EXPECT_LT(recipe.pressure, 2e8);
  EXPECT_NO_THROW(compact(sparse(60), support::sand(), {}, recipe));
}

TEST(Room, NamesANumberOfGrainsAndASizeThatAreEnough) {
  const Grading wide{{1e-3, 2e-3, 5e-3, 10e-3, 20e-3}, {0, 0.1, 0.3, 0.5, 1}};
  const Room room{wide, 3, {1, 1, 1}, 0.7};
  const std::string said = message_of<DataError>([&] { room.demand(300); });
  const auto grains = static_cast<std::size_t>(number_after("take at least ", said));
  EXPECT_GE(room.diameters(grains), least_diameters) << said;
  EXPECT_LT(room.diameters(grains), 1.3 * chosen_diameters) << said;
  const double coarsest = 1e-3 * number_after("leave out grains coarser than ", said);
  const Room finer{wide.up_to(coarsest), 3, {1, 1, 1}, 0.7};
  EXPECT_NO_THROW(finer.demand(300)) << said;
  EXPECT_EQ(enough_grains(Room{Grading::toyoura(), 3, {1, 1, 2}, 2.5}, 0.68, 1000), 1000u);
  EXPECT_GE(enough_grains(room, 0.7, 300), grains);
}

TEST(Grading, IsCutAtASize) {
  const Grading curve{{1, 2, 4}, {0.2, 0.6, 1}};
  const Grading cut = curve.up_to(3);
  EXPECT_EQ(cut.diameter, (std::vector<double>{1, 2, 3}));
  EXPECT_DOUBLE_EQ(cut.finer[1], 0.75);
  EXPECT_EQ(cut.finer[2], 1);
  EXPECT_EQ(curve.up_to(2).diameter, (std::vector<double>{1, 2}));
  EXPECT_EQ(curve.up_to(9).diameter, curve.diameter);
  EXPECT_THROW(curve.up_to(0.5), DataError);
}

TEST(Doubtful, StiffnessOfAnotherSizeIsDoubtedWithTheOneThatFits) {
  // Returns the first doubt about the stiffness of these grains; "" without one.
  const auto said = [](const dem::Model& model, const io::Snapshot& grains) {
    const std::vector<Doubt> doubts = analysis::stiffness_doubts(grains, model);
    return doubts.empty() ? "" : doubts.front().sentence;
  };
  const io::Snapshot thesis = sparse(100), small = scaled(thesis, 1e-4 / mean_radius(thesis));
  EXPECT_EQ(said(support::sand(), thesis), "");
  EXPECT_EQ(said(support::linear_sand(), small), "");
  const std::string doubt = said(support::sand(), small);
  const double fit = number_after("write ", doubt);
  EXPECT_NEAR(fit, default_rotational_stiffness(1e-4), 0.01 * fit);
  EXPECT_EQ(said(sand_with_moments(fit), small), "");
  EXPECT_NE(said(sand_with_moments(1e6), thesis).find("rolling and twisting stiffness 1e+06 N m/rad"),
            std::string::npos);
  // Nodes do not rotate, so that their stiffness does not matter.
  io::Snapshot nodes = small;
  for (std::int32_t k = 0; k + 1 < 100; ++k) nodes.yarns.nodes.push_back({k, k + 1});
  EXPECT_EQ(said(support::sand(), nodes), "");
}

TEST(Doubtful, AGradingThatBeginsFarAboveNothing) {
  const auto doubt = finest_doubt({{0.1e-3, 0.2e-3, 0.4e-3}, {0.4, 0.7, 1}});
  ASSERT_TRUE(doubt);
  EXPECT_NE(doubt->sentence.find("finer than 0.1 mm, 40 % of the mass, is left out: give the rows"), std::string::npos);
  EXPECT_FALSE(finest_doubt({{0.05e-3, 0.1e-3, 0.4e-3}, {0.1, 0.4, 1}}));
  EXPECT_FALSE(finest_doubt({{0.4e-3}, {1}})) << "one size";
}

TEST(Doubtful, AGradingWhoseSizesNoSoilHas) {
  const auto doubt = size_doubt({{0.1, 0.2, 0.4}, {0, 0.2, 1}});
  ASSERT_TRUE(doubt);
  EXPECT_NE(doubt->sentence.find("is 275 mm, where silt to cobbles have 0.002 to 200 mm"), std::string::npos)
      << doubt->sentence;
  EXPECT_TRUE(size_doubt({{0.14e-6}, {1}})) << "micrometres for millimetres";
  EXPECT_FALSE(size_doubt({{0.0021e-3}, {1}}));
  EXPECT_FALSE(size_doubt({{0.19}, {1}}));
}

TEST(Doubtful, AGradingWhoseCoarseHalfHasNoGrainsIsDoubtedWithTheNumberThatHasThem) {
  const Room wide{{{1e-3, 2e-3, 5e-3, 10e-3, 20e-3, 40e-3}, {0, 0.1, 0.3, 0.5, 0.6, 1}}, 3, {1, 1, 1}, 0.7};
  const auto doubt = grading_doubt(wide, 300);
  ASSERT_TRUE(doubt);
  EXPECT_FALSE(grading_doubt(wide, static_cast<std::size_t>(number_after("take ", doubt->sentence))));
  EXPECT_FALSE(grading_doubt(Room{Grading::toyoura(), 3, {1, 1, 2}, 0.7}, 1000));
}

TEST(Doubtful, RattlersCoordinationAndCellAreSaid) {
  const io::Snapshot small = support::packed(support::sand(), 1e3, 60);
  io::Snapshot loose = small;
  const std::size_t half = small.grains.size();
  loose.cell.matrix.col(2) *= 2;
  for (std::size_t i = 0; i < half; ++i) {
    loose.grains.position.push_back(small.grains.position[i] + small.cell.matrix.col(2));
    loose.grains.radius.push_back(1e-4), loose.grains.mass.push_back(1);
    loose.grains.orientation.push_back(small.grains.orientation[i]);
    loose.grains.velocity.push_back(Vec3::Zero()), loose.grains.angular_velocity.push_back(Vec3::Zero());
    loose.grains.material_id.push_back(0), loose.grains.copy_id.push_back(0);
    loose.grains.body_id.push_back(static_cast<std::int64_t>(half + i));
  }
  std::string keys;
  const Contacts contacts(default_material(mean_radius(loose)), "default material");
  for (const Doubt& doubt : doubts_about(loose, contacts, std::nullopt)) keys += doubt.key + " ";
  EXPECT_EQ(keys.find("rattlers coordination cell "), 0u) << keys;
  EXPECT_EQ(keys.find("tolerance"), std::string::npos) << keys;
  for (const Doubt& doubt : doubts_about(loose, contacts, std::nullopt, 0.5)) keys += doubt.key + " ";
  EXPECT_NE(keys.find("tolerance"), std::string::npos) << "an unbalanced force of a half is no rest";
}

}  // namespace
}  // namespace soilweave::packing
