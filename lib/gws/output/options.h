// Options on geotextile, bag, soil and lateral stress, shared by the verbs of gws-solve.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/cli/tool.h"
#include "files/provenance.h"
#include "gws/design/design.h"
#include "gws/design/factors.h"
#include "gws/identification/identify.h"
#include "gws/solution/doubts.h"
#include "gws/solution/respond.h"

namespace soilweave::gws {

inline constexpr Parameter surcharge_range{"surcharge",
                                           "Pa",
                                           0,
                                           1e9,
                                           true,
                                           "pressure the geotextile is looked for; without, the bag's own",
                                           "1 GPa is far beyond any test of soil"};
inline constexpr Parameter last_surcharge{"surcharge",
                                          "Pa",
                                          0,
                                          1e9,
                                          true,
                                          "end at this pressure; else at the ultimate one",
                                          "1 GPa is far beyond any test of soil"};
inline constexpr Parameter settlement_range{"settlement",
                                            "1",
                                            0,
                                            1,
                                            true,
                                            "axial strain: settlement over height",
                                            "at 1 the bag is flat; per cent are written \"5 %\""};
inline constexpr Parameter points_range{"points", "1", 1, 1e6, false, "rows of the table", "a table has rows"};
inline constexpr Parameter share_range{
    "range", "1", 0, 1, true, "share varied where no interval is known", "a constant keeps its sign"};
inline constexpr Parameter samples_range{"samples",         "1", 2, 1e6, false, "bands from this many draws",
                                         "a band needs two"};
inline constexpr Parameter safety_range{
    "safety", "1", 1, 100, false, "factor of safety on the surcharge, against failure", "below 1 it fails"};
inline constexpr Parameter lowest_stiffness{
    "from", "N/m", 0, 1e10, true, "lowest stiffness", "without stiffness the geotextile holds nothing"};
inline constexpr Parameter highest_stiffness{
    "to", "N/m", 0, 1e10, true, "highest stiffness", "without stiffness the geotextile holds nothing"};

/// Soil if none is chosen.
inline constexpr const char* default_soil = "toyoura-gws";

/// Adds a usage mistake if an option's pressure is below 1 kPa, probably because kPa were given without their unit.
void doubt_pressure(const char* option, double pressure, std::vector<std::string>& wrong);

/// A case with its sources.
struct ReadCase {
  Case the_case;
  SoilFile soil;
  std::vector<io::Source> sources;
  /// Soil as TOML, for provenance.
  std::string scenario;
  Factors factors;
  /// A doubt about the geotextile's own numbers.
  std::vector<Doubt> about_geotextile;
  /// Whether the user chose the soil and the strength fraction.
  bool chose_soil = false, chose_fraction = false;

  /// Returns the first line of an answer: an unchosen or estimated soil; else nothing.
  std::string soil_line() const;
  /// Returns the surcharge that must not bring failure: the given one times the factor on load.
  std::optional<double> asked(const std::optional<double>& surcharge) const;
  /// Returns the basis of the answer for `bag` (gws/design/factors.h).
  std::string conditions(const Case& bag) const;
  /// Returns the doubts about an answer (gws/solution/doubts.h).
  std::vector<Doubt> doubts(const std::vector<double>& stiffnesses, const std::vector<Point>& states) const;
  /// Returns the doubts about a response: those of doubts(), and "weakened" where a factor on the soil changes its
  /// settlements.
  std::vector<Doubt> response_doubts(const std::vector<double>& stiffnesses, const std::vector<Point>& states) const;
  /// Returns the doubts about a chart.
  std::vector<Doubt> chart_doubts(const std::vector<ChartRow>& rows) const;
};

/// Options of a bag.
struct CaseOptions {
  /// Names of geotextile and soil; empty: none was chosen.
  std::string geotextile, soil;
  std::optional<double> stiffness, strength, failure_strain, initial_settlement, initial_surcharge;
  std::vector<std::string> assignments;
  std::filesystem::path history;
  double width = 0.4, height = 0.08, lateral = 0, tolerance = 1e-6;
  /// Fraction of the strength; empty: default of Case.
  std::optional<double> fraction;
  Factors factors;

  /// Declares the options in a tool's table.
  void declare(tool::Table& table);
  /// Returns usage mistakes, one a line.
  std::vector<std::string> mistakes(bool needs_geotextile) const;
  /// Reads the files and names. Throws DataError or MissingInput.
  ReadCase read() const;

 private:
  Geotextile read_geotextile() const;
  LateralStress read_lateral(std::vector<io::Source>& sources) const;
};

/// Returns a soil by name (data/soils) or from a TOML file. With --set assignments, "(changed)" is added to its name.
SoilFile find_soil(const std::string& name, const std::vector<std::string>& assignments,
                   std::vector<io::Source>& sources, std::string& resolved);

/// Reads a table from TSV text or a group of an HDF5 fields file. "-" is standard input.
io::Series read_series(const std::filesystem::path& path, const std::string& group, std::vector<io::Source>& sources);

/// Reads one bag per path: a run of run-dem, RUN.part of an unfinished run, or a table for read_series(). geotextiles:
/// one per bag, or none. natural: strains of plain tables are logarithmic; those of a bag's loading never are.
std::vector<BagSeries> read_bags(const std::vector<std::filesystem::path>& paths, const std::string& group,
                                 const std::vector<std::string>& geotextiles, bool natural,
                                 std::vector<io::Source>& sources);

}  // namespace soilweave::gws
