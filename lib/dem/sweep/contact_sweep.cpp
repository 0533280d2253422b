// One sweep over all candidate pairs, a vector register of contacts at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums over contacts are made contact by contact within a chunk of grains, and the chunks are summed in order. Every
// bit is independent of the width of the register, of pairs that do not touch, and of the number of threads.
//
// A contact is a long chain of dependent operations, square roots and divisions among them. So the sweep takes a batch
// of registers through one stage after the other: where the pairs lie (approach), how they move (move), what the law
// answers (answer), and what that does to the grains (act). Within a stage the processor works on several registers at
// once, and a batch stays in its L1 cache. Forces are added at once to the loads of the grains, in the order of the
// pairs. If the second grain is in another chunk, on which another thread may work, the pair has a load of its own
// (contacts.h). Disks go through the same stages with the vectors and rotations of the plane (space.h).
//
// This file is compiled once per width (vector_width.cpp). Bits do not depend on the width, because the order of
// operations on every contact is the same.
//
// No old normal is kept: the rotation of a pair follows from its velocity (transport.h).
//
// The stress needs no product of force and branch per contact. The sum of f (x) l equals the sum of F (x) x over the
// grains, F being their resultants (motion.h), plus f (x) cell offset over the pairs across the cell's faces.
#include "dem/sweep/contact_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "dem/contact/law_list.h"
#include "dem/contact/material_pairs.h"
#include "dem/contact/transport.h"
#include "dem/sweep/grain_sums.h"
#include "dem/sweep/memory_ahead.h"
#include "dem/sweep/own_history.h"
#include "dem/sweep/plane_sweep.h"
#include "dem/sweep/sweep_groups.h"

namespace soilweave::dem {
namespace {

constexpr auto nothing = [](std::size_t) {};

template <class Law>
class LawSweep final : public ContactSweep {
 public:
  explicit LawSweep(const std::vector<typename Law::Material>& materials)
      : material_pairs_(materials),
        planes_(material_pairs_),
        use_masses_(material_pairs_.use_masses()),
        use_moments_(material_pairs_.use_moments()) {}

  SweepSums run(const Scene& scene, double dt, Contacts& contacts, AroundChunk& around,
                Vec3* affine_stiffness) override {
    const Cell& cell = scene.cell;
    set_shifts(cell, contacts);
    across_.assign(chunks_of(scene.bodies.size()) * shifts_.size(), Lane4{});
    const AffineMotion affine(cell.velocity_gradient(), cell.deforming(), dt);
    if (!use_moments_ && dt > 0) let_moments_go(contacts);
    Lane4 stiffness{};
    // Planes come first, because the sweep over grains collects the loads of each chunk.
    SweepSums total = planes_.run(scene, dt, contacts, affine_stiffness ? &stiffness : nullptr);
    scene.bodies.dimension == 2 ? step<Planar>(scene, affine, dt, affine_stiffness != nullptr, contacts, around)
                                : step<Spatial>(scene, affine, dt, affine_stiffness != nullptr, contacts, around);
    for (const StepSums<Lanes>& s : step_sums_) s.put_into(total);
    total.force_branch += force_branch_across();
    if (affine_stiffness) {
      for (const StepSums<Lanes>& s : step_sums_) stiffness += s.affine_stiffness;
      *affine_stiffness = vector_of(stiffness);
    }
    return total;
  }

  Vec3 stiffen(const Scene& scene, Contacts& contacts) override {
    set_shifts(scene.cell, contacts);
    scene.bodies.dimension == 2 ? look<Planar>(scene, contacts) : look<Spatial>(scene, contacts);
    Lane4 total = planes_.stiffen(scene, contacts);
    for (const Lane4& sum : row_sums_) total += sum;
    return vector_of(total);
  }

  StoredEnergies stored(const Scene& scene, Contacts& contacts) override {
    set_shifts(scene.cell, contacts);
    sweep<Spatial, false>(
        scene, AffineMotion(Mat3::Zero(), false, 0), 0, contacts, row_sums_, nothing, nothing,
        [this](Batch<Lanes, Spatial> batch, const Surroundings& s, Lane4& sum) { store_up(batch, s, sum); });
    Lane4 total = planes_.stored(scene, contacts);
    for (const Lane4& sum : row_sums_) total += sum;
    return {total[0], total[1], total[2], total[3]};
  }

