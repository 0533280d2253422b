// The finite elements: lumped mass, internal forces, central differences.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fem/material/material_point.h"
#include "fem/mesh/mesh.h"

namespace soilweave::fem {

/// Prescribed motion of a boundary's nodes ("all": every node).
struct Support {
  std::string boundary;
  /// Velocity along the axes, m/s.
  std::optional<double> x, y;
  /// Velocity over position, on both axes, 1/s.
  std::optional<Mat2> gradient;
};

/// Force per present area of a boundary with edges, Pa. Tractions on one boundary add up.
struct Traction {
  std::string boundary;
  Vec2 value = Vec2::Zero();
};

/// Input of the finite elements.
struct SoilSetup {
  Mesh mesh;
  Integration integration = Integration::reduced;
  double density = 0;  // kg/m3
  double damping = 0;  // c of thesis Eq. 6.2, 1/s
  std::vector<Support> supports;
  std::vector<Traction> tractions;
};

/// Velocity of a held node along one axis: constant + gradient * position.
struct HeldMotion {
  double constant = 0;           // m/s
  Vec2 gradient = Vec2::Zero();  // 1/s
  /// Number of the first support that prescribes this motion.
  Index support = 0;
};
/// Held motions of a node along x and y; an axis without one is free.
using HeldNode = std::array<std::optional<HeldMotion>, 2>;
/// Returns the held motions of each node. Throws DataError for an unknown boundary, and for two supports that move a
/// common node differently.
std::vector<HeldNode> held_nodes(const Mesh& mesh, const std::vector<Support>& supports);

/// Returns the tractions as forces on the nodes, which are at these positions, N/m.
std::vector<Vec2> traction_forces(const Mesh& mesh, const std::vector<Vec2>& positions,
                                  const std::vector<Traction>& tractions);

/// A material point of the soil.
struct SoilPoint {
  Index element;
  Vec2 position;  // m
  double area;    // its part of the element's area, m2
};

/// Work and energy since the start, J per metre of thickness.
struct SoilEnergies {
  double kinetic = 0, internal_work = 0, viscous = 0;
  double traction_work = 0, support_work = 0, interface_work = 0;
  /// Returns the work of all outer forces.
  double external() const { return traction_work + support_work + interface_work; }
  /// Returns the energy that the balance lacks.
  double error() const { return external() - kinetic - internal_work - viscous; }
};

using Points = std::vector<std::unique_ptr<MaterialPoint>>;

/// The finite elements in motion.
class Soil {
 public:
  /// Checks the mesh and lumps masses: scales the consistent diagonal to the element's mass (HRZ: Hinton, Rock &
  /// Zienkiewicz 1976). Throws DataError for an unknown boundary, supports that contradict each other, and a
  /// traction on points.
  explicit Soil(SoilSetup setup);
  /// Returns the number of points.
  Index points() const { return setup_.mesh.elements.size() * rule_.size(); }
  Index points_of_element() const { return rule_.size(); }

  /// Returns an upper bound of the largest eigenvalue of M^-1 K, 1/s2: the stiffest element's (Irons & Treharne 1971).
  /// The stable step is 2/sqrt of it. tangent: as MaterialPoint::tangent.
  double largest_eigenvalue(const std::function<Mat3(Index point)>& tangent) const;

  /// Takes one step of central differences (thesis Eqs. 6.1 to 6.3) from stresses of all points (Pa, tension positive)
  /// and interface forces (N/m per node). Sets gradients(). Throws PhysicsError naming a degenerate element.
  void step(const std::vector<Mat2>& stresses, const std::vector<Vec2>& interface_forces, double dt);

  /// Returns the gradients of the last increment, one per point, on the geometry before the step.
  const std::vector<Mat2>& gradients() const { return gradients_; }
  /// Returns plain sums of the gradients.
  const std::vector<Mat2>& strains() const { return strains_; }
  /// Return the nodes' positions and displacements (m), velocities (m/s) and masses (kg/m).
  const std::vector<Vec2>& positions() const { return positions_; }
  const std::vector<Vec2>& displacements() const { return displacements_; }
  const std::vector<Vec2>& velocities() const { return velocities_; }
  const std::vector<double>& masses() const { return masses_; }
  const Mesh& mesh() const { return setup_.mesh; }
  /// Return energies since the start, and the present kinetic energy, J/m.
  SoilEnergies energies() const;
  double kinetic_energy() const;
  /// Returns element, position and area of a point.
  SoilPoint soil_point(Index point) const;
  /// Returns node averages of point values, weighted by area.
  std::vector<Mat2> at_nodes(const std::vector<Mat2>& values) const;
  /// Returns the resultant internal force at a boundary, N/m. At rest it equals the outer forces on that boundary.
  Vec2 reaction(const std::string& boundary) const;
  /// Returns internal forces, N/m per node. Throws PhysicsError naming a degenerate element.
  std::vector<Vec2> internal_forces(const std::vector<Mat2>& stresses) const;

  /// Holds supports still, or releases them. damping: replaces the viscous coefficient.
  void hold(bool held, std::optional<double> damping = std::nullopt);
  /// Keeps or restores everything that steps change.
  void archive(Archive& archive);

 private:
  void lump();
  void support(Index node, Vec2& velocity, bool* fixed) const;

  SoilSetup setup_;
  std::vector<IntegrationPoint> rule_;
  std::vector<double> masses_;  // kg/m
  std::vector<Vec2> positions_, displacements_, velocities_, increments_;
  std::vector<Mat2> gradients_, strains_;
  std::vector<Vec2> internal_;  // N/m, at the start of the step
  std::vector<HeldNode> held_;
  bool standing_ = false;
  std::optional<double> damping_;
  SoilEnergies energies_;
};

/// Returns the gradient rounded to multiples of 2^-60. Floating-point errors make equal strains of unequal elements
/// differ. Grains would amplify these differences chaotically.
Mat2 rounded_gradient(const Mat2& gradient);

}  // namespace soilweave::fem
