// One sweep over all candidate pairs, a vector register of contacts at a time. What is summed over contacts is summed
// contact by contact within a chunk of grains, and the chunks in order: every bit is independent of the width of the
// register, of the pairs listed without touching, and of the number of threads.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact_sweep.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "dem/pair_geometry.h"
#include "dem/transport.h"

namespace soilweave::dem {
namespace {

// What one contact adds to the sums of a sweep.
template <class T>
struct Contribution {
  V3<T> force_branch_x, force_branch_y, force_branch_z;  // rows of f (x) l
  V3<T> axial_stiffness;
  T force, kinematic;
  Books<T> books;
};

// Rows of four sums each, so that four contacts become four rows by transposition.
struct RowSums {
  Lane4 row[6] = {};
  Lane4 relative_overlap{};  // the largest, a lane each
  std::int64_t contacts = 0;

  void add(const Contribution<Lane4>& c) {
    const Books<Lane4>& b = c.books;
    add(0, {c.force_branch_x.x, c.force_branch_x.y, c.force_branch_x.z, c.force});
    add(1, {c.force_branch_y.x, c.force_branch_y.y, c.force_branch_y.z, c.kinematic});
    add(2, {c.force_branch_z.x, c.force_branch_z.y, c.force_branch_z.z, b.elastic_normal});
    add(3, {c.axial_stiffness.x, c.axial_stiffness.y, c.axial_stiffness.z, b.frictional});
    add(4, {b.elastic_shear, b.elastic_rolling, b.elastic_twisting, b.rolling_plastic});
    add(5, {b.shear_before, b.rolling_before, b.twisting_before, b.viscous});
  }

  void add(const Contribution<double>& c) {
    const Books<double>& b = c.books;
    row[0] += Lane4{c.force_branch_x.x, c.force_branch_x.y, c.force_branch_x.z, c.force};
    row[1] += Lane4{c.force_branch_y.x, c.force_branch_y.y, c.force_branch_y.z, c.kinematic};
    row[2] += Lane4{c.force_branch_z.x, c.force_branch_z.y, c.force_branch_z.z, b.elastic_normal};
    row[3] += Lane4{c.axial_stiffness.x, c.axial_stiffness.y, c.axial_stiffness.z, b.frictional};
    row[4] += Lane4{b.elastic_shear, b.elastic_rolling, b.elastic_twisting, b.rolling_plastic};
    row[5] += Lane4{b.shear_before, b.rolling_before, b.twisting_before, b.viscous};
  }

  void put_into(SweepSums& s) const {
    for (int a = 0; a < 3; ++a)
      for (int b = 0; b < 3; ++b) s.force_branch(a, b) += row[a][b];
    for (int a = 0; a < 3; ++a) s.axial_stiffness[a] += row[3][a];
    s.force_magnitude += row[0][3], s.kinematic += row[1][3];
    s.elastic_normal += row[2][3], s.frictional += row[3][3];
    s.elastic_shear += row[4][0], s.elastic_rolling += row[4][1], s.elastic_twisting += row[4][2];
    s.rolling_plastic += row[4][3], s.viscous += row[5][3];
    s.shear_before += row[5][0], s.rolling_before += row[5][1], s.twisting_before += row[5][2];
    for (int lane = 0; lane < width<Lane4>; ++lane)
      s.largest_relative_overlap = std::max(s.largest_relative_overlap, relative_overlap[lane]);
    s.contacts += contacts;
  }

