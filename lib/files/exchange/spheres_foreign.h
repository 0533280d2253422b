// Recognises texts of spheres in the formats of other programs by their first lines.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace soilweave::io {

/// Returns the other program's format, with commands that convert it; empty for a plain list. Lines must end with line
/// feeds.
std::string foreign_spheres(std::string_view text);

}  // namespace soilweave::io
