// Packings that pack-generate starts from.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "packing/generate/imported.h"

#include <utility>

#include "core/error.h"
#include "dem/state/bodies.h"
#include "packing/generate/spatial_order.h"

namespace soilweave::packing {

bool is_packing_file(const std::filesystem::path& path) { return path.extension() == ".h5" || io::is_hdf5(path); }

Imported import_packing(const std::filesystem::path& path, const std::optional<double>& density,
                        io::SpheresOptions options) {
  if (!is_packing_file(path)) {
    options.density = density.value_or(default_density);
    io::ImportedSpheres read = io::import_spheres(path, options);
    return {in_spatial_order(read.state), std::move(read.source), std::move(read.notes)};
  }
  io::PackingFile file = io::read_state(path);
  if (density) dem::set_density(file.state, *density);
  return {in_spatial_order(file.state), std::move(file.source), {}};
}

void demand_no_geotextile(const io::Snapshot& state, const std::filesystem::path& where) {
  if (state.yarns.size() > 0)
    throw DataError(where.string() +
                    ": has a geotextile, which is not compacted here: give --as-is, put soil around it by "
                    "filter-expand with [surround], or load it by run-dem");
}

}  // namespace soilweave::packing
