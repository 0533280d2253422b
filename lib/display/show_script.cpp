// The ParaView script that to-vtk lays beside its files.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "display/show_script.h"

#include "core/embedded.h"

SOILWEAVE_EMBED(show_py, "lib/display/show.py")

namespace soilweave::io {

std::string_view show_script() { return {show_py_begin, show_py_end}; }

}  // namespace soilweave::io
