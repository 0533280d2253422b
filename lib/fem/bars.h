// The geosynthetic: a chain of bars beside the soil's boundary, touching it, and fixed guides, through virtual disks.
// Quantities per metre of width. The chain moves by leap-frog steps of its own within each step of the soil.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "core/archive.h"
#include "core/tensor.h"

namespace soilweave::fem {

struct Touch {
  double normal_stiffness = 0;  // N/m3, per length of bar and width
  double shear_ratio = 0;       // of the stiffnesses
  double friction_angle = 0;    // rad
};

/// A straight fixed bar without friction.
struct Guide {
  Vec2 from = Vec2::Zero(), to = Vec2::Zero();
  bool holds_soil = false;  // it carries the interface, too
};

struct ChainEnd {
  std::optional<double> x, y;  // m/s, driven; nothing: free
};

struct BarsSetup {
  std::vector<Vec2> interface;                                // nodes of the soil's boundary, the soil to the left
  std::vector<Vec2> chain;                                    // nodes of the geosynthetic, m
  double radius = 0;                                          // m, of the virtual disks, chain and boundary alike
  double stiffness = 0;                                       // J, N/m
  double strength = std::numeric_limits<double>::infinity();  // N/m
  bool compression = true;                                    // whether bars resist shortening
  double areal_density = 0;                                   // kg/m2
  double damping = 0;                                         // local, non-viscous
  Vec2 gravity = Vec2::Zero();                                // m/s2, on the chain
  double safety = 0.7;                                        // of the stable step
  Touch touch;  // of chain and boundary; guides: the same stiffness, no friction
  std::vector<Guide> guides;
  ChainEnd start, end;
  bool stop_when_broken = true;
};

/// Chain nodes 2r outside the line, `spacing` apart at most along each of its edges; corners on their bisector;
/// overhang: m, that the chain goes on straight before the start. Throws DataError beyond 100,000 bars.
std::vector<Vec2> chain_beside(const std::vector<Vec2>& line, double radius, double spacing, double overhang);

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

class Bars {
 public:
  explicit Bars(BarsSetup setup);

  /// s, stable for chain and contacts (row sums of the stiffness over the lumped mass), safety included.
  double time_step() const { return stable_; }
  /// N/m per metre, a node of the interface: what contacts add to the stiffness of the soil's boundary at most.
  std::vector<double> interface_stiffness() const;
  /// The interface moves evenly to these positions during the duration. Throws PhysicsError naming bar or disk.
  void advance(const std::vector<Vec2>& interface, double duration);
  /// N/m on the nodes of the interface at the present positions; reading it moves nothing.
  const std::vector<Vec2>& interface_forces() const { return on_interface_; }
  /// Before the start: interface nodes yield along y under these loads (N/m) until contacts carry them; chain nodes
  /// move along y alone. Friction is forgotten. Throws TargetNotReached.
  void seat(const std::vector<double>& loads);
  /// Where interface nodes stand off the soil's since seat().
  const std::vector<Vec2>& offsets() const { return offsets_; }

  void hold(bool held, std::optional<double> damping = std::nullopt);
  const std::vector<Vec2>& nodes() const { return x_; }
  const std::vector<Vec2>& velocities() const { return v_; }
  const std::vector<Vec2>& interface() const { return lines_.front().x; }
  std::size_t bars() const { return x_.size() - 1; }
  double tension(std::size_t bar) const;  // N/m, tension positive
  bool broken(std::size_t bar) const { return broken_[bar]; }
  std::size_t broken_bars() const;
  /// Normal and shear force between a bar and the boundary, N/m; shear: along the chain's sense.
  Vec2 contact_of(std::size_t bar) const;
  /// Sums of contact_of over the boundary, N/m.
  Vec2 contact_sum() const;
  /// Force that drives an end, N/m.
  Vec2 end_force(bool last) const;
  BarEnergies energies() const;
  std::int64_t steps() const { return steps_; }
  const BarsSetup& setup() const { return setup_; }
  void archive(Archive& archive);

 private:
  struct Line {
    std::vector<Vec2> x, v;
    bool fixed = true;  // a guide: forces on it go nowhere
  };
  // A virtual disk on a bar of the chain (its middle) or a node of the interface, against a line. The shear force stays
  // with the disk while it slides from one bar of the line to the next.
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
  /// Where on the line's nearest bar, 0 to 1; the contact's segment follows.
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
  std::vector<std::size_t> near_;  // of the contacts, those that may touch before the next look
  double stable_ = 0, elastic_ = 0, touching_ = 0;
  bool held_ = false, only_along_y_ = false;
  std::optional<double> damping_;
  BarEnergies energies_;
  std::int64_t steps_ = 0;
};

}  // namespace soilweave::fem
