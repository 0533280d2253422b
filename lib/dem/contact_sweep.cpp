// One sweep over all candidate pairs. Pairs are cut into fixed chunks whatever the number of threads, and the chunks'
// sums are added in order, so that every bit is independent of the thread count.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/contact_sweep.h"

#include <algorithm>
#include <cmath>

#include "dem/contact_kinematics.h"
#include "dem/transport.h"

namespace soilweave::dem {
namespace {

constexpr std::size_t chunk_size = 512;

V3<double> to_v3(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

// What a pair's geometry needs to know of its second partner.
struct Partner {
  V3<double> position, velocity, angular_velocity;
  double radius, mass;
  std::int32_t material;
};

template <class Law>
class LawSweep final : public ContactSweep {
 public:
  explicit LawSweep(const std::vector<typename Law::Material>& materials) : count_(materials.size()) {
    for (const auto& a : materials)
      for (const auto& b : materials) couples_.push_back(Law::mix(a, b));
  }

  SweepSums run(const Bodies& bodies, const Cell& cell, const Planes& planes, double dt, int threads,
                Contacts& contacts) const override {
    const std::size_t chunks = (contacts.size() + chunk_size - 1) / chunk_size;
    std::vector<SweepSums> sums(chunks);
#pragma omp parallel for schedule(static) num_threads(threads) if (threads > 1)
    for (std::size_t chunk = 0; chunk < chunks; ++chunk) {
      const std::size_t end = std::min(contacts.size(), (chunk + 1) * chunk_size);
      for (std::size_t k = chunk * chunk_size; k < end; ++k)
        contacts.second[k] >= 0 ? grains(bodies, cell, dt, contacts, k, sums[chunk])
                                : plane(bodies, planes, dt, contacts, k, sums[chunk]);
    }
    SweepSums total;
    for (const SweepSums& s : sums) total.add(s);
    return total;
  }

  double stiffness(double radius, double overlap) const override {
    Kinematics<double> kinematics{};
    kinematics.normal = {1, 0, 0};
    kinematics.overlap = overlap;
    kinematics.r1 = kinematics.r2 = radius;
    kinematics.R_star = radius / 2;
    kinematics.m_star = 1;
    double largest = 0;
    for (const auto& couple : couples_) {
      Memory<double> memory{{0, 0, 0}, {0, 0, 0}, 0};
      Books<double> books;
      largest = std::max(largest, Law::respond(couple, kinematics, 0.0, memory, books).normal_stiffness);
    }
    return largest;
  }

 private:
  void grains(const Bodies& bodies, const Cell& cell, double dt, Contacts& contacts, std::size_t k,
              SweepSums& sums) const {
    const auto i = static_cast<std::size_t>(contacts.first[k]), j = static_cast<std::size_t>(contacts.second[k]);
    V3<double> d = bodies.position[j] - bodies.position[i];
    const Vec3i& image = contacts.image[k];
    if (image[0] || image[1] || image[2]) d = d + to_v3(cell.matrix() * image.cast<double>());
    const double reach = bodies.radius[i] + bodies.radius[j], distance_squared = norm2(d);
    if (distance_squared > reach * reach) {
      if (contacts.touching[k]) contacts.clear(k);
      return;
    }
    const double distance = std::sqrt(distance_squared);
    V3<double> velocity = bodies.velocity[j] - bodies.velocity[i];
    // Affine closing over the step, at the branch before the cell moved, to first order in the step.
    if (cell.deforming()) velocity = velocity + to_v3(affine(cell, d, dt));
    PairMotion<double> motion;
    motion.velocity = velocity;
    motion.spin_1 = bodies.angular_velocity[i], motion.spin_2 = bodies.angular_velocity[j];
    motion.lever_1 = bodies.radius[i], motion.lever_2 = bodies.radius[j];
    motion.distance = distance;
    motion.normal = (1.0 / distance) * d;
    const double overlap = reach - distance;
    Kinematics<double> kin = pair_kinematics(motion, dt);
    kin.overlap = overlap;
    kin.r1 = bodies.radius[i], kin.r2 = bodies.radius[j];
    kin.R_star = kin.r1 * kin.r2 / reach;
    kin.m_star = bodies.mass[i] * bodies.mass[j] / (bodies.mass[i] + bodies.mass[j]);
    contacts.branch[k] = d;
    respond(couple(bodies.material[i], bodies.material[j]), kin, motion, kin.r1 - 0.5 * overlap, kin.r2 - 0.5 * overlap,
            dt, contacts, k, sums);
  }

  // Levers are the full radius, for slip and torque alike: work-conjugate, and the rigid-body limit of the benchmarks.
  void plane(const Bodies& bodies, const Planes& planes, double dt, Contacts& contacts, std::size_t k,
             SweepSums& sums) const {
    const auto i = static_cast<std::size_t>(contacts.first[k]);
    const Plane& plane = planes.all[plane_number(contacts.second[k])];
    const V3<double> inward = to_v3(plane.normal);
    const double height = dot(bodies.position[i] - to_v3(plane.point), inward);
    const double overlap = bodies.radius[i] - height;
    if (overlap < 0) {
      if (contacts.touching[k]) contacts.clear(k);
      return;
    }
    PairMotion<double> motion;
    motion.velocity = to_v3(plane.velocity) - bodies.velocity[i];
    motion.spin_1 = bodies.angular_velocity[i], motion.spin_2 = {0, 0, 0};
    motion.lever_1 = bodies.radius[i], motion.lever_2 = 0;
    motion.distance = bodies.radius[i];
    motion.normal = -1.0 * inward;
    Kinematics<double> kin = pair_kinematics(motion, dt);
    kin.overlap = overlap;
    kin.r1 = kin.r2 = kin.R_star = bodies.radius[i];
    kin.m_star = bodies.mass[i];
    contacts.branch[k] = height * motion.normal;
    const V3<double> before = contacts.force[k];
    respond(couple(bodies.material[i], plane.material), kin, motion, kin.r1, 0.0, dt, contacts, k, sums);
    sums.plane_work -= 0.5 * dt * dot(before + contacts.force[k], to_v3(plane.velocity));
  }

  static Vec3 affine(const Cell& cell, const V3<double>& d, double dt) {
    const Vec3 now(d.x, d.y, d.z);
    const Mat3& gradient = cell.velocity_gradient();
    return gradient * (now - dt * (gradient * now));
  }

  void respond(const typename Law::Couple& couple, const Kinematics<double>& kin, const PairMotion<double>& motion,
               double arm_1, double arm_2, double dt, Contacts& contacts, std::size_t k, SweepSums& sums) const {
    Memory<double>& memory = contacts.memory[k];
    if (contacts.touching[k] && dt > 0) {
      const double spin = 0.5 * dt * dot(kin.normal, motion.spin_1 + motion.spin_2);
      memory.shear = transport(memory.shear, contacts.normal[k], kin.normal, spin);
      memory.rolling = transport(memory.rolling, contacts.normal[k], kin.normal, spin);
    }
    const V3<double> shear_before = memory.shear;
    Books<double> books;
    const Memory<double> kept = memory;
    const auto response = Law::respond(couple, kin, dt, memory, books);
    if (dt == 0) memory = kept;  // the first sweep of a restored state changes no history
    contacts.touching[k] = 1;
    contacts.normal[k] = kin.normal;
    contacts.overlap[k] = kin.overlap;
    contacts.normal_force[k] = response.normal_force;
    contacts.sliding[k] = response.sliding != 0;
    contacts.normal_stiffness[k] = response.normal_stiffness;
    contacts.shear_stiffness[k] = response.shear_stiffness;
    contacts.rolling_stiffness[k] = response.rolling_stiffness;
    contacts.twisting_stiffness[k] = response.twisting_stiffness;
    const V3<double> force = response.normal_force * kin.normal + memory.shear;
    const V3<double> moment = memory.rolling + memory.twisting * kin.normal;
    const V3<double> turn = cross(kin.normal, memory.shear);
    contacts.force[k] = force;
    contacts.torque_first[k] = -1.0 * (arm_1 * turn + moment);
    contacts.torque_second[k] = moment - arm_2 * turn;
    tally(kin, motion, arm_1, arm_2, dt, shear_before, books, contacts, k, sums);
  }

  static void tally(const Kinematics<double>& kin, const PairMotion<double>& motion, double arm_1, double arm_2,
                    double dt, const V3<double>& shear_before, const Books<double>& books, const Contacts& contacts,
                    std::size_t k, SweepSums& sums) {
    const V3<double>& f = contacts.force[k];
    const V3<double>& l = contacts.branch[k];
    sums.force_branch += Vec3(f.x, f.y, f.z) * Vec3(l.x, l.y, l.z).transpose();
    sums.axial_stiffness += affine_stiffness(kin.normal, l, contacts.normal_stiffness[k], contacts.shear_stiffness[k]);
    sums.force_magnitude += std::sqrt(norm2(f));
    sums.largest_relative_overlap = std::max(sums.largest_relative_overlap, kin.overlap / std::min(kin.r1, kin.r2));
    ++sums.contacts;
    sums.elastic_normal += books.elastic_normal;
    sums.elastic_shear += books.elastic_shear;
    sums.elastic_rolling += books.elastic_rolling;
    sums.elastic_twisting += books.elastic_twisting;
    sums.shear_before += books.shear_before;
    sums.rolling_before += books.rolling_before;
    sums.twisting_before += books.twisting_before;
    sums.frictional += books.frictional;
    sums.rolling_plastic += books.rolling_plastic;
    sums.viscous += books.viscous;
    const V3<double> true_slip = dt * tangential_velocity(motion, arm_1, arm_2);
    sums.kinematic -= 0.5 * dot(shear_before + contacts.memory[k].shear, true_slip - kin.slip);
  }

  // Stress response of a contact to a stretch of the cell along each axis: l_a^2 (kn n_a^2 + ks (1 - n_a^2)).
  static Vec3 affine_stiffness(const V3<double>& n, const V3<double>& l, double kn, double ks) {
    const Vec3 n2(n.x * n.x, n.y * n.y, n.z * n.z), l2(l.x * l.x, l.y * l.y, l.z * l.z);
    return l2.cwiseProduct(ks * Vec3::Ones() + (kn - ks) * n2);
  }

  const typename Law::Couple& couple(std::int32_t a, std::int32_t b) const {
    return couples_[static_cast<std::size_t>(a) * count_ + static_cast<std::size_t>(b)];
  }

  std::size_t count_;
  std::vector<typename Law::Couple> couples_;
};

template <class Law>
std::unique_ptr<ContactSweep> make(const std::vector<typename Law::Material>& materials) {
  return std::make_unique<LawSweep<Law>>(materials);
}

}  // namespace

void SweepSums::add(const SweepSums& o) {
  force_branch += o.force_branch;
  axial_stiffness += o.axial_stiffness;
  force_magnitude += o.force_magnitude;
  largest_relative_overlap = std::max(largest_relative_overlap, o.largest_relative_overlap);
  elastic_normal += o.elastic_normal, elastic_shear += o.elastic_shear;
  elastic_rolling += o.elastic_rolling, elastic_twisting += o.elastic_twisting;
  shear_before += o.shear_before, rolling_before += o.rolling_before, twisting_before += o.twisting_before;
  frictional += o.frictional, rolling_plastic += o.rolling_plastic, viscous += o.viscous;
  kinematic += o.kinematic, plane_work += o.plane_work;
  contacts += o.contacts;
}

std::unique_ptr<ContactSweep> make_contact_sweep(const Model& model) {
  return std::visit(
      []<class Material>(const std::vector<Material>& materials) { return make<typename Material::Law>(materials); },
      model.materials);
}

}  // namespace soilweave::dem
