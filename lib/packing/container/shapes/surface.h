// Containers given as closed triangulated surfaces.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "packing/container/chart.h"
#include "packing/container/container.h"

namespace soilweave::packing {

/// The space enclosed by a closed surface of triangles.
class Surface final : public Container {
 public:
  static constexpr std::string_view name = "surface";
  /// Reads the file that [container] names; nullptr without files.
  static std::unique_ptr<Container> read(Settings& table, PlanFiles* files);

  /// Reads STL, binary or text, or VTP. scale: metres per unit of the file. Throws DataError if the surface is absent,
  /// open, intersects itself or encloses nothing.
  explicit Surface(const std::string& path, double scale = 1);
  ~Surface() override;
  double depth(const Vec3& point) const override;
  Vec3 low() const override { return low_; }
  Vec3 high() const override { return high_; }
  /// Counts points of a grid; at depth 0 it is exact, from the triangles.
  double volume(double depth = 0) const override;
  /// Throws DataError for a surface that is not star-shaped about its middle.
  std::vector<Vec3> spread(const std::vector<Vec3>& box, const std::array<int, 3>& cells, double outside,
                           bool even) const override;
  Vec3 nearest(const Vec3& point, double outside) const override;

 private:
  struct Mesh;
  Chart chart() const;

  std::string path_;
  /// Triangles and their search tree.
  std::unique_ptr<Mesh> mesh_;
  /// Corners of the box, m.
  Vec3 low_, high_;
  /// Enclosed volume, m3.
  double enclosed_ = 0;
  // Depths of the grid's points inside, ascending, m; filled on first use.
  mutable std::vector<double> depths_;
  /// Made on first use.
  mutable std::unique_ptr<Chart> chart_;
};

}  // namespace soilweave::packing
