// Which pairs may touch soon. Two lists: an outer one with a wide skin from a grid over the deforming cell, and the one
// that is swept, with a narrow skin, filtered from it. Contacts keep their memory across rebuilds.
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
  /// Skins (gaps up to which pairs are listed) are fractions of this radius, m.
  explicit Neighbours(double largest_radius);

  /// Counts how much pairs may have closed in a step: at first twice the fastest grain plus the affine closing of the
  /// longest branch, and when that sum uses up the skin, by what the grains have truly moved since. Returns true when
  /// the list is no longer safe. Speeds in m/s, of the fluctuation and of planes.
  bool outdated(const Bodies& bodies, double fastest, double fastest_plane, const Mat3& velocity_gradient, double dt);
  /// Whether a step without planes is sure not to use up the skin by that count, where no grain is faster.
  bool outlast(double fastest, const Mat3& velocity_gradient, double dt) const;
  /// Lists all pairs of grains, and of grains and planes, closer than the skin; what `contacts` knew of them is kept.
  /// Loads of the bodies are left zero.
  void rebuild(Bodies& bodies, const Cell& cell, const Planes& planes, Contacts& contacts);

 private:
  // A state that pairs were looked for in, and what has moved since.
  struct Since {
    std::vector<Vec3> position;
    Mat3 deformation = Mat3::Identity();
    double planes = 0;  // m
    double closed = 0;  // m, at most

    void begin(const Bodies& bodies);
    /// What a step adds to `closed`, m.
    static double closing(double fastest, double fastest_plane, const Mat3& velocity_gradient, double dt,
                          double longest);
    void move(double fastest, double fastest_plane, const Mat3& velocity_gradient, double dt, double longest);
    void look(const Bodies& bodies, double longest);
  };

  void search(const Bodies& bodies, const Cell& cell);
  double longest() const { return 2 * radius_ + outer_skin_; }  // branch that is listed, m

  double radius_, outer_skin_, skin_;  // m
  bool planes_ = false;
  Since filtered_, searched_;
  std::vector<Pair> outer_, listed_;  // sorted
};

}  // namespace soilweave::dem
