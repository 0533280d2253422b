// The processes that share the points of one run. Without MPI there is one. `make mpi` links fem-dem with ranks_mpi.cpp
// instead of ranks.cpp; mpirun starts it.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace soilweave::fem {

/// A process of a run. Every process computes the same soil and geosynthetic; points are distributed in turn. Only the
/// first process handles checkpoints and output.
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

  /// Sends each point's `width` numbers from its owner to all processes, bit for bit.
  void share(std::vector<double>& values, std::size_t width) const;
  /// Returns on all processes the failure of the lowest failed task, at most 1000 bytes; empty if none failed.
  std::string agree(const std::string& failure, std::int64_t task) const;
  /// Return on all processes the value that the first process passes.
  std::int64_t told(std::int64_t number) const;
  std::string told(const std::string& bytes) const;
  /// Returns on the first process the bytes of process `from`, on others an empty text.
  std::string to_first(const std::string& bytes, int from) const;

 private:
  int rank_ = 0, size_ = 1;
};

}  // namespace soilweave::fem
