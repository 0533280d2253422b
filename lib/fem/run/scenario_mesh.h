// The table [mesh] of a two-scale scenario.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "core/text/settings.h"
#include "fem/mesh/mesh.h"

namespace soilweave::fem {

/// Reads [mesh] and returns the mesh: the given one of a file, or else a rectangle. Adds mistakes for keys of the
/// other, and for a mesh of a file whose parts do not join as its keys tell.
Mesh read_mesh(Settings& table, std::optional<Mesh> given);
/// Returns the points of integration that [mesh] chooses for elements of a shape.
Integration read_integration(Settings& table, Shape shape);

}  // namespace soilweave::fem