  PairStiffness stiffness(double radius, double overlap, std::int32_t materials, int dimension) const override {
    PairStiffness largest;
    for (const auto& mixed : material_pairs_.of_first(materials)) {
      const Response<double> r = of_equal_grains(mixed, radius, overlap);
      largest.normal = std::max(largest.normal, r.normal_stiffness);
      // At this speed a critical dashpot bears twice what the spring bears.
      const double speed = overlap * std::sqrt(2 * r.normal_stiffness), twice = 2 * r.normal_stiffness * overlap;
      const double of_dashpot = of_equal_grains(mixed, radius, overlap, speed).normal_force - r.normal_force;
      if (twice > 0) largest.damping_ratio = std::max(largest.damping_ratio, of_dashpot / twice);
      largest.rotational =
          std::max({largest.rotational, r.rolling_stiffness, dimension == 3 ? r.twisting_stiffness : 0});
    }
    return largest;
  }

  double normal_force(double radius, double overlap) const override {
    return of_equal_grains(material_pairs_.of(0, 0), radius, overlap).normal_force;
  }
  double range() const override { return material_pairs_.range(); }
  std::span<const HistoryField> own_history() const override { return history_fields<Law>(); }

 private:
  // Returns the response of two equal grains of 1 kg that meet for the first time, at rest or approaching, m/s.
  static Response<double> of_equal_grains(const typename Law::MaterialPair& mixed, double radius, double overlap,
                                          double speed = 0) {
    Kinematics<double> k{};
    k.normal = {1, 0, 0};
    k.overlap = overlap, k.r1 = k.r2 = radius, k.R_star = radius / 2, k.per_reach = 0.5 / radius, k.m1 = k.m2 = 1;
    k.approach_speed = speed;
    HistoryOf<Law, double> history{};
    ContactEnergies<double> energies;
    return Law::respond(mixed, k, 0.0, history, energies);
  }

  void set_shifts(const Cell& cell, const Contacts& contacts) {
    shifts_.clear();
    for (const CellOffset image : contacts.images) shifts_.push_back(row(shift_of(image, cell.matrix()), 0));
  }

  // Removes the moments that a state from another law may have. Sweeps without moments ignore them, so they would stay
  // in contacts and files for ever.
  void let_moments_go(Contacts& contacts) {
    if (std::exchange(moments_gone_, true)) return;
    for (auto& chunk : contacts.chunks)
      for (ContactBlock& block : chunk)
        for (std::size_t k = 0; k < ContactBlock::size; k += width<Lanes>) BlockLanes<Lanes>(block, k).forget_moments();
  }

  template <class Space>
  void step(const Scene& scene, const AffineMotion& affine, double dt, bool with_stiffness, Contacts& contacts,
            AroundChunk& around) {
    const auto through = [=, this](Batch<Lanes, Space> batch, const Surroundings& s, StepSums<Lanes>& sums) {
      move<Space>(batch, s.dt);
      if (use_moments_)
        answer<Space, true>(batch, s, sums), act<Space, true>(batch, s, sums.work);
      else
        answer<Space, false>(batch, s, sums), act<Space, false>(batch, s, sums.work);
      if (with_stiffness) stiffen<Space>(batch, s, sums.affine_stiffness);
    };
    sweep<Space, true>(
        scene, affine, dt, contacts, step_sums_, [&around](std::size_t chunk) { around.before(chunk); },
        [&around](std::size_t chunk) { around.after(chunk); }, through);
  }

  template <class Space>
  void look(const Scene& scene, Contacts& contacts) {
    sweep<Space, false>(
        scene, AffineMotion(Mat3::Zero(), false, 0), 0, contacts, row_sums_, nothing, nothing,
        [this](Batch<Lanes, Space> batch, const Surroundings& s, Lane4& sum) { stiffen<Space>(batch, s, sum); });
  }

