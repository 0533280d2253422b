// One sweep over all candidate pairs, a vector register of contacts at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is summed over contacts is summed contact by contact within a chunk of grains, and the chunks in order: every
// bit is independent of the width of the register, of the pairs listed without touching, and of the number of threads.
//
// A contact is a long chain of dependent operations, square roots and divisions among them. So the sweep takes a batch
// of registers through one stage after the other: how the pairs lie and move (approach), then what the law answers and
// what that does to the grains (act). Within a stage the processor works on several registers at once, and a batch
// stays in its first cache. What a contact does to its grains is added at once to their loads, in the order of the
// pairs; only for grains of other chunks, which another thread may be at, does it wait in a place of its own
// (contacts.h).
//
// No old normal is kept: where a pair has turned from follows from its velocity (transport.h).
//
// The stress needs no product of force and branch for every contact: the sum of f (x) l is that of F (x) x over the
// grains, F their resultants (motion.h), and of f times cell offset over the pairs that reach across the cell's faces.
#include "dem/contact_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>
#include <utility>

#include "dem/block_lanes.h"
#include "dem/contact_action.h"
#include "dem/couples.h"
#include "dem/row_sums.h"
#include "dem/transport.h"

namespace soilweave::dem {
namespace {

// This file is compiled once for either width; the same order of operations on every contact gives the same bits.
#ifdef SOILWEAVE_EIGHT_LANES
using Lanes = Lane8;
#else
using Lanes = Lane4;
#endif

// What a step sums over the contacts of a chunk.
struct StepSums {
  Lane4 work{};     // -2 times that on the springs; frictional, rolling plastic, viscous
  Lanes overlap{};  // the largest, a lane each
  std::int64_t contacts = 0;

  template <class T, class Space>
  void add(const PairGeometry<T, Space>& g, const Memory<T, Space>& before, const Memory<T, Space>& after, bool moments,
           const Books<T>& b) {
    const Kinematics<T, Space>& k = g.kinematics;
    T twice = dot(before.shear + after.shear, g.surface_slip);
    if (moments) {
      twice += product(Turn<T, Space>(before.rolling + after.rolling), k.roll);
      if constexpr (Space::twists) twice = fused(T(before.twisting + after.twisting), k.twist, twice);
    }
    add_to(work, twice, b.frictional, b.rolling_plastic, b.viscous);
    overlap = maximum(overlap, k.overlap + Lanes{});
  }

  void put_into(SweepSums& s) const {
    s.tangential_work -= 0.5 * work[0];
    s.frictional += work[1], s.rolling_plastic += work[2], s.viscous += work[3];
    for (int lane = 0; lane < width<Lanes>; ++lane) s.largest_overlap = std::max(s.largest_overlap, overlap[lane]);
    s.contacts += contacts;
  }
};

template <class T>
void put(const V3<T>& v, Lane4& row) {
  row = Lane4{v.x, v.y, v.z, 0};
}

// What a sweep works with beside the pairs.
struct Surroundings {
  const Bodies& bodies;
  const std::vector<Lane4>& shifts;  // of Contacts::images, m
  AffineMotion affine;
  double dt;
  double* loads;
  double* across;  // of this chunk: forces summed by image

  const double* grains() const { return reinterpret_cast<const double*>(bodies.grains.data()); }
};

// Pairs of one register on their way through the stages.
template <class Space>
struct Group {
  BlockLanes<Lanes> lanes;
  unsigned touching;
  PairMotion<Lanes, Space> motion;
  PairGeometry<Lanes, Space> geometry;
};
constexpr std::size_t batch_size = 8;  // what the first cache holds
template <class Space>
using Batch = std::span<Group<Space>>;

template <class Law>
class LawSweep final : public ContactSweep {
 public:
  explicit LawSweep(const std::vector<typename Law::Material>& materials)
      : couples_(materials), use_masses_(couples_.use_masses()), use_moments_(couples_.use_moments()) {}

