// The schema as the tables of FORMAT.md.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace soilweave::io::test {

std::string schema_tables();

}  // namespace soilweave::io::test
