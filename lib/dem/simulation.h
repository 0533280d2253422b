// A granular assembly in motion: grains, their contacts, the cell and the clock. A plain object; no global state.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>

#include "core/archive.h"
#include "dem/cell.h"
#include "dem/clamp.h"
#include "dem/model.h"
#include "dem/plate.h"
#include "dem/step_times.h"
#include "dem/yarns.h"
#include "io/records.h"

namespace soilweave::dem {

/// What every step measures. Stress compression positive.
struct Measures {
  // Love-Weber stress over the cell, Pa (2D: N/m over the unit thickness): contacts and, in a periodic cell, yarns.
  Mat3 stress = Mat3::Zero();
  // Affine stiffness of the same contacts and yarns along each axis, as last looked at, Pa.
  Vec3 axial_stiffness = Vec3::Zero();
  std::int64_t contacts = 0;
};

/// Work and energy since the start, J. boundary_work + gravity_work + initial = kinetic + elastic + dissipated parts
/// + law_created (with its sign) + error.
struct Energies {
  double kinetic = 0, elastic_normal = 0, elastic_shear = 0, elastic_rolling = 0, elastic_twisting = 0;
  double frictional = 0;       // dissipated by sliding
  double rolling_plastic = 0;  // dissipated at the rolling and twisting limits
  double viscous = 0;          // dissipated by contact damping
  double damping = 0;          // dissipated by local non-viscous damping
  double boundary_work = 0;    // done on the assembly by the deforming cell, moving planes and clamps
  double gravity_work = 0;
  double elastic_yarns = 0, yarn_dissipation = 0;  // stored in yarns; taken by their yielding and breaking
  double law = 0;                                  // taken out (+) or created (-) by the incremental contact law itself
  double tangential_work = 0;                      // on the tangential springs, and what they held at the start
  double initial = 0;                              // kinetic and elastic at the start
  double turned_over = 0;                          // work and dissipation of every step, without their signs
  double elastic() const { return elastic_normal + elastic_shear + elastic_rolling + elastic_twisting + elastic_yarns; }
  double error() const {
    return initial + boundary_work + gravity_work -
           (kinetic + elastic() + frictional + rolling_plastic + viscous + damping + yarn_dissipation + law);
  }
};

class Simulation {
 public:
  /// Takes over the state, contacts and their history included; contacts absent from the record are born at zero shear.
  /// Throws DataError where grains overlap by more than half a radius, or are of a material that the model lacks.
  Simulation(const io::Snapshot& state, const Model& model, const Numerics& numerics);
  /// Goes on from a snapshot taken between two steps and what archive() kept then, bit by bit.
  Simulation(const io::Snapshot& state, const Model& model, const Numerics& numerics, Archive& kept);
  Simulation(Simulation&&) noexcept;
  Simulation& operator=(Simulation&&) noexcept;
  ~Simulation();

  /// Advances one time step with the cell's velocity gradient as set. Throws PhysicsError when physics breaks.
  void step();

  const Measures& measures() const;  // of the last step
  /// Mean resultant on grains over mean force of contacts and taut yarns, or over `least`, N, if that is more; 0/0 is
  /// 0.
  double unbalanced_force(double least = 0) const;
  double kinetic_energy() const;              // J
  double kinetic_energy_of_acted_on() const;  // J, of grains that float free nothing
  double largest_overlap() const;             // over the smaller radius
  Energies energies() const;
  double time_step() const;  // s, of the next step
  double stability_limit();  // s, from the present stiffness
  double time() const;
  std::int64_t steps() const;

  const Cell& cell() const;
  const Mat3& cell_matrix() const { return cell().matrix(); }
  const Mat3& deformation_gradient() const { return cell().deformation_gradient(); }
  double volume() const { return cell().volume(); }  // m3 (2D: m2)
  std::size_t grains() const { return bodies().size(); }
  const Bodies& bodies() const;
  double mass() const { return bodies().total_mass(); }            // kg (2D: kg/m), of all grains
  double solid_volume() const { return bodies().solid_volume(); }  // m3 (2D: m2), overlaps counted twice
  double void_ratio() const { return volume() / solid_volume() - 1; }
  /// Natural strains since the reference, compression positive: -ln of the principal stretches along the axes.
  Vec3 strain() const { return (0.0 - deformation_gradient().diagonal().array().log()).matrix(); }  // 0 - 0: not -0
  void set_reference();                              // the present cell becomes the reference of the strains
  void set_velocity_gradient(const Mat3& gradient);  // 1/s, extension positive

  void set_plane_velocity(std::size_t plane, const Vec3& velocity);  // m/s
  const Planes& planes() const;
  std::vector<PlateLoad> plate_loads() const;
  void set_clamp_velocity(std::size_t clamp, const Vec3& velocity);  // m/s
  const std::vector<Clamp>& clamps() const;
  const YarnSums& yarns() const;

  void set_model(const Model& model);  // between stages: friction lowered, law parameters changed; history is kept
  void set_damping(double damping);
  /// Of soil; masses follow at constant density. stretch: soil is also moved, coordinate by coordinate, from the
  /// origin.
  void scale_radii(double factor, const Vec3& stretch = Vec3::Ones());
  /// Of fluctuation velocities and spins this share is left; what they lose counts as damped away.
  void slow_motion(double share);
  /// Changes velocities as told. Kinetic energy that the grains gain counts as work of the boundary, for whose motion
  /// it is given; what they lose, as damped away.
  void change_velocities(const std::function<void(Bodies&)>& change);

  /// State and history. A Simulation made from it alone counts energies anew, and looks at the stiffness at once.
  io::Snapshot snapshot() const;
  /// Keeps what a snapshot leaves out.
  void archive(Archive& archive) const;
  std::int64_t contact_steps() const;  // contacts, summed over the steps
  const StepTimes& step_times() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace soilweave::dem
