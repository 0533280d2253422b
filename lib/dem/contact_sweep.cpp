// One sweep over all candidate pairs, a vector register of contacts at a time. What is summed over contacts is summed
// contact by contact within a chunk of grains, and the chunks in order: every bit is independent of the width of the
// register, of the pairs listed without touching, and of the number of threads.
//
// A contact is a long chain of dependent operations, square roots and divisions among them. So the sweep takes a batch
// of registers through one stage after the other (approach, carry, act): within a stage the processor works on
// several of them at once, and a batch stays in its first cache.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact_sweep.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <span>

#include "dem/block_lanes.h"
#include "dem/couples.h"
#include "dem/row_sums.h"
#include "dem/transport.h"

namespace soilweave::dem {
namespace {

// What a step sums over the contacts of a chunk.
struct StepSums {
  RowSums<4> rows;
  Lane4 relative_overlap{};  // the largest, a lane each
  std::int64_t contacts = 0;

  template <class T>
  void add(const PairGeometry<T>& g, const V3<T>& force, const V3<T>& shear_before, const V3<T>& shear,
           const Books<T>& b) {
    const V3<T>& l = g.branch;
    const T stored = b.elastic_shear + b.elastic_rolling + b.elastic_twisting;
    const T before = b.shear_before + b.rolling_before + b.twisting_before;
    const T kinematic = 0.5 * dot(shear_before + shear, g.excess_slip);
    rows.add(0, T(force.x * l.x), T(force.x * l.y), T(force.x * l.z), b.elastic_normal);
    rows.add(1, T(force.y * l.x), T(force.y * l.y), T(force.y * l.z), stored);
    rows.add(2, T(force.z * l.x), T(force.z * l.y), T(force.z * l.z), before);
    rows.add(3, b.frictional, b.rolling_plastic, b.viscous, kinematic);
    const T relative = g.kinematics.overlap / minimum(g.kinematics.r1, g.kinematics.r2);
    relative_overlap = maximum(relative_overlap, relative + Lane4{});
  }

  void put_into(SweepSums& s) const {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) s.force_branch(a, b) += rows.row[a][b];
    s.elastic_normal += rows.row[0][3], s.elastic_tangential += rows.row[1][3], s.tangential_before += rows.row[2][3];
    s.frictional += rows.row[3][0], s.rolling_plastic += rows.row[3][1];
    s.viscous += rows.row[3][2], s.kinematic += rows.row[3][3];
    for (int lane = 0; lane < width<Lane4>; ++lane)
      s.largest_relative_overlap = std::max(s.largest_relative_overlap, relative_overlap[lane]);
    s.contacts += contacts;
  }
};

// What a survey sums over them.
struct SurveySums {
  RowSums<2> rows;

  template <class T>
  void add(const PairGeometry<T>& g, const Response<T>& r, const Books<T>& b) {
    // Response of a contact to a stretch of the cell along each axis: l_a^2 (kn n_a^2 + ks (1 - n_a^2)).
    const T ks = keep(g.touching, r.shear_stiffness), difference = keep(g.touching, r.normal_stiffness) - ks;
    const V3<T>&n = g.kinematics.normal, &l = g.branch;
    const auto along = [&](const T& n_a, const T& l_a) { return T(l_a * l_a * fused(difference, T(n_a * n_a), ks)); };
    rows.add(0, along(n.x, l.x), along(n.y, l.y), along(n.z, l.z), b.elastic_shear);
    rows.add(1, b.elastic_rolling, b.elastic_twisting, all<T>(0), all<T>(0));
  }

