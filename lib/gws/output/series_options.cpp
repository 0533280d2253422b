// The options of identification.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/output/series_options.h"

#include <fmt/format.h>

#include "gws/identification/points.h"
#include "gws/output/options.h"

namespace soilweave::gws {

void SeriesOptions::declare(tool::Table& t) {
  t.inputs(inputs, "SERIES", "runs of bags; TSV or fields: strain_axial, _volumetric, mean_ and deviatoric_stress");
  t.option(geotextiles, "geotextile", "NAME|FILE",
           "geotextile of each series in turn; else the run's own, or column tensile_stiffness");
  t.option(group, "group", "NAME", "table of a fields file; else loading, reinforced, response or cell");
  t.choice(strains, "strains", {"engineering", "natural"},
           "strains in tables; homogenize writes natural ones of cells");
  t.choice(fit, "fit", {"path", "thesis"}, "all at once, plastic strain taken off; line by line, with it");
  t.choice(difference, "difference", {"central", "backward"}, "state that an increment belongs to");
  t.option(compression, "compression", "FILE", "TSV with mean_stress, strain_volumetric: the line's points");
  t.option(failure, "failure", "FILE", "TSV with confining_pressure, obliquity_at_failure");
}

void SeriesOptions::check(std::vector<std::string>& wrong) const {
  if (!geotextiles.empty() && geotextiles.size() != inputs.size())
    wrong.push_back(
        fmt::format("--geotextile: {} for {} series; give one for each", geotextiles.size(), inputs.size()));
}

std::vector<BagSeries> SeriesOptions::bags(std::vector<io::Source>& sources) const {
  return read_bags(inputs, group, geotextiles, strains == "natural", sources);
}

Identification SeriesOptions::identified(const std::vector<BagSeries>& bags, const SoilFile& given,
                                         std::vector<io::Source>& sources) const {
  const Points line = compression_points(compression, sources);
  const Points peaks = failure_points(failure, method() == Method::thesis, sources);
  return identify(bags, given, line, peaks, difference == "central" ? Difference::central : Difference::backward,
                  method());
}

}  // namespace soilweave::gws