  // Passes the pairs that touch, or touched in the last step, through `stage`, chunk by chunk and batch by batch.
  template <class Space, bool moving, class Sums, class Before, class After, class Stage>
  void sweep(const Scene& scene, const AffineMotion& affine, double dt, Contacts& contacts, std::vector<Sums>& sums,
             const Before& before, const After& after, const Stage& stage) {
    sums.assign(contacts.chunks.size(), Sums{});
    const auto one = [&](std::size_t chunk) {
      const Surroundings s{scene.bodies,
                           shifts_,
                           affine,
                           dt,
                           contacts.chunks.size() == 1,
                           reinterpret_cast<double*>(scene.bodies.loads.data()),
                           reinterpret_cast<double*>(scene.bodies.stiffness.data()),
                           reinterpret_cast<double*>(across_.data() + chunk * shifts_.size()),
                           contacts.chunks[chunk].data(),
                           contacts.own[chunk].data()};
      std::array<Group<Lanes, Space>, batch_size> groups;
      ContactBlock* next = contacts.chunks[chunk].data();
      ContactBlock* const end = next + contacts.chunks[chunk].size();
      while (next != end) {
        const std::size_t n = approach<Space, moving>(next, end, s, groups);
        if (n) stage(Batch<Lanes, Space>(groups.data(), n), s, sums[chunk]);
      }
    };
    contacts.plan.run(before, one, after);
  }

  // Returns the relative position of a block's lanes, within the range of a law that acts across gaps.
  template <class Space>
  [[gnu::always_inline]] RelativePosition<Lanes, Space> position_in_reach(const PairRows<Lanes, Space>& rows,
                                                                          const ContactBlock& block,
                                                                          const Surroundings& s) const {
    if constexpr (ActsAcrossGaps<Law>)
      return relative_position<Lanes, Space>(rows.branch, rows.radius_1, rows.radius_2,
                                             broadcast<Lanes>(Law::range(material_pairs_.of(block, s.bodies))));
    else
      return relative_position<Lanes, Space>(rows.branch, rows.radius_1, rows.radius_2);
  }

  // Fills the batch from `next` on, which becomes the first unvisited block. Returns the number of filled groups.
  // Results are held as values and stored at the end, because after every store the compiler reads references again.
  template <class Space, bool moving>
  [[gnu::noinline, gnu::flatten]] std::size_t approach(ContactBlock*& next, ContactBlock* end, const Surroundings& s,
                                                       std::array<Group<Lanes, Space>, batch_size>& groups) const {
    constexpr std::size_t per_block = ContactBlock::size / width<Lanes>;
    const std::byte* const grains = s.grains();
    const double* const loads = s.loads;
    const Lane4* const shifts = s.shifts.data();
    const bool deforming = moving && s.affine.deforming, use_masses = use_masses_;
    Group<Lanes, Space>* group = groups.data();
    ContactBlock* block = next;
    for (; block != end && group + per_block <= groups.data() + batch_size; ++block) {
      if (!s.in_cache) call_for(block, end, grains, loads);
      for (std::size_t k = 0; k < ContactBlock::size; k += width<Lanes>) {
        const BlockLanes<Lanes> lanes(*block, k);
        const PairRows<Lanes, Space> rows = lanes.template read<Space, moving>(grains, shifts);
        const auto relative = position_in_reach<Space>(rows, *block, s);
        const Vector<Lanes, Space> velocity = deforming ? rows.velocity + s.affine(rows.branch) : rows.velocity;
        const unsigned touching = bits(relative.touching);
        // A rarely taken branch: the position of the next group must not wait for the result of this one.
        if ((touching | lanes.touching()) == 0) [[unlikely]]
          continue;
        // Members are copied one by one. A copy of the whole struct would read both halves just stored, and wait for
        // them.
        group->lanes.block = lanes.block, group->lanes.lane = lanes.lane, group->lanes.numbers = lanes.numbers;
        group->touching = touching;
        group->motion = {velocity, rows.spin_1, rows.spin_2, rows.radius_1, rows.radius_2, relative.inverse_distance};
        PairGeometry<Lanes, Space>& g = group->geometry;
        g.touching = relative.touching;
        Kinematics<Lanes, Space>& kinematics = g.kinematics;
        kinematics.normal = relative.normal, kinematics.overlap = relative.overlap;
        kinematics.R_star = relative.R_star, kinematics.per_reach = relative.per_reach;
        kinematics.r1 = rows.radius_1, kinematics.r2 = rows.radius_2;
        if (use_masses) lanes.masses(grains, kinematics);
        ++group;
      }
    }
    next = block;
    return static_cast<std::size_t>(group - groups.data());
  }

