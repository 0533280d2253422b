// The ParaView script that to-vtk lays beside its files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace soilweave::io {

/// Returns the script, show.py as it was when this program was built.
std::string_view show_script();

}  // namespace soilweave::io