 private:
  void add(int r, const Rows4& columns) {
    const Rows4 contact = transpose(columns);
    row[r] = row[r] + contact.a + contact.b + contact.c + contact.d;
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
  const V3<T> moment = memory.rolling + memory.twisting * n;
  const V3<T> turn = cross(n, memory.shear);
  return {normal_force * n + memory.shear, all<T>(-1) * (g.arm_1 * turn + moment), moment - g.arm_2 * turn};
}

template <class T>
Contribution<T> contribution(const PairGeometry<T>& g, const V3<T>& force, const V3<T>& shear_before,
                             const V3<T>& shear, const Response<T>& r, const Books<T>& books) {
  Contribution<T> c;
  const V3<T>& l = g.branch;
  c.force_branch_x = force.x * l, c.force_branch_y = force.y * l, c.force_branch_z = force.z * l;
  // Response of a contact to a stretch of the cell along each axis: l_a^2 (kn n_a^2 + ks (1 - n_a^2)).
  const T ks = keep(g.touching, r.shear_stiffness), difference = keep(g.touching, r.normal_stiffness) - ks;
  const V3<T>& n = g.kinematics.normal;
  c.axial_stiffness = {l.x * l.x * fused(difference, T(n.x * n.x), ks), l.y * l.y * fused(difference, T(n.y * n.y), ks),
                       l.z * l.z * fused(difference, T(n.z * n.z), ks)};
  c.force = norm(force);
  c.books = books;
  c.kinematic = 0.5 * dot(shear_before + shear, g.excess_slip);
  return c;
}

// Four lanes of a block, from lane k on.
struct Lanes {
  ContactBlock& block;
  int k;

  unsigned touching() const { return (block.touching >> k) & 15u; }
  void set_masks(unsigned touching, unsigned sliding) const {
    block.touching = (block.touching & ~(15u << k)) | (touching << k);
    block.sliding = (block.sliding & ~(15u << k)) | (sliding << k);
  }
  V3<Lane4> load3(const double (&from)[3][ContactBlock::size]) const {
    return {load<Lane4>(from[0] + k), load<Lane4>(from[1] + k), load<Lane4>(from[2] + k)};
  }
  void store3(double (&to)[3][ContactBlock::size], const V3<Lane4>& v) const {
    store(to[0] + k, v.x), store(to[1] + k, v.y), store(to[2] + k, v.z);
  }
  Memory<Lane4> memory() const { return {load3(block.shear), load3(block.rolling), load<Lane4>(block.twisting + k)}; }

  Lane4 column(const std::int32_t* from) const {
    __m128i integers;
    std::memcpy(&integers, from + k, sizeof integers);
    return _mm256_cvtepi32_pd(integers);
  }
  V3<Lane4> shift(const Mat3& h) const {
    const Lane4 a = column(block.image[0]), b = column(block.image[1]), c = column(block.image[2]);
    const auto component = [&](int i) {
      return fused(all<Lane4>(h(i, 2)), c, fused(all<Lane4>(h(i, 1)), b, h(i, 0) * a));
    };
    return {component(0), component(1), component(2)};
  }
  Rows4 rows(const std::vector<Lane4>& of, const std::int32_t* index) const {
    const Lane4* p = of.data();
    return transpose({p[index[k]], p[index[k + 1]], p[index[k + 2]], p[index[k + 3]]});
  }
  Partner<Lane4> partner(const Bodies& bodies, const std::int32_t* index) const {
    const Rows4 x = rows(bodies.position, index), v = rows(bodies.velocity, index), w = rows(bodies.spin, index);
    return {{x.a, x.b, x.c}, {v.a, v.b, v.c}, {w.a, w.b, w.c}, x.d, v.d};
  }
  void write(const std::uint32_t* slot, const V3<Lane4>& force, const V3<Lane4>& torque, std::vector<Slot>& to) const {
    const Rows4 f = transpose({force.x, force.y, force.z, Lane4{}}),
                t = transpose({torque.x, torque.y, torque.z, Lane4{}});
    to[slot[k]] = {f.a, t.a};
    to[slot[k + 1]] = {f.b, t.b};
    to[slot[k + 2]] = {f.c, t.c};
    to[slot[k + 3]] = {f.d, t.d};
  }
};

// The couples of materials, and the law's answers for them.
template <class Law>
class Couples {
 public:
  explicit Couples(const std::vector<typename Law::Material>& materials) : count_(materials.size()) {
    for (const auto& a : materials)
      for (const auto& b : materials) all_.push_back(Law::mix(a, b));
  }