  template <class Space>
  [[gnu::noinline, gnu::flatten]] static void move(Batch<Lanes, Space> batch, double dt) {
    for (Group<Lanes, Space>& group : batch) set_motion(group.motion, dt, group.geometry);
  }

  template <class Space, bool moments>
  [[gnu::noinline, gnu::flatten]] void answer(Batch<Lanes, Space> batch, const Surroundings& s,
                                              StepSums<Lanes>& sums) const {
    // Copies keep the parameters in registers; references would be read and spread over the lanes after every store.
    const std::optional<typename Law::MaterialPair> lone = material_pairs_.lone();
    const Lanes dt = broadcast<Lanes>(s.dt);
    const bool at_rest = s.dt == 0;
    Lanes overlap = sums.overlap;
    std::int64_t contacts = sums.contacts;
    for (Group<Lanes, Space>& group : batch) {
      const BlockLanes<Lanes> lanes = group.lanes;
      const PairGeometry<Lanes, Space>& g = group.geometry;
      // Pairs that have parted have no history. Their overlap and increments are zero and give no force.
      const auto carried = carry(g);
      HistoryOf<Law, Lanes, Space> before{};
      before.shear = carried(masked(g.touching, lanes.template shear<Space>()));
      if (moments) {
        before.rolling = carried(masked(g.touching, lanes.template rolling<Space>()));
        if (Space::twists) before.twisting = masked(g.touching, lanes.twisting());
      }
      Own::template read<Lanes, Space>(s.template own_of<Own>(lanes), g.touching, carried, before);
      HistoryOf<Law, Lanes, Space> history = before;
      ContactEnergies<Lanes> energies;
      const auto response =
          lone ? Law::respond(*lone, g.kinematics, dt, history, energies)
               : Law::respond(material_pairs_.of(*lanes.block, s.bodies), g.kinematics, dt, history, energies);
      if (at_rest) history = before;  // the first sweep of a restored state changes no history
      lanes.remember_shear(history.shear);
      if (moments) lanes.template remember_moments<Space>(history);
      Own::template write<Lanes, Space>(history, s.template own_of<Own>(lanes));
      lanes.remember_normal_force(response.normal_force);
      lanes.set_masks(group.touching, group.touching & bits(response.sliding));
      group.work = work_of<Lanes, Space>(g, before, history, moments, energies);
      overlap = maximum(overlap, g.kinematics.overlap);
      contacts += std::popcount(group.touching);
    }
    sums.overlap = overlap, sums.contacts = contacts;
  }
  // Returns the map that carries history from the old contact plane to the present one.
  static Rotation<Lanes> carry(const PairGeometry<Lanes, Spatial>& g) { return Rotation<Lanes>::by_small(g.turn); }
  static std::identity carry(const PairGeometry<Lanes, Planar>&) { return {}; }

  template <class Space, bool moments>
  [[gnu::noinline, gnu::flatten]] static void act(Batch<Lanes, Space> batch, const Surroundings& s, Lane4& work) {
    Lane4 all_work = work;  // in a register: in memory each addition would wait until the one before is stored
    for (const Group<Lanes, Space>& group : batch) {
      const BlockLanes<Lanes> lanes = group.lanes;
      const Kinematics<Lanes, Space>& k = group.geometry.kinematics;
      ContactHistory<Lanes, Space> history{};
      history.shear = lanes.template shear<Space>();
      if (moments) {
        history.rolling = lanes.template rolling<Space>();
        if (Space::twists) history.twisting = lanes.twisting();
      }
      const Lanes depth = 0.5 * k.overlap;
      add_to_loads(action(k.normal, Lanes(k.r1 - depth), Lanes(k.r2 - depth), history, lanes.normal_force()), lanes, s);
      add_to(all_work, group.work);
    }
    work = all_work;
  }

