// Reports of gws-solve on identification, design and sensitivity.
// SPDX-License-Identifier: GPL-3.0-or-later
#include "gws/output/report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/error.h"
#include "core/text/text.h"
#include "gws/output/tables.h"
#include "gws/solution/model.h"

namespace soilweave::gws {
namespace {

std::string short_name(const std::string& key) { return key.substr(key.find('.') + 1); }

std::string unit_of(const std::string& key) {
  for (const Constant& c : constants())
    if (c.key() == key) return std::string(c.parameter.unit);
  return "1";
}

void put(io::Series& table, std::string name, std::string unit, std::string long_name, std::vector<double> values) {
  table.columns.push_back({std::move(name), std::move(unit), std::move(long_name), std::move(values)});
}

/// Returns the notes of the series that have one, a line each.
std::string notes(const std::vector<BagSeries>& series) {
  std::string text;
  for (const BagSeries& one : series)
    if (!one.note.empty()) text += one.note + "\n";
  return text;
}

/// Returns the limit that decides. most: what the bag carries at most where its response ends before both limits.
std::string governing(Governs governs, End end, const std::string& most) {
  switch (governs) {
    case Governs::settlement:
      return "the settlement governs";
    case Governs::strength:
      return "the strength governs";
    case Governs::range:
      return "the softest of the range will do";
    case Governs::end:
      return fmt::format("neither settlement nor strength governs,\nsince {}{}{}", most, end == End::none ? "" : ":\n",
                         end == End::none ? "" : reason(end));
  }
  return "";
}

/// Returns the name of the strength that a tension is compared with.
std::string_view compared_strength(const Case& bag) { return bag.reduction == 1 ? "strength" : "long-term strength"; }

std::string difference(double estimate, double given) {
  return given != 0 ? fmt::format("{:+.1f} %", 100 * (estimate / given - 1)) : fmt::format("{:+.3g}", estimate);
}

void put_band(io::Series& table, const std::string& name, const std::string& unit, const std::string& long_name,
              const std::vector<BandRow>& rows, Band BandRow::*field) {
  std::vector<double> low, middle, high;
  for (const BandRow& row : rows) {
    low.push_back((row.*field).low);
    middle.push_back((row.*field).middle);
    high.push_back((row.*field).high);
  }
  put(table, name + "_low", unit, long_name + ", quantile of 2.5 %", low);
  put(table, name, unit, long_name + ", median", middle);
  put(table, name + "_high", unit, long_name + ", quantile of 97.5 %", high);
}

template <class Row, class Value>
std::vector<double> column(const std::vector<Row>& rows, const Value& value) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(value(row));
  return values;
}

/// Returns sensitivities of settlement and tension at the surcharge asked for.
std::string describe_service(const std::vector<Sensitivity>& rows) {
  std::string text =
      fmt::format("At the surcharge asked for:\n{:>2} {:<25} {:>9} {:>9} {:>16}\n{:>2} {:<25} {:>9} {:>9} {:>16}\n", "",
                  "constant", "ds/dln", "dt/dln", "settlement", "", "", "%/1", "kN/m/1", "%");
  for (std::size_t i = 0; i < rows.size(); ++i)
    text += fmt::format(
        "{:>2} {:<25} {:>9.3f} {:>9.3f} {:>16}\n", i, rows[i].key,
        100 * rows[i].service_settlement_derivative * rows[i].value,
        rows[i].service_tension_derivative * rows[i].value / 1e3,
        fmt::format("{:.2f}..{:.2f}", 100 * rows[i].service_settlement_low, 100 * rows[i].service_settlement_high));
  return text;
}

}  // namespace

