// Soil around reinforced soil in a periodic cell, before compaction.
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
  /// wrapped: the file as it is. layered: soil between the geotextiles' faces, without sides.
  enum class Form { wrapped, layered };

  /// Shape of the reinforced part.
  Form form = Form::wrapped;
  /// Copies left out along each edge of the block, for layered soil.
  double rings = 1;
  /// Copies of the representative volume. None: as many as cover the file.
  std::optional<std::array<int, 3>> copies;
  /// Factor on the representative volume's lengths.
  double scale = 1;
  /// material_id of the fill.
  std::int32_t material = 2;
  /// Least distance between the part and its image, m. None: one mean diameter of the fill.
  std::optional<double> gap;
  /// Strain rate, 1/s. None: the rate at which the fill's impact is 0.4 % of the pressure.
  std::optional<double> max_rate;
  /// Relative tolerances of the part's height and of the fill's mean stress.
  double height_tolerance = 0.02, stress_tolerance = 0.2;
  /// False: a cell that misses a criterion is a result with doubts.
  bool missed_is_error = true;
  /// Representative volume.
  io::Snapshot volume;
  /// Compaction of the fill.
  Recipe recipe;

  /// Reads the table and the representative volume.
  static Surround read(Settings& table, const NamedFiles& files, std::vector<io::Source>& sources);
};

/// A cell before compaction.
struct Surrounded {
  /// State of the periodic cell, with loose fill.
  io::Snapshot state;
  /// Whether each body is fill.
  std::vector<bool> fill;
  /// Whether the fill was cut from the same block.
  bool cut_away = false;
  /// Shares of the strain rate by axis that make all fill equally dense.
  Vec3 shares = Vec3::Ones();
};

/// Puts the grains around the reinforced part at random places in a loose cell. copy_id: -1 for fill and nodes.
/// density: density of the fill, kg/m3; 0: the representative volume's. Throws DataError if the file has no geotextile,
/// the block is smaller than the reinforced part, or the cell lacks room.
Surrounded surround(const io::Snapshot& reinforced, const Surround& how, double density);

}  // namespace soilweave::packing
