// The ParaView script that to-vtk lays beside its files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace soilweave::io {

extern const std::string_view show_script;

}  // namespace soilweave::io