io::Series constants_table(const Identification& found) {
  io::Series table;
  for (const Line& line : found.lines)
    for (std::size_t k = 0; k < line.constants.size(); ++k) {
      const std::string name = short_name(line.constants[k]), unit = unit_of(line.constants[k]);
      const double value = line.fit.estimates[k], half = line.fit.half_width(k);
      const bool known = std::isfinite(half);
      put(table, name, unit, "identified", {value});
      put(table, name + "_low", unit, "low end of the 95 % interval", {known ? value - half : std::nan("")});
      put(table, name + "_high", unit, "high end of the 95 % interval", {known ? value + half : std::nan("")});
      put(table, name + "_given", unit, "value that the identification started from", {line.given[k]});
    }
  return table;
}

io::Series line_table(const Line& line) {
  io::Series table;
  const auto numbers = [](const std::vector<std::size_t>& list) {
    return std::vector<double>(list.begin(), list.end());
  };
  put(table, "series", "1", "number of the series, from 0; the next after the last: points of another test",
      numbers(line.series));
  put(table, "row", "1", "row in its series, from 0", numbers(line.row));
  put(table, line.x_name, line.x_unit, "abscissa", line.x);
  put(table, line.y_name, line.y_unit, "ordinate", line.y);
  put(table, "fitted", line.y_unit, "ordinate of the line", line.ordinate);
  put(table, "residual", line.residual_unit, "fitted value less the line's value: " + line.residual_name,
      line.fit.residuals);
  put(table, "studentized", "1", "residual over its standard error", line.fit.studentized);
  put(table, "outlier", "1", "1 where the studentized residual is beyond 3",
      column(line.fit.studentized, [](double t) { return std::abs(t) > outlier_distance ? 1.0 : 0.0; }));
  return table;
}

io::Series increments_table(const Identification& found) {
  std::vector<double> series, row;
  std::vector<Increment> all;
  for (std::size_t s = 0; s < found.increments.size(); ++s)
    for (std::size_t i = 0; i < found.increments[s].size(); ++i) {
      series.push_back(static_cast<double>(s));
      row.push_back(static_cast<double>(i + 1));
      all.push_back(found.increments[s][i]);
    }
  io::Series table;
  using I = const Increment&;
  put(table, "series", "1", "number of the series, from 0", series);
  put(table, "row", "1", "row in its series that the increment ends at, from 0", row);
  put(table, "generalized_stress", "Pa", "increment of p*", column(all, [](I d) { return d.generalized_stress; }));
  put(table, "plastic_axial", "1", "increment of plastic axial strain",
      column(all, [](I d) { return d.plastic_axial; }));
  put(table, "plastic_volumetric", "1", "increment of plastic volumetric strain",
      column(all, [](I d) { return d.plastic_volumetric; }));
  put(table, "plastic_deviatoric", "1", "increment of plastic deviatoric strain",
      column(all, [](I d) { return d.plastic_deviatoric; }));
  put(table, "obliquity", "1", "q/p that the increment belongs to", column(all, [](I d) { return d.obliquity; }));
  put(table, "failure_obliquity", "1", "q/p at failure there", column(all, [](I d) { return d.failure_obliquity; }));
  return table;
}

std::vector<std::string> table_names() {
  return {"constants",      "compression_line", "failure_line", "near_failure_line",
          "dilatancy_line", "stiffness",        "increments"};
}

std::vector<io::FieldsFile::Group> groups_of(const Identification& found) {
  std::vector<io::FieldsFile::Group> groups{{"constants", "identified constants", constants_table(found)}};
  for (const Line& line : found.lines)
    groups.push_back({line.name, "points of the line and their residuals", line_table(line)});
  if (!found.increments.empty())
    groups.push_back({"increments", "plastic strain and generalized stress from row to row", increments_table(found)});
  return groups;
}

