// The processes that share the points of one run. Alone, there is one; `make mpi` links fem-dem with ranks_mpi.cpp
// in place of ranks.cpp, to be started by mpirun.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace soilweave::fem {

/// A process of a run. Every process computes the same soil and geosynthetic; points are dealt out in turn. Only the
/// first process reads and writes checkpoints and writes the output.
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
  /// Return whether this process computes a point, and which process does.
  bool owns(std::size_t point) const { return static_cast<int>(point % static_cast<std::size_t>(size_)) == rank_; }
  int owner(std::size_t point) const { return static_cast<int>(point % static_cast<std::size_t>(size_)); }

  // All processes must call these functions together.

  /// Shares numbers of all points, `width` each: numbers of a process's own points go to every process, bit for bit.
  void share(std::vector<double>& values, std::size_t width) const;
  /// Returns the failure of the lowest task over all processes, at most 1000 bytes; empty without a failure.
  std::string agree(const std::string& failure, std::int64_t task) const;
  /// Returns the number that the first process passes.
  std::int64_t told(std::int64_t number) const;
  std::string told(const std::string& bytes) const;
  /// Sends bytes from a process to the first one, which returns them; others return an empty text.
  std::string to_first(const std::string& bytes, int from) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace soilweave::fem
