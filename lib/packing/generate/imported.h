// Packings that pack-generate starts from: a packing file, or a text of spheres.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "files/exchange/spheres_text.h"
#include "files/files.h"

namespace soilweave::packing {

/// Default density of grains, kg/m3, scaled.
inline constexpr double default_density = 2650e3;

/// A packing that was read.
struct Imported {
  /// Grains in spatial order.
  io::Snapshot state;
  io::Source source;
  /// Left-out content, one sentence each.
  std::vector<std::string> notes;
};

/// Returns whether a file is a packing file, by its ending or its first bytes.
bool is_packing_file(const std::filesystem::path& path);

/// Reads a packing file or a text. A given density replaces the masses of a packing file, except those of nodes.
Imported import_packing(const std::filesystem::path& path, const std::optional<double>& density,
                        io::SpheresOptions options);

/// Throws DataError naming `where` if the packing has a geotextile, which a compaction does not load.
void demand_no_geotextile(const io::Snapshot& state, const std::filesystem::path& where);

}  // namespace soilweave::packing
