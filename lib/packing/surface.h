// Containers given as closed triangulated surfaces, read from a file.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "packing/chart.h"
#include "packing/container.h"

namespace soilweave::packing {

/// What a closed surface of triangles encloses.
class Surface final : public Container {
 public:
  /// Reads STL, binary or text, or VTP. scale: m in the file's unit of length. Throws DataError where it is no surface,
  /// or one that is open, cuts itself or encloses nothing.
  explicit Surface(const std::string& path, double scale = 1);
  ~Surface() override;
  double depth(const Vec3& point) const override;
  Vec3 low() const override { return low_; }
  Vec3 high() const override { return high_; }
  /// By counting the points of a grid that lie as deep; 0 means the enclosed volume itself, by its triangles.
  double volume(double depth = 0) const override;
  /// Throws DataError where not all of the surface is seen from the middle of what it encloses.
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;

 private:
  struct Mesh;
  Chart chart() const;

  std::string path_;
  std::unique_ptr<Mesh> mesh_;
  Vec3 low_, high_;      // m
  double enclosed_ = 0;  // m3
  // Made when asked for.
  mutable std::vector<double> depths_;  // m, of the grid's points inside, ascending
  mutable std::unique_ptr<Chart> chart_;
};

}  // namespace soilweave::packing
