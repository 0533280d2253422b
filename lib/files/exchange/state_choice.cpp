// The states of a file that --state names.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "files/exchange/state_choice.h"

#include <fmt/format.h>

#include <charconv>
#include <cstdint>
#include <numeric>

#include "core/error.h"

namespace soilweave::io {

void check_states(const std::string& which, std::vector<std::string>& mistakes) {
  std::int64_t number = 0;
  const auto [end, error] = std::from_chars(which.data(), which.data() + which.size(), number);
  const bool whole_number = error == std::errc{} && end == which.data() + which.size();
  if (!whole_number && which != "all" && which != "first" && which != "last")
    mistakes.push_back(fmt::format("--state {}: give all, first, last or a number", which));
}

std::vector<std::size_t> chosen_states(const std::string& which, std::size_t count, const std::string& where) {
  const auto n = static_cast<std::int64_t>(count);
  std::vector<std::size_t> chosen;
  if (which == "all") {
    chosen.resize(count);
    std::iota(chosen.begin(), chosen.end(), std::size_t{0});
    return chosen;
  }
  std::int64_t number = which == "last" ? n - 1 : 0;
  if (which != "last") std::from_chars(which.data(), which.data() + which.size(), number);
  if (number < 0) number += n;
  if (number < 0 || number >= n)
    throw UsageError(fmt::format("--state {}: {} holds {}", which, where,
                                 n == 1 ? "1 state, number 0" : fmt::format("{} states, 0 to {}", n, n - 1)));
  chosen.push_back(static_cast<std::size_t>(number));
  return chosen;
}

}  // namespace soilweave::io
