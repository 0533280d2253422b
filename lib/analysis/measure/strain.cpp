// Natural strains and displacement gradients.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/measure/strain.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <cmath>
#include <unordered_map>

#include "core/error.h"
#include "core/linear_algebra.h"

namespace soilweave::analysis {
namespace {

// Returns for each grain of one state the index of the same body in the other.
std::vector<std::size_t> same_bodies(const io::Snapshot& one, const io::Snapshot& other) {
  std::unordered_map<std::int64_t, std::size_t> index;
  for (std::size_t i = 0; i < other.grains.size(); ++i) index[other.grains.body_id[i]] = i;
  std::vector<std::size_t> same;
  same.reserve(one.grains.size());
  for (const std::int64_t id : one.grains.body_id) {
    const auto found = index.find(id);
    if (found == index.end())
      throw DataError(fmt::format("grain {} of step {} is missing at step {}: strain needs the same grains in both", id,
                                  one.step, other.step));
    same.push_back(found->second);
  }
  return same;
}

}  // namespace

Mat3 natural_strain(const Mat3& f) {
  const Eigensystem<Mat3> stretch = eigensystem(Mat3(f * f.transpose()));
  const Vec3 logs = 0.0 - 0.5 * stretch.values.array().log();  // 0 - 0 avoids -0 for no strain
  return stretch.vectors * logs.asDiagonal() * stretch.vectors.transpose();
}

Mat3 cell_strain(const io::CellRecord& cell) { return natural_strain(cell.deformation_gradient); }

double volumetric_strain(const Mat3& strain, int dimension) { return dimension * mean(strain, dimension); }

double deviatoric_strain(const Mat3& strain, int dimension) {
  return (dimension == 3 ? 2.0 / 3.0 : 2.0) * deviatoric_stress(strain, dimension);
}

std::vector<Mat3> simplex_gradients(const io::Snapshot& reference, const io::Snapshot& present,
                                    const std::vector<Simplex>& simplices) {
  const int d = reference.grains.dimension;
  const std::vector<std::size_t> same = same_bodies(reference, present);
  std::vector<Mat3> gradients;
  gradients.reserve(simplices.size());
  for (const Simplex& simplex : simplices) {
    Mat3 before = Mat3::Identity(), after = Mat3::Identity();
    const auto at = [&](const io::Snapshot& s, const Simplex::Vertex& v, std::size_t i) -> Vec3 {
      return s.grains.position[i] + s.cell.matrix * v.image.cast<double>();
    };
    const Simplex::Vertex& origin = simplex.vertices[0];
    for (int k = 0; k < d; ++k) {
      const Simplex::Vertex& v = simplex.vertices[static_cast<std::size_t>(k) + 1];
      before.col(k) = at(reference, v, v.grain) - at(reference, origin, origin.grain);
      after.col(k) = at(present, v, same[v.grain]) - at(present, origin, same[origin.grain]);
    }
    gradients.push_back(after * before.inverse());
  }
  return gradients;
}

std::vector<Mat3> grain_gradients(const io::Snapshot& reference, const io::Snapshot& present,
                                  const std::vector<Simplex>& simplices, const std::vector<Mat3>& gradients) {
  const auto corners = static_cast<std::size_t>(reference.grains.dimension) + 1;
  const std::vector<std::size_t> same = same_bodies(reference, present);
  std::vector<Mat3> sum(present.grains.size(), Mat3::Zero());
  std::vector<double> weight(present.grains.size(), 0.0);
  for (std::size_t s = 0; s < simplices.size(); ++s)
    for (std::size_t k = 0; k < corners; ++k) {
      const std::size_t i = same[simplices[s].vertices[k].grain];
      sum[i] += simplices[s].volume * gradients[s];
      weight[i] += simplices[s].volume;
    }
  for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = weight[i] > 0 ? Mat3(sum[i] / weight[i]) : Mat3::Identity();
  return sum;
}

Mat3 best_fit_gradient(const io::Snapshot& reference, const io::Snapshot& present,
                       const std::vector<std::size_t>& grains, const std::vector<Vec3i>& images) {
  const int d = reference.grains.dimension;
  const std::vector<std::size_t> same = same_bodies(present, reference);
  const Mat3 inverse = reference.cell.matrix.inverse();
  std::vector<Vec3> before, after;
  Vec3 middle_before = Vec3::Zero(), middle_after = Vec3::Zero();
  const double n = static_cast<double>(grains.size());
  for (std::size_t k = 0; k < grains.size(); ++k) {
    const std::size_t i = grains[k];
    // Both positions move by the same image, so that grains that left through a face are neighbours again.
    Vec3 image = Vec3::Zero();
    const Vec3 reduced = inverse * reference.grains.position[same[i]];
    for (int a = 0; a < d; ++a)
      if (reference.cell.periodic[static_cast<std::size_t>(a)]) image[a] = -std::floor(reduced[a]);
    if (!images.empty()) image = images[k].cast<double>();
    before.emplace_back(reference.grains.position[same[i]] + reference.cell.matrix * image);
    after.emplace_back(present.grains.position[i] + present.cell.matrix * image);
    middle_before += before.back() / n;
    middle_after += after.back() / n;
  }
  Mat3 spread = Mat3::Zero(), mapped = Mat3::Zero();
  for (std::size_t k = 0; k < before.size(); ++k) {
    spread += (before[k] - middle_before) * (before[k] - middle_before).transpose();
    mapped += (after[k] - middle_after) * (before[k] - middle_before).transpose();
  }
  if (d == 2) spread(2, 2) = mapped(2, 2) = spread(0, 0) + spread(1, 1);
  const Eigensystem<Mat3> extent = eigensystem(spread);
  if (grains.size() <= static_cast<std::size_t>(d) || extent.values[0] <= 1e-12 * extent.values[2])
    throw DataError(
        fmt::format("{} grains are too few, or too flat, for a strain; take a larger volume", grains.size()));
  return mapped * spread.inverse();
}

}  // namespace soilweave::analysis
