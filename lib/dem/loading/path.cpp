// Keys that loading paths share.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "dem/loading/path.h"

#include <fmt/format.h>

#include <cmath>

#include "core/text/beside.h"

namespace soilweave::dem {

std::vector<double> stations_every(double step, double end, Settings& table) {
  constexpr double coarse = 0.05;
  if (step >= coarse && step > std::abs(end) && end != 0)
    table.mistake(
        "increment",
        fmt::format("is {0:.4g}, beyond the strain of {1:.4g}, so that the end alone would be recorded: if "
                    "{0:.4g} % is meant, write \"{0:.4g} %\", else leave it out and give stations = [{1:.4g}]",
                    step, end));
  const double count = std::max(1.0, std::ceil(std::abs(end) / step * (1 - 1e-12)));
  constexpr double most = 1e6;
  if (count > most) {
    table.mistake("increment",
                  fmt::format("makes {:.3g} stations, and at most {:.0f} are recorded: give at least {:.3g}", count,
                              most, std::abs(end) / most));
    return {end};
  }
  const auto n = static_cast<std::size_t>(count);
  std::vector<double> stations;
  for (std::size_t k = 1; k <= n; ++k)
    stations.push_back(k == n ? end : std::copysign(step * static_cast<double>(k), end));
  return stations;
}

StrainStations read_strain_stations(Settings& table) {
  static constexpr Parameter axial{"axial_strain",
                                   "1",
                                   -2,
                                   2,
                                   false,
                                   "natural axial strain of the stage, compression positive",
                                   "beyond it the cell has changed by more than a factor of seven"};
  static constexpr Parameter increment{"increment", "1", 0, 1, true, "axial strain between recorded stations"};
  static constexpr Parameter list_key{
      "stations", "1", -2, 2, false, "axial strains of the stage to record at, instead of axial_strain"};
  static constexpr Parameter rate{"rate", "1/s", 0, 1e3, true, "largest axial strain rate"};
  StrainStations s;
  s.rate = table.number(rate, 0.1);
  if (table.has("stations")) {
    refuse_beside(table, "stations", {axial.name, increment.name});
    s.strain = table.numbers(list_key);
    return s;
  }
  const double end = table.number(axial);
  const double step = table.number(increment, 1e-3);
  s.strain = stations_every(step, end, table);
  return s;
}

double read_max_rate(Settings& table) {
  static constexpr Parameter max_rate{"max_rate", "1/s", 0,
                                      1e3,        true,  "largest strain rate of the stress-controlled axes"};
  return table.number(max_rate, 1.0);
}

double read_stress(Settings& table, std::string_view key, std::string_view sentence) {
  return table.number(Parameter{key, "Pa", 0, 1e12, true, sentence, "a packing of dry grains carries no tension"});
}

}  // namespace soilweave::dem
