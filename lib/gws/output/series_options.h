// Options of identification.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/cli/tool.h"
#include "files/provenance.h"
#include "gws/identification/identify.h"

namespace soilweave::gws {

/// Choice of series, and of their fit.
struct SeriesOptions {
  std::vector<std::filesystem::path> inputs;
  std::vector<std::string> geotextiles;
  std::string group, strains = "engineering", difference = "central", fit = "path";
  std::filesystem::path failure, compression;

  void declare(tool::Table& table);
  /// Adds usage mistakes, one per line.
  void check(std::vector<std::string>& wrong) const;
  Method method() const { return fit == "path" ? Method::path : Method::thesis; }
  /// Reads the bags. Throws DataError, MissingInput.
  std::vector<BagSeries> bags(std::vector<io::Source>& sources) const;
  /// Reads points of other tests, and identifies the soil.
  Identification identified(const std::vector<BagSeries>& bags, const SoilFile& given,
                            std::vector<io::Source>& sources) const;
};

}  // namespace soilweave::gws
