// Sweep over pairs of grains and planes.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <bit>
#include <functional>
#include <utility>
#include <vector>

#include "core/in_parallel.h"
#include "dem/contact/contact_action.h"
#include "dem/contact/material_pairs.h"
#include "dem/contact/transport.h"
#include "dem/sweep/plane_lanes.h"

namespace soilweave::dem {

/// Sweep over pairs with planes for one law.
template <class Law, class T>
class PlaneSweep {
 public:
  explicit PlaneSweep(const MaterialPairs<Law>& material_pairs)
      : material_pairs_(material_pairs), moments_(material_pairs.use_moments()) {}

  /// Updates the contacts over a step dt and sets their loads.
  /// Sets their stiffness too if `affine_stiffness` is given (ContactSweep).
  SweepSums run(const Scene& scene, double dt, Contacts& contacts, Lane4* affine_stiffness) {
    over(scene, contacts, sums_, [&](const PlaneLanes<T>& lanes, PlaneSums<T>& sums) {
      act(lanes, dt, scene.bodies.loads, sums);
      if (affine_stiffness) stiffen(lanes, scene.bodies.stiffness, sums.step.affine_stiffness);
    });
    SweepSums total;
    for (const PlaneSums<T>& s : sums_) {
      s.put_into(total);
      if (affine_stiffness) *affine_stiffness += s.step.affine_stiffness;
    }
    return total;
  }

  /// Sets the stiffness of the pairs and returns the affine one (ContactSweep).
  Lane4 stiffen(const Scene& scene, Contacts& contacts) {
    return total(scene, contacts,
                 [&](const PlaneLanes<T>& lanes, Lane4& sum) { stiffen(lanes, scene.bodies.stiffness, sum); });
  }

  /// Returns normal, shear, rolling and twisting energy, J.
  Lane4 stored(const Scene& scene, Contacts& contacts) {
    return total(scene, contacts, [this](const PlaneLanes<T>& lanes, Lane4& sum) {
      const PairGeometry<T> g = lanes.geometry(0, range(lanes));
      const ContactEnergies<T> b = at_rest(lanes, g, lanes.template history<Law>(g.touching, std::identity())).second;
      add_to(sum, b.elastic_normal, b.elastic_shear, b.elastic_rolling, b.elastic_twisting);
    });
  }

 private:
  using Own = OwnFields<Law>;

  template <class Sum, class Use>
  static void over(const Scene& scene, Contacts& contacts, std::vector<Sum>& sums, const Use& use) {
    LargeVector<PlaneBlock>& blocks = contacts.planes.blocks();
    const std::vector<std::size_t>& groups = contacts.planes.groups();
    sums.assign(groups.size() - 1, Sum{});
    if (blocks.empty()) return;
    in_parallel(sums.size(), contacts.threads, [&](std::size_t group) {
      for (std::size_t b = groups[group]; b < groups[group + 1]; ++b)
        for (std::size_t k = 0; k < blocks[b].pairs.count; k += width<T>)
          use(PlaneLanes<T>(scene, blocks[b], k, contacts.planes.own(b) + k), sums[group]);
    });
  }
  template <class Use>
  Lane4 total(const Scene& scene, Contacts& contacts, const Use& use) {
    over(scene, contacts, row_sums_, use);
    Lane4 sum{};
    for (const Lane4& s : row_sums_) sum += s;
    return sum;
  }

  void act(const PlaneLanes<T>& lanes, double dt, LargeVector<Load>& loads, PlaneSums<T>& sums) const {
    const PairGeometry<T> g = lanes.geometry(dt, range(lanes));
    const Kinematics<T>& k = g.kinematics;
    const unsigned touching = bits(g.touching);
    if (!(touching | lanes.pairs.touching())) return;
    const V3<T> old_shear = masked(g.touching, lanes.pairs.template shear<Spatial>());
    const V3<T> force_before = fused(lanes.pairs.normal_force(), k.normal, old_shear);
    const HistoryOf<Law, T> before = lanes.template history<Law>(g.touching, Rotation<T>(g.turn));
    HistoryOf<Law, T> history = before;
    ContactEnergies<T> energies;
    const Response<T> response = Law::respond(mixed(lanes), k, broadcast<T>(dt), history, energies);
    // The first sweep leaves the history as it is (ContactSweep).
    if (dt == 0) history = before;
    lanes.pairs.remember_shear(history.shear);
    lanes.pairs.template remember_moments<Spatial>(history);
    Own::template write<T, Spatial>(history, lanes.own);
    lanes.pairs.remember_normal_force(response.normal_force);
    lanes.pairs.set_masks(touching, touching & bits(response.sliding));

    const Action<T> act = action<T, Spatial>(k.normal, k.r1, T{}, history, response.normal_force);
    lanes.put(-act.force, -act.torque_first, loads);
    add_to(sums.step.work, work_of<T, Spatial>(g, before, history, moments_, energies));
    sums.step.overlap = maximum(sums.step.overlap, k.overlap);
    sums.step.contacts += std::popcount(touching);
    // Beside F (x) x of the grain, f (x) l has a part of the plane: its force at the foot of the perpendicular.
    const V3<T> moved = T(broadcast<T>(dt)) * lanes.in_lanes(lanes.plane.velocity);
    sums.add(act.force, masked(g.touching, dot(force_before + act.force, moved)), lanes.foot(k));
  }

  void stiffen(const PlaneLanes<T>& lanes, LargeVector<Load>& stiffness, Lane4& sum) const {
    const PairGeometry<T> g = lanes.geometry(0, range(lanes));
    if (!any(g.touching)) return;
    const Kinematics<T>& k = g.kinematics;
    const Response<T> r = at_rest(lanes, g, without_forces(lanes, g)).first;
    add_to(sum, masked(g.touching, affine_stiffness(k.normal, T(k.r1 - k.overlap), r)));
    const auto [translation, rotation] = axis_stiffness(k.normal, r, k.r1);
    lanes.put(masked(g.touching, translation), masked(g.touching, rotation), stiffness);
  }

  std::pair<Response<T>, ContactEnergies<T>> at_rest(const PlaneLanes<T>& lanes, const PairGeometry<T>& g,
                                                     HistoryOf<Law, T> history) const {
    Kinematics<T> k = g.kinematics;
    k.approach_speed = T{};
    ContactEnergies<T> energies;
    const Response<T> r = Law::respond(mixed(lanes), k, T{}, history, energies);
    return {r, energies};
  }

  /// Returns a history of the law's own fields alone.
  static HistoryOf<Law, T> without_forces(const PlaneLanes<T>& lanes, const PairGeometry<T>& g) {
    HistoryOf<Law, T> history{};
    Own::template read<T, Spatial>(lanes.own, g.touching, std::identity(), history);
    return history;
  }
  double range(const PlaneLanes<T>& lanes) const {
    if constexpr (ActsAcrossGaps<Law>) return Law::range(mixed(lanes));
    return 0;
  }
  const typename Law::MaterialPair& mixed(const PlaneLanes<T>& lanes) const {
    return material_pairs_.of(lanes.material_of_grains(), lanes.plane.material);
  }

  const MaterialPairs<Law>& material_pairs_;
  bool moments_;
  std::vector<PlaneSums<T>> sums_;
  std::vector<Lane4> row_sums_;
};

}  // namespace soilweave::dem