  SweepSums run(const Scene& scene, double dt, Contacts& contacts) override {
    const Cell& cell = scene.cell;
    set_shifts(cell, contacts);
    across_.assign(chunks_of(scene.bodies.size()) * shifts_.size(), Lane4{});
    const AffineMotion affine(cell.velocity_gradient(), cell.deforming(), dt);
    if (!use_moments_ && dt > 0) let_moments_go(contacts);
    scene.bodies.dimension == 2 ? step<Planar>(scene, affine, dt, contacts)
                                : step<Spatial>(scene, affine, dt, contacts);
    SweepSums total;
    for (const StepSums& s : step_sums_) s.put_into(total);
    add_across(scene.bodies.dimension == 2, total.force_branch);
    StepSums with_planes;
    for (PlanePair& pair : contacts.planes) act(scene, dt, pair, with_planes, total);
    with_planes.put_into(total);
    return total;
  }

  Vec3 stiffen(const Scene& scene, Contacts& contacts) override {
    set_shifts(scene.cell, contacts);
    sweep<Spatial, false>(scene, AffineMotion(Mat3::Zero(), false, 0), 0, contacts, row_sums_,
                          [this](Batch<Spatial> batch, const Surroundings& s, Lane4& sum) { stiffen(batch, s, sum); });
    Lane4 total{};
    for (const Lane4& sum : row_sums_) total += sum;
    for (const PlanePair& pair : contacts.planes) stiffen(scene, pair, scene.bodies.loads[pair.load], total);
    return vector_of(total);
  }

  StoredEnergies stored(const Scene& scene, Contacts& contacts) override {
    set_shifts(scene.cell, contacts);
    sweep<Spatial, false>(scene, AffineMotion(Mat3::Zero(), false, 0), 0, contacts, row_sums_,
                          [this](Batch<Spatial> batch, const Surroundings& s, Lane4& sum) { store_up(batch, s, sum); });
    Lane4 total{};
    for (const Lane4& sum : row_sums_) total += sum;
    for (const PlanePair& pair : contacts.planes) {
      if (!pair.history.touching) continue;
      Memory<double> memory = pair.history.memory;
      Books<double> b;
      Law::respond(couple(scene, pair), geometry(scene, 0, pair).kinematics, 0.0, memory, b);
      total = total + Lane4{b.elastic_normal, b.elastic_shear, b.elastic_rolling, b.elastic_twisting};
    }
    return {total[0], total[1], total[2], total[3]};
  }

  double stiffness(double radius, double overlap, std::int32_t materials) const override {
    Kinematics<double> kinematics{};
    kinematics.normal = {1, 0, 0};
    kinematics.overlap = overlap;
    kinematics.r1 = kinematics.r2 = radius;
    kinematics.R_star = radius / 2;
    kinematics.m1 = kinematics.m2 = 1;
    double largest = 0;
    for (const auto& couple : couples_.of_first(materials)) {
      Memory<double> memory{{0, 0, 0}, {0, 0, 0}, 0};
      Books<double> books;
      largest = std::max(largest, Law::respond(couple, kinematics, 0.0, memory, books).normal_stiffness);
    }
    return largest;
  }

 private:
  void set_shifts(const Cell& cell, const Contacts& contacts) {
    shifts_.clear();
    for (const Vec3i& image : contacts.images) shifts_.push_back(row(cell.matrix() * image.cast<double>(), 0));
  }

  // Moments of a state that was made with a law that has them: this one would turn the grains by them for ever.
  void let_moments_go(Contacts& contacts) {
    if (std::exchange(moments_gone_, true)) return;
    for (auto& chunk : contacts.chunks)
      for (ContactBlock& block : chunk)
        for (int k = 0; k < ContactBlock::size; k += width<Lanes>) BlockLanes<Lanes>{&block, k}.forget_moments();
  }

