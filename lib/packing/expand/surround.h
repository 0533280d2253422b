// Reinforced soil in a periodic cell with soil around it: the table [surround] of a plan, and the assembly before
// compaction.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/text/named_file.h"
#include "core/text/settings.h"
#include "files/provenance.h"
#include "files/records.h"
#include "packing/generate/generate.h"

namespace soilweave::packing {

/// The table [surround]; PLAN.md describes it.
struct Surround {
  /// wrapped: the file as it is. layered: its soil between the faces of its geotextiles, without the sides.
  enum class Form { wrapped, layered };

  Form form = Form::wrapped;
  double rings = 1;  // copies along each edge of the block whose soil the layered form leaves out
  std::optional<std::array<int, 3>> copies;  // copies of the representative volume; none: as many as cover the file
  double scale = 1;                          // factor on the representative volume's lengths
  std::int32_t material = 2;                 // material_id of the fill
  std::optional<double> gap;  // distance between the reinforced part and its image, m; none: from the fill's grains
  std::optional<double> max_rate;  // strain rate, 1/s; none: so slow that the fill strikes nothing
  double height_tolerance = 0.02, stress_tolerance = 0.2;
  bool missed_is_error = true;  // false: a cell that misses a criterion is a result with doubts
  io::Snapshot volume;          // the representative volume
  Recipe recipe;

  /// Reads the table, and the representative volume that it names.
  static Surround read(Settings& table, const NamedFiles& files, std::vector<io::Source>& sources);
};

/// A cell before compaction.
struct Surrounded {
  io::Snapshot state;          // periodic, with loose fill
  std::vector<bool> fill;      // whether a body is fill
  bool cut_away = false;       // whether the fill grains were cut from the same block
  Vec3 shares = Vec3::Ones();  // shares of the strain rate by axis, with which all fill becomes equally dense
};

/// Puts the grains of the block of copies that surround the reinforced part into a loose cell, at random places.
/// copy_id: -1 for fill, as for nodes. density: of the fill, kg/m3; 0: the representative volume's. Throws DataError if
/// the file has no geotextile, the block is smaller than the reinforced part, or the cell has no room for it or for the
/// fill.
Surrounded surround(const io::Snapshot& reinforced, const Surround& how, double density);

}  // namespace soilweave::packing