  void put_into(Survey& s) const {
    for (int a = 0; a < 3; ++a) s.axial_stiffness[a] += rows.row[0][a];
    s.elastic_shear += rows.row[0][3], s.elastic_rolling += rows.row[1][0], s.elastic_twisting += rows.row[1][1];
  }
};

// The force and the torques of a contact.
template <class T>
struct Action {
  V3<T> force;                        // N, on the second body
  V3<T> torque_first, torque_second;  // N m
};

template <class T>
Action<T> action(const PairGeometry<T>& g, const Memory<T>& memory, const T& normal_force) {
  const V3<T>& n = g.kinematics.normal;
  const V3<T> moment = fused(memory.twisting, n, memory.rolling);
  const V3<T> turn = cross(n, memory.shear);
  return {fused(normal_force, n, memory.shear), fused(T(-g.arm_1), turn, -moment), fused(T(-g.arm_2), turn, moment)};
}

// Diagonals of a contact's stiffness matrices about the axes (Chareyre & Villard 2005).
template <class T>
std::pair<V3<T>, V3<T>> axis_stiffness(const V3<T>& n, const Response<T>& r, const T& radius) {
  const V3<T> n2{n.x * n.x, n.y * n.y, n.z * n.z}, one{all<T>(1), all<T>(1), all<T>(1)};
  const T kr = r.rolling_stiffness + r.shear_stiffness * (radius * radius);
  return {r.shear_stiffness * one + (r.normal_stiffness - r.shear_stiffness) * n2,
          kr * one + (r.twisting_stiffness - kr) * n2};
}

// Four pairs on their way through the stages.
struct Four {
  BlockLanes lanes;
  unsigned touching;
  PairGeometry<Lane4> geometry;
  Memory<Lane4> memory;  // carried to the present normal
};
constexpr std::size_t batch_size = 8;  // what the first cache holds
using Batch = std::span<Four>;

template <class Law>
class LawSweep final : public ContactSweep {
 public:
  explicit LawSweep(const std::vector<typename Law::Material>& materials) : couples_(materials) {}

  SweepSums run(const Bodies& bodies, const Cell& cell, const Planes& planes, double dt, int threads,
                Contacts& contacts) override {
    const AffineMotion affine(cell.velocity_gradient(), cell.deforming(), dt);
    const std::size_t chunks = chunks_of(bodies.size());
    step_sums_.assign(chunks, {});
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
      in_batches(contacts, chunk, bodies, cell.matrix(), affine, [&](Batch batch) {
        carry(batch, dt);
        act(batch, bodies, dt, contacts.slots, step_sums_[chunk]);
      });
    SweepSums total;
    for (const StepSums& s : step_sums_) s.put_into(total);
    StepSums with_planes;
    for (PlanePair& pair : contacts.planes) total.plane_work += plane(bodies, planes, dt, pair, contacts, with_planes);
    with_planes.put_into(total);
    return total;
  }

