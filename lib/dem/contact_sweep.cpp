// One sweep over all candidate pairs, a vector register of contacts at a time.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is summed over contacts is summed contact by contact within a chunk of grains, and the chunks in order: every
// bit is independent of the width of the register, of the pairs listed without touching, and of the number of threads.
//
// A contact is a long chain of dependent operations, square roots and divisions among them. So the sweep takes a batch
// of registers through one stage after the other (approach, act): within a stage the processor works on several of
// them at once, and a batch stays in its first cache. What a contact does to its grains is added at once to their
// loads, in the order of the pairs; only for grains of other chunks, which another thread may be at, does it wait in a
// place of its own (contacts.h).
//
// The stress needs no product of force and branch for every contact: the sum of f (x) l is that of F (x) x over the
// grains, F their resultants (motion.h), and of f times cell offset over the pairs that reach across the cell's faces.
#include "dem/contact_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

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
  Lane4 energies{}, losses{};
  Lanes relative_overlap{};  // the largest, a lane each
  std::int64_t contacts = 0;

  template <class T>
  void add(const PairGeometry<T>& g, const V3<T>& shear_before, const V3<T>& shear, const Books<T>& b) {
    const T stored = b.elastic_shear + b.elastic_rolling + b.elastic_twisting;
    const T before = b.shear_before + b.rolling_before + b.twisting_before;
    const T kinematic = 0.5 * dot(shear_before + shear, g.excess_slip);
    add_to(energies, b.elastic_normal, stored, before, kinematic);
    // Where nothing is lost to add it changes no bit.
    if (any(Mask<T>((b.frictional + b.rolling_plastic != all<T>(0)) | (b.viscous != all<T>(0)))))
      add_to(losses, b.frictional, b.rolling_plastic, b.viscous, all<T>(0));
    const T relative = g.kinematics.overlap / minimum(g.kinematics.r1, g.kinematics.r2);
    relative_overlap = maximum(relative_overlap, relative + Lanes{});
  }

  void put_into(SweepSums& s) const {
    s.elastic_normal += energies[0], s.elastic_tangential += energies[1], s.tangential_before += energies[2];
    s.kinematic += energies[3];
    s.frictional += losses[0], s.rolling_plastic += losses[1], s.viscous += losses[2];
    for (int lane = 0; lane < width<Lanes>; ++lane)
      s.largest_relative_overlap = std::max(s.largest_relative_overlap, relative_overlap[lane]);
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
};

