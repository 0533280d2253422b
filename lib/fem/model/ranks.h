// The processes that share the points of one run. Alone, there is one; `make mpi` links fem-dem with ranks_mpi.cpp
// in place of ranks.cpp, to be started by mpirun.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace soilweave::fem {

/// A process of a run. Every process computes the same soil and geosynthetic; points are dealt out in turn. Only the
/// first one handles checkpoints and output.
class Ranks {
 public:
  /// Joins the processes of this run.
  Ranks();
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  /// Returns whether this is the first process.
  bool first() const { return rank_ == 0; }
  /// Returns the number of processes.
  int size() const { return size_; }
  /// Returns whether this process computes a point.
  bool owns(std::size_t point) const { return static_cast<int>(point % static_cast<std::size_t>(size_)) == rank_; }
  /// Returns the process that computes a point.
  int owner(std::size_t point) const { return static_cast<int>(point % static_cast<std::size_t>(size_)); }

  // All processes must call these functions together.

  /// Shares numbers of all points, `width` each, with every process, bit for bit.
  void share(std::vector<double>& values, std::size_t width) const;
  /// Returns the lowest task's failure, at most 1000 bytes; empty without one.
  std::string agree(const std::string& failure, std::int64_t task) const;
  /// Returns the number that the first process passes.
  std::int64_t told(std::int64_t number) const;
  std::string told(const std::string& bytes) const;
  /// Returns bytes of a process to the first one, an empty text to others.
  std::string to_first(const std::string& bytes, int from) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace soilweave::fem
