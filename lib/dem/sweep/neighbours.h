// Lists of the pairs that may touch soon.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Testing all pairs of N grains would cost N^2. So pairs are listed, and the list is used until it may be incomplete.
// An outer list with a wide skin comes from a search (pair_search.h). The swept list is filtered from it.
//
// Each grain has a skin distance, its leeway: how far it may move relative to the cell before pairs are listed anew. A
// pair is listed if it may close within both skins and that of the cell. In a sheared packing only few grains are fast,
// mostly rattlers in their cages. Only these get a wide skin, so the list lasts long and has few pairs that never
// touch.
#pragma once

#include <vector>

#include "dem/contact/contacts.h"
#include "dem/state/bodies.h"
#include "dem/state/cell.h"
#include "dem/state/plane.h"

namespace soilweave::dem {

/// Neighbour lists of one simulation.
class Neighbours {
 public:
  /// Skins are fractions of the largest radius, m. range: the gap across which bodies act on each other, m.
  explicit Neighbours(double largest_radius, double range = 0);

  /// Adds up how much of the skins a step has used; when that may be all, measures how far the grains have moved.
  /// Returns true if the list is no longer safe. skin_rate: MotionSums::skin_rate, 1/s. fastest_plane: m/s.
  bool outdated(const Bodies& bodies, double skin_rate, double fastest_plane, const Mat3& velocity_gradient, double dt);
  /// Returns whether the list surely outlasts one more step without planes, if no grain gains more speed than `gain`,
  /// m/s.
  bool outlast(double gain, const Mat3& velocity_gradient, double dt) const;
  /// Lists all pairs of grains, and of grains and planes, that may touch within their skins. Skins follow the present
  /// speeds and the last call of outdated(). Contacts keep their history. Leaves the loads zero.
  void rebuild(Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts);

 private:
  // The state in which pairs were searched, and the deformation of the cell since.
  struct Since {
    /// Positions at the search, m.
    std::vector<Vec3> position;
    Mat3 deformation = Mat3::Identity();

    void begin(const Bodies& bodies, int threads);
    void step(const Mat3& velocity_gradient, double dt) { deformation += dt * velocity_gradient * deformation; }
    double strain() const { return (deformation - Mat3::Identity()).norm(); }
    /// Returns the squared distance that a grain has moved relative to the cell, m2.
    double moved2(const Bodies& bodies, std::size_t i) const;
  };
  // The last counted step.
  struct Pace {
    double dt = 0, plane = 0;  // s, m/s
    Mat3 velocity_gradient = Mat3::Zero();
  };

  /// Sets the skin distance of each grain from its speed.
  void set_leeways(const Bodies& bodies);
  bool fit_outer_list(const Bodies& bodies);
  /// Makes the swept list from the outer one.
  void filter(const Bodies& bodies, const Cell& cell);
  /// Returns whether a pair may touch within the skins.
  bool is_near(const Pair& pair, const Bodies& bodies, const Cell& cell) const;
  std::vector<PlanePair> near_planes(const Bodies& bodies, const Planes& planes) const;
  void begin_list(Bodies& bodies);
  /// Returns the longest branch in a list, m.
  double longest() const { return 2 * radius_ + outer_skin_ + range_; }

  double radius_, outer_skin_, range_;  // m
  /// The last counted step.
  Pace pace_;
  /// Skin distance of each grain, m.
  std::vector<double> leeway_;
  double least_leeway_ = 0, cell_leeway_ = 0;  // m; least skin of all grains; closing of a pair by the cell
  /// Skin for the motion of planes, and of grains with the cell, m.
  double plane_leeway_ = 0;
  double skin_rate_ = 0, used_skin_ = 0;  // 1/s; largest used share of a skin, so far
  double planes_moved_ = 0, extent_ = 0;  // m; largest distance of a grain from the origin
  bool planes_ = false;
  /// Number of threads.
  int threads_ = 1;
  Since filtered_, searched_;
  /// Outer list and swept list, sorted.
  std::vector<Pair> outer_, listed_;
  /// Whether a pair of the outer list is in the swept list.
  std::vector<char> near_;
  /// Number of listed pairs in the shares before each share of the outer list.
  std::vector<std::size_t> listed_before_;
};

}  // namespace soilweave::dem