  template <class Space>
  void step(const Scene& scene, const AffineMotion& affine, double dt, Contacts& contacts) {
    const auto through = [this](Batch<Space> batch, const Surroundings& s, StepSums& sums) {
      move<Space>(batch, s.dt);
      if (use_moments_)
        answer<Space, true>(batch, s, sums), act<Space, true>(batch, s);
      else
        answer<Space, false>(batch, s, sums), act<Space, false>(batch, s);
    };
    sweep<Space, true>(scene, affine, dt, contacts, step_sums_, through);
  }

  // Chunk by chunk, batch by batch, the pairs that touch, or did so in the last step, through `stage`.
  template <class Space, bool moving, class Sums, class Stage>
  void sweep(const Scene& scene, const AffineMotion& affine, double dt, Contacts& contacts, std::vector<Sums>& sums,
             const Stage& stage) {
    const std::size_t chunks = chunks_of(scene.bodies.size());
    sums.assign(chunks, Sums{});
#pragma omp parallel for schedule(static) num_threads(scene.threads) if (scene.threads > 1)
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
      const Surroundings s{scene.bodies,
                           shifts_,
                           affine,
                           dt,
                           reinterpret_cast<double*>(scene.bodies.loads.data()),
                           reinterpret_cast<double*>(across_.data() + chunk * shifts_.size())};
      std::array<Group<Space>, batch_size> groups;
      ContactBlock* next = contacts.chunks[chunk].data();
      ContactBlock* const end = next + contacts.chunks[chunk].size();
      while (next != end) {
        std::size_t n = 0;
        next = approach<Space, moving>(next, end, s, groups, n);
        if (n) stage(Batch<Space>(groups.data(), n), s, sums[chunk]);
      }
    }
  }

  // Fills the batch from `next` on; returns the first block not looked at. n: how many were filled.
  template <class Space, bool moving>
  [[gnu::noinline, gnu::flatten]] ContactBlock* approach(ContactBlock* next, ContactBlock* end, const Surroundings& s,
                                                         std::array<Group<Space>, batch_size>& groups,
                                                         std::size_t& n) const {
    constexpr std::size_t per_block = ContactBlock::size / width<Lanes>;
    const double* grains = s.grains();
    for (; next != end && n + per_block <= batch_size; ++next) {
      call_for(next, end, grains, s.loads);
      for (int k = 0; k < ContactBlock::size; k += width<Lanes>) {
        const BlockLanes<Lanes> lanes{next, k};
        Group<Space>& group = groups[n];
        PairGeometry<Lanes, Space>& g = group.geometry;
        PairMotion<Lanes, Space>& motion = group.motion;
        const auto ends = lanes.ends(grains);
        const Vector<Lanes, Space> branch = lanes.template branch<Space>(ends, s.shifts);
        lanes.spins_and_radii(ends, motion);
        motion.inverse_distance = set_place(branch, motion.lever_1, motion.lever_2, g);
        const unsigned touching = bits(g.touching);
        group.lanes = lanes, group.touching = touching;
        if (moving) {
          motion.velocity = lanes.template velocity<Space>(ends);
          if (s.affine.deforming) motion.velocity = motion.velocity + s.affine(branch);
        }
        if (use_masses_) lanes.masses(ends, g.kinematics);
        n += (touching | lanes.touching()) != 0;
      }
    }
    return next;
  }

  template <class Space>
  [[gnu::noinline, gnu::flatten]] static void move(Batch<Space> batch, double dt) {
    for (Group<Space>& group : batch) set_motion(group.motion, dt, group.geometry);
  }

