// Reinforced soil in a periodic cell with soil around it: the table [surround] of a plan, and the assembly before
// compaction.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/named_file.h"
#include "core/settings.h"
#include "io/provenance.h"
#include "io/records.h"
#include "packing/generate.h"

namespace soilweave::packing {

struct Surround {
  /// wrapped: the file as it is. layered: its soil between the faces of its geotextiles, without the sides.
  enum class Form { wrapped, layered };

  Form form = Form::wrapped;
  double rings = 1;  // copies along each edge of the block whose soil is left out of the layered form
  std::optional<std::array<int, 3>> copies;  // of the representative volume; none: as many as cover the file
  double scale = 1;                          // of the representative volume's lengths
  std::int32_t material = 2;                 // material_id of the fill
  std::optional<double> gap;                 // m, between the reinforced part and its image; none: of the fill's grains
  std::optional<double> max_rate;            // 1/s; none: so slow that the fill strikes nothing
  double height_tolerance = 0.02, stress_tolerance = 0.2;
  io::Snapshot volume;  // the representative one
  Recipe recipe;

  /// Reads the table and the representative volume that it names.
  static Surround read(Settings& table, const NamedFiles& files, std::vector<io::Source>& sources);
};

/// A cell before it is compacted.
struct Surrounded {
  io::Snapshot state;          // periodic, the fill loose
  std::vector<bool> fill;      // by body
  bool cut_away = false;       // whether the fill are the grains that were cut from the same block
  Vec3 shares = Vec3::Ones();  // of the strain rate by axis, with which all gaps close at one speed
};

/// Puts what the block of copies has around the reinforced part of the file into a loose cell, near where it was.
/// copy_id: -1 of fill, as of nodes. density: of the fill, kg/m3; 0: the representative volume's. Throws DataError
/// where the file has no geotextile, the block is smaller than the reinforced part, or the cell that is asked for has
/// no room for it or for the fill.
Surrounded surround(const io::Snapshot& reinforced, const Surround& how, double density);

}  // namespace soilweave::packing