  const typename Law::Couple& of(std::int32_t a, std::int32_t b) const {
    return all_[static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b)];
  }
  const std::vector<typename Law::Couple>& all() const { return all_; }

  // The law's answer in four lanes, whose couples may differ: each couple answers for all, its own lanes are taken.
  Response<Lane4> respond(const Bodies& bodies, const Lanes& lanes, const Kinematics<Lane4>& kinematics,
                          const Lane4& dt, Memory<Lane4>& memory, Books<Lane4>& books) const {
    if (all_.size() == 1) return Law::respond(all_[0], kinematics, dt, memory, books);
    const auto couple_of = [&](int lane) {
      const auto a = static_cast<std::size_t>(lanes.block.first[lanes.k + lane]);
      const auto b = static_cast<std::size_t>(lanes.block.second[lanes.k + lane]);
      return static_cast<std::int64_t>(static_cast<std::size_t>(bodies.material[a]) * count_ +
                                       static_cast<std::size_t>(bodies.material[b]));
    };
    const Mask<Lane4> couple{couple_of(0), couple_of(1), couple_of(2), couple_of(3)};
    const Memory<Lane4> before = memory;
    Response<Lane4> response = Law::respond(all_[static_cast<std::size_t>(couple[0])], kinematics, dt, memory, books);
    for (int lane = 1; lane < 4; ++lane) {
      const auto one = couple[lane];
      if (one == couple[0] || (lane > 1 && one == couple[1]) || (lane > 2 && one == couple[2])) continue;
      Memory<Lane4> other = before;
      Books<Lane4> other_books;
      const auto answer = Law::respond(all_[static_cast<std::size_t>(one)], kinematics, dt, other, other_books);
      const Mask<Lane4> mine = couple == one;
      response = select<Lane4>(mine, answer, response);
      memory = select<Lane4>(mine, other, memory);
      books = select<Lane4>(mine, other_books, books);
    }
    return response;
  }

 private:
  std::size_t count_;
  std::vector<typename Law::Couple> all_;
};

template <class Law>
class LawSweep final : public ContactSweep {
 public:
  explicit LawSweep(const std::vector<typename Law::Material>& materials) : couples_(materials) {}

  SweepSums run(const Bodies& bodies, const Cell& cell, const Planes& planes, double dt, int threads,
                Contacts& contacts) override {
    const AffineMotion affine(cell.velocity_gradient(), cell.deforming(), dt);
    const std::size_t chunks = chunks_of(bodies.size());
    sums_.assign(chunks, {});
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
      for (std::size_t b = contacts.chunk_start[chunk]; b < contacts.chunk_start[chunk + 1]; ++b)
        for (int k = 0; k < ContactBlock::size; k += width<Lane4>)
          grains(bodies, cell.matrix(), affine, dt, {contacts.blocks[b], k}, contacts.slots, sums_[chunk]);
    SweepSums total;
    for (const RowSums& s : sums_) s.put_into(total);
    RowSums with_planes;
    for (PlanePair& pair : contacts.planes) total.plane_work += plane(bodies, planes, dt, pair, contacts, with_planes);
    with_planes.put_into(total);
    return total;
  }

  void stiffnesses(const Bodies& bodies, const Cell& cell, const Planes& planes, int threads,
                   Contacts& contacts) override {
    const std::size_t chunks = chunks_of(bodies.size());
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (std::size_t chunk = 0; chunk < chunks; ++chunk)
      for (std::size_t b = contacts.chunk_start[chunk]; b < contacts.chunk_start[chunk + 1]; ++b)
        for (int k = 0; k < ContactBlock::size; k += width<Lane4>)
          grain_stiffness(bodies, cell.matrix(), {contacts.blocks[b], k}, contacts.slots);
    for (const PlanePair& pair : contacts.planes) plane_stiffness(bodies, planes, pair, contacts.slots);
  }