  template <class Space, bool moments>
  [[gnu::noinline, gnu::flatten]] void answer(Batch<Space> batch, const Surroundings& s, StepSums& sums) const {
    for (const Group<Space>& group : batch) {
      const BlockLanes<Lanes> lanes = group.lanes;
      const PairGeometry<Lanes, Space>& g = group.geometry;
      // What has parted has no memory; then its overlap and increments, zero, give no force.
      const auto turn = rotation(g.turn);
      Memory<Lanes, Space> before{};
      before.shear = turn(keep(g.touching, lanes.template shear<Space>()));
      if (moments) {
        before.rolling = turn(keep(g.touching, lanes.template rolling<Space>()));
        if (Space::twists) before.twisting = keep(g.touching, lanes.twisting());
      }
      Memory<Lanes, Space> memory = before;
      Books<Lanes> books;
      const auto response = couples_.respond(s.bodies, lanes, g.kinematics, all<Lanes>(s.dt), memory, books);
      if (s.dt == 0) memory = before;  // the first sweep of a restored state changes no history
      lanes.remember_shear(memory.shear);
      if (moments) lanes.remember_moments(memory);
      lanes.remember_normal_force(response.normal_force);
      lanes.set_masks(group.touching, group.touching & bits(response.sliding));
      sums.add(g, before, memory, moments, books);
      sums.contacts += std::popcount(group.touching);
    }
  }
  static Rotation<Lanes> rotation(const V3<Lanes>& gibbs) { return Rotation<Lanes>::by_small(gibbs); }
  static PlanarRotation<Lanes> rotation(const Lanes& gibbs) { return PlanarRotation<Lanes>::by_small(gibbs); }

  template <class Space, bool moments>
  [[gnu::noinline, gnu::flatten]] static void act(Batch<Space> batch, const Surroundings& s) {
    for (const Group<Space>& group : batch) {
      const BlockLanes<Lanes>& lanes = group.lanes;
      const Kinematics<Lanes, Space>& k = group.geometry.kinematics;
      Memory<Lanes, Space> memory{};
      memory.shear = lanes.template shear<Space>();
      if (moments) {
        memory.rolling = lanes.template rolling<Space>();
        if (Space::twists) memory.twisting = lanes.twisting();
      }
      const Lanes depth = 0.5 * k.overlap;
      add(action(k.normal, Lanes(k.r1 - depth), Lanes(k.r2 - depth), memory, lanes.normal_force()), lanes, s);
    }
  }

  // To the loads of the grains, pair by pair.
  static void add(const Action<Lanes>& act, const BlockLanes<Lanes>& lanes, const Surroundings& s) {
    std::array<Lane4, width<Lanes>> force, torque;
    const auto& f = act.force;
    const auto &t1 = act.torque_first, &t2 = act.torque_second;
    const Lanes zero{};
    to_rows(f.x, f.y, f.z, zero, [&](int lane, const Lane4& row) { force[static_cast<std::size_t>(lane)] = row; });
    to_rows(t1.x, t1.y, t1.z, zero, [&](int lane, const Lane4& row) { torque[static_cast<std::size_t>(lane)] = row; });
    to_rows(t2.x, t2.y, t2.z, zero, [&](int lane, const Lane4& row) {
      const auto k = static_cast<std::size_t>(lane);
      double *one = s.loads + lanes.load_first(lane), *two = s.loads + lanes.load_second(lane);
      take(one, force[k]), take(one + width<Lane4>, torque[k]);
      add(two, force[k]), add(two + width<Lane4>, row);
    });
    add_across(force, lanes, s);
  }
  // In the plane the torque comes as the third part of the force (Motion::gather).
  static void add(const Action<Lanes, Planar>& act, const BlockLanes<Lanes>& lanes, const Surroundings& s) {
    const auto& f = act.force;
    std::array<Lane4, width<Lanes>> first;
    to_rows(f.x, f.y, act.torque_first, Lanes{},
            [&](int lane, const Lane4& row) { first[static_cast<std::size_t>(lane)] = row; });
    to_rows(f.x, f.y, act.torque_second, Lanes{}, [&](int lane, const Lane4& row) {
      take(s.loads + lanes.load_first(lane), first[static_cast<std::size_t>(lane)]);
      add(s.loads + lanes.load_second(lane), row);
    });
    add_across(first, lanes, s);
  }
  static void add_across(const std::array<Lane4, width<Lanes>>& force, const BlockLanes<Lanes>& lanes,
                         const Surroundings& s) {
    if (!lanes.block->folded) return;
    for (int lane = 0; lane < width<Lanes>; ++lane)
      add(s.across + width<Lane4> * lanes.image(lane), force[static_cast<std::size_t>(lane)]);
  }
  static void add(double* row, const Lane4& part) { store(row, Lane4(load<Lane4>(row) + part)); }
  static void take(double* row, const Lane4& part) { store(row, Lane4(load<Lane4>(row) - part)); }

