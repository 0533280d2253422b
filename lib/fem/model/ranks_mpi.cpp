// Several processes over MPI. Only this file includes it.
// SPDX-License-Identifier: GPL-3.0-or-later
#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "fem/model/ranks.h"

namespace soilweave::fem {

Ranks::Ranks() {
  MPI_Init(nullptr, nullptr);
  MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &size_);
  if (rank_ == 0) return;
  // Only the first process may write to the terminal.
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  ::dup2(nowhere, STDOUT_FILENO);
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

Ranks::~Ranks() { MPI_Finalize(); }

void Ranks::share(std::vector<double>& values, std::size_t width) const {
  // Values of other processes are zero and bits are combined by or, because sums would lose the sign of a zero.
  std::vector<std::uint64_t> bits(values.size());
  for (std::size_t k = 0; k < values.size(); ++k)
    bits[k] = owns(k / width) ? std::bit_cast<std::uint64_t>(values[k]) : 0;
  MPI_Allreduce(MPI_IN_PLACE, bits.data(), static_cast<int>(bits.size()), MPI_UINT64_T, MPI_BOR, MPI_COMM_WORLD);
  for (std::size_t k = 0; k < values.size(); ++k) values[k] = std::bit_cast<double>(bits[k]);
}

std::string Ranks::agree(const std::string& failure, std::int64_t task) const {
  std::int64_t least = failure.empty() ? std::numeric_limits<std::int64_t>::max() : task;
  const std::int64_t mine = least;
  MPI_Allreduce(MPI_IN_PLACE, &least, 1, MPI_INT64_T, MPI_MIN, MPI_COMM_WORLD);
  if (least == std::numeric_limits<std::int64_t>::max()) return "";
  int speaker = mine == least ? rank_ : size_;
  MPI_Allreduce(MPI_IN_PLACE, &speaker, 1, MPI_INT, MPI_MIN, MPI_COMM_WORLD);
  std::string text = failure;
  text.resize(1000, ' ');
  MPI_Bcast(text.data(), static_cast<int>(text.size()), MPI_CHAR, speaker, MPI_COMM_WORLD);
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::int64_t Ranks::told(std::int64_t number) const {
  MPI_Bcast(&number, 1, MPI_INT64_T, 0, MPI_COMM_WORLD);
  return number;
}

std::string Ranks::told(const std::string& bytes) const {
  std::string heard(static_cast<std::size_t>(told(static_cast<std::int64_t>(bytes.size()))), '\0');
  if (first()) heard = bytes;
  constexpr std::size_t most = std::size_t{1} << 30;
  for (std::size_t at = 0; at < heard.size(); at += most)
    MPI_Bcast(heard.data() + at, static_cast<int>(std::min(most, heard.size() - at)), MPI_BYTE, 0, MPI_COMM_WORLD);
  return heard;
}

std::string Ranks::to_first(const std::string& bytes, int from) const {
  if (from == 0) return first() ? bytes : std::string();
  if (rank_ == from) MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, 0, 0, MPI_COMM_WORLD);
  if (!first()) return {};
  MPI_Status status;
  MPI_Probe(from, 0, MPI_COMM_WORLD, &status);
  int size = 0;
  MPI_Get_count(&status, MPI_BYTE, &size);
  std::string heard(static_cast<std::size_t>(size), '\0');
  MPI_Recv(heard.data(), size, MPI_BYTE, from, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
  return heard;
}

}  // namespace soilweave::fem