  // Returns the part of f (x) l from pairs across the cell's faces.
  Mat3 force_branch_across() const {
    const std::size_t images = shifts_.size();
    Mat3 force_branch = Mat3::Zero();
    for (std::size_t image = 1; image + 1 < images; ++image) {
      Lane4 force{};
      for (std::size_t at = image; at < across_.size(); at += images) force += across_[at];
      for (int a = 0; a < 3; ++a) force_branch.col(a) += shifts_[image][a] * vector_of(force);
    }
    return force_branch;
  }

  template <class Space>
  [[gnu::noinline, gnu::flatten]] void stiffen(Batch<Lanes, Space> batch, const Surroundings& s, Lane4& sum) const {
    for (const Group<Lanes, Space>& group : batch) {
      const PairGeometry<Lanes, Space>& g = group.geometry;
      const Kinematics<Lanes, Space>& k = g.kinematics;
      const auto r = response<Space>(group, s, HistoryOf<Law, Lanes, Space>{}).first;
      add_to(sum, masked(g.touching, affine_stiffness(k.normal, Lanes(k.r1 + k.r2 - k.overlap), r)));
      const auto [translation, rotation_first] = axis_stiffness(k.normal, r, k.r1);
      const auto rotation_second = axis_stiffness(k.normal, r, k.r2).second;
      add_stiffness(masked(g.touching, translation), masked(g.touching, rotation_first),
                    masked(g.touching, rotation_second), group.lanes, s.stiffness);
    }
  }

  [[gnu::noinline, gnu::flatten]] void store_up(Batch<Lanes, Spatial> batch, const Surroundings& s, Lane4& sum) const {
    for (const Group<Lanes, Spatial>& group : batch) {
      const BlockLanes<Lanes>& lanes = group.lanes;
      const Mask<Lanes>& touching = group.geometry.touching;
      HistoryOf<Law, Lanes> history{};
      history.shear = masked(touching, lanes.shear<Spatial>()),
      history.rolling = masked(touching, lanes.rolling<Spatial>());
      history.twisting = masked(touching, lanes.twisting());
      const ContactEnergies<Lanes> b = response<Spatial>(group, s, history).second;
      add_to(sum, b.elastic_normal, b.elastic_shear, b.elastic_rolling, b.elastic_twisting);
    }
  }

  // Returns the response of pairs at rest.
  template <class Space>
  std::pair<Response<Lanes>, ContactEnergies<Lanes>> response(const Group<Lanes, Space>& group, const Surroundings& s,
                                                              HistoryOf<Law, Lanes, Space> history) const {
    Kinematics<Lanes, Space> k = group.geometry.kinematics;
    Own::template read<Lanes, Space>(s.template own_of<Own>(group.lanes), group.geometry.touching, std::identity(),
                                     history);
    k.approach_speed = k.twist = Lanes{};
    k.slip = Along<Lanes, Space>{}, k.roll = Turn<Lanes, Space>{};
    ContactEnergies<Lanes> energies;
    const auto r = Law::respond(material_pairs_.of(*group.lanes.block, s.bodies), k, Lanes{}, history, energies);
    return {r, energies};
  }

  using Own = OwnFields<Law>;

  MaterialPairs<Law> material_pairs_;
  PlaneSweep<Law, Lanes> planes_;
  bool use_masses_, use_moments_, moments_gone_ = false;
  std::vector<Lane4> shifts_, across_;
  std::vector<StepSums<Lanes>> step_sums_;
  std::vector<Lane4> row_sums_;
};

// Makes the sweep of the law to which the materials belong.
template <class... Law>
std::unique_ptr<ContactSweep> make(const Materials& materials, LawList<Law...>) {
  std::unique_ptr<ContactSweep> sweep;
  const auto try_law = [&]<class L>() {
    if (materials.are<typename L::Material>())
      sweep = std::make_unique<LawSweep<L>>(materials.of<typename L::Material>());
  };
  (try_law.template operator()<Law>(), ...);
  return sweep;
}

}  // namespace

#ifdef SOILWEAVE_EIGHT_LANES
std::unique_ptr<ContactSweep> make_contact_sweep_of_eight(const Model& model) {
#else
std::unique_ptr<ContactSweep> make_contact_sweep_of_four(const Model& model) {
#endif
  return make(model.materials, Laws());
}

}  // namespace soilweave::dem
