// The finite elements.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/model/soil.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "core/linear_algebra.h"

namespace soilweave::fem {
namespace {

Eigen::Index row(Index i) { return static_cast<Eigen::Index>(i); }

void archive_pairs(Archive& a, const std::string& name, std::vector<Vec2>& values) {
  std::vector<double> flat;
  for (const Vec2& v : values) flat.insert(flat.end(), {v[0], v[1]});
  a.sized(name, flat);
  for (Index i = 0; i < values.size(); ++i) values[i] = Vec2(flat.at(2 * i), flat.at(2 * i + 1));
}

double velocity_of(const HeldMotion& motion, const Vec2& position) {
  return motion.constant + motion.gradient.dot(position);
}

// Returns whether two motions are equal, or both leave the node at rest. reach: distance of the farthest node from the
// origin, m.
bool equal_motions(const HeldMotion& a, const HeldMotion& b, const Vec2& position, double reach) {
  const auto stands = [&](const HeldMotion& m) {
    return std::abs(velocity_of(m, position)) <= 1e-12 * (std::abs(m.constant) + m.gradient.norm() * reach);
  };
  return (a.constant == b.constant && a.gradient == b.gradient) || (stands(a) && stands(b));
}

std::string text_of(const HeldMotion& motion) {
  const Vec2& g = motion.gradient;
  return g.isZero(0) ? fmt::format("{:.6g} m/s", motion.constant)
                     : fmt::format("{:.6g} m/s plus the gradient ({:.6g}, {:.6g}) 1/s", motion.constant, g[0], g[1]);
}

// Returns the motion that a support holds along an axis, if any.
std::optional<HeldMotion> motion_along(const Support& support, Eigen::Index axis, Index number) {
  const std::optional<double>& constant = axis == 0 ? support.x : support.y;
  if (!constant && !support.gradient) return std::nullopt;
  HeldMotion motion{constant.value_or(0), Vec2::Zero(), number};
  if (support.gradient) motion.gradient = support.gradient->row(axis);
  return motion;
}

}  // namespace

std::vector<HeldNode> held_nodes(const Mesh& mesh, const std::vector<Support>& supports) {
  std::vector<HeldNode> held(mesh.nodes.size());
  double reach = 0;
  for (const Vec2& x : mesh.nodes) reach = std::max(reach, x.norm());
  for (Index k = 0; k < supports.size(); ++k)
    for (const Index n : mesh.nodes_on(supports[k].boundary))
      for (const std::size_t axis : {0, 1}) {
        const auto motion = motion_along(supports[k], row(axis), k);
        std::optional<HeldMotion>& known = held[n][axis];
        const Vec2& x = mesh.nodes[n];
        if (motion && known && !equal_motions(*known, *motion, x, reach))
          throw DataError(
              fmt::format("the supports on \"{}\" and \"{}\" move their common node at ({:.4g}, {:.4g}) m differently "
                          "along {}: by {} and by {}; give both one velocity, or leave the axis out of one of them",
                          supports[known->support].boundary, supports[k].boundary, x[0], x[1], "xy"[axis],
                          text_of(*known), text_of(*motion)));
        if (!known) known = motion;
      }
  return held;
}

std::vector<Vec2> traction_forces(const Mesh& mesh, const std::vector<Vec2>& positions,
                                  const std::vector<Traction>& tractions) {
  std::vector<Vec2> forces(positions.size(), Vec2::Zero());
  for (const Traction& t : tractions) {
    const Boundary& b = mesh.boundary_with_edges(t.boundary);
    for (Index k = 0; k < b.ends.size(); ++k) {
      const auto [first, second] = b.ends[k];
      const Vec2 force = t.value * (positions[second] - positions[first]).norm();
      const double at_end = b.middle.empty() ? 0.5 : 1.0 / 6;
      forces[first] += at_end * force;
      forces[second] += at_end * force;
      if (!b.middle.empty()) forces[b.middle[k]] += 2.0 / 3 * force;
    }
  }
  return forces;
}

Mat2 rounded_gradient(const Mat2& gradient) {
  constexpr double fine = 0x1p60;
  return (gradient * fine).array().round().matrix() / fine;
}

Soil::Soil(SoilSetup setup)
    : setup_(std::move(setup)), rule_(integration_points(setup_.mesh.shape, setup_.integration)) {
  setup_.mesh.check("the mesh");
  const Index nodes = setup_.mesh.nodes.size();
  positions_ = setup_.mesh.nodes;
  displacements_.assign(nodes, Vec2::Zero());
  velocities_ = increments_ = internal_ = displacements_;
  gradients_.assign(points(), Mat2::Zero());
  strains_ = gradients_;
  lump();
  held_ = held_nodes(mesh(), setup_.supports);
  for (const Traction& t : setup_.tractions) mesh().boundary_with_edges(t.boundary);
}

void Soil::lump() {
  const Shape shape = mesh().shape;
  const auto full = integration_points(shape, Integration::full);
  masses_.assign(positions_.size(), 0);
  for (Index e = 0; e < mesh().elements.size(); ++e) {
    NodeValues diagonal = NodeValues::Zero(row(mesh().nodes_of_element()));
    double area = 0;
    for (const IntegrationPoint& p : full) {
      const double part = p.weight * fem::gradients(shape, p.at, mesh().corners(e, positions_)).area;
      diagonal += part * shape_functions(shape, p.at).cwiseAbs2();
      area += part;
    }
    diagonal *= setup_.density * area / diagonal.sum();
    for (Index k = 0; k < mesh().nodes_of_element(); ++k) masses_[mesh().elements[e][k]] += diagonal[row(k)];
  }
}

double Soil::largest_eigenvalue(const std::function<Mat3(Index point)>& tangent) const {
  const Shape shape = mesh().shape;
  const auto n = row(mesh().nodes_of_element());
  double largest = 0;
  for (Index e = 0; e < mesh().elements.size(); ++e) {
    const ElementNodes x = mesh().corners(e, positions_);
    Eigen::MatrixXd K = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    NodeValues mass = NodeValues::Zero(n);
    double area = 0;
    for (const IntegrationPoint& p : integration_points(shape, Integration::full)) {
      const double part = p.weight * fem::gradients(shape, p.at, x).area;
      mass += part * shape_functions(shape, p.at).cwiseAbs2();
      area += part;
    }
    mass *= setup_.density * area / mass.sum();
    for (Index q = 0; q < rule_.size(); ++q) {
      const Gradients g = fem::gradients(shape, rule_[q].at, x);
      Eigen::Matrix<double, 3, Eigen::Dynamic> B = Eigen::MatrixXd::Zero(3, 2 * n);
      for (Eigen::Index k = 0; k < n; ++k) {
        B(0, 2 * k) = B(2, 2 * k + 1) = g.dN(0, k);
        B(1, 2 * k + 1) = B(2, 2 * k) = g.dN(1, k);
      }
      K += rule_[q].weight * g.area * B.transpose() * tangent(e * rule_.size() + q) * B;
    }
    for (Eigen::Index i = 0; i < 2 * n; ++i)
      for (Eigen::Index j = 0; j < 2 * n; ++j) K(i, j) /= std::sqrt(mass[i / 2] * mass[j / 2]);
    largest = std::max(largest, soilweave::largest_eigenvalue(K));
  }
  return largest;
}

std::vector<Vec2> Soil::internal_forces(const std::vector<Mat2>& stresses) const {
  std::vector<Vec2> forces(positions_.size(), Vec2::Zero());
  for (Index e = 0; e < mesh().elements.size(); ++e) {
    const ElementNodes x = mesh().corners(e, positions_);
    for (Index q = 0; q < rule_.size(); ++q) {
      const Gradients g = fem::gradients(mesh().shape, rule_[q].at, x);
      if (!(g.area > 0))
        throw PhysicsError(fmt::format(
            "element {} has the area {:.3g} m2 at its point {}: it was crushed or turned over; take a finer mesh or a "
            "stiffer soil there, or load it less",
            e, g.area, q));
      const ElementNodes f = rule_[q].weight * g.area * stresses[e * rule_.size() + q] * g.dN;
      for (Index k = 0; k < mesh().nodes_of_element(); ++k) forces[mesh().elements[e][k]] += f.col(row(k));
    }
  }
  return forces;
}

void Soil::support(Index node, Vec2& velocity, bool* fixed) const {
  for (int a = 0; a < 2; ++a) {
    const std::optional<HeldMotion>& held = held_[node][static_cast<std::size_t>(a)];
    fixed[a] = held.has_value();
    if (fixed[a]) velocity[a] = standing_ ? 0 : velocity_of(*held, positions_[node]);
  }
}

void Soil::step(const std::vector<Mat2>& stresses, const std::vector<Vec2>& interface_forces, double dt) {
  internal_ = internal_forces(stresses);
  const std::vector<Vec2> traction = traction_forces(mesh(), positions_, setup_.tractions);
  // Work is force times the mean velocity of the step, so energies balance to rounding (Belytschko et al. 2014, 6.2.3).
  const double c = damping_.value_or(setup_.damping), half = 0.5 * c * dt;
  for (Index n = 0; n < positions_.size(); ++n) {
    const Vec2 before = velocities_[n], force = traction[n] + interface_forces[n] - internal_[n];
    Vec2 v = ((1 - half) * before + dt / masses_[n] * force) / (1 + half);
    const Vec2 free = v;
    bool fixed[2];
    support(n, v, fixed);
    const Vec2 impulse = (1 + half) * masses_[n] * (v - free);  // of the support
    energies_.viscous += 0.25 * c * masses_[n] * (before + v).squaredNorm() * dt;
    energies_.support_work += 0.5 * impulse.dot(before + v);
    energies_.traction_work += 0.5 * dt * traction[n].dot(before + v);
    energies_.interface_work += 0.5 * dt * interface_forces[n].dot(before + v);
    energies_.internal_work += 0.5 * dt * internal_[n].dot(before + v);
    velocities_[n] = v;
    increments_[n] = dt * v;
  }
  for (Index e = 0; e < mesh().elements.size(); ++e) {
    const ElementNodes x = mesh().corners(e, positions_), u = mesh().corners(e, increments_);
    for (Index q = 0; q < rule_.size(); ++q) {
      const Index p = e * rule_.size() + q;
      gradients_[p] = rounded_gradient(u * fem::gradients(mesh().shape, rule_[q].at, x).dN.transpose());
      strains_[p] += gradients_[p];
    }
  }
  for (Index n = 0; n < positions_.size(); ++n) {
    displacements_[n] += increments_[n];
    positions_[n] += increments_[n];
  }
}

double Soil::kinetic_energy() const {
  double sum = 0;
  for (Index n = 0; n < masses_.size(); ++n) sum += 0.5 * masses_[n] * velocities_[n].squaredNorm();
  return sum;
}

SoilEnergies Soil::energies() const {
  SoilEnergies e = energies_;
  e.kinetic = kinetic_energy();
  return e;
}

SoilPoint Soil::soil_point(Index point) const {
  const Index e = point / rule_.size();
  const IntegrationPoint& p = rule_[point % rule_.size()];
  const ElementNodes x = mesh().corners(e, positions_);
  return {e, x * shape_functions(mesh().shape, p.at), p.weight * fem::gradients(mesh().shape, p.at, x).area};
}

std::vector<Mat2> Soil::at_nodes(const std::vector<Mat2>& values) const {
  std::vector<Mat2> sums(positions_.size(), Mat2::Zero());
  std::vector<double> areas(positions_.size(), 0);
  for (Index p = 0; p < points(); ++p) {
    const SoilPoint at = soil_point(p);
    for (Index k = 0; k < mesh().nodes_of_element(); ++k) {
      const Index n = mesh().elements[at.element][k];
      sums[n] += at.area * values[p];
      areas[n] += at.area;
    }
  }
  for (Index n = 0; n < sums.size(); ++n) sums[n] /= areas[n];
  return sums;
}

Vec2 Soil::reaction(const std::string& boundary) const {
  Vec2 sum = Vec2::Zero();
  for (const Index n : mesh().boundary(boundary).nodes) sum += internal_[n];
  return sum;
}

void Soil::hold(bool held, std::optional<double> damping) {
  standing_ = held;
  damping_ = damping;
}

void Soil::archive(Archive& a) {
  archive_pairs(a, "soil_position", positions_);
  archive_pairs(a, "soil_displacement", displacements_);
  archive_pairs(a, "soil_velocity", velocities_);
  archive_pairs(a, "soil_internal_force", internal_);
  for (auto* of : {&gradients_, &strains_}) {
    std::vector<double> flat;
    for (const Mat2& m : *of) flat.insert(flat.end(), m.data(), m.data() + 4);
    a.sized(of == &gradients_ ? "soil_gradient" : "soil_strain", flat);
    for (Index p = 0; p < of->size(); ++p)
      std::copy_n(flat.begin() + static_cast<std::ptrdiff_t>(4 * p), 4, (*of)[p].data());
  }
  SoilEnergies& e = energies_;
  a.item("soil_internal_work", e.internal_work), a.item("soil_viscous", e.viscous);
  a.item("soil_traction_work", e.traction_work), a.item("soil_support_work", e.support_work);
  a.item("soil_interface_work", e.interface_work);
}

}  // namespace soilweave::fem