  Survey survey(const Bodies& bodies, const Cell& cell, const Planes& planes, int threads,
                Contacts& contacts) override {
    const AffineMotion still(Mat3::Zero(), false, 0);
    const std::size_t chunks = chunks_of(bodies.size());
    survey_sums_.assign(chunks, {});
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
      in_batches(contacts, chunk, bodies, cell.matrix(), still, [&](Batch batch) {
        carry(batch, 0);
        look(batch, bodies, contacts.slots, survey_sums_[chunk]);
      });
    Survey total;
    for (const SurveySums& s : survey_sums_) s.put_into(total);
    SurveySums with_planes;
    for (const PlanePair& pair : contacts.planes) look(bodies, planes, pair, contacts.slots, with_planes);
    with_planes.put_into(total);
    return total;
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
  // Takes the pairs of a chunk that touch, or did so in the last step, batch by batch to `stages`.
  template <class Stages>
  static void in_batches(Contacts& contacts, std::size_t chunk, const Bodies& bodies, const Mat3& cell,
                         const AffineMotion& affine, const Stages& stages) {
    std::array<Four, batch_size> fours;
    ContactBlock* next = contacts.blocks.data() + contacts.chunk_start[chunk];
    ContactBlock* const end = contacts.blocks.data() + contacts.chunk_start[chunk + 1];
    while (next != end) {
      std::size_t n = 0;
      next = approach(next, end, bodies, cell, affine, fours, n);
      if (n) stages(Batch(fours.data(), n));
    }
  }

  // Fills the batch from `next` on; returns the first block not looked at. n: how many were filled.
  [[gnu::noinline, gnu::flatten]] static ContactBlock* approach(ContactBlock* next, ContactBlock* end,
                                                                const Bodies& bodies, const Mat3& cell,
                                                                const AffineMotion& affine,
                                                                std::array<Four, batch_size>& fours, std::size_t& n) {
    constexpr std::size_t per_block = ContactBlock::size / width<Lane4>;
    for (; next != end && n + per_block <= batch_size; ++next)
      for (int k = 0; k < ContactBlock::size; k += width<Lane4>) {
        const BlockLanes lanes{next, k};
        Four& four = fours[n];
        four.lanes = lanes;
        dem::approach(lanes.meeting(bodies, cell), affine, four.geometry);
        four.touching = bits(four.geometry.touching);
        n += (four.touching | lanes.touching()) != 0;
      }
    return next;
  }

  [[gnu::noinline, gnu::flatten]] static void carry(Batch batch, double dt) {
    for (Four& four : batch) {
      PairGeometry<Lane4>& g = four.geometry;
      increments(all<Lane4>(dt), g);
      // What has parted has no memory; then its overlap and increments, zero, give no force.
      Memory<Lane4> memory = keep(g.touching, four.lanes.memory());
      if (dt > 0) {
        // Memory that was zero stays zero, also where the old normal is of no meaning.
        const Transport<Lane4> transport(four.lanes.load3(four.lanes.block->normal), g.kinematics.normal, g.half_spin);
        memory.shear = transport(memory.shear), memory.rolling = transport(memory.rolling);
      }
      four.memory = memory;
    }
  }

  [[gnu::noinline, gnu::flatten]] void act(Batch batch, const Bodies& bodies, double dt, std::vector<Slot>& slots,
                                           StepSums& sums) const {
    for (const Four& four : batch) {
      const BlockLanes lanes = four.lanes;
      ContactBlock& block = *lanes.block;
      const PairGeometry<Lane4>& g = four.geometry;
      Memory<Lane4> memory = four.memory;
      Books<Lane4> books;
      const auto response = couples_.respond(bodies, lanes, g.kinematics, all<Lane4>(dt), memory, books);
      if (dt == 0) memory = four.memory;  // the first sweep of a restored state changes no history
      lanes.store3(block.normal, g.kinematics.normal), lanes.store3(block.shear, memory.shear);
      lanes.store3(block.rolling, memory.rolling), store(block.twisting + lanes.k, memory.twisting);
      store(block.normal_force + lanes.k, response.normal_force);
      lanes.set_masks(four.touching, four.touching & bits(response.sliding));
      const Action<Lane4> act = action(g, memory, response.normal_force);
      lanes.write(block.slot_first, -act.force, act.torque_first, slots);
      lanes.write(block.slot_second, act.force, act.torque_second, slots);
      sums.add(g, act.force, four.memory.shear, memory.shear, books);
      sums.contacts += std::popcount(four.touching);
    }
  }

  [[gnu::noinline, gnu::flatten]] void look(Batch batch, const Bodies& bodies, std::vector<Slot>& slots,
                                            SurveySums& sums) const {
    for (const Four& four : batch) {
      const PairGeometry<Lane4>& g = four.geometry;
      Memory<Lane4> memory = four.memory;
      Books<Lane4> books;
      const auto response = couples_.respond(bodies, four.lanes, g.kinematics, Lane4{}, memory, books);
      sums.add(g, response, books);
      const auto put = [&](const std::uint32_t* slot, const Lane4& radius) {
        const auto [translation, rotation] = axis_stiffness(g.kinematics.normal, response, radius);
        four.lanes.write(slot, keep(g.touching, translation), keep(g.touching, rotation), slots);
      };
      put(four.lanes.block->slot_first, g.kinematics.r1);
      put(four.lanes.block->slot_second, g.kinematics.r2);
    }
  }

  static PairGeometry<double> geometry(const Bodies& bodies, const Planes& planes, double dt, const PlanePair& pair) {
    const auto i = static_cast<std::size_t>(pair.grain);
    const Plane& p = planes.all[static_cast<std::size_t>(pair.plane)];
    const auto v3 = [](const Lane4& row) { return V3<double>{row[0], row[1], row[2]}; };
    const V3<double> inward = from_eigen(p.normal);
    const double height = dot(v3(bodies.position[i]) - from_eigen(p.point), inward);
    Meeting<double> m{};
    m.velocity = from_eigen(p.velocity) - v3(bodies.velocity[i]);
    m.spin_1 = v3(bodies.spin[i]);
    m.r1 = bodies.radius(i), m.m1 = bodies.mass(i);
    return plane_geometry(m, height, inward, dt);
  }

  const typename Law::Couple& couple(const Bodies& bodies, const Planes& planes, const PlanePair& pair) const {
    return couples_.of(bodies.material[static_cast<std::size_t>(pair.grain)],
                       planes.all[static_cast<std::size_t>(pair.plane)].material);
  }

  // Returns the work done on the grain by the moving plane, J.
  double plane(const Bodies& bodies, const Planes& planes, double dt, PlanePair& pair, Contacts& contacts,
               StepSums& sums) const {
    const PairGeometry<double> g = geometry(bodies, planes, dt, pair);
    History& history = pair.history;
    Slot& slot = contacts.slots[pair.slot];
    if (!g.touching) {
      history = {};
      slot = Slot{};
      return 0;
    }
    const V3<double> force_before = history.normal_force * history.normal + history.memory.shear;
    Memory<double>& memory = history.memory;
    if (dt > 0) {
      const Transport<double> transport(history.normal, g.kinematics.normal, g.half_spin);
      memory.shear = transport(memory.shear), memory.rolling = transport(memory.rolling);
    }
    const Memory<double> before = memory;
    Books<double> books;
    const auto response = Law::respond(couple(bodies, planes, pair), g.kinematics, dt, memory, books);
    if (dt == 0) memory = before;
    const Action<double> act = action(g, memory, response.normal_force);
    history.normal = g.kinematics.normal;
    history.normal_force = response.normal_force;
    history.touching = true, history.sliding = response.sliding;
    slot = {Lane4{-act.force.x, -act.force.y, -act.force.z, 0},
            Lane4{act.torque_first.x, act.torque_first.y, act.torque_first.z, 0}};
    sums.add(g, act.force, before.shear, memory.shear, books);
    ++sums.contacts;
    const Vec3& velocity = planes.all[static_cast<std::size_t>(pair.plane)].velocity;
    return -0.5 * dt * dot(force_before + act.force, from_eigen(velocity));
  }

  void look(const Bodies& bodies, const Planes& planes, const PlanePair& pair, std::vector<Slot>& slots,
            SurveySums& sums) const {
    if (!pair.history.touching) return;
    const PairGeometry<double> g = geometry(bodies, planes, 0, pair);
    Memory<double> memory = pair.history.memory;
    Books<double> books;
    const auto r = Law::respond(couple(bodies, planes, pair), g.kinematics, 0.0, memory, books);
    sums.add(g, r, books);
    const auto [translation, rotation] = axis_stiffness(g.kinematics.normal, r, g.kinematics.r1);
    slots[pair.slot] = {Lane4{translation.x, translation.y, translation.z, 0},
                        Lane4{rotation.x, rotation.y, rotation.z, 0}};
  }

  Couples<Law> couples_;
  std::vector<StepSums> step_sums_;
  std::vector<SurveySums> survey_sums_;
};

template <class Law>
std::unique_ptr<ContactSweep> make(const std::vector<typename Law::Material>& materials) {
  return std::make_unique<LawSweep<Law>>(materials);
}

}  // namespace

std::unique_ptr<ContactSweep> make_contact_sweep(const Model& model) {
  return std::visit(
      []<class Material>(const std::vector<Material>& materials) { return make<typename Material::Law>(materials); },
      model.materials);
}

}  // namespace soilweave::dem