  // The part of f (x) l that comes from pairs across the cell's faces.
  void add_across(bool planar, Mat3& force_branch) const {
    const std::size_t images = shifts_.size();
    for (std::size_t image = 1; image + 1 < images; ++image) {
      Lane4 force{};
      for (std::size_t at = image; at < across_.size(); at += images) force += across_[at];
      if (planar) force[2] = 0;
      force_branch += vector_of(force) * vector_of(shifts_[image]).transpose();
    }
  }

  [[gnu::noinline, gnu::flatten]] void stiffen(Batch<Spatial> batch, const Surroundings& s, Lane4& sum) const {
    for (const Group<Spatial>& group : batch) {
      const PairGeometry<Lanes>& g = group.geometry;
      const Kinematics<Lanes>& k = g.kinematics;
      const auto r = response(group, s, Memory<Lanes>{}).first;
      const V3<Lanes> affine = keep(g.touching, affine_stiffness(k.normal, Lanes(k.r1 + k.r2 - k.overlap), r));
      add_to(sum, affine.x, affine.y, affine.z, Lanes{});
      const auto put = [&](const Lanes& radius, const auto& load_of) {
        const auto [translation, rotation] = axis_stiffness(k.normal, r, radius);
        const V3<Lanes> t = keep(g.touching, translation), w = keep(g.touching, rotation);
        to_rows(t.x, t.y, t.z, Lanes{}, [&](int lane, const Lane4& row) { add(s.loads + load_of(lane), row); });
        to_rows(w.x, w.y, w.z, Lanes{},
                [&](int lane, const Lane4& row) { add(s.loads + load_of(lane) + width<Lane4>, row); });
      };
      const BlockLanes<Lanes>& lanes = group.lanes;
      put(k.r1, [&](int lane) { return lanes.load_first(lane); });
      put(k.r2, [&](int lane) { return lanes.load_second(lane); });
    }
  }

  [[gnu::noinline, gnu::flatten]] void store_up(Batch<Spatial> batch, const Surroundings& s, Lane4& sum) const {
    for (const Group<Spatial>& group : batch) {
      const BlockLanes<Lanes>& lanes = group.lanes;
      const Mask<Lanes>& touching = group.geometry.touching;
      const Memory<Lanes> memory{keep(touching, lanes.shear<Spatial>()), keep(touching, lanes.rolling<Spatial>()),
                                 keep(touching, lanes.twisting())};
      const Books<Lanes> b = response(group, s, memory).second;
      add_to(sum, b.elastic_normal, b.elastic_shear, b.elastic_rolling, b.elastic_twisting);
    }
  }

  // To pairs at rest.
  std::pair<Response<Lanes>, Books<Lanes>> response(const Group<Spatial>& group, const Surroundings& s,
                                                    Memory<Lanes> memory) const {
    Kinematics<Lanes> k = group.geometry.kinematics;
    k.approach_speed = k.twist = Lanes{};
    k.slip = k.roll = V3<Lanes>{};
    Books<Lanes> books;
    const auto r = couples_.respond(s.bodies, group.lanes, k, Lanes{}, memory, books);
    return {r, books};
  }

  static PairGeometry<double> geometry(const Scene& scene, double dt, const PlanePair& pair) {
    const Grain& grain = scene.bodies.grains[static_cast<std::size_t>(pair.grain)];
    const Plane& p = scene.planes.all[static_cast<std::size_t>(pair.plane)];
    const auto v3 = [](const Lane4& row) { return V3<double>{row[0], row[1], row[2]}; };
    const V3<double> inward = from_eigen(p.normal);
    const double height = dot(v3(grain.position) - from_eigen(p.point), inward);
    return plane_geometry(from_eigen(p.velocity) - v3(grain.velocity), v3(grain.spin), grain.position[3],
                          grain.velocity[3], height, inward, pair.normal, dt);
  }

