// The geosynthetic: a chain of bars that touches the soil's boundary and fixed guides through virtual disks.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.h"
#include "core/tensor.h"

namespace soilweave::fem {

/// Contact parameters.
struct Touch {
  double normal_stiffness = 0;  // N/m3: per length of bar and width
  double shear_ratio = 0;       // shear over normal stiffness
  double friction_angle = 0;    // rad
};

/// A straight fixed bar without friction.
struct Guide {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  bool holds_soil = false;  // touches the soil's boundary, too
};

/// Motion of an end of the chain.
struct ChainEnd {
  std::optional<double> x, y;  // velocity, m/s; none: free
};

/// Input of a geosynthetic.
struct BarsSetup {
  std::vector<Vec2> interface;                                // nodes of the soil's boundary, soil on the left
  std::vector<Vec2> chain;                                    // nodes of the geosynthetic, m
  double radius = 0;                                          // of the virtual disks, m
  double stiffness = 0;                                       // J, N/m
  double strength = std::numeric_limits<double>::infinity();  // N/m
  bool compression = true;                                    // bars resist shortening
  double areal_density = 0;                                   // kg/m2
  double damping = 0;                                         // local, non-viscous
  Vec2 gravity = Vec2::Zero();                                // m/s2, on the chain
  double safety = 0.7;                                        // fraction of the stable step
  Touch touch;                                                // guides have this stiffness without friction
  std::vector<Guide> guides;
  ChainEnd start, end;
  bool stop_when_broken = true;
};

/// Returns chain nodes 2r outside the line, at most `spacing` apart on each edge, corners on bisectors. overhang:
/// straight length before the start, m. Throws DataError above 100,000 bars.
std::vector<Vec2> chain_beside(const std::vector<Vec2>& line, double radius, double spacing, double overhang);

/// Energies of the geosynthetic since the start, J per metre.
struct BarEnergies {
  double kinetic = 0, elastic = 0, contact = 0;
  double damping = 0, friction = 0, broken = 0;
  double end_work = 0, interface_work = 0, gravity_work = 0;
  double initial = 0;
  double error() const {
    return initial + end_work + interface_work + gravity_work - kinetic - elastic - contact - damping - friction -
           broken;
  }
};

/// Chain, contacts and guides in motion.
class Bars {
 public:
  explicit Bars(BarsSetup setup);

  /// Returns the stable step times safety, s: from row sums of the stiffness over lumped masses.
  double time_step() const { return stable_; }
  /// Returns the greatest contact stiffness at each interface node, N/m per metre.
  std::vector<double> interface_stiffness() const;
  /// Moves the interface evenly within `duration`. Throws PhysicsError naming bar or disk.
  void advance(const std::vector<Vec2>& interface, double duration);
  /// Returns the forces on interface nodes, N/m.
  const std::vector<Vec2>& interface_forces() const { return on_interface_; }
  /// Seats the chain before the start: interface nodes yield along y under loads (N/m) until contacts carry them. Chain
  /// nodes move along y only. Friction is forgotten. Throws TargetNotReached.
  void seat(const std::vector<double>& loads);
  /// Returns the distances of interface nodes from soil nodes since seat(), m.
  const std::vector<Vec2>& offsets() const { return offsets_; }

  /// Holds the ends still and replaces the damping, or releases both.
  void hold(bool held, std::optional<double> damping = std::nullopt);
  const std::vector<Vec2>& nodes() const { return x_; }
  const std::vector<Vec2>& velocities() const { return v_; }
  const std::vector<Vec2>& interface() const { return lines_.front().x; }
  std::size_t bars() const { return x_.size() - 1; }
  /// Returns the tension of a bar, N/m.
  double tension(std::size_t bar) const;
  bool broken(std::size_t bar) const { return broken_[bar]; }
  std::size_t broken_bars() const;
  /// Returns normal and shear force between bar and boundary, N/m, shear positive along the chain.
  Vec2 contact_of(std::size_t bar) const;
  /// Returns the sum of contact_of() over all bars, N/m.
  Vec2 contact_sum() const;
  /// Returns the force that drives an end, N/m.
  Vec2 end_force(bool last) const;
  BarEnergies energies() const;
  std::int64_t steps() const { return steps_; }
  const BarsSetup& setup() const { return setup_; }
  void archive(Archive& archive);

 private:
  struct Line {
    std::vector<Vec2> x, v;
    bool fixed = true;  // a guide, which takes up any force
  };
  // Contact of a virtual disk, at the middle of a bar or an interface node, with a line. The shear force stays with the
  // disk while it slides from bar to bar.
  struct Contact {
    std::size_t bar, line;
    bool of_interface;
    double normal_stiffness, shear_stiffness, friction;
    std::size_t segment = 0;
    double shear = 0, normal = 0;
    Vec2 direction = Vec2::Zero();
  };
  void add_contacts();
  void find_step();
  void forces(double dt);
  void bar_forces();
  void contact_force(Contact& contact, double dt);
  void touch(Contact& contact, const Vec2& p, const Vec2& v, double spin, double dt);
  /// Stores the nearest bar of the line in contact.segment. Returns the position on it, 0 to 1.
  static double nearest(const Line& line, const Vec2& p, Contact& contact);
  Vec2 place(const Contact& contact) const;
  void look_around();
  void kick(double dt);

  BarsSetup setup_;
  std::vector<Vec2> x_, v_, f_;
  std::vector<double> mass_, length_;
  std::vector<bool> broken_;
  std::vector<Line> lines_;  // the interface, then the guides
  std::vector<Vec2> on_interface_, offsets_;
  std::vector<Contact> contacts_;
  std::vector<std::size_t> near_;  // contacts that may touch before the next search
  double stable_ = 0, elastic_ = 0, touching_ = 0;
  bool held_ = false, only_along_y_ = false;
  std::optional<double> damping_;
  BarEnergies energies_;
  std::int64_t steps_ = 0;
};

}  // namespace soilweave::fem