std::string describe(const Identification& found, const std::vector<BagSeries>& series, Method method) {
  std::string text = fmt::format("{}\n{}", explained(method), notes(series));
  for (const Line& line : found.lines) {
    text += fmt::format("{}: {} points, R2 {:.4f}, residuals {:.3g}\n", line.name, line.x.size(),
                        line.fit.determination, line.fit.scatter);
    for (std::size_t k = 0; k < line.constants.size(); ++k) {
      const double value = line.fit.estimates[k], half = line.fit.half_width(k), given = line.given[k];
      text += fmt::format(
          "  {:<8} {:>11.5g} {:<4} 95 %: {:>10.5g} to {:<10.5g} given {:.5g}: {} ({})\n", short_name(line.constants[k]),
          value, unit_of(line.constants[k]) == "1" ? "" : unit_of(line.constants[k]), value - half, value + half, given,
          std::abs(given - value) <= std::max(half, 1e-9 * std::abs(given)) ? "inside" : "outside",
          difference(value, given));
    }
    for (std::size_t i = 0; i < line.x.size(); ++i) {
      if (std::abs(line.fit.studentized[i]) <= outlier_distance) continue;
      const BagSeries* bag = line.series[i] < series.size() ? &series[line.series[i]] : nullptr;
      text += fmt::format("  outlier, kept: row {} of {}: {:.4g} where the line has {:.4g}, {:+.1f} standard errors\n",
                          (bag ? bag->row[line.row[i]] : line.row[i]) + 1, bag ? bag->name : "the other test",
                          line.fit.fitted[i] + line.fit.residuals[i], line.fit.fitted[i], line.fit.studentized[i]);
    }
  }
  for (const std::string& why : found.left_out) text += "not identified: " + why + "\n";
  return text;
}

std::string identified_soil(const Identification& found, const std::vector<BagSeries>& series, Method method,
                            const std::string& command) {
  std::string comment = fmt::format("Identified by {}\n{}\n{}", command, explained(method), notes(series));
  for (const std::string& why : found.left_out) comment += "Not identified, constants as given: " + why + "\n";
  const Soil& soil = found.soil.soil;
  for (const BagSeries& bag : series)
    if (const End end = soil_state(soil, soil.young_modulus(bag.stiffness), soil.p_0, {}).end; end != End::none)
      throw DataError(
          fmt::format("{}: the constants found allow no state of it at the first mean stress, {:.4g} Pa: {}; give "
                      "--fit {}, or bags "
                      "that begin at rest",
                      bag.name, soil.p_0, reason(end), method == Method::path ? "thesis" : "path"));
  SoilFile named = found.soil;
  if (!named.name.starts_with("identified"))
    named.name = fmt::format("identified (other constants: {})", found.soil.name);
  return soil_text(named, comment);
}

std::string describe(const Design& design, const Demand& demand, const Case& bag) {
  const double settled = design.service.settlement() - design.start.settlement();
  const Geotextile &found = design.geotextile, &given = bag.geotextile;
  const std::string secant =
      found.curve.known() ? fmt::format(" (secant at the {:.4g} % it reaches)", 100 * found.secant_at) : "";
  const std::string scaled = found.curve.known() ? fmt::format(", {:.4g} times the tensions of {}",
                                                               found.strength / given.strength, given.name)
                                                 : "";
  std::string governs = governing(
      design.governs, design.end,
      fmt::format("with a softer geotextile the bag does not carry {:.6g} kPa", design.factored.surcharge / 1e3));
  governs.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(governs.front())));
  return fmt::format(
      "Smallest stiffness {:.5g} kN/m{} with a strength of {:.5g} kN/m{}.\n{}.\n"
      "At {:.6g} kPa the bag settles {:.4g} % ({:.3g} mm) with a tension of {:.4g} kN/m; at {:.4g} times that, {:.6g} "
      "kPa,\n"
      "the tension is {:.4g} kN/m, {:.3g} of the {}, at a settlement of {:.4g} %.\n",
      found.stiffness / 1e3, secant, found.strength / 1e3, scaled, governs, demand.surcharge / 1e3, 100 * settled,
      1e3 * bag.bag.height * settled, design.service.hoop_tension / 1e3, demand.safety, design.factored.surcharge / 1e3,
      design.factored.hoop_tension / 1e3, design.factored.hoop_tension / (design.geotextile.strength / bag.reduction),
      compared_strength(bag), 100 * (design.factored.settlement() - design.start.settlement()));
}

