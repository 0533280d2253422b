// Bins in reduced coordinates. The grains of a bin, moved into the cell, lie side by side and are tested four at a
// time.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/sweep/pair_search.h"

#include <Eigen/LU>
#include <algorithm>
#include <bit>
#include <cmath>
#include <span>

#include "core/in_parallel.h"

namespace soilweave::dem {
namespace {

// Grid whose bins are at least one interaction length wide along every axis.
class Grid {
 public:
  Grid(const Bodies& bodies, const Cell& cell, const std::vector<double>& reach, double length, int threads)
      : bodies_(bodies), cell_(cell), reach_(reach) {
    frame(length);
    const std::size_t grains = bodies.size();
    bin_of_.resize(grains), wrap_.resize(grains), members_.resize(grains);
    start_.assign(static_cast<std::size_t>(bins_.prod()) + 1, 0);
    in_parallel(grains, threads, [&](std::size_t i) { place(i); });
    for (std::size_t i = 0; i < grains; ++i) ++start_[bin_of_[i] + 1];
    for (std::size_t b = 1; b < start_.size(); ++b) start_[b] += start_[b - 1];
    for (auto* column : {&x_, &y_, &z_, &reaches_}) column->resize(grains + width<Lane4>);
    std::vector<std::uint32_t> next = start_;
    for (std::size_t i = 0; i < grains; ++i) {
      const std::uint32_t m = next[bin_of_[i]]++;
      const Vec3 x = within(i);
      members_[m] = static_cast<std::int32_t>(i);
      x_[m] = x[0], y_[m] = x[1], z_[m] = x[2], reaches_[m] = reach[i];
    }
  }

  // Adds the near pairs of i with grains j > i, sorted.
  void near(std::size_t i, std::vector<Pair>& found) const {
    const auto begin = static_cast<std::ptrdiff_t>(found.size());
    const Vec3i home = coordinates(static_cast<int>(bin_of_[i]));
    const int reach_z = bodies_.dimension == 3 ? 1 : 0;
    for (int dz = -reach_z; dz <= reach_z; ++dz)
      for (int dy = -1; dy <= 1; ++dy) {
        // Bins are contiguous along x, except at the end of the cell.
        const int from = std::max(home[0] - 1, 0), to = std::min(home[0] + 1, bins_[0] - 1);
        near(i, {from, home[1] + dy, home[2] + dz}, to - from, found);
        if (home[0] == 0) near(i, {-1, home[1] + dy, home[2] + dz}, 0, found);
        if (home[0] == bins_[0] - 1) near(i, {bins_[0], home[1] + dy, home[2] + dz}, 0, found);
      }
    std::sort(found.begin() + begin, found.end(), before);
  }

 private:
  // Adds the pairs in a bin and in `more` bins after it.
  void near(std::size_t i, Vec3i bin, int more, std::vector<Pair>& found) const {
    Vec3i turn = Vec3i::Zero();
    if (!fold(bin, turn)) return;
    const CellOffset offset = cell_offset(turn);
    const Vec3 from = within(i) - shift_of(offset, cell_.matrix());
    const Lane4 x = broadcast<Lane4>(from[0]), y = broadcast<Lane4>(from[1]), z = broadcast<Lane4>(from[2]);
    const Lane4 own = broadcast<Lane4>(reach_[i]);
    const std::size_t first = index(bin);
    const std::uint32_t end = start_[first + static_cast<std::size_t>(more) + 1];
    for (std::uint32_t m = start_[first]; m < end; m += width<Lane4>) {
      const V3<Lane4> d{load<Lane4>(&x_[m]) - x, load<Lane4>(&y_[m]) - y, load<Lane4>(&z_[m]) - z};
      const Lane4 reach = load<Lane4>(&reaches_[m]) + own;
      for (unsigned near = bits(Mask<Lane4>(norm2(d) < reach * reach)); near != 0; near &= near - 1) {
        const std::uint32_t at = m + static_cast<std::uint32_t>(std::countr_zero(near));
        if (at >= end) break;
        const auto j = static_cast<std::size_t>(members_[at]);
        if (j <= i) continue;
        const CellOffset image = offset + wrap_[i] - wrap_[j];
        // Yarns have no images, so a fabric touches its own image like another fabric.
        if (image != 0 || !bodies_.in_one_fabric(i, j))
          found.push_back({static_cast<std::int32_t>(i), members_[at], image});
      }
    }
  }

