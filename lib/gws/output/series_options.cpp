// The options of identification.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/output/series_options.h"

#include <fmt/format.h>

#include "core/error.h"
#include "gws/output/options.h"

namespace soilweave::gws {
namespace {

// Reads triaxial peaks as points (p, q/p). The thesis has the confining pressure in the place of p; else
// p = 3 sigma_r / (3 - q/p), since q = sigma_a - sigma_r.
Points failure_points(const std::filesystem::path& path, Method method, std::vector<io::Source>& sources) {
  Points peaks = read_points(path, "confining_pressure", "Pa", "obliquity_at_failure", "1", sources);
  for (std::size_t i = 0; i < peaks.x.size(); ++i) {
    if (!(peaks.x[i] > 0 && peaks.y[i] > 0 && peaks.y[i] < 3))
      throw DataError(
          fmt::format("{}: row {}: q/p = {:.4g} under {:.4g} kPa; in compression q/p lies between 0 and 3, and the "
                      "pressure above 0",
                      path.string(), i + 1, peaks.y[i], peaks.x[i] / 1e3));
    if (method == Method::path) peaks.x[i] *= 3 / (3 - peaks.y[i]);
  }
  return peaks;
}

}  // namespace

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
  const Points line = read_points(compression, "mean_stress", "Pa", "strain_volumetric", "1", sources);
  const Points peaks = failure_points(failure, method(), sources);
  return identify(bags, given, line, peaks, difference == "central" ? Difference::central : Difference::backward,
                  method());
}

}  // namespace soilweave::gws