  const typename Law::Couple& couple(const Scene& scene, const PlanePair& pair) const {
    return couples_.of(scene.bodies.material[static_cast<std::size_t>(pair.grain)],
                       scene.planes.all[static_cast<std::size_t>(pair.plane)].material);
  }

  void act(const Scene& scene, double dt, PlanePair& pair, StepSums& sums, SweepSums& total) const {
    const PairGeometry<double> g = geometry(scene, dt, pair);
    const Kinematics<double>& k = g.kinematics;
    History& history = pair.history;
    if (!g.touching) {
      history = {};
      return;
    }
    const V3<double> n = k.normal, force_before = history.normal_force * pair.normal + history.memory.shear;
    Memory<double>& memory = history.memory;
    if (dt > 0 && history.touching) {
      const Rotation<double> turn(g.turn);
      memory.shear = turn(memory.shear), memory.rolling = turn(memory.rolling);
    }
    const Memory<double> before = memory;
    Books<double> books;
    const auto response = Law::respond(couple(scene, pair), k, dt, memory, books);
    if (dt == 0) memory = before;
    const Action<double> act = action(n, k.r1, 0.0, memory, response.normal_force);
    pair.normal = n;
    history.normal_force = response.normal_force;
    history.touching = true, history.sliding = response.sliding;
    Load& load = scene.bodies.loads[pair.load];
    put(-act.force, load.force), put(-act.torque_first, load.torque);
    if (scene.bodies.dimension == 2) load.force[2] = load.torque[2], load.torque = Lane4{};
    sums.add(g, before, memory, use_moments_, books);
    ++sums.contacts;
    // Of f (x) l what is not F (x) x: f at the foot of the perpendicular.
    const double height = k.r1 - k.overlap;
    const Vec3 foot =
        vector_of(scene.bodies.grains[static_cast<std::size_t>(pair.grain)].position) + to_eigen(height * n);
    total.force_branch += to_eigen(act.force) * foot.transpose();
    const Vec3& velocity = scene.planes.all[static_cast<std::size_t>(pair.plane)].velocity;
    total.plane_work -= 0.5 * dt * dot(force_before + act.force, from_eigen(velocity));
  }

  void stiffen(const Scene& scene, const PlanePair& pair, Load& load, Lane4& total) const {
    const PairGeometry<double> g = geometry(scene, 0, pair);
    if (!g.touching) return;
    const Kinematics<double>& k = g.kinematics;
    Memory<double> memory = pair.history.memory;
    Books<double> books;
    const auto r = Law::respond(couple(scene, pair), k, 0.0, memory, books);
    const V3<double> affine = affine_stiffness(k.normal, k.r1 - k.overlap, r);
    add_to(total, affine.x, affine.y, affine.z, 0.0);
    const auto [translation, rotation] = axis_stiffness(k.normal, r, k.r1);
    put(translation, load.force), put(rotation, load.torque);
  }

  Couples<Law> couples_;
  bool use_masses_, use_moments_, moments_gone_ = false;
  std::vector<Lane4> shifts_, across_;
  std::vector<StepSums> step_sums_;
  std::vector<Lane4> row_sums_;
};

template <class Law>
std::unique_ptr<ContactSweep> make(const std::vector<typename Law::Material>& materials) {
  return std::make_unique<LawSweep<Law>>(materials);
}

}  // namespace

#ifdef SOILWEAVE_EIGHT_LANES
std::unique_ptr<ContactSweep> make_contact_sweep_of_eight(const Model& model) {
#else
std::unique_ptr<ContactSweep> make_contact_sweep_of_four(const Model& model) {
#endif
  return std::visit(
      []<class Material>(const std::vector<Material>& materials) { return make<typename Material::Law>(materials); },
      model.materials);
}

}  // namespace soilweave::dem
