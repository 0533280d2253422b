// One process alone.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "fem/model/ranks.h"

namespace soilweave::fem {

Ranks::Ranks() = default;
Ranks::~Ranks() = default;
void Ranks::share(std::vector<double>&, std::size_t) const {}
std::string Ranks::agree(const std::string& failure, std::int64_t) const { return failure; }
std::int64_t Ranks::told(std::int64_t number) const { return number; }
std::string Ranks::told(const std::string& bytes) const { return bytes; }
std::string Ranks::to_first(const std::string& bytes, int) const { return bytes; }

}  // namespace soilweave::fem