std::string describe(const Allowance& allowance, double settlement, double safety, const Case& bag) {
  const std::string most = fmt::format("the bag carries {:.6g} kPa at most", allowance.limit.surcharge / 1e3);
  return fmt::format(
      "Carries {:.6g} kPa within a settlement of {:.4g} % and with a safety of {:.4g}: {}.\n"
      "There the tension of the geotextile {} is {:.4g} kN/m, {:.3g} of its {}.\n",
      allowance.surcharge / 1e3, 100 * settlement, safety, governing(allowance.governs, allowance.end, most),
      bag.geotextile.name, allowance.at.hoop_tension / 1e3,
      allowance.at.hoop_tension / (bag.geotextile.strength / bag.reduction), compared_strength(bag));
}

io::Series design_table(const Design& design, double reduction) {
  io::Series table;
  const double compacted = design.start.settlement();
  put(table, "stiffness", "N/m", "smallest stiffness", {design.geotextile.stiffness});
  put(table, "strength", "N/m", "strength of the product it needs", {design.geotextile.strength});
  put(table, "long_term_strength", "N/m", "strength over the reduction factors",
      {design.geotextile.strength / reduction});
  put(table, "failure_strain", "1", "strain at failure", {design.geotextile.failure_strain});
  put(table, "surcharge", "Pa", "surcharge at service", {design.service.surcharge});
  put(table, "settlement", "1", "settlement at service, since compaction", {design.service.settlement() - compacted});
  put(table, "hoop_tension", "N/m", "hoop tension at service", {design.service.hoop_tension});
  put(table, "factored_surcharge", "Pa", "surcharge times safety", {design.factored.surcharge});
  put(table, "factored_settlement", "1", "settlement at the factored surcharge, since compaction",
      {design.factored.settlement() - compacted});
  put(table, "factored_hoop_tension", "N/m", "hoop tension at the factored surcharge", {design.factored.hoop_tension});
  return table;
}

io::Series allowance_table(const Allowance& allowance) {
  io::Series table;
  put(table, "surcharge", "Pa", "surcharge that the bag carries", {allowance.surcharge});
  put(table, "strain_axial", "1", "axial strain at that surcharge", {allowance.at.settlement()});
  put(table, "hoop_tension", "N/m", "hoop tension at that surcharge", {allowance.at.hoop_tension});
  return table;
}

io::Series chart_table(const std::vector<ChartRow>& rows, double reduction) {
  io::Series table;
  using R = const ChartRow&;
  put(table, "stiffness", "N/m", "stiffness of the geotextile",
      column(rows, [](R r) { return r.geotextile.stiffness; }));
  put(table, "strength", "N/m", "strength of the geotextile", column(rows, [](R r) { return r.geotextile.strength; }));
  put(table, "long_term_strength", "N/m", "strength over the reduction factors",
      column(rows, [=](R r) { return r.geotextile.strength / reduction; }));
  put(table, "capacity", "Pa", "ultimate surcharge", column(rows, [](R r) { return r.capacity; }));
  put(table, "settlement", "1", "settlement at the capacity", column(rows, [](R r) { return r.settlement; }));
  put(table, "hoop_strain", "1", "hoop strain at the capacity", column(rows, [](R r) { return r.hoop_strain; }));
  put(table, "reinforcing_efficiency", "1/m", "capacity over stiffness",
      column(rows, [](R r) { return r.capacity / r.geotextile.stiffness; }));
  put(table, "service_settlement", "1", "settlement at the surcharge asked for",
      column(rows, [](R r) { return r.service_settlement; }));
  put(table, "allowable_surcharge", "Pa", "surcharge within the settlement and with the safety asked for",
      column(rows, [](R r) { return r.allowable_surcharge; }));
  return table;
}

