// Which pairs may touch soon. Two lists: an outer one with a wide skin from a search (pair_search.h), and the one that
// is swept, filtered from it. Contacts keep their memory across rebuilds.
//
// A grain has a leeway: how far it may move beside the cell before pairs are listed anew. A pair is listed that may
// close within the leeways of both and that of the cell. In a sheared packing few grains are fast, most of all those
// that rattle in their cage, and they alone get a long one: the list lasts, and names little that does not touch.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "dem/bodies.h"
#include "dem/cell.h"
#include "dem/contacts.h"
#include "dem/plane.h"

namespace soilweave::dem {

class Neighbours {
 public:
  /// Skins are fractions of this radius, m.
  explicit Neighbours(double largest_radius);

  /// Counts how much of the leeways a step has used up, and when that may be all, by how far the grains have truly
  /// moved since they were listed. Returns true when the list is no longer safe. haste: the largest speed over leeway
  /// of a grain in the step, 1/s (Motion); fastest_plane in m/s.
  bool outdated(const Bodies& bodies, double haste, double fastest_plane, const Mat3& velocity_gradient, double dt);
  /// Whether a step without planes is sure not to use up the leeways by that count, where no grain gains more speed
  /// than this, m/s.
  bool outlast(double gain, const Mat3& velocity_gradient, double dt) const;
  /// Lists all pairs of grains, and of grains and planes, that may touch within their leeways, which are set anew by
  /// the present speeds and those that outdated() was last told of; what `contacts` knew of the pairs is kept. Loads of
  /// the bodies are left zero.
  void rebuild(Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts);

 private:
  // A state that pairs were looked for in, and how the cell has deformed since.
  struct Since {
    std::vector<Vec3> position;
    Mat3 deformation = Mat3::Identity();

    void begin(const Bodies& bodies, int threads);
    void step(const Mat3& velocity_gradient, double dt) { deformation += dt * velocity_gradient * deformation; }
    double strain() const { return (deformation - Mat3::Identity()).norm(); }
    /// How far a grain has moved beside the cell, squared, m2.
    double moved2(const Bodies& bodies, std::size_t i) const;
  };
  // The last step counted.
  struct Pace {
    double dt = 0, plane = 0;  // s, m/s
    Mat3 velocity_gradient = Mat3::Zero();
  };

  void set_leeways(const Bodies& bodies);
  bool fit_outer_list(const Bodies& bodies);
  void filter(const Bodies& bodies, const Cell& cell);
  bool is_near(const Pair& pair, const Bodies& bodies, const Cell& cell) const;
  std::vector<PlanePair> near_planes(const Bodies& bodies, const Planes& planes) const;
  void begin_list(Bodies& bodies);
  double longest() const { return 2 * radius_ + outer_skin_; }  // branch that is listed, m

  double radius_, outer_skin_;  // m
  Pace pace_;
  std::vector<double> leeway_;                 // m
  double least_leeway_ = 0, cell_leeway_ = 0;  // m; of all grains; closing of a pair with the cell
  double plane_leeway_ = 0;                    // m, what a plane, and a grain with the cell, may move
  double haste_ = 0, worn_ = 0;                // 1/s; share of its leeway a grain has used up at most
  double planes_moved_ = 0, extent_ = 0;       // m; how far from the origin grains are
  bool planes_ = false;
  int threads_ = 1;
  Since filtered_, searched_;
  std::vector<Pair> outer_, listed_;        // sorted
  std::vector<char> near_;                  // of the outer ones: whether it is listed
  std::vector<std::size_t> listed_before_;  // by share of the outer ones, how many of the shares before
};

}  // namespace soilweave::dem