  double stiffness(double radius, double overlap) const override {
    Kinematics<double> kinematics{};
    kinematics.normal = {1, 0, 0};
    kinematics.overlap = overlap;
    kinematics.r1 = kinematics.r2 = radius;
    kinematics.R_star = radius / 2;
    kinematics.m_star = 1;
    double largest = 0;
    for (const auto& couple : couples_.all()) {
      Memory<double> memory{{0, 0, 0}, {0, 0, 0}, 0};
      Books<double> books;
      largest = std::max(largest, Law::respond(couple, kinematics, 0.0, memory, books).normal_stiffness);
    }
    return largest;
  }

 private:
  static PairGeometry<Lane4> geometry(const Bodies& bodies, const Mat3& cell, const AffineMotion& affine, double dt,
                                      const Lanes& lanes) {
    const Partner<Lane4> a = lanes.partner(bodies, lanes.block.first);
    Partner<Lane4> b = lanes.partner(bodies, lanes.block.second);
    if (lanes.block.folded) b.position = b.position + lanes.shift(cell);
    return grain_geometry(a, b, affine, all<Lane4>(dt));
  }

  [[gnu::flatten]] void grains(const Bodies& bodies, const Mat3& cell, const AffineMotion& affine, double dt,
                               const Lanes& lanes, std::vector<Slot>& slots, RowSums& sums) const {
    const PairGeometry<Lane4> g = geometry(bodies, cell, affine, dt, lanes);
    const unsigned touching = bits(g.touching);
    if (!touching && !lanes.touching()) return;
    ContactBlock& block = lanes.block;
    const Kinematics<Lane4>& kin = g.kinematics;
    // What has parted has no memory; then its overlap and increments, zero, give no force.
    Memory<Lane4> memory = keep(g.touching, lanes.memory());
    if (dt > 0) {
      // Memory that was zero stays zero, also where the old normal is of no meaning.
      const Transport<Lane4> carry(lanes.load3(block.normal), kin.normal, g.half_spin);
      memory.shear = carry(memory.shear), memory.rolling = carry(memory.rolling);
    }
    const Memory<Lane4> kept = memory;
    Books<Lane4> books;
    const auto response = couples_.respond(bodies, lanes, kin, all<Lane4>(dt), memory, books);
    if (dt == 0) memory = kept;  // the first sweep of a restored state changes no history
    const Action<Lane4> act = action(g, memory, response.normal_force);
    lanes.store3(block.normal, kin.normal), lanes.store3(block.shear, memory.shear);
    lanes.store3(block.rolling, memory.rolling), store(block.twisting + lanes.k, memory.twisting);
    store(block.normal_force + lanes.k, response.normal_force);
    lanes.set_masks(touching, touching & bits(response.sliding));
    lanes.write(block.slot_first, {-act.force.x, -act.force.y, -act.force.z}, act.torque_first, slots);
    lanes.write(block.slot_second, act.force, act.torque_second, slots);
    sums.add(contribution(g, act.force, kept.shear, memory.shear, response, books));
    sums.contacts += std::popcount(touching);
    sums.relative_overlap = maximum(sums.relative_overlap, kin.overlap / minimum(kin.r1, kin.r2));
  }

  [[gnu::flatten]] void grain_stiffness(const Bodies& bodies, const Mat3& cell, const Lanes& lanes,
                                        std::vector<Slot>& slots) const {
    if (!lanes.touching()) return;
    const PairGeometry<Lane4> g = geometry(bodies, cell, AffineMotion(Mat3::Zero(), false, 0), 0, lanes);
    Memory<Lane4> memory = lanes.memory();
    Books<Lane4> books;
    const auto r = couples_.respond(bodies, lanes, g.kinematics, Lane4{}, memory, books);
    const auto put = [&](const std::uint32_t* slot, const Lane4& radius) {
      const auto [translation, rotation] = axis_stiffness(g.kinematics.normal, r, radius);
      lanes.write(slot, keep(g.touching, translation), keep(g.touching, rotation), slots);
    };
    put(lanes.block.slot_first, g.kinematics.r1);
    put(lanes.block.slot_second, g.kinematics.r2);
  }

