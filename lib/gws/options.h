// The options that say which bag is meant: geotextile, bag, soil, lateral stress. Shared by the verbs of gws-solve.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/tool.h"
#include "gws/respond.h"
#include "io/provenance.h"

namespace soilweave::gws {

inline constexpr Parameter surcharge_range{
    "surcharge", "Pa", 0, 1e9, true, "vertical pressure on the bag", "1 GPa is far beyond any test of soil"};
inline constexpr Parameter settlement_range{"settlement",          "1", 0, 1, true, "axial strain, of the height",
                                            "at 1 the bag is flat"};

/// A case with where its parts came from.
struct ReadCase {
  Case the_case;
  SoilFile soil;
  std::vector<io::Source> sources;
  std::string scenario;  // the soil as TOML, for provenance
};

struct CaseOptions {
  std::string geotextile, soil = "toyoura-gws";
  std::optional<double> stiffness, strength, failure_strain;
  std::vector<std::string> assignments;
  std::filesystem::path history;
  double width = 0.4, height = 0.08, lateral = 0, fraction = 0.5, tolerance = 1e-6;

  void declare(tool::Table& table);
  /// Usage mistakes, one a line.
  std::vector<std::string> mistakes(bool needs_geotextile) const;
  /// Reads the files and names. Throws DataError, MissingInput.
  ReadCase read() const;

 private:
  Geotextile read_geotextile() const;
  LateralStress read_lateral(std::vector<io::Source>& sources) const;
};

/// A soil by name (data/soils) or from a TOML file, with --set assignments.
SoilFile find_soil(const std::string& name, const std::vector<std::string>& assignments,
                   std::vector<io::Source>& sources, std::string& resolved);

}  // namespace soilweave::gws
