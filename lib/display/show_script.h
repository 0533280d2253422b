// The ParaView script beside the files of to-vtk.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace soilweave::io {

/// Returns show.py as it was when the program was built.
std::string_view show_script();

}  // namespace soilweave::io
