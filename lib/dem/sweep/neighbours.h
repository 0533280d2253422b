// Lists of the pairs that may touch soon.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Testing all pairs of N grains would cost N^2. So pairs are listed, and the list is used until it may be incomplete.
// An outer list with a wide skin comes from a search (pair_search.h). The swept list is filtered from it. A small grain
// that flies fast, as where a bag has torn, gets a wider skin in the outer list too, so that it causes no search alone.
//
// Each grain has a skin distance, its leeway: how far it may move relative to the cell before pairs are listed anew.
// A pair is listed if its gap is smaller than both skin distances plus the allowed closing by the cell's strain. In a
// sheared packing few grains are fast, mostly rattlers. Only these get a wide skin, so a short list lasts long.
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
  /// Skins are fractions of `largest_radius`, m. `range`: gap across which bodies act, m.
  explicit Neighbours(double largest_radius, double range = 0);

  /// Adds the share of the skins that a step has used. Returns true if the list is no longer safe.
  /// `skin_rate`: MotionSums::skin_rate, 1/s. `fastest_plane`: speed, m/s.
  bool outdated(const Bodies& bodies, double skin_rate, double fastest_plane, const Mat3& velocity_gradient, double dt);
  /// Returns whether the list surely outlasts one more step without planes.
  /// `gain`: largest speed that any grain gains, m/s.
  bool outlast(double gain, const Mat3& velocity_gradient, double dt) const;
  /// Lists all pairs, planes included, that may touch within their skins. Leaves the loads zero.
  /// Skins follow the present speeds and the last call of outdated(). Contacts keep their history.
  void rebuild(Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts);

 private:
  /// Positions when pairs were listed, and deformation of the cell since then.
  struct Since {
    /// Positions at the listing, m.
    std::vector<Vec3> position;
    /// Deformation gradient since the listing.
    Mat3 deformation = Mat3::Identity();

    void begin(const Bodies& bodies, int threads);
    void step(const Mat3& velocity_gradient, double dt) { deformation += dt * velocity_gradient * deformation; }
    /// Returns the norm of the deformation gradient minus the identity.
    double strain() const { return (deformation - Mat3::Identity()).norm(); }
    /// Returns the squared distance that a grain has moved relative to the cell, m2.
    double moved2(const Bodies& bodies, std::size_t i) const;
  };
  /// The last counted step.
  struct Pace {
    /// Time step, s; speed of the fastest plane, m/s.
    double dt = 0, plane = 0;
    /// Velocity gradient of the cell, 1/s.
    Mat3 velocity_gradient = Mat3::Zero();
  };

  /// Sets the skin distance of each grain from its speed.
  void set_leeways(const Bodies& bodies);
  /// Sets the skin distance of each grain in the outer list from its speed.
  void set_outer_leeways(const Bodies& bodies);
  /// Makes the outer list.
  void search(const Bodies& bodies, const Cell& cell);
  /// Limits the skins to those that the outer list covers. Returns false if a new search is needed.
  bool fit_outer_list(const Bodies& bodies);
  /// Makes the swept list from the outer one.
  void filter(const Bodies& bodies, const Cell& cell);
  /// Returns whether a pair may touch within the skins.
  bool is_near(const Pair& pair, const Bodies& bodies, const Cell& cell) const;
  /// Returns the pairs of grains and planes within the skins.
  std::vector<PlanePair> near_planes(const Bodies& bodies, const Planes& planes) const;
  /// Begins to count the use of the skins.
  void begin_list(Bodies& bodies);
  /// Returns the longest branch in a list, m.
  double longest() const { return 2 * radius_ + outer_skin_ + range_; }

  /// Largest radius, skin of the outer list, and range, m.
  double radius_, outer_skin_, range_;
  /// The last counted step.
  Pace pace_;
  /// Skin distance of each grain in the swept list and in the outer list, m.
  std::vector<double> leeway_, outer_leeway_;
  /// Least skin distance of all grains, and allowed closing of a pair by the cell's strain, m.
  double least_leeway_ = 0, cell_leeway_ = 0;
  /// Skin for the motion of planes, and of grains with the cell, m.
  double plane_leeway_ = 0;
  /// Skin rate of the last step, 1/s; largest used share of a skin so far.
  double skin_rate_ = 0, used_skin_ = 0;
  /// Distance that planes have moved, and largest distance of a grain from the origin, m.
  double planes_moved_ = 0, extent_ = 0;
  /// Whether there are planes.
  bool planes_ = false;
  /// Number of threads.
  int threads_ = 1;
  /// State and deformation since the swept list was made, and since the outer list was made.
  Since filtered_, searched_;
  /// Outer list and swept list, sorted.
  std::vector<Pair> outer_, listed_;
  /// Whether a pair of the outer list is in the swept list.
  std::vector<char> near_;
  /// Number of swept pairs before each thread's share of the outer list.
  std::vector<std::size_t> listed_before_;
};

}  // namespace soilweave::dem