  // Diagonals of a contact's stiffness matrices about the axes (Chareyre & Villard 2005).
  template <class T>
  static std::pair<V3<T>, V3<T>> axis_stiffness(const V3<T>& n, const Response<T>& r, const T& radius) {
    const V3<T> n2{n.x * n.x, n.y * n.y, n.z * n.z}, one{all<T>(1), all<T>(1), all<T>(1)};
    const T kr = r.rolling_stiffness + r.shear_stiffness * (radius * radius);
    return {r.shear_stiffness * one + (r.normal_stiffness - r.shear_stiffness) * n2,
            kr * one + (r.twisting_stiffness - kr) * n2};
  }

  static PairGeometry<double> geometry(const Bodies& bodies, const Planes& planes, double dt, const PlanePair& pair) {
    const auto i = static_cast<std::size_t>(pair.grain);
    const Plane& p = planes.all[static_cast<std::size_t>(pair.plane)];
    const auto v3 = [](const Lane4& row) { return V3<double>{row[0], row[1], row[2]}; };
    const Partner<double> grain{v3(bodies.position[i]), v3(bodies.velocity[i]), v3(bodies.spin[i]), bodies.radius(i),
                                bodies.mass(i)};
    return plane_geometry(grain, from_eigen(p.point), from_eigen(p.normal), from_eigen(p.velocity), dt);
  }

  const typename Law::Couple& couple(const Bodies& bodies, const Planes& planes, const PlanePair& pair) const {
    return couples_.of(bodies.material[static_cast<std::size_t>(pair.grain)],
                       planes.all[static_cast<std::size_t>(pair.plane)].material);
  }

  // Returns the work done on the grain by the moving plane, J.
  double plane(const Bodies& bodies, const Planes& planes, double dt, PlanePair& pair, Contacts& contacts,
               RowSums& sums) const {
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
      const Transport<double> carry(history.normal, g.kinematics.normal, g.half_spin);
      memory.shear = carry(memory.shear), memory.rolling = carry(memory.rolling);
    }
    const Memory<double> kept = memory;
    Books<double> books;
    const auto response = Law::respond(couple(bodies, planes, pair), g.kinematics, dt, memory, books);
    if (dt == 0) memory = kept;
    const Action<double> act = action(g, memory, response.normal_force);
    history.normal = g.kinematics.normal;
    history.normal_force = response.normal_force;
    history.touching = true, history.sliding = response.sliding;
    slot = {Lane4{-act.force.x, -act.force.y, -act.force.z, 0},
            Lane4{act.torque_first.x, act.torque_first.y, act.torque_first.z, 0}};
    sums.add(contribution(g, act.force, kept.shear, memory.shear, response, books));
    ++sums.contacts;
    sums.relative_overlap = maximum(sums.relative_overlap, all<Lane4>(g.kinematics.overlap / g.kinematics.r1));
    const Vec3& velocity = planes.all[static_cast<std::size_t>(pair.plane)].velocity;
    return -0.5 * dt * dot(force_before + act.force, from_eigen(velocity));
  }

  void plane_stiffness(const Bodies& bodies, const Planes& planes, const PlanePair& pair,
                       std::vector<Slot>& slots) const {
    if (!pair.history.touching) return;
    const PairGeometry<double> g = geometry(bodies, planes, 0, pair);
    Memory<double> memory = pair.history.memory;
    Books<double> books;
    const auto r = Law::respond(couple(bodies, planes, pair), g.kinematics, 0.0, memory, books);
    const auto [translation, rotation] = axis_stiffness(g.kinematics.normal, r, g.kinematics.r1);
    slots[pair.slot] = {Lane4{translation.x, translation.y, translation.z, 0},
                        Lane4{rotation.x, rotation.y, rotation.z, 0}};
  }

  Couples<Law> couples_;
  std::vector<RowSums> sums_;
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