// Pairs of one register on their way through the stages.
struct Group {
  BlockLanes<Lanes> lanes;
  unsigned touching;
  Approach<Lanes> approach;
};
constexpr std::size_t batch_size = 8;  // what the first cache holds
using Batch = std::span<Group>;

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
    sweep(scene, affine, dt, contacts, step_sums_, [this](Batch batch, const Surroundings& s, StepSums& sums) {
      s.dt > 0 ? act<true>(batch, s, sums) : act<false>(batch, s, sums);
    });
    SweepSums total;
    for (const StepSums& s : step_sums_) s.put_into(total);
    add_across(total.force_branch);
    StepSums with_planes;
    for (PlanePair& pair : contacts.planes) act(scene, dt, pair, contacts, with_planes, total);
    with_planes.put_into(total);
    return total;
  }

  Vec3 stiffen(const Scene& scene, Contacts& contacts) override {
    set_shifts(scene.cell, contacts);
    sweep(scene, AffineMotion(Mat3::Zero(), false, 0), 0, contacts, row_sums_,
          [this](Batch batch, const Surroundings& s, Lane4& sum) { stiffen(batch, s, sum); });
    Lane4 total{};
    for (const Lane4& sum : row_sums_) total += sum;
    for (const PlanePair& pair : contacts.planes) stiffen(scene, pair, contacts.loads[pair.load], total);
    return vector_of(total);
  }

  StoredEnergies stored(const Scene& scene, Contacts& contacts) override {
    set_shifts(scene.cell, contacts);
    sweep(scene, AffineMotion(Mat3::Zero(), false, 0), 0, contacts, row_sums_,
          [this](Batch batch, const Surroundings& s, Lane4& sum) { store_up(batch, s, sum); });
    Lane4 total{};
    for (const Lane4& sum : row_sums_) total += sum;
    for (const PlanePair& pair : contacts.planes) {
      if (!pair.history.touching) continue;
      Memory<double> memory = pair.history.memory;
      Books<double> b;
      Law::respond(couple(scene, pair), geometry(scene, 0, pair).kinematics, 0.0, memory, b);
      total = total + Lane4{b.elastic_shear, b.elastic_rolling, b.elastic_twisting, 0};
    }
    return {total[0], total[1], total[2]};
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

  // Chunk by chunk, batch by batch, the pairs that touch, or did so in the last step, through `stage`.
  template <class Sums, class Stage>
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
                           reinterpret_cast<double*>(contacts.loads.data()),
                           reinterpret_cast<double*>(across_.data() + chunk * shifts_.size())};
      std::array<Group, batch_size> groups;
      ContactBlock* next = contacts.chunks[chunk].data();
      ContactBlock* const end = next + contacts.chunks[chunk].size();
      while (next != end) {
        std::size_t n = 0;
        next = approach(next, end, s, groups, n);
        if (n) stage(Batch(groups.data(), n), s, sums[chunk]);
      }
    }
  }

  // Fills the batch from `next` on; returns the first block not looked at. n: how many were filled.
  [[gnu::noinline, gnu::flatten]] static ContactBlock* approach(ContactBlock* next, ContactBlock* end,
                                                                const Surroundings& s,
                                                                std::array<Group, batch_size>& groups, std::size_t& n) {
    constexpr std::size_t per_block = ContactBlock::size / width<Lanes>;
    for (; next != end && n + per_block <= batch_size; ++next) {
      call_for(next, end, s.bodies, s.loads);
      for (int k = 0; k < ContactBlock::size; k += width<Lanes>) {
        const BlockLanes<Lanes> lanes{next, k};
        Group& group = groups[n];
        group.lanes = lanes;
        Approach<Lanes>& a = group.approach;
        lanes.spins_and_radii(s.bodies, a.motion);
        const V3<Lanes> branch = lanes.branch(s.bodies, s.shifts), velocity = lanes.velocity(s.bodies);
        a.motion.velocity = s.affine.deforming ? velocity + s.affine(branch) : velocity;
        dem::approach(branch, a);
        group.touching = bits(group.approach.touching);
        n += (group.touching | lanes.touching()) != 0;
      }
    }
    return next;
  }

  template <bool moving>
  [[gnu::noinline, gnu::flatten]] void act(Batch batch, const Surroundings& s, StepSums& sums) const {
    for (const Group& group : batch) {
      const BlockLanes<Lanes> lanes = group.lanes;
      const Approach<Lanes>& a = group.approach;
      PairGeometry<Lanes> g = increments(a, s.dt);
      // What has parted has no memory; then its overlap and increments, zero, give no force.
      Memory<Lanes> before = keep(a.touching, lanes.memory());
      if (moving) {
        // Memory that was zero stays zero, also where the old normal is of no meaning.
        const Transport<Lanes> transport(lanes.normal(), a.normal, g.half_spin);
        before.shear = transport(before.shear);
        if (use_moments_) before.rolling = transport(before.rolling);
      }
      if (use_masses_) lanes.masses(s.bodies, g.kinematics);
      Memory<Lanes> memory = before;
      Books<Lanes> books;
      const auto response = couples_.respond(s.bodies, lanes, g.kinematics, all<Lanes>(s.dt), memory, books);
      if (!moving) memory = before;  // the first sweep of a restored state changes no history
      lanes.remember(a.normal, memory, response.normal_force);
      lanes.set_masks(group.touching, group.touching & bits(response.sliding));
      add(action(g, memory, response.normal_force), lanes, s);
      sums.add(g, before.shear, memory.shear, books);
      sums.contacts += std::popcount(group.touching);
    }
  }

  // To the loads of the grains, pair by pair.
  static void add(const Action<Lanes>& act, const BlockLanes<Lanes>& lanes, const Surroundings& s) {
    const auto& f = act.force;
    const auto &t1 = act.torque_first, &t2 = act.torque_second;
    const Lanes zero{};
    std::array<Lane4, width<Lanes>> force, torque;
    to_rows(f.x, f.y, f.z, zero, [&](int lane, const Lane4& row) { force[static_cast<std::size_t>(lane)] = row; });
    to_rows(t1.x, t1.y, t1.z, zero, [&](int lane, const Lane4& row) { torque[static_cast<std::size_t>(lane)] = row; });
    to_rows(t2.x, t2.y, t2.z, zero, [&](int lane, const Lane4& row) {
      const auto k = static_cast<std::size_t>(lane);
      double *one = s.loads + 2 * lanes.first(lane), *two = s.loads + 2 * lanes.load_second(lane);
      take(one, force[k]), take(one + width<Lane4>, torque[k]);
      add(two, force[k]), add(two + width<Lane4>, row);
    });
    if (lanes.block->folded)
      for (int lane = 0; lane < width<Lanes>; ++lane)
        add(s.across + lanes.image(lane), force[static_cast<std::size_t>(lane)]);
  }
  static void add(double* row, const Lane4& part) { store(row, Lane4(load<Lane4>(row) + part)); }
  static void take(double* row, const Lane4& part) { store(row, Lane4(load<Lane4>(row) - part)); }

  // The part of f (x) l that comes from pairs across the cell's faces.
  void add_across(Mat3& force_branch) const {
    const std::size_t images = shifts_.size();
    for (std::size_t image = 1; image + 1 < images; ++image) {
      Lane4 force{};
      for (std::size_t at = image; at < across_.size(); at += images) force += across_[at];
      force_branch += vector_of(force) * vector_of(shifts_[image]).transpose();
    }
  }

  [[gnu::noinline, gnu::flatten]] void stiffen(Batch batch, const Surroundings& s, Lane4& sum) const {
    for (const Group& group : batch) {
      const Approach<Lanes>& a = group.approach;
      const PairGeometry<Lanes> g = increments(a, 0);
      const auto r = response(group, s, g.kinematics, Memory<Lanes>{});
      const Lanes length = g.kinematics.r1 + g.kinematics.r2 - a.overlap;
      const V3<Lanes> affine = keep(a.touching, affine_stiffness(a.normal, length, r.first));
      add_to(sum, affine.x, affine.y, affine.z, Lanes{});
      const auto put = [&](const Lanes& radius, const auto& load_of) {
        const auto [translation, rotation] = axis_stiffness(a.normal, r.first, radius);
        const V3<Lanes> t = keep(a.touching, translation), w = keep(a.touching, rotation);
        to_rows(t.x, t.y, t.z, Lanes{}, [&](int lane, const Lane4& row) { add(s.loads + 2 * load_of(lane), row); });
        to_rows(w.x, w.y, w.z, Lanes{},
                [&](int lane, const Lane4& row) { add(s.loads + 2 * load_of(lane) + width<Lane4>, row); });
      };
      const BlockLanes<Lanes>& lanes = group.lanes;
      put(g.kinematics.r1, [&](int lane) { return lanes.first(lane); });
      put(g.kinematics.r2, [&](int lane) { return lanes.load_second(lane); });
    }
  }

  [[gnu::noinline, gnu::flatten]] void store_up(Batch batch, const Surroundings& s, Lane4& sum) const {
    for (const Group& group : batch) {
      const Approach<Lanes>& a = group.approach;
      const auto [r, b] = response(group, s, increments(a, 0).kinematics, keep(a.touching, group.lanes.memory()));
      add_to(sum, b.elastic_shear, b.elastic_rolling, b.elastic_twisting, Lanes{});
    }
  }

  std::pair<Response<Lanes>, Books<Lanes>> response(const Group& group, const Surroundings& s, Kinematics<Lanes> k,
                                                    Memory<Lanes> memory) const {
    if (use_masses_) group.lanes.masses(s.bodies, k);
    Books<Lanes> books;
    const auto r = couples_.respond(s.bodies, group.lanes, k, Lanes{}, memory, books);
    return {r, books};
  }

  static PairGeometry<double> geometry(const Scene& scene, double dt, const PlanePair& pair) {
    const auto i = static_cast<std::size_t>(pair.grain);
    const Bodies& bodies = scene.bodies;
    const Plane& p = scene.planes.all[static_cast<std::size_t>(pair.plane)];
    const auto v3 = [](const Lane4& row) { return V3<double>{row[0], row[1], row[2]}; };
    const V3<double> inward = from_eigen(p.normal);
    const double height = dot(v3(bodies.position[i]) - from_eigen(p.point), inward);
    return plane_geometry(from_eigen(p.velocity) - v3(bodies.velocity[i]), v3(bodies.spin[i]), bodies.radius(i),
                          bodies.mass(i), height, inward, dt);
  }

  const typename Law::Couple& couple(const Scene& scene, const PlanePair& pair) const {
    return couples_.of(scene.bodies.material[static_cast<std::size_t>(pair.grain)],
                       scene.planes.all[static_cast<std::size_t>(pair.plane)].material);
  }

  void act(const Scene& scene, double dt, PlanePair& pair, Contacts& contacts, StepSums& sums, SweepSums& total) const {
    const PairGeometry<double> g = geometry(scene, dt, pair);
    History& history = pair.history;
    if (g.kinematics.overlap < 0) {
      history = {};
      return;
    }
    const V3<double> n = g.kinematics.normal,
                     force_before = history.normal_force * history.normal + history.memory.shear;
    Memory<double>& memory = history.memory;
    if (dt > 0) {
      const Transport<double> transport(history.normal, n, g.half_spin);
      memory.shear = transport(memory.shear), memory.rolling = transport(memory.rolling);
    }
    const Memory<double> before = memory;
    Books<double> books;
    const auto response = Law::respond(couple(scene, pair), g.kinematics, dt, memory, books);
    if (dt == 0) memory = before;
    const Action<double> act = action(g, memory, response.normal_force);
    history.normal = n;
    history.normal_force = response.normal_force;
    history.touching = true, history.sliding = response.sliding;
    put(-act.force, contacts.loads[pair.load].force), put(-act.torque_first, contacts.loads[pair.load].torque);
    sums.add(g, before.shear, memory.shear, books);
    ++sums.contacts;
    // Of f (x) l what is not F (x) x: f at the foot of the perpendicular.
    const double height = g.kinematics.r1 - g.kinematics.overlap;
    const Vec3 foot = vector_of(scene.bodies.position[static_cast<std::size_t>(pair.grain)]) + to_eigen(height * n);
    total.force_branch += to_eigen(act.force) * foot.transpose();
    const Vec3& velocity = scene.planes.all[static_cast<std::size_t>(pair.plane)].velocity;
    total.plane_work -= 0.5 * dt * dot(force_before + act.force, from_eigen(velocity));
  }

  void stiffen(const Scene& scene, const PlanePair& pair, Load& load, Lane4& total) const {
    if (!pair.history.touching) return;
    const Kinematics<double> k = geometry(scene, 0, pair).kinematics;
    Memory<double> memory = pair.history.memory;
    Books<double> books;
    const auto r = Law::respond(couple(scene, pair), k, 0.0, memory, books);
    const V3<double> affine = affine_stiffness(k.normal, k.r1 - k.overlap, r);
    add_to(total, affine.x, affine.y, affine.z, 0.0);
    const auto [translation, rotation] = axis_stiffness(k.normal, r, k.r1);
    put(translation, load.force), put(rotation, load.torque);
  }

  Couples<Law> couples_;
  bool use_masses_, use_moments_;
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