io::Series readable(const std::vector<ChartRow>& rows, double reduction) {
  io::Series table;
  using R = const ChartRow&;
  put(table, "stiffness", "kN/m", "", column(rows, [](R r) { return r.geotextile.stiffness / 1e3; }));
  put(table, "strength", "kN/m", "", column(rows, [](R r) { return r.geotextile.strength / 1e3; }));
  if (reduction != 1)
    put(table, "long_term", "kN/m", "", column(rows, [=](R r) { return r.geotextile.strength / reduction / 1e3; }));
  put(table, "capacity", "kPa", "", column(rows, [](R r) { return r.capacity / 1e3; }));
  put(table, "settlement", "%", "", column(rows, [](R r) { return 100 * r.settlement; }));
  put(table, "efficiency", "1/m", "", column(rows, [](R r) { return r.capacity / r.geotextile.stiffness; }));
  put(table, "at_service", "%", "", column(rows, [](R r) { return 100 * r.service_settlement; }));
  put(table, "allowable", "kPa", "", column(rows, [](R r) { return r.allowable_surcharge / 1e3; }));
  return table;
}

io::Series sensitivity_table(const std::vector<Sensitivity>& rows) {
  io::Series table;
  using R = const Sensitivity&;
  std::vector<double> number;
  for (std::size_t i = 0; i < rows.size(); ++i) number.push_back(static_cast<double>(i));
  put(table, "constant", "1", "number of the constant", number);
  put(table, "value", "its own", "value of the constant, SI", column(rows, [](R r) { return r.value; }));
  put(table, "low", "its own", "low end of its range", column(rows, [](R r) { return r.low; }));
  put(table, "high", "its own", "high end of its range", column(rows, [](R r) { return r.high; }));
  put(table, "capacity_derivative", "Pa per its own", "derivative of the ultimate surcharge by the constant",
      column(rows, [](R r) { return r.capacity_derivative; }));
  put(table, "settlement_derivative", "1 per its own", "derivative of the final settlement by the constant",
      column(rows, [](R r) { return r.settlement_derivative; }));
  put(table, "capacity_low", "Pa", "ultimate surcharge at the low end",
      column(rows, [](R r) { return r.capacity_low; }));
  put(table, "capacity_high", "Pa", "ultimate surcharge at the high end",
      column(rows, [](R r) { return r.capacity_high; }));
  put(table, "settlement_low", "1", "final settlement at the low end",
      column(rows, [](R r) { return r.settlement_low; }));
  put(table, "settlement_high", "1", "final settlement at the high end",
      column(rows, [](R r) { return r.settlement_high; }));
  if (rows.empty() || !rows.front().asked) return table;
  put(table, "service_settlement_derivative", "1 per its own",
      "derivative of the settlement at the surcharge asked for",
      column(rows, [](R r) { return r.service_settlement_derivative; }));
  put(table, "service_tension_derivative", "N/m per its own", "derivative of the hoop tension at that surcharge",
      column(rows, [](R r) { return r.service_tension_derivative; }));
  put(table, "service_settlement_low", "1", "settlement at that surcharge, at the low end",
      column(rows, [](R r) { return r.service_settlement_low; }));
  put(table, "service_settlement_high", "1", "settlement at that surcharge, at the high end",
      column(rows, [](R r) { return r.service_settlement_high; }));
  return table;
}