  // Periodic axes are binned over the cell, others over the extent of the grains.
  void frame(double length) {
    inverse_ = cell_.matrix().inverse();
    const Vec3 widths = cell_.widths();
    for (int a = 0; a < 3; ++a) {
      low_[a] = 0, span_[a] = 1;
      double width = widths[a];
      if (!cell_.periodic(a)) {
        double low = 0, high = 0;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
          const double s = inverse_.row(a).dot(vector_of(bodies_.grains[i].position));
          low = i == 0 ? s : std::min(low, s), high = i == 0 ? s : std::max(high, s);
        }
        low_[a] = low, span_[a] = std::max(high - low, 1e-300) * (1 + 1e-12);
        width *= span_[a];
      }
      bins_[a] = static_cast<int>(std::clamp(std::floor(width / length), 1.0, 256.0));
    }
  }
  void place(std::size_t i) {
    Vec3i bin;
    Vec3i wrap = Vec3i::Zero();
    for (int a = 0; a < 3; ++a) {
      double s = (inverse_.row(a).dot(vector_of(bodies_.grains[i].position)) - low_[a]) / span_[a];
      if (cell_.periodic(a)) {
        wrap[a] = static_cast<int>(std::floor(s));
        s -= std::floor(s);
      }
      bin[a] = static_cast<int>(std::clamp(s * bins_[a], 0.0, bins_[a] - 1.0));
    }
    wrap_[i] = cell_offset(wrap);
    bin_of_[i] = static_cast<std::uint32_t>(index(bin));
  }
  Vec3 within(std::size_t i) const {
    return vector_of(bodies_.grains[i].position) - shift_of(wrap_[i], cell_.matrix());
  }
  bool fold(Vec3i& bin, Vec3i& turn) const {
    for (int a = 0; a < 3; ++a) {
      if (bin[a] >= 0 && bin[a] < bins_[a]) continue;
      if (!cell_.periodic(a)) return false;
      turn[a] = bin[a] < 0 ? -1 : 1;
      bin[a] -= turn[a] * bins_[a];
    }
    return true;
  }
  std::size_t index(const Vec3i& bin) const {
    return static_cast<std::size_t>((bin[2] * bins_[1] + bin[1]) * bins_[0] + bin[0]);
  }
  Vec3i coordinates(int b) const { return {b % bins_[0], (b / bins_[0]) % bins_[1], b / (bins_[0] * bins_[1])}; }

  const Bodies& bodies_;
  const Cell& cell_;
  const std::vector<double>& reach_;
  Mat3 inverse_;
  Vec3 low_, span_;
  Vec3i bins_;
  std::vector<std::uint32_t> bin_of_, start_;
  std::vector<std::int32_t> members_;        // bin by bin
  std::vector<double> x_, y_, z_, reaches_;  // positions and reaches of the members, m
  std::vector<CellOffset> wrap_;             // cells from a grain's wrapped to its unwrapped position
};

}  // namespace

void find_pairs(const Bodies& bodies, const Cell& cell, const std::vector<double>& reach, double longest, int threads,
                std::vector<Pair>& found) {
  const Grid grid(bodies, cell, reach, longest, threads);
  // Each thread searches a contiguous range of grains. The first thread's list finally takes the others.
  std::vector<std::vector<Pair>> others(static_cast<std::size_t>(threads) - 1);
  const std::size_t shares = others.size() + 1;
  in_parallel(shares, threads, [&](std::size_t share) {
    std::vector<Pair>& mine = share == 0 ? found : others[share - 1];
    mine.clear();
    const std::size_t end = (share + 1) * bodies.size() / shares;
    for (std::size_t i = share * bodies.size() / shares; i < end; ++i) grid.near(i, mine);
  });
  for (const std::vector<Pair>& more : others) found.insert(found.end(), more.begin(), more.end());
  const PairOrder order(bodies);
  if (order.is_that_of_grains()) return;
  // Pairs in the order of grains are also in the order of chunks. Within a chunk they are sorted by materials.
  std::vector<std::span<Pair>> parts;
  for (std::size_t chunk = 0; chunk < chunks_of(bodies.size()); ++chunk)
    parts.push_back(of_chunk(std::span(found), chunk));
  in_parallel(parts.size(), threads, [&](std::size_t k) { std::sort(parts[k].begin(), parts[k].end(), order); });
}

}  // namespace soilweave::dem