std::string describe(const std::vector<Sensitivity>& rows) {
  std::string text = fmt::format("{:>2} {:<25} {:>10} {:<4} {:>22} {:>15} {:>9} {:>20} {:>16}\n", "", "constant",
                                 "value", "", "range", "dlnQ/dln", "ds/dln", "capacity", "settlement");
  text += fmt::format("{:>2} {:<25} {:>10} {:<4} {:>22} {:>15} {:>9} {:>20} {:>16}\n", "", "", "", "", "", "%/%", "%/1",
                      "kPa", "%");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Sensitivity& r = rows[i];
    const double middle = (r.capacity_low + r.capacity_high) / 2;
    text +=
        fmt::format("{:>2} {:<25} {:>10.4g} {:<4} {:>22} {:>15.3f} {:>9.3f} {:>20} {:>16}\n", i, r.key, r.value,
                    r.unit == "1" ? "" : r.unit, fmt::format("{:.4g}..{:.4g}{}", r.low, r.high, r.interval ? "*" : ""),
                    r.capacity_derivative * r.value / middle, 100 * r.settlement_derivative * r.value,
                    fmt::format("{:.1f}..{:.1f}", r.capacity_low / 1e3, r.capacity_high / 1e3),
                    fmt::format("{:.2f}..{:.2f}", 100 * r.settlement_low, 100 * r.settlement_high));
  }
  text += "* interval of 95 %; the others are varied by the share asked for\n";
  return rows.empty() || !rows.front().asked ? text : text + describe_service(rows);
}

io::Series bands_table(const Bands& bands) {
  io::Series table;
  put(table, "settlement", "1", "since compaction", column(bands.rows, [](const BandRow& r) { return r.settlement; }));
  put(table, "samples", "1", "draws that get as far",
      column(bands.rows, [](const BandRow& r) { return static_cast<double>(r.samples); }));
  put_band(table, "surcharge", "Pa", "surcharge", bands.rows, &BandRow::surcharge);
  put_band(table, "axial_stress", "Pa", "axial stress in the soil", bands.rows, &BandRow::axial_stress);
  put_band(table, "radial_stress", "Pa", "lateral stress in the soil", bands.rows, &BandRow::radial_stress);
  put_band(table, "hoop_strain", "1", "strain of the geotextile", bands.rows, &BandRow::hoop_strain);
  return table;
}

io::Series readable(const Bands& bands) {
  io::Series table;
  using R = const BandRow&;
  put(table, "settlement", "%", "", column(bands.rows, [](R r) { return 100 * r.settlement; }));
  put(table, "draws", "1", "", column(bands.rows, [](R r) { return static_cast<double>(r.samples); }));
  put(table, "2.5 %", "kPa", "", column(bands.rows, [](R r) { return r.surcharge.low / 1e3; }));
  put(table, "surcharge", "kPa", "", column(bands.rows, [](R r) { return r.surcharge.middle / 1e3; }));
  put(table, "97.5 %", "kPa", "", column(bands.rows, [](R r) { return r.surcharge.high / 1e3; }));
  put(table, "2.5 %", "kPa", "", column(bands.rows, [](R r) { return r.radial_stress.low / 1e3; }));
  put(table, "sigma_r", "kPa", "", column(bands.rows, [](R r) { return r.radial_stress.middle / 1e3; }));
  put(table, "97.5 %", "kPa", "", column(bands.rows, [](R r) { return r.radial_stress.high / 1e3; }));
  return table;
}

std::string describe(const Bands& bands) {
  std::size_t left_out = 0;
  for (const auto& [why, count] : bands.left_out) left_out += count;
  const std::string apart = left_out > 0 ? fmt::format(" ({} of {} left out)", left_out, bands.samples + left_out) : "";
  std::string text = fmt::format(
      "{} draws{}: ultimate bearing capacity {:.1f} kPa (95 %: {:.1f} to {:.1f}), final settlement {:.2f} % (95 %: "
      "{:.2f} to {:.2f})\nConstants {}\n",
      bands.samples, apart, bands.capacity.middle / 1e3, bands.capacity.low / 1e3, bands.capacity.high / 1e3,
      100 * bands.settlement.middle, 100 * bands.settlement.low, 100 * bands.settlement.high, variation(bands));
  for (const auto& [why, count] : bands.left_out) text += fmt::format("{} draws left out: {}\n", count, why);
  return text;
}

}  // namespace soilweave::gws
